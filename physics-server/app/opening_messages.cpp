#include "app/opening_messages.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "osc/address_table.hpp"

namespace percussionist::app {

namespace {

/// Words that are numbers as numbers.
std::vector<osc::Argument> arguments(std::istringstream& words) {
    std::vector<osc::Argument> all;
    for (std::string word; words >> word;) {
        char* end = nullptr;
        const double number = std::strtod(word.c_str(), &end);
        if (*end == '\0') {
            all.emplace_back(number);
        } else {
            all.emplace_back(word);
        }
    }
    return all;
}

}  // namespace

void add_opening_flag(CLI::App& command, std::vector<std::string>& messages) {
    command.add_option("--with", messages,
                       "how it is played, as messages: '/nuance accent left', '/tempo 2 8' (all of "
                       "docs/osc-protocol.md on how it plays)");
}

void obey(Steering& steering, const std::vector<std::string>& messages) {
    for (const std::string& message : messages) {
        std::istringstream words(message);
        std::string path;
        words >> path;
        const auto said = osc::understand(path, arguments(words));
        if (const auto* refusal = std::get_if<osc::Refusal>(&said)) {
            throw std::invalid_argument("'" + message + "': " + refusal->reason);
        }
        if (!steering.obey(std::get<osc::Command>(said))) {
            throw std::invalid_argument("'" + message + "': expected a message on how it plays");
        }
    }
}

}  // namespace percussionist::app
