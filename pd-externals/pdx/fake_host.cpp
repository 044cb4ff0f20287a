#include "pdx/fake_host.hpp"

#include <algorithm>
#include <utility>

#include "pdx/fake_pd.hpp"

namespace percussionist::pdx {

using namespace fake;

FakeHost::FakeHost(double sample_rate) {
    auto& s = state();
    s.sample_rate = sample_rate;
    s.time = 0.0;
    s.errors.clear();
    s.posts.clear();
    s.arrays.clear();
}

FakeHost::~FakeHost() {
    while (!order_.empty()) {
        destroy(order_.back());
    }
    state().chain.clear();
}

FakeObject* FakeHost::create(const std::string& name, std::vector<Atom> arguments) {
    const auto short_name = name.substr(name.rfind('/') + 1);
    for (auto& c : state().classes) {
        if (c.name->s_name == short_name) {
            auto atoms = pd_atoms(arguments);
            using Make = void* (*)(t_symbol*, int, t_atom*);
            void* const box = reinterpret_cast<Make>(c.make)(
                gensym(name.c_str()), static_cast<int>(arguments.size()), atoms.data());
            if (!box) {
                return nullptr;
            }
            auto object = std::make_unique<FakeObject>();
            object->box_ = box;
            FakeObject* const raw = object.get();
            objects_[raw] = std::move(object);
            order_.push_back(raw);
            return raw;
        }
    }
    state().errors.push_back(name + " ... couldn't create");
    return nullptr;
}

void FakeHost::on_sent(std::function<void(const Sent&)> hearer) {
    state().hearer = std::move(hearer);
}

void FakeHost::destroy(FakeObject* object) {
    state().chain.clear();
    pd_free(static_cast<t_pd*>(object->box_));
    order_.erase(std::find(order_.begin(), order_.end(), object));
    objects_.erase(object);
}

namespace {

void deliver(t_pd* receiver, const std::string& selector, const std::vector<Atom>& atoms) {
    auto values = pd_atoms(atoms);
    using Receive = void (*)(void*, t_symbol*, int, t_atom*);
    reinterpret_cast<Receive>((*receiver)->anything)(receiver, gensym(selector.c_str()),
                                                     static_cast<int>(atoms.size()), values.data());
}

}  // namespace

void FakeObject::message(const std::string& selector, std::vector<Atom> atoms) {
    deliver(static_cast<t_pd*>(box_), selector, atoms);
}

void FakeObject::message_at(std::size_t inlet, const std::string& selector,
                            std::vector<Atom> atoms) {
    deliver(state().listeners[static_cast<t_object*>(box_)].at(inlet), selector, atoms);
}

std::vector<Sent> FakeObject::sent() {
    const auto& all = state().sent[static_cast<t_object*>(box_)];
    std::vector<Sent> fresh(all.begin() + static_cast<std::ptrdiff_t>(seen_), all.end());
    seen_ = all.size();
    return fresh;
}

void FakeHost::start_dsp(std::size_t block_size, std::size_t over) {
    auto& s = state();
    s.chain.clear();
    block_size_ = block_size;
    over_ = over;
    for (FakeObject* object : order_) {
        auto* const box = static_cast<t_object*>(object->box_);
        const t_class* const c = box->ob_pd;
        if (!c->dsp) {
            continue;
        }
        const std::size_t inputs = c->main_signal ? 1 + s.extra_inlets[box] : 0;
        const auto outputs = static_cast<std::size_t>(
            std::count_if(s.outlets[box].begin(), s.outlets[box].end(),
                          [](const auto& outlet) { return outlet->signal; }));
        object->inputs_.resize(inputs);
        object->outputs_.assign(outputs, {});
        auto buffers = std::make_shared<std::vector<std::vector<t_sample>>>(
            inputs + outputs, std::vector<t_sample>(block_size));
        std::vector<t_signal> signals(inputs + outputs);
        std::vector<t_signal*> pointers;
        for (std::size_t i = 0; i < signals.size(); ++i) {
            signals[i].s_n = static_cast<int>(block_size);
            signals[i].s_vec = (*buffers)[i].data();
            signals[i].s_sr = static_cast<t_float>(s.sample_rate * static_cast<double>(over));
            pointers.push_back(&signals[i]);
        }
        s.chain.emplace_back([object, buffers, inputs] {
            for (std::size_t i = 0; i < inputs; ++i) {
                std::fill((*buffers)[i].begin(), (*buffers)[i].end(), object->inputs_[i]);
            }
        });
        reinterpret_cast<void (*)(void*, t_signal**)>(c->dsp)(box, pointers.data());
        s.chain.emplace_back([object, buffers, inputs] {
            for (std::size_t i = inputs; i < buffers->size(); ++i) {
                auto& all = object->outputs_[i - inputs];
                all.insert(all.end(), (*buffers)[i].begin(), (*buffers)[i].end());
            }
        });
    }
}

void FakeHost::run_clocks(double until) {
    auto& s = state();
    for (;;) {
        _clock* next = nullptr;
        for (auto& clock : s.clocks) {
            const bool due = clock.time >= 0.0 && clock.time < until;
            if (due && (!next ||
                        std::pair(clock.time, clock.order) < std::pair(next->time, next->order))) {
                next = &clock;
            }
        }
        if (!next) {
            return;
        }
        s.time = std::max(s.time, next->time);
        next->time = -1.0;
        reinterpret_cast<void (*)(void*)>(next->call)(next->owner);
    }
}

void FakeHost::perform_tick() {
    if (block_size_ == 0) {
        return;
    }
    const std::size_t samples = kTickSize * over_;
    const std::size_t ticks_a_block = std::max<std::size_t>(1, block_size_ / samples);
    const std::size_t runs = std::max<std::size_t>(1, samples / block_size_);
    if (tick_ % ticks_a_block != 0) {
        return;
    }
    for (std::size_t i = 0; i < runs; ++i) {
        for (auto& link : state().chain) {
            link();
        }
    }
}

void FakeHost::run_tick() {
    const double tick = kTickSize * kUnitsPerSecond / state().sample_rate;
    ++tick_;
    const double end = static_cast<double>(tick_) * tick;
    run_clocks(end);
    state().time = end;
    perform_tick();
}

void FakeHost::advance_to(double seconds) {
    const double tick = kTickSize * kUnitsPerSecond / state().sample_rate;
    const double target = seconds * kUnitsPerSecond;
    while (static_cast<double>(tick_ + 1) * tick <= target) {
        run_tick();
    }
    run_clocks(target);
    state().time = std::max(state().time, target);
}

double FakeHost::now() const {
    return state().time / kUnitsPerSecond;
}

void FakeHost::set_array(const std::string& name, const std::vector<double>& values) {
    auto& words = state().arrays[name];
    words.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        words[i].w_float = static_cast<t_float>(values[i]);
    }
}

void FakeHost::set_patch_folder(const std::string& path) {
    state().patch_folder = path;
}

std::vector<std::string> FakeHost::errors() {
    return std::exchange(state().errors, {});
}

std::vector<std::string> FakeHost::posts() {
    return std::exchange(state().posts, {});
}

}  // namespace percussionist::pdx
