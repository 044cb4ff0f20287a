#include "app/simulation_flags.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

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

}  // namespace percussionist::app
