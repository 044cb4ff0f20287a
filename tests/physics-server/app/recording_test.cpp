#include <doctest/doctest.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "app/named_file.hpp"
#include "app/recorder.hpp"
#include "app/server.hpp"
#include "app/simulation_flags.hpp"
#include "app/tape.hpp"
#include "app/told_comparison.hpp"
#include "support/running_server.hpp"

using namespace percussionist;
using test::HurriedClock;
using test::OscListener;

namespace {

struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "percussionist-takes";
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

/// Runs a server while `act` tells it things; the contacts it made.
std::vector<app::LoggedContact> perform(app::ServeOptions options,
                                        const std::function<void(OscListener&)>& act) {
    options.endpoint.port = 0;
    HurriedClock clock;
    app::Server server(options, clock);
    std::atomic<bool> stop{false};
    std::thread thread([&] { server.run(stop); });
    OscListener client(server.port());
    REQUIRE(client.subscribes("sound"));
    act(client);
    stop = true;
    thread.join();
    return server.performance().log().contacts();
}

struct Replayed {
    std::vector<app::LoggedContact> contacts;
    bool same = false;
    std::string words;
};

Replayed replay(files::Recording take) {
    const auto shared = std::make_shared<const files::Recording>(std::move(take));
    const auto& settings = shared->records.front().bytes;
    app::ToldComparison comparison(*shared);
    app::ServeOptions options;
    options.endpoint.port = 0;
    options.replay = shared;
    options.simulation = app::simulation_of({settings.begin(), settings.end()}, "take");
    options.told = [&](std::int64_t step, const osc::Packet& p) { comparison.told(step, p); };
    HurriedClock clock;
    app::Server server(options, clock);
    server.run(std::atomic<bool>{false});
    return {server.performance().log().contacts(), comparison.same(), comparison.describe()};
}

void send_tempo(OscListener& client, double factor) {
    client.send(osc::encode_exactly("/tempo", std::vector<osc::Argument>{factor}));
}

}  // namespace

TEST_CASE("a recording played again makes the same contacts and poses to the last bit") {
    const Folder folder;
    app::ServeOptions options;
    options.recording = folder.path / "take.recording";
    options.settings = "--rate\n500\n--law\npaper\n";
    options.simulation = app::simulation_of(options.settings, "test");
    const auto live = perform(options, [](OscListener& client) {
        send_tempo(client, 1.0 / 3.0 + 1.0);
        client.send("/play");
        REQUIRE(client.hears("/contact", 9));
        send_tempo(client, 0.9);
        REQUIRE(client.hears("/contact", 15));
        client.send("/stop");
        client.send("/play");
        // More than can have been under way when it began anew.
        REQUIRE(client.hears_contacts(client.contacts().size() + 6));
    });
    const files::Recording take = files::read_recording(options.recording);
    CHECK(!take.cut);
    const Replayed again = replay(take);
    CHECK_MESSAGE(again.same, again.words);
    REQUIRE(live.size() == again.contacts.size());
    REQUIRE(!live.empty());
    for (std::size_t i = 0; i < live.size(); ++i) {
        CHECK(live[i].event.instant == again.contacts[i].event.instant);
        CHECK(live[i].event.impulse == again.contacts[i].event.impulse);
        CHECK(live[i].event.velocity == again.contacts[i].event.velocity);
    }
}

TEST_CASE("a recording begun and ended while all plays is played again from the start of the run") {
    const Folder folder;
    app::ServeOptions options;
    options.score_folder = folder.path;
    perform(options, [](OscListener& client) {
        client.send("/play");
        send_tempo(client, 1.1);
        REQUIRE(client.hears("/contact", 4));
        client.send("/record", {"late"});
        REQUIRE(client.hears("/reply"));
        // More than can have been under way when it was begun.
        REQUIRE(client.hears_contacts(client.contacts().size() + 6));
        client.send("/record", {"another"});
        REQUIRE(client.hears("/error"));
        client.send("/record", {"../outside"});
        REQUIRE(client.hears("/error", 2));
        client.send("/record");
        REQUIRE(client.hears("/reply", 2));
        client.send("/record");
        REQUIRE(client.hears("/error", 3));
    });
    files::Recording take = files::read_recording(folder.path / "late.recording");
    const Replayed again = replay(take);
    CHECK_MESSAGE(again.same, again.words);
    CHECK(!again.contacts.empty());

    // One bit of one pose makes it another.
    for (files::Record& record : take.records) {
        if (record.kind != files::RecordKind::told) continue;
        record.bytes.back() ^= 1;
        break;
    }
    CHECK(!replay(take).same);
}

TEST_CASE("what is recorded of a recording played again is that recording") {
    const Folder folder;
    app::ServeOptions options;
    options.recording = folder.path / "first.recording";
    perform(options, [](OscListener& client) {
        send_tempo(client, 1.1);
        client.send("/play");
        REQUIRE(client.hears_contacts(12));
    });
    options = {};
    options.replay = std::make_shared<const files::Recording>(
        files::read_recording(folder.path / "first.recording"));
    options.recording = folder.path / "second.recording";
    options.endpoint.port = 0;
    HurriedClock clock;
    app::Server(options, clock).run(std::atomic<bool>{false});
    const Replayed again = replay(files::read_recording(options.recording));
    CHECK_MESSAGE(again.same, again.words);
    CHECK(again.contacts.size() >= 12);
}

TEST_CASE("a recording asked for over OSC replaces no file and follows no link") {
    const Folder folder;
    const auto outside = folder.path / "outside";
    std::ofstream(outside) << "as it was";
    std::ofstream(folder.path / "taken.recording") << "as it was";
    std::filesystem::create_symlink(outside, folder.path / "link.recording");
    std::filesystem::create_symlink(folder.path / "nowhere", folder.path / "loose.recording");
    app::ServeOptions options;
    options.score_folder = folder.path;
    perform(options, [](OscListener& client) {
        int errors = 0;
        for (const char* name : {"taken", "link", "loose"}) {
            client.send("/record", {name});
            REQUIRE(client.hears("/error", ++errors));
        }
        client.send("/record", {"free"});
        REQUIRE(client.hears("/reply"));
    });
    CHECK(std::filesystem::exists(folder.path / "free.recording"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "nowhere"));
    for (const auto& file : {outside, folder.path / "taken.recording"}) {
        std::ifstream in(file);
        CHECK(std::string(std::istreambuf_iterator<char>(in), {}) == "as it was");
    }
}

TEST_CASE("what a run is told is kept in bounded memory; beyond that no recording begins late") {
    const Folder folder;
    app::Tape tape("");
    const app::ScoreSource score{"long.wav", std::vector<char>(app::Tape::kMostKept / 4)};
    for (int i = 0; i < 3; ++i) tape.loaded(i, score);
    CHECK_NOTHROW(tape.require_idle());
    tape.loaded(4, score);
    CHECK_THROWS_AS(tape.begin(folder.path / "late.recording"), std::runtime_error);
}

TEST_CASE("on a disk that is nearly full a recording ends early, whole up to there, and says so") {
    const Folder folder;
    const auto path = folder.path / "full.recording";
    constexpr std::uintmax_t kMoreThanThereIs = std::uintmax_t{1} << 62U;
    app::Recorder recorder(path, kMoreThanThereIs);
    recorder.add({files::RecordKind::settings, 0, {}});
    const std::string fault = recorder.finish(1);
    CHECK(fault.find("nearly full") != std::string::npos);
    CHECK(fault.find("full.recording") != std::string::npos);
}

TEST_CASE("a file that is named alone lies on a disk too, which may be full") {
    const Folder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    std::string fault;
    {
        app::Recorder recorder("full.recording", std::uintmax_t{1} << 62U);
        recorder.add({files::RecordKind::settings, 0, {}});
        fault = recorder.finish(1);
        for (int i = 0; i < 100; ++i) std::ofstream(std::to_string(i) + ".kit") << "";
        CHECK_THROWS_AS(app::require_room("another.kit"), std::runtime_error);
    }
    std::filesystem::current_path(before);
    CHECK(fault.find("nearly full") != std::string::npos);
}

TEST_CASE("a recording takes a score of any size") {
    const Folder folder;
    const auto path = folder.path / "large.recording";
    app::Recorder recorder(path, 0);
    const std::vector<char> score(70U << 20U);
    recorder.add({files::RecordKind::settings, 0, {}});
    recorder.add({files::RecordKind::score, 0, files::pack_score("long.wav", score)});
    recorder.add({files::RecordKind::told, 1, {}});
    CHECK(recorder.finish(1).empty());
    CHECK(std::filesystem::file_size(path) > score.size());
}

TEST_CASE("what a body is made of is kept as it was given") {
    CLI::App program;
    sim::SimulationOptions given;
    app::add_simulation_flags(program, given);
    program.parse("--rate 1234.5 --law paper --stature 1.6", false);
    const auto again = app::simulation_of(app::simulation_settings(program), "test");
    CHECK(again.rate == given.rate);
    CHECK(again.control.law == given.control.law);
    CHECK(again.person.stature == given.person.stature);
    CHECK(again.person.mass == sim::SimulationOptions().person.mass);
    CHECK_THROWS_AS(app::simulation_of("--rate\nfast\n", "test"), std::runtime_error);
    CHECK_THROWS_AS(app::simulation_of("--no-such-flag\n", "test"), std::runtime_error);
}
