#include "pdx/fake_host.hpp"

#include <m_pd.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdlib>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <utility>

using percussionist::pdx::Atom;
using percussionist::pdx::Sample;
using percussionist::pdx::Sent;

// Pd's own types, as small as they can be.
struct _class {
    t_symbol* name;
    t_newmethod make;
    t_method destroy;
    std::size_t size;
    t_method anything = nullptr;
    t_method dsp = nullptr;
    int main_signal = 0;
};
struct _outlet {
    t_object* owner;
    std::size_t index;
    bool signal;
};
struct _inlet {};
struct _clock {
    void* owner;
    t_method call;
    double time = -1.0;
    std::size_t order = 0;
};

namespace {

constexpr double kUnitsPerSecond = 32.0 * 441.0 * 1000.0;
constexpr std::size_t kTickSize = 64;

/// What Pd keeps in global variables.
struct State {
    double sample_rate = 48000;
    double time = 0.0;  ///< in Pd's units
    std::size_t clock_order = 0;
    std::list<t_symbol> symbols;
    std::deque<std::string> names;
    std::list<_class> classes;
    std::list<_clock> clocks;
    std::map<t_object*, std::vector<std::unique_ptr<_outlet>>> outlets;
    std::map<t_object*, std::size_t> extra_inlets;
    std::map<t_object*, std::vector<Sent>> sent;
    std::vector<std::function<void()>> chain;
    std::vector<std::string> errors;
    std::vector<std::string> posts;
};

State& state() {
    static State the_state;
    return the_state;
}

std::string formatted(const char* format, va_list arguments) {
    char text[4096];
    std::vsnprintf(text, sizeof text, format, arguments);
    return text;
}

void record(t_outlet* outlet, const char* selector, int count, const t_atom* atoms) {
    std::vector<Atom> values;
    for (int i = 0; i < count; ++i) {
        if (atoms[i].a_type == A_SYMBOL) {
            values.emplace_back(atoms[i].a_w.w_symbol->s_name);
        } else {
            values.emplace_back(static_cast<double>(atoms[i].a_w.w_float));
        }
    }
    state().sent[outlet->owner].push_back(
        {outlet->index, selector, values, state().time / kUnitsPerSecond});
}

std::vector<t_atom> pd_atoms(const std::vector<Atom>& values) {
    std::vector<t_atom> atoms(values.size() + 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (percussionist::pdx::is_number(values[i])) {
            SETFLOAT(&atoms[i], static_cast<t_float>(std::get<double>(values[i])));
        } else {
            SETSYMBOL(&atoms[i], gensym(std::get<const char*>(values[i])));
        }
    }
    return atoms;
}

}  // namespace

// --- the functions of m_pd.h that the seam calls ---

t_symbol s_list{.s_name = "list", .s_thing = nullptr, .s_next = nullptr};
t_symbol s_signal{.s_name = "signal", .s_thing = nullptr, .s_next = nullptr};

t_symbol* gensym(const char* name) {
    for (auto& symbol : state().symbols) {
        if (std::string_view(symbol.s_name) == name) {
            return &symbol;
        }
    }
    state().names.emplace_back(name);
    state().symbols.push_back({state().names.back().c_str(), nullptr, nullptr});
    return &state().symbols.back();
}

t_class* class_new(t_symbol* name, t_newmethod make, t_method destroy, std::size_t size, int,
                   t_atomtype, ...) {
    state().classes.push_back({name, make, destroy, size});
    return &state().classes.back();
}

void(class_addanything)(t_class* c, t_method method) {
    c->anything = method;
}

void class_addmethod(t_class* c, t_method method, t_symbol* selector, t_atomtype type, ...) {
    if (selector == gensym("dsp") && type == A_CANT) {
        c->dsp = method;
    }
}

void class_domainsignalin(t_class* c, int onset) {
    c->main_signal = onset;
}

t_pd* pd_new(t_class* c) {
    auto* const object = static_cast<t_pd*>(std::calloc(1, c->size));
    *object = c;
    return object;
}

void pd_free(t_pd* object) {
    reinterpret_cast<void (*)(void*)>((*object)->destroy)(object);
    state().outlets.erase(reinterpret_cast<t_object*>(object));
    state().extra_inlets.erase(reinterpret_cast<t_object*>(object));
    state().sent.erase(reinterpret_cast<t_object*>(object));
    std::free(object);
}

t_outlet* outlet_new(t_object* owner, t_symbol* type) {
    auto& outlets = state().outlets[owner];
    outlets.push_back(std::make_unique<_outlet>(_outlet{owner, outlets.size(), type == &s_signal}));
    return outlets.back().get();
}

t_inlet* signalinlet_new(t_object* owner, t_float) {
    ++state().extra_inlets[owner];
    return nullptr;
}

void outlet_bang(t_outlet* outlet) {
    record(outlet, "bang", 0, nullptr);
}

void outlet_float(t_outlet* outlet, t_float value) {
    t_atom atom;
    SETFLOAT(&atom, value);
    record(outlet, "float", 1, &atom);
}

void outlet_list(t_outlet* outlet, t_symbol*, int count, t_atom* atoms) {
    record(outlet, "list", count, atoms);
}

void outlet_anything(t_outlet* outlet, t_symbol* selector, int count, t_atom* atoms) {
    record(outlet, selector->s_name, count, atoms);
}

t_clock* clock_new(void* owner, t_method call) {
    state().clocks.push_back({owner, call});
    return &state().clocks.back();
}

void clock_delay(t_clock* clock, double milliseconds) {
    clock->time = state().time + milliseconds * kUnitsPerSecond / 1000;
    clock->order = ++state().clock_order;
}

void clock_unset(t_clock* clock) {
    clock->time = -1.0;
}

void clock_free(t_clock* clock) {
    state().clocks.remove_if([clock](const _clock& c) { return &c == clock; });
}

double clock_gettimesince(double before) {
    return (state().time - before) * 1000 / kUnitsPerSecond;
}

void pd_error(const void*, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    state().errors.push_back(formatted(format, arguments));
    va_end(arguments);
}

void post(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    state().posts.push_back(formatted(format, arguments));
    va_end(arguments);
}

t_float sys_getsr() {
    return static_cast<t_float>(state().sample_rate);
}

int sys_getblksize() {
    return kTickSize;
}

void dsp_add(t_perfroutine perform, int count, ...) {
    std::vector<t_int> words{0};
    va_list arguments;
    va_start(arguments, count);
    for (int i = 0; i < count; ++i) {
        words.push_back(va_arg(arguments, t_int));
    }
    va_end(arguments);
    state().chain.emplace_back([perform, words]() mutable { perform(words.data()); });
}

void dsp_add_zero(t_sample* out, int n) {
    state().chain.emplace_back([out, n] { std::fill_n(out, n, t_sample(0)); });
}

// --- the host ---

namespace percussionist::pdx {

FakeHost::FakeHost(double sample_rate) {
    auto& s = state();
    s.sample_rate = sample_rate;
    s.time = 0.0;
    s.errors.clear();
    s.posts.clear();
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

void FakeHost::destroy(FakeObject* object) {
    state().chain.clear();
    pd_free(static_cast<t_pd*>(object->box_));
    order_.erase(std::find(order_.begin(), order_.end(), object));
    objects_.erase(object);
}

void FakeObject::message(const std::string& selector, std::vector<Atom> atoms) {
    auto values = pd_atoms(atoms);
    using Receive = void (*)(void*, t_symbol*, int, t_atom*);
    reinterpret_cast<Receive>((*static_cast<t_pd*>(box_))->anything)(
        box_, gensym(selector.c_str()), static_cast<int>(atoms.size()), values.data());
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

std::vector<std::string> FakeHost::errors() {
    return std::exchange(state().errors, {});
}

std::vector<std::string> FakeHost::posts() {
    return std::exchange(state().posts, {});
}

}  // namespace percussionist::pdx
