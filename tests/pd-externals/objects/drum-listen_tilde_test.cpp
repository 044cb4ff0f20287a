#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"

extern "C" void setup_drum0x2dlisten_tilde();

using namespace percussionist::pdx;

namespace {

struct Told {
    std::string selector;
    std::vector<Atom> atoms;
};

/// Told something, if anything, before signals are on.
FakeObject& make(FakeHost& host, const Told& first = {}) {
    if (!find_class("drum-listen~")) setup_drum0x2dlisten_tilde();
    FakeObject* const object = host.create("drum-listen~");
    REQUIRE(object);
    if (!first.selector.empty()) object->message(first.selector, first.atoms);
    host.start_dsp();
    return *object;
}

/// Silence, then a click: the inlet steps up for one tick.
void click(FakeHost& host, FakeObject& object) {
    object.input(0, 0.0F);
    host.advance_to(host.now() + 0.3);
    object.input(0, 0.8F);
    host.run_tick();
    object.input(0, 0.0F);
    host.advance_to(host.now() + 0.1);
}

double number_of(const Atom& atom) {
    return std::get<double>(atom);
}

}  // namespace

TEST_CASE("an attack is told within 12 ms and its age with it; drums within 60 ms") {
    FakeHost host;
    FakeObject& object = make(host);
    click(host, object);
    const double struck = host.now() - 0.1;
    const auto sent = object.sent();
    REQUIRE(!sent.empty());
    CHECK(sent.front().selector == "attack");
    CHECK(sent.front().time - struck < 0.0135);  // and the tick that a message takes
    CHECK(number_of(sent.front().atoms.at(0)) < 0.012);
    for (const Sent& s : sent) {
        if (s.selector == "attack") continue;
        CHECK(s.selector == "drum");
        REQUIRE(s.atoms.size() == 4);
        CHECK(number_of(s.atoms[1]) > 0.0);
        CHECK(number_of(s.atoms[2]) >= 0.5);
        CHECK(number_of(s.atoms[3]) < 0.060);
    }
}

TEST_CASE("a drum learnt, saved, forgotten and loaded is known again") {
    FakeHost host;
    FakeObject& object = make(host);
    const std::string file =
        (std::filesystem::temp_directory_path() / "drum-listen-test.txt").string();
    const auto own = [&] {
        click(host, object);
        int count = 0;
        for (const Sent& s : object.sent())
            count +=
                s.selector == "own" && std::string(std::get<const char*>(s.atoms.at(0))) == "click"
                    ? 1
                    : 0;
        return count;
    };
    CHECK(own() == 0);
    object.message("learn", {"click", 3.0});
    for (int stroke = 0; stroke < 3; ++stroke) click(host, object);
    object.sent();
    CHECK(own() == 1);
    object.message("save", {file.c_str()});
    object.message("forget");
    CHECK(own() == 0);
    object.message("load", {file.c_str()});
    CHECK(own() == 1);
    CHECK(host.errors().empty());
    std::remove(file.c_str());
}

TEST_CASE("a drum to be learnt before signals are on is learnt at whatever rate they come") {
    for (const double rate : {44100.0, 48000.0, 96000.0}) {
        FakeHost host(rate);
        FakeObject& object = make(host, {"learn", {"click", 3.0}});
        for (int stroke = 0; stroke < 3; ++stroke) click(host, object);
        object.message("print");
        CAPTURE(rate);
        CHECK(host.posts().back() == "drum-listen~: click, learnt from 3 strokes");
    }
}

TEST_CASE("a rate it cannot hear at is refused each time, and the one before stays") {
    FakeHost host;
    FakeObject& object = make(host);
    CHECK(host.errors().empty());
    for (int time = 0; time < 2; ++time) {
        host.start_dsp(64, 16);
        REQUIRE(host.errors().size() == 1);
    }
    host.start_dsp();
    click(host, object);
    CHECK(host.errors().empty());
    CHECK(!object.sent().empty());
}

TEST_CASE("files that are not there or are no drums are one clear error, and nothing is lost") {
    FakeHost host;
    FakeObject& object = make(host);
    object.message("load", {"/nowhere/drums.txt"});
    auto errors = host.errors();
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].find("/nowhere/drums.txt: cannot be opened") != std::string::npos);
    object.message("save", {"/nowhere/drums.txt"});
    CHECK(host.errors().size() == 1);
    object.message("learn", {"click", 0.0});
    CHECK(host.errors().size() == 1);
    click(host, object);
    CHECK(!object.sent().empty());
}
