// What stands in for Pd's innards in tests: its own types, as small as they can be, and the state
// it keeps in global variables. For fake_pd.cpp and fake_host.cpp alone.
#pragma once

#include <m_pd.h>

#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pdx/fake_host.hpp"

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

namespace percussionist::pdx::fake {

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
    std::map<std::string, t_newmethod, std::less<>> creators;  ///< by further names
    std::list<_clock> clocks;
    std::map<t_object*, std::vector<std::unique_ptr<_outlet>>> outlets;
    std::map<t_object*, std::size_t> extra_inlets;
    std::map<t_object*, std::vector<t_pd*>> listeners;
    std::map<t_object*, std::vector<Sent>> sent;
    std::function<void(const Sent&)> hearer;
    std::map<std::string, std::vector<t_word>, std::less<>> arrays;
    std::vector<std::function<void()>> chain;
    std::vector<std::string> errors;
    std::vector<std::string> posts;
    std::string patch_folder;  ///< of all objects; none: where the program runs
};

State& state();

std::vector<t_atom> pd_atoms(const std::vector<Atom>& values);

}  // namespace percussionist::pdx::fake
