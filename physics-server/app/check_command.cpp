#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/sound_check.hpp"

namespace percussionist::app {

void add_check_command(CLI::App& program) {
    struct Files {
        std::filesystem::path recording, contacts;
    };
    auto files = std::make_shared<Files>();
    CLI::App& command = *program.add_subcommand(
        "check", "how well a recording agrees with the contacts of its performance");
    command.add_option("recording", files->recording, "audio file")->required();
    command.add_option("contacts", files->contacts, "contacts.csv, as serve and render write it")
        ->required();
    command.callback(
        [files] { fmt::print("{}", describe(check_sound(files->recording, files->contacts))); });
}

}  // namespace percussionist::app
