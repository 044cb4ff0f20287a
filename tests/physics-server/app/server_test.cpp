#include "app/server.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/route_file.hpp"
#include "support/running_server.hpp"

using namespace percussionist;
using test::OscListener;

namespace {

using RunningServer = test::Running<app::Server, app::ServeOptions>;

}  // namespace

TEST_CASE("server: two subscribers hear every contact, poses and status only whom they concern") {
    RunningServer server;
    OscListener sound(server.port());
    OscListener all(server.port());
    REQUIRE(sound.subscribes("sound"));
    REQUIRE(all.subscribes("all"));
    sound.send("/play");
    REQUIRE(sound.hears("/finished"));
    REQUIRE(all.hears("/finished"));
    CHECK(sound.contacts().size() == 153);
    CHECK(all.contacts() == sound.contacts());
    CHECK(sound.count("/pose") == 0);
    CHECK(all.count("/pose") > 1000);
}

TEST_CASE("server: of two viewers and two that sound, one of each dies; the others hear all") {
    RunningServer server;
    OscListener sound(server.port()), viewer(server.port());
    auto dying_sound = std::make_unique<OscListener>(server.port());
    auto dying_viewer = std::make_unique<OscListener>(server.port());
    for (OscListener* one : {&sound, dying_sound.get()}) REQUIRE(one->subscribes("sound"));
    for (OscListener* one : {&viewer, dying_viewer.get()}) REQUIRE(one->subscribes("all"));
    sound.send("/play");
    REQUIRE(dying_sound->hears("/contact", 5));
    dying_sound.reset();
    dying_viewer.reset();
    REQUIRE(sound.hears("/finished"));
    REQUIRE(viewer.hears("/finished"));
    CHECK(sound.contacts().size() == 153);
    CHECK(viewer.contacts() == sound.contacts());
    CHECK(viewer.count("/dropped") >= 2);
}

TEST_CASE("server: answers ping and describe; what it cannot understand it says to the sender") {
    RunningServer server;
    OscListener asker(server.port());
    asker.send("/ping");
    CHECK(asker.hears("/pong"));
    asker.send("/describe");
    CHECK(asker.hears("/description", static_cast<int>(osc::address_table().size())));
    asker.send("/tempo", {"fast"});
    CHECK(asker.hears("/error"));
    asker.send(osc::Packet{'x', 'y', 'z', 0});
    CHECK(asker.hears("/error", 2));
}

TEST_CASE("server: a score outside its folder, or none, is refused and the old one plays on") {
    const auto folder = std::filesystem::temp_directory_path() / "percussionist-scores";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "broken.mid") << "MThd and nothing more";
    app::ServeOptions options;
    options.score_folder = folder;
    RunningServer server(options);
    OscListener asker(server.port());
    REQUIRE(asker.subscribes("sound"));
    int errors = 0;
    for (const char* name : {"../../etc/passwd", "nowhere.mid", "broken.mid"}) {
        asker.send("/score", {name});
        CHECK(asker.hears("/error", ++errors));
    }
    asker.send("/play");
    CHECK(asker.hears("/contact", 3));
    std::filesystem::remove_all(folder);
}

TEST_CASE("server: who plays as soon as a score is said to be loaded hears all of it") {
    RunningServer server;
    OscListener asker(server.port());
    REQUIRE(asker.subscribes("sound"));
    for (int i = 1; i <= 8; ++i) {
        asker.send("/score", {"built-in"});
        REQUIRE(asker.hears("/reply", i));
        const auto before = asker.contacts().size();
        asker.send("/play");
        CHECK(asker.hears_contacts(before + 8));
    }
}

TEST_CASE("server: unsubscribed, one hears no more") {
    RunningServer server;
    OscListener asker(server.port());
    REQUIRE(asker.subscribes("sound"));
    asker.send(osc::encode_message("/unsubscribe",
                                   std::vector<osc::Argument>{static_cast<double>(asker.port())}));
    asker.send("/ping");
    REQUIRE(asker.hears("/pong"));
    // What was under way has arrived before the answer to a later ping.
    asker.send("/ping");
    REQUIRE(asker.hears("/pong", 2));
    const int before = asker.count("/status");
    for (int i = 3; i < 60; ++i) {
        asker.send("/ping");
        REQUIRE(asker.hears("/pong", i));
    }
    CHECK(asker.count("/status") <= before + 1);
}

TEST_CASE("server: a route sends what it names to whom it names, until it is removed") {
    RunningServer server;
    OscListener asker(server.port());
    OscListener target(server.port());
    const std::string to = " to 127.0.0.1:" + std::to_string(target.port());
    asker.send("/route/add", {"contact" + to + " /hard velocity when velocity 2 99"});
    asker.send("/route/add", {"contact" + to + " /any"});
    asker.send("/route/add", {"strike" + to + " /soon hand ahead"});
    asker.send("/route/add", {"pose" + to + " /stick x y z when body right_stick"});
    REQUIRE(asker.hears("/route", 4));
    asker.send("/play");
    REQUIRE(target.hears("/any", 20));
    CHECK(target.count("/soon") >= 20);
    CHECK(target.count("/hard") > 0);
    CHECK(target.count("/hard") < target.count("/any"));
    CHECK(target.hears("/stick"));
    asker.send(osc::encode_message("/route/remove", std::vector<osc::Argument>{4.0}));
    REQUIRE(asker.hears("/reply"));
    asker.send("/route/list");
    REQUIRE(asker.hears("/route", 7));
}

TEST_CASE("server: nobody can have a third party sent to") {
    RunningServer server;
    OscListener asker(server.port());
    asker.send("/route/add", {"contact to 10.1.2.3:9000 /hit"});
    asker.send(osc::encode_message(
        "/subscribe",
        std::vector<osc::Argument>{9000.0, std::string("all"), std::string("10.1.2.3")}));
    REQUIRE(asker.hears("/error", 2));
    CHECK(asker.texts("/error").at(1).find("--allow") != std::string::npos);
    CHECK(asker.texts("/error").at(3).find("--allow") != std::string::npos);
}

TEST_CASE("server: routes are saved by a plain name, and nowhere else") {
    const auto folder = std::filesystem::temp_directory_path() / "percussionist-routes";
    std::filesystem::create_directories(folder);
    app::ServeOptions options;
    options.score_folder = folder;
    RunningServer server(options);
    OscListener asker(server.port());
    asker.send("/route/add", {"status to 127.0.0.1:9000 /s load*100"});
    REQUIRE(asker.hears("/route"));
    asker.send("/route/save", {"../escape"});
    REQUIRE(asker.hears("/error"));
    asker.send("/route/save", {"mine"});
    REQUIRE(asker.hears("/reply"));
    const auto saved = app::read_routes(folder / "mine.routes");
    REQUIRE(saved.size() == 1);
    CHECK(saved[0] == "status to 127.0.0.1:9000 /s load*100");
    std::filesystem::remove_all(folder);
}

TEST_CASE("server: a listener that has gone is dropped, and the others are told") {
    RunningServer server;
    OscListener stays(server.port());
    REQUIRE(stays.subscribes("sound"));
    int gone = 0;
    {
        OscListener leaves(server.port());
        REQUIRE(leaves.subscribes("sound"));
        gone = leaves.port();
    }
    REQUIRE(stays.hears("/dropped"));
    CHECK(stays.texts("/dropped").at(1) == std::to_string(gone));
}

TEST_CASE(
    "server: held up for a second or an hour it pauses, reports late steps, and plays every "
    "stroke") {
    for (const double seconds : {1.0, 3600.0}) {
        RunningServer running;
        OscListener listener(running.port());
        REQUIRE(listener.subscribes("sound"));
        listener.send("/play");
        REQUIRE(listener.hears("/contact", 20));
        running.clock().jump(seconds);
        REQUIRE(listener.hears("/finished"));
        CHECK(listener.contacts().size() == 153);
        running.end();
        const sim::Simulation& simulation = running.server().performance().simulation();
        CHECK(running.server().late_steps() >=
              static_cast<int>(0.9 * seconds / simulation.step_length()));
        // The pause is none of simulated time: strokes keep their distances.
        CHECK(simulation.time() < 600.0);
        CHECK(running.server().performance().summary().worst_error < 0.02);
    }
}

TEST_CASE("server: a port that is taken is one clear error") {
    test::HurriedClock clock;
    app::ServeOptions options;
    options.endpoint.port = 0;
    app::Server first(options, clock);
    options.endpoint.port = first.port();
    try {
        app::Server second(options, clock);
        FAIL("two servers on one port");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find(std::to_string(first.port())) != std::string::npos);
    }
}

TEST_CASE("server: a missing score is one clear error that names it") {
    test::HurriedClock clock;
    app::ServeOptions options;
    options.endpoint.port = 0;
    options.score = "no-such-file.mid";
    try {
        app::Server server(options, clock);
        FAIL("accepted");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find("no-such-file.mid") != std::string::npos);
    }
}
