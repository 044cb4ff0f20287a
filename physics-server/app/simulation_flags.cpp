#include "app/simulation_flags.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace percussionist::app {

void add_simulation_flags(CLI::App& command, sim::SimulationOptions& o) {
    static const std::map<std::string, sim::Law> laws{{"implicit", sim::Law::implicit},
                                                      {"paper", sim::Law::paper}};
    command.add_option("--rate", o.rate, "steps a second [Hz]")
        ->check(CLI::Range(250.0, 4000.0))
        ->capture_default_str();
    command
        .add_option("--law", o.control.law,
                    "how joints are driven: implicit (with target velocity and feed-forward), or "
                    "paper (torque = ks e - kd w)")
        ->transform(CLI::CheckedTransformer(laws, CLI::ignore_case))
        ->default_str("implicit");
    command.add_option("--stature", o.person.stature, "of the percussionist [m]")
        ->check(CLI::Range(0.5, 2.5))
        ->capture_default_str();
    command.add_option("--weight", o.person.mass, "of the percussionist [kg]")
        ->check(CLI::Range(10.0, 300.0))
        ->capture_default_str();
}

std::string simulation_settings(const CLI::App& command) {
    CLI::App alone;
    sim::SimulationOptions unused;
    add_simulation_flags(alone, unused);
    std::string settings;
    for (const CLI::Option* flag : alone.get_options()) {
        const CLI::Option* given = command.get_option_no_throw(flag->get_name());
        if (given == nullptr || given->count() == 0 || flag == alone.get_help_ptr()) continue;
        settings += flag->get_name() + '\n';
        for (const std::string& value : given->results()) settings += value + '\n';
    }
    return settings;
}

sim::SimulationOptions simulation_of(const std::string& settings, const std::string& name) {
    CLI::App alone;
    sim::SimulationOptions options;
    add_simulation_flags(alone, options);
    std::vector<std::string> words;
    std::istringstream in(settings);
    for (std::string word; std::getline(in, word);) words.insert(words.begin(), word);
    try {
        alone.parse(words);  // the last word first
    } catch (const CLI::ParseError& error) {
        throw std::runtime_error(name + ": settings: " + error.what());
    }
    return options;
}

}  // namespace percussionist::app
