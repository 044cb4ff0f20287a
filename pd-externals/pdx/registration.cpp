// Classes: making them known to Pd, objects of them, and their messages and signals.
#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <type_traits>

#include "pdx/box.hpp"

namespace percussionist::pdx {

static_assert(std::is_same_v<Sample, t_sample>);

namespace {

std::map<std::string, Known, std::less<>>& known_classes() {
    static std::map<std::string, Known, std::less<>> classes;
    return classes;
}

std::vector<Atom> from_pd(int count, const t_atom* atoms) {
    std::vector<Atom> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const bool symbol = atoms[i].a_type == A_SYMBOL;
        symbol ? values.emplace_back(atoms[i].a_w.w_symbol->s_name)
               : values.emplace_back(
                     atoms[i].a_type == A_FLOAT ? static_cast<double>(atoms[i].a_w.w_float) : 0.0);
    }
    return values;
}

std::string what_it_hears(const Description& table) {
    std::string names;
    for (const auto& message : table.messages) {
        names += (names.empty() ? "" : ", ") + message.selector;
    }
    return names.empty() ? "it hears no messages" : "it hears: " + names;
}

void receive(Box* box, t_symbol* selector, int count, t_atom* atoms) noexcept {
    const Description& table = box->known->table;
    const auto message =
        std::find_if(table.messages.begin(), table.messages.end(),
                     [&](const Message& m) { return m.selector == selector->s_name; });
    if (message == table.messages.end() && selector == gensym("reference")) {
        std::istringstream lines(table.reference());
        for (std::string line; std::getline(lines, line);) {
            ::post("%s", line.c_str());
        }
        return;
    }
    if (message == table.messages.end()) {
        print_error(
            box, table.name + ": no message '" + selector->s_name + "'; " + what_it_hears(table));
        return;
    }
    Object& object = *box->object;
    guarded(Call(object), message->selector, [&] {
        const auto given = from_pd(count, atoms);
        message->call(object, check(message->arguments, given, message->selector));
    });
}

/// Listens at a further inlet.
struct Ear {
    t_pd header;
    Box* box;
    t_symbol* selector;
};

void hear(Ear* ear, t_symbol* selector, int count, t_atom* atoms) noexcept {
    std::vector<t_atom> all(atoms, atoms + count);
    const std::string_view name = selector->s_name;
    if (name != "list" && name != "float" && name != "symbol" && name != "bang") {
        all.insert(all.begin(), t_atom{});
        SETSYMBOL(all.data(), selector);
    }
    receive(ear->box, ear->selector, static_cast<int>(all.size()), all.data());
}

void forget(Ear*) noexcept {}

t_class* ear_class() {
    static t_class* const known = [] {
        t_class* const c =
            class_new(gensym("percussionist-inlet"), nullptr, reinterpret_cast<t_method>(&forget),
                      sizeof(Ear), CLASS_PD, A_NULL);
        class_addanything(c, reinterpret_cast<t_method>(&hear));
        return c;
    }();
    return known;
}

/// The logical time at which the coming block starts. At a tick Pd has already moved its time to
/// the tick's end; a short block is one of several within a tick, a long one ends with its tick.
double block_start(Box* box, std::size_t size) noexcept {
    const double now = logical_seconds();
    const double duration = static_cast<double>(size) / box->sample_rate;
    if (now != box->tick_time) {
        const double tick = sys_getblksize() / static_cast<double>(sys_getsr());
        box->tick_time = now;
        box->next_start = now - std::max(duration, tick);
    }
    const double start = box->next_start;
    box->next_start += duration;
    return start;
}

t_int* perform(t_int* words) noexcept {
    auto* const box = reinterpret_cast<Box*>(words[1]);
    const auto size = static_cast<std::size_t>(words[2]);
    const Description& table = box->known->table;
    box->object->process({.inputs = {box->inputs, table.signal_inlets.size()},
                          .outputs = {box->outputs, box->output_count},
                          .size = size,
                          .start = block_start(box, size),
                          .sample_rate = box->sample_rate});
    return words + 3;
}

/// Since Pd 0.54 a cord carries several channels. An object that knows of it says how many each of
/// its outlets has; before, there is no such function, and no such cord.
using SetChannels = void (*)(t_signal**, int);
constexpr int kClassMultichannel = 0x10;

SetChannels set_channels() {
    static const auto known =
        reinterpret_cast<SetChannels>(dlsym(RTLD_DEFAULT, "signal_setmultiout"));
    return known;
}

/// The samples of a signal outlet, one cord of all channels or a cord for each.
void take_outlet(Box* box, t_signal** signal, std::size_t size) {
    const std::size_t channels = std::max<std::size_t>(box->channels, 1);
    if (box->known->table.last_outlets && set_channels()) {
        set_channels()(signal, static_cast<int>(channels));
    }
    for (std::size_t channel = 0; channel < channels; ++channel) {
        box->outputs[box->output_count++] = (*signal)->s_vec + channel * size;
    }
}

void sort_signals(Box* box, t_signal** signals) noexcept {
    const Description& table = box->known->table;
    const auto size = static_cast<std::size_t>(signals[0]->s_n);
    box->sample_rate = static_cast<double>(signals[0]->s_sr);
    box->tick_time = -1.0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < table.signal_inlets.size(); ++i) {
        box->inputs[i] = signals[next++]->s_vec;
    }
    box->output_count = 0;
    for (std::size_t i = 0; i < box->outlet_count; ++i) {
        if (port_of_outlet(box, i).signal) {
            take_outlet(box, &signals[next++], size);
        }
    }
    bool ready = false;
    guarded(Call(*box->object), "dsp", [&] {
        box->object->prepare(box->sample_rate, size);
        ready = true;
    });
    if (ready) {
        dsp_add(&perform, 2, box, static_cast<t_int>(size));
        return;
    }
    for (std::size_t i = 0; i < box->output_count; ++i) {
        dsp_add_zero(box->outputs[i], static_cast<int>(size));
    }
}

bool has_signals(const Description& table) {
    return !table.signal_inlets.empty() ||
           std::any_of(table.outlets.begin(), table.outlets.end(),
                       [](const Port& outlet) { return outlet.signal; });
}

void make_ports(Box* box, const Arguments& creation) {
    const Description& table = box->known->table;
    for (std::size_t i = 1; i < table.signal_inlets.size(); ++i) {
        signalinlet_new(&box->header, 0);
    }
    box->inlets = new t_pd* [table.message_inlets.size()] {};
    for (std::size_t i = 0; i < table.message_inlets.size(); ++i) {
        auto* const ear = reinterpret_cast<Ear*>(pd_new(ear_class()));
        ear->box = box;
        ear->selector = gensym(table.message_inlets[i].selector.c_str());
        box->inlets[i] = &ear->header;
        inlet_new(&box->header, &ear->header, nullptr, nullptr);
    }
    const auto wanted = table.last_outlets ? creation.number(*table.last_outlets) : 1.0;
    const std::size_t more = wanted > 1.0 ? static_cast<std::size_t>(wanted) - 1 : 0;
    const std::size_t all = std::min(table.outlets.size() + more, kMaxSignals);
    box->channels = box->channels > 0 ? all - table.outlets.size() + 1 : 0;
    box->outlet_count = box->channels > 0 ? table.outlets.size() : all;
    box->outlets = new t_outlet* [box->outlet_count] {};
    for (std::size_t i = 0; i < box->outlet_count; ++i) {
        const bool signal = port_of_outlet(box, i).signal;
        box->outlets[i] = outlet_new(&box->header, signal ? &s_signal : nullptr);
    }
}

/// "-m" in front of the arguments: the last outlets are one, with a channel for each.
std::span<const Atom> take_flag(Box* box, std::span<const Atom> given) {
    if (!box->known->table.last_outlets || given.empty() || is_number(given[0]) ||
        to_string(given[0]) != "-m") {
        return given;
    }
    if (!set_channels()) {
        throw std::invalid_argument("-m: several channels in one cord need Pd 0.54 or newer");
    }
    box->channels = 1;
    return given.subspan(1);
}

void* create(t_symbol* typed_name, int count, t_atom* atoms) noexcept {
    // A folder may stand in front of the name.
    const std::string_view path = typed_name->s_name;
    const auto found = known_classes().find(path.substr(path.rfind('/') + 1));
    if (found == known_classes().end()) {
        return nullptr;
    }
    auto* const box = reinterpret_cast<Box*>(pd_new(found->second.pd_class));
    box->known = &found->second;
    box->canvas = canvas_getcurrent();
    guarded(Making{box}, "", [&] {
        const Description& table = box->known->table;
        const auto given = from_pd(count, atoms);
        const Arguments creation =
            check(table.creation_arguments, take_flag(box, given), table.name);
        make_ports(box, creation);
        box->object = table.make(*box, creation).release();
    });
    if (!box->object) {
        pd_free(reinterpret_cast<t_pd*>(box));
        return nullptr;
    }
    return box;
}

void destroy(Box* box) noexcept {
    if (box->object) {
        Call::forsake(box->object);
    }
    for (std::size_t i = 0; box->inlets && i < box->known->table.message_inlets.size(); ++i) {
        if (box->inlets[i]) {
            pd_free(box->inlets[i]);
        }
    }
    delete[] box->inlets;
    delete[] box->outlets;
}

}  // namespace

void add_class(Description description) {
    const std::string name = description.name;
    t_symbol* const long_name = gensym(("percussionist/" + name).c_str());
    if (zgetfn(&pd_objectmaker, long_name)) {
        return;  // by the library of all, or by the object's own file
    }
    if (description.signal_inlets.size() > kMaxSignals ||
        description.outlets.size() > kMaxSignals) {
        print_error(nullptr, name + ": too many signals");
        return;
    }
    Known& known = known_classes()[name];
    known.table = std::move(description);
    t_class* const c =
        class_new(gensym(name.c_str()), reinterpret_cast<t_newmethod>(&create),
                  reinterpret_cast<t_method>(&destroy), sizeof(Box),
                  known.table.last_outlets && set_channels() ? kClassMultichannel : CLASS_DEFAULT,
                  A_GIMME, A_NULL);
    known.pd_class = c;
    if (!zgetfn(&pd_objectmaker, long_name)) {
        class_addcreator(reinterpret_cast<t_newmethod>(&create), long_name, A_GIMME, A_NULL);
    }
    if (!known.table.signal_inlets.empty()) {
        class_domainsignalin(c, offsetof(Box, unconnected_inlet));
    }
    class_addanything(c, reinterpret_cast<t_method>(&receive));
    if (has_signals(known.table)) {
        // A_CANT: a message "dsp" that a user types must not get here.
        class_addmethod(c, reinterpret_cast<t_method>(&sort_signals), gensym("dsp"), A_CANT,
                        A_NULL);
    }
}

const Description* find_class(std::string_view name) {
    const auto found = known_classes().find(name);
    return found == known_classes().end() ? nullptr : &found->second.table;
}

std::vector<const Description*> all_classes() {
    std::vector<const Description*> all;
    for (const auto& [name, known] : known_classes()) {
        all.push_back(&known.table);
    }
    return all;
}

std::string Description::reference() const {
    std::string text = name + ": " + summary + "\n  [" + usage(name, creation_arguments) + "]\n";
    for (const auto& message : messages) {
        text +=
            "  " + usage(message.selector, message.arguments) + ": " + message.description + "\n";
    }
    if (last_outlets) {
        text += std::string("  ") + kOneCord + "\n";
    }
    for (const auto& inlet : signal_inlets) {
        text += "  signal inlet: " + inlet.description + "\n";
    }
    for (const auto& inlet : message_inlets) {
        text += "  inlet: " + inlet.description + "\n";
    }
    for (const auto& outlet : outlets) {
        text += std::string("  ") + (outlet.signal ? "signal " : "") +
                "outlet: " + outlet.description + "\n";
    }
    return text;
}

}  // namespace percussionist::pdx
