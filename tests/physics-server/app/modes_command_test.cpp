#include "app/commands.hpp"

#include <doctest/doctest.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "core/modal/drum_set.hpp"
#include "core/modal/mode_file.hpp"

using namespace percussionist;

namespace {

class Folder {
  public:
    Folder() : path_(std::filesystem::temp_directory_path() / "percussionist-modes-test") {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

void run(const std::string& line) {
    CLI::App program;
    app::add_modes_command(program);
    app::add_drum_command(program);
    program.parse(line);
}

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string fault(const std::string& line) {
    try {
        run(line);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the modes of a computed drum are measured from recordings made of it") {
    const Folder folder;
    run("drum tom-low --modes 8 -o " + folder / "tom.modes" + " --strokes " + folder / "hit");
    std::string hits;
    for (int i = 0; i < 6; ++i) {
        hits += " " + folder / ("hit" + std::to_string(i) + ".wav");
    }
    run("modes" + hits + " --positions 0,0.2,0.4,0.6,0.8,0.95 --low 60 --high 400 -o " +
        folder / "found.modes" + " --picture " + folder / "found.svg" + " --resynthesis " +
        folder / "again");
    const auto computed = modal::parse_modes(text_of(folder / "tom.modes"));
    const auto found = modal::parse_modes(text_of(folder / "found.modes"));
    REQUIRE(found.modes.size() >= 4);
    for (const auto& mode : found.modes) {
        double nearest = 1.0;
        for (const auto& own : computed.modes) {
            nearest = std::min(nearest, std::abs(mode.frequency / own.frequency - 1));
        }
        CHECK(nearest < 0.002);
    }
    CHECK(text_of(folder / "found.svg").find("<svg") == 0);
    CHECK(std::filesystem::file_size(folder / "again5.wav") > 100000);
}

TEST_CASE("what cannot be done is said in one line") {
    const Folder folder;
    CHECK(fault("drum kazoo -o " + folder / "x").find("no drum 'kazoo'; there are: bodhran") == 0);
    CHECK(fault("modes a.wav b.wav --positions 0 -o " + folder / "x") ==
          "modes: 2 recordings, but 1 positions");
    CHECK(fault("modes /no/such.wav --positions 0 -o " + folder / "x").find("/no/such.wav") !=
          std::string::npos);
    CHECK(fault("drum snare -o /no/such/folder/x") == "/no/such/folder/x: cannot be written");
}

TEST_CASE("the mode files that come along are those the command makes, and say they are computed") {
    for (const auto& drum : modal::drum_set()) {
        const auto file = text_of(PERCUSSIONIST_SOURCE_DIR "/drums/" + drum.name + ".modes");
        CHECK(file == modal::write_modes(modal::computed_modes(drum, 240)));
        CHECK(modal::parse_modes(file).origin.find("computed: ") == 0);
    }
}
