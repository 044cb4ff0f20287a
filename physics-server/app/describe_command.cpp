#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "osc/address_table.hpp"

namespace percussionist::app {

void add_describe_command(CLI::App& program) {
    CLI::App& command = *program.add_subcommand(
        "describe", "what the server understands over OSC, as the table of docs/osc-protocol.md");
    command.callback([] {
        for (const osc::Address& address : osc::address_table()) {
            fmt::print("| `{}` | {} |\n", osc::usage(address), address.description);
        }
    });
}

}  // namespace percussionist::app
