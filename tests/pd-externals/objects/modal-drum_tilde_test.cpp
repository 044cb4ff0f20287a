#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"

extern "C" void setup_modal0x2ddrum_tilde();

using namespace percussionist::pdx;

namespace {

FakeObject* create(FakeHost& host, std::vector<Atom> arguments = {}) {
    if (!find_class("modal-drum~")) {
        setup_modal0x2ddrum_tilde();
    }
    return host.create("modal-drum~", std::move(arguments));
}

std::size_t onset(const std::vector<Sample>& sound, std::size_t from = 0) {
    return static_cast<std::size_t>(std::find_if(sound.begin() + static_cast<long>(from),
                                                 sound.end(), [](Sample x) { return x != 0; }) -
                                    sound.begin());
}

Sample peak(const std::vector<Sample>& sound) {
    Sample most = 0;
    for (const Sample x : sound) {
        most = std::max(most, std::abs(x));
    }
    return most;
}

}  // namespace

TEST_CASE("a stroke sounds from the sample of its message on, in blocks of any size") {
    for (const std::size_t over : {1u, 2u}) {
        for (const std::size_t block : {1u, 64u, 1024u}) {
            FakeHost host;
            auto& drum = *create(host);
            host.start_dsp(block, over);
            host.advance_to(5003.0 / 48000);
            drum.message("strike", {1.5, 0.1, 0.5, 0.02});
            host.advance_to(0.3);
            CHECK(onset(drum.output(0)) == 5003 * over);
        }
    }
}

TEST_CASE("two strokes within one block are two, each at its own sample") {
    const auto rendered = [](bool both) {
        FakeHost host;
        auto& drum = *create(host);
        host.start_dsp();
        host.advance_to(1003.0 / 48000);
        drum.message("strike", {1.0});
        host.advance_to(1014.0 / 48000);
        if (both) {
            drum.message("strike", {1.0, 0.3});
        }
        host.advance_to(0.1);
        return drum.output(0);
    };
    const auto one = rendered(false), two = rendered(true);
    CHECK(onset(one) == 1003);
    CHECK(std::mismatch(one.begin(), one.end(), two.begin()).first - one.begin() == 1014);
}

TEST_CASE("a hand laid before signals are on lies there at whatever rate they come") {
    for (const double rate : {44100.0, 48000.0, 96000.0}) {
        const auto rendered = [rate](bool before) {
            FakeHost host(rate);
            auto& drum = *create(host);
            const auto lay = [&] {
                drum.message("hand", {1.0, 0.1, 0.0});
                drum.message("hand", {2.0, 0.2, 1.0});
                drum.message("lift", {2.0});
            };
            before ? lay() : host.start_dsp();
            before ? host.start_dsp() : lay();
            drum.message("strike", {2.0});
            host.advance_to(0.1);
            return drum.output(0);
        };
        CAPTURE(rate);
        CHECK(rendered(true) == rendered(false));
    }
}

TEST_CASE("a pickup that was placed stays where it is; those that were not follow the radius") {
    using Messages = std::vector<std::pair<std::string, std::vector<Atom>>>;
    const auto rendered = [](const Messages& messages, std::size_t outlet) {
        FakeHost host;
        auto& drum = *create(host, {0.3, 3500.0, 0.26, 2.0});
        host.start_dsp();
        for (const auto& [selector, atoms] : messages) {
            drum.message(selector, atoms);
        }
        drum.message("strike", {2.0, 0.1, 0.5});
        host.advance_to(0.1);
        return drum.output(outlet);
    };
    const Messages::value_type radius{"radius", {0.2}};
    for (const std::string what : {"pickup", "pickup-position", "pickup-pressure"}) {
        const Messages::value_type place{what, {0.05, 0.3, 2.0}};
        CAPTURE(what);
        CHECK(rendered({place, radius}, 1) == rendered({radius, place}, 1));
        CHECK(rendered({place, radius}, 0) == rendered({radius}, 0));
    }
}

TEST_CASE("every bad message gets one error and changes nothing") {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const std::vector<std::pair<std::string, std::vector<Atom>>> bad = {
        {"strike", {}},
        {"strike", {"hard"}},
        {"strike", {nan}},
        {"strike", {-1.0}},
        {"strike", {0.0}},
        {"strike", {1e9}},
        {"strike", {1.0, -0.1}},
        {"strike", {1.0, 0.1, inf}},
        {"strike", {1.0, 0.1, 0.0, 0.0}},
        {"strike", {1.0, 0.1, 0.0, 0.01, 5.0}},
        {"mallet", {0.01}},
        {"mallet", {0.01, -1.0}},
        {"mallet", {0.01, 1e8, 0.5}},
        {"radius", {0.0}},
        {"radius", {nan}},
        {"tension", {-3.0}},
        {"density", {"heavy"}},
        {"decay", {1.0}},
        {"decay", {0.1, 1.0}},
        {"modes", {0.0}},
        {"modes", {1e6}},
        {"pickup", {-1.0}},
        {"mute", {0.0}},
        {"bang", {1.0}},
        {"float", {3.0}},
        {"dsp", {}},
        {"nonsense", {1.0}},
    };
    FakeHost host, other;
    auto& drum = *create(host);
    auto& untouched = *create(host);
    host.start_dsp();
    for (const auto& [selector, atoms] : bad) {
        CAPTURE(selector);
        drum.message(selector, atoms);
        const auto errors = host.errors();
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].find("modal-drum~: ") == 0);
        CHECK(errors[0].find(selector) != std::string::npos);
    }
    drum.message("strike", {2.0});
    untouched.message("strike", {2.0});
    host.advance_to(0.1);
    CHECK(drum.output(0) == untouched.output(0));
    drum.message("tension", {-3.0});
    CHECK(host.errors().at(0) ==
          "modal-drum~: tension: expected a number from 0.1 to 1e+06 [N/m], got -3");
    drum.message("decay", {0.1, 1.0});
    CHECK(host.errors().at(0).find("modal-drum~: decay: expected t60 ") == 0);
}

TEST_CASE("a drum that cannot be is not made, and says why") {
    FakeHost host;
    CHECK(create(host, {-0.3}) == nullptr);
    CHECK(host.errors().at(0) ==
          "modal-drum~: radius: expected a number from 0.01 to 5 [m], got -0.3");
    CHECK(create(host, {"big"}) == nullptr);
    CHECK(create(host, {0.3, 3500.0, 0.26, 9.0}) == nullptr);
    CHECK(create(host, {0.3, 3500.0, 0.26, 1.0, 1.0}) == nullptr);
    CHECK(create(host, {0.3, 3500.0, 0.26}) != nullptr);
}

TEST_CASE("every setting may be changed while it sounds") {
    FakeHost host;
    auto& drum = *create(host);
    host.start_dsp();
    drum.message("strike", {2.0});
    host.advance_to(0.01);
    const std::vector<std::pair<std::string, std::vector<Atom>>> settings = {
        {"radius", {0.2}},    {"tension", {2000.0}},
        {"density", {0.5}},   {"decay", {3.0, 0.5}},
        {"modes", {64.0}},    {"pickup", {0.05, 1.0}},
        {"position", {0.02}}, {"mallet", {0.03, 1e6}},
        {"mute", {0.2}},      {"strike", {1.0, 9.0 / 2}},
        {"bang", {}},
    };
    for (const auto& [selector, atoms] : settings) {
        drum.message(selector, atoms);
        CHECK(host.errors().empty());
        host.advance_to(host.now() + 0.01);
    }
    const auto& sound = drum.output(0);
    CHECK(std::all_of(sound.begin(), sound.end(), [](Sample x) { return std::abs(x) <= 1; }));
    CHECK(peak(sound) > Sample(0.05));
    drum.message("reset");
    host.run_tick();
    CHECK(drum.output(0).back() == 0);
    drum.message("print");
    CHECK(host.posts().at(0).find("modal-drum~: 64 modes from ") == 0);
}

TEST_CASE("strokes sent while signals are off are forgotten, and too many are refused") {
    FakeHost host;
    auto& drum = *create(host);
    for (int i = 0; i < 64; ++i) {
        drum.message("bang");
    }
    CHECK(host.errors().empty());
    drum.message("bang");
    CHECK(host.errors().size() == 1);
    host.advance_to(1.0);
    host.start_dsp();
    host.advance_to(1.1);
    CHECK(peak(drum.output(0)) == 0);
    drum.message("bang");
    host.advance_to(1.2);
    CHECK(peak(drum.output(0)) > Sample(0.1));
}
