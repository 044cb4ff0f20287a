#include "app/kit_server.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "files/kit_file.hpp"
#include "support/running_server.hpp"

using namespace percussionist;
using test::OscListener;

namespace {

using RunningKit = test::Running<app::KitServer, app::KitServeOptions>;

osc::Packet note(double key, double velocity, const std::string& sound) {
    return osc::encode_message("/note", std::vector<osc::Argument>{key, velocity, sound});
}

}  // namespace

TEST_CASE("kit server: tells the kit, what moves of it, and every stroke once") {
    RunningKit kit;
    OscListener all(kit.port());
    OscListener sounds(kit.port());  // a hurried server floods who wants poses
    REQUIRE(all.subscribes("all"));
    REQUIRE(sounds.subscribes("sound"));
    all.send("/play");
    REQUIRE(all.hears("/finished"));
    CHECK(all.hears("/kit/object", 11));
    CHECK(all.hears("/kit/event", 16));
    CHECK(all.hears("/kit/pedal", 2));
    CHECK(all.count("/pose") > 1000);
    CHECK(all.count("/object") > 1000);
    CHECK(all.hears("/tick", 100));
    CHECK(sounds.hears_contacts(150));
    kit.end();
    CHECK(sounds.contacts().size() == 150);
    CHECK(kit.server().summary().contacts == 150);
    CHECK(kit.server().summary().worst_error < 1e-3);
}

TEST_CASE("kit server: his body plays: what is told of a contact is what it felt, soon enough") {
    app::KitServeOptions options;
    options.simulated = true;
    RunningKit kit(options);
    OscListener sounds(kit.port());
    REQUIRE(sounds.subscribes("sound"));
    sounds.send("/play");
    REQUIRE(sounds.hears_contacts(12));
    kit.end();
    const app::TimingSummary summary = kit.server().summary();
    CHECK(summary.contacts >= 12);
    CHECK(summary.worst_error < 5e-3);
    CHECK(summary.worst_error > 1e-6);  // physics, not the plan
    CHECK(kit.server().player().passed_over() == 0);
}

TEST_CASE("kit server: a live note is a contact, at once or with its stroke, and never both") {
    for (const char* sound : {"now", "contact"}) {
        RunningKit kit;
        OscListener sounds(kit.port());
        REQUIRE(sounds.subscribes("sound"));
        sounds.send(note(38, 100, sound));
        REQUIRE(sounds.hears("/noted"));
        const int statuses = sounds.count("/status");
        REQUIRE(sounds.hears("/status", statuses + 3));
        CHECK(sounds.contacts().size() == 1);
    }
}

TEST_CASE("kit server: a note that has sounded is nobody's contact; a key of no event is refused") {
    RunningKit kit;
    OscListener sounds(kit.port());
    REQUIRE(sounds.subscribes("sound"));
    sounds.send(note(38, 100, "none"));
    REQUIRE(sounds.hears("/noted"));
    sounds.send(note(99, 100, "now"));
    REQUIRE(sounds.hears("/error"));
    sounds.send("/grip", {"french"});
    REQUIRE(sounds.hears("/error", 2));
    const int statuses = sounds.count("/status");
    REQUIRE(sounds.hears("/status", statuses + 2));
    CHECK(sounds.contacts().empty());
}

TEST_CASE("kit server: told where a song is it goes on from there; paused it stays") {
    RunningKit kit;
    OscListener sounds(kit.port());
    REQUIRE(sounds.subscribes("sound"));
    sounds.send(osc::encode_message("/song/position", std::vector<osc::Argument>{5.0}));
    REQUIRE(sounds.hears("/contact"));
    sounds.send(osc::encode_message("/song/pause", std::vector<osc::Argument>{7.0}));
    const int ticks = sounds.count("/tick");
    REQUIRE(sounds.hears("/tick", ticks + 20));
    sounds.send(osc::encode_message("/song/position", std::vector<osc::Argument>{5.0, 1e6}));
    CHECK(sounds.hears("/error"));  // a time that is not this server's
    kit.end();
    CHECK(kit.server().position() == 7.0);
}

TEST_CASE(
    "kit server: a pose is shown, turned and saved with the kit; the name stays in the folder") {
    const auto folder = std::filesystem::temp_directory_path() / "percussionist-kits";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    app::KitServeOptions options;
    options.score_folder = folder;
    RunningKit kit(options);
    OscListener editor(kit.port());
    REQUIRE(editor.subscribes("sound"));
    editor.send(
        osc::encode_message("/pose/joint", std::vector<osc::Argument>{"elbow", .1, .2, .3}));
    REQUIRE(editor.hears("/error", 1));
    editor.send("/pose/show", {"right-hand", "kick", "up"});
    REQUIRE(editor.hears("/error", 2));
    editor.send("/pose/show", {"right-hand", "ride", "up"});
    editor.send(
        osc::encode_message("/pose/joint", std::vector<osc::Argument>{"elbow", .1, .2, .3}));
    editor.send(osc::encode_message(
        "/script", std::vector<osc::Argument>{"wrist", "down", 0.0, 0.25, 0.5, 1.0}));
    editor.send("/kit/save", {"mine"});
    REQUIRE(editor.hears("/reply"));
    editor.send("/kit/save", {"../mine"});
    REQUIRE(editor.hears("/error", 3));
    const score::Kit saved = files::read_kit_file(folder / "mine.kit");
    REQUIRE(saved.poses.size() == 1);
    CHECK(saved.poses[0].joint == "elbow");
    CHECK(saved.poses[0].up);
    CHECK((saved.poses[0].angles - linear::Vector3(0.1, 0.2, 0.3)).norm() < 1e-3);
    CHECK(saved.scripts.size() == files::standard_kit().scripts.size());
    CHECK(saved.scripts.back().curve == std::vector<double>{0.0, 0.25, 0.5, 1.0});
    kit.end();
    std::filesystem::remove_all(folder);
}
