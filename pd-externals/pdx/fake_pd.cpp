// The functions of m_pd.h that the seam calls, for tests without Pd.
#include "pdx/fake_pd.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>

using namespace percussionist::pdx::fake;
using percussionist::pdx::Atom;
using percussionist::pdx::Sent;

namespace percussionist::pdx::fake {

State& state() {
    static State the_state;
    return the_state;
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

}  // namespace percussionist::pdx::fake

namespace {

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
    const Sent sent{outlet->index, selector, values, state().time / kUnitsPerSecond};
    state().sent[outlet->owner].push_back(sent);
    if (const auto hearer = state().hearer) {
        hearer(sent);
    }
}

}  // namespace

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

t_pd pd_objectmaker = nullptr;

/// Whether objects can be made by that name.
t_gotfn zgetfn(const t_pd*, t_symbol* name) {
    const auto& creators = state().creators;
    const auto found = creators.find(name->s_name);
    return found == creators.end() ? nullptr : reinterpret_cast<t_gotfn>(found->second);
}

void class_addcreator(t_newmethod make, t_symbol* name, t_atomtype, ...) {
    state().creators[name->s_name] = make;
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
    state().listeners.erase(reinterpret_cast<t_object*>(object));
    state().sent.erase(reinterpret_cast<t_object*>(object));
    std::free(object);
}

t_outlet* outlet_new(t_object* owner, t_symbol* type) {
    auto& outlets = state().outlets[owner];
    outlets.push_back(std::make_unique<_outlet>(_outlet{owner, outlets.size(), type == &s_signal}));
    return outlets.back().get();
}

t_inlet* inlet_new(t_object* owner, t_pd* listener, t_symbol*, t_symbol*) {
    state().listeners[owner].push_back(listener);
    return nullptr;
}

t_inlet* signalinlet_new(t_object* owner, t_float) {
    ++state().extra_inlets[owner];
    return nullptr;
}

t_class* garray_class = nullptr;

t_pd* pd_findbyclass(t_symbol* name, const t_class*) {
    const auto found = state().arrays.find(name->s_name);
    return found == state().arrays.end() ? nullptr : reinterpret_cast<t_pd*>(&found->second);
}

int garray_getfloatwords(t_garray* array, int* size, t_word** words) {
    auto& values = *reinterpret_cast<std::vector<t_word>*>(array);
    *size = static_cast<int>(values.size());
    *words = values.data();
    return 1;
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

t_glist* canvas_getcurrent() {
    return nullptr;
}

void canvas_makefilename(const t_glist*, const char* file, char* result, int size) {
    const bool beside_patch = *file != '/' && !state().patch_folder.empty();
    const std::string path = beside_patch ? state().patch_folder + '/' + file : file;
    result[path.copy(result, static_cast<std::size_t>(size) - 1)] = '\0';
}

int canvas_open(const t_canvas* canvas, const char* name, const char*, char* folder, char** found,
                unsigned int size, int) {
    canvas_makefilename(canvas, name, folder, static_cast<int>(size));
    char* const slash = std::strrchr(folder, '/');
    if (!slash || !std::ifstream(folder)) {
        return -1;
    }
    *slash = '\0';
    *found = slash + 1;
    return 0;
}

int sys_close(int) {
    return 0;
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
