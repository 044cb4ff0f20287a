#include "body/live_drummer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "body/animation_check.hpp"
#include "support/small_kit.hpp"

using namespace percussionist;
using body::KitContact;
using body::LiveDrummer;
using score::Limb;
using score::SongClock;
using score::SongStep;
using test::hat_and_snare;

namespace {

constexpr double kStep = 0.002;

/// A drummer, a song and its clock, stepped together.
struct Playing {
    LiveDrummer drummer{test::small_kit()};
    SongClock clock;
    std::vector<KitContact> contacts;
    double now = 0.0;
    double worst_off = 0.0;  ///< of a limb from its spot, at contacts [m]

    void run(double seconds) {
        for (const double end = now + seconds; now < end;) {
            now += kStep;
            drummer.step(now, clock.advance(now));
            for (const KitContact& c : drummer.contacts()) note(c);
        }
    }
    /// The limb at the contact's own instant, which lies within the step.
    void note(const KitContact& c) {
        contacts.push_back(c);
        const linear::Vector3 off =
            drummer.animation().limb_point(drummer.placement(), c.limb, c.event) -
            drummer.animation().target(c.limb, c.event);
        worst_off = std::max(worst_off, off.norm());
    }
    void play(const std::vector<score::KitStroke>& strokes) {
        drummer.load(strokes);
        clock.play(now, -1.0);
    }
};

}  // namespace

TEST_CASE("live drummer: each stroke of a song is one contact, at its time, the limb at its spot") {
    Playing p;
    const auto strokes = hat_and_snare(p.drummer.kit(), 40);
    p.play(strokes);
    p.run(12.0);
    REQUIRE(p.contacts.size() == strokes.size());
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        CHECK(std::abs(p.contacts[i].time - (strokes[p.contacts[i].stroke].time + 1.0)) < 1e-6);
    }
    CHECK(p.worst_off < 0.005);
    CHECK(p.drummer.passed_over() == 0);
}

TEST_CASE("live drummer: after a seek he is on time, in place, and strikes nothing twice at once") {
    for (const double to : {6.1, 1.05, 3.76}) {
        CAPTURE(to);
        Playing p;
        const auto strokes = hat_and_snare(p.drummer.kit(), 40);
        p.drummer.load(strokes);
        p.clock.told(0.0, 0.0, 3.0);
        p.run(1.3);
        const std::size_t before = p.contacts.size();
        const double sought = p.now;
        p.clock.told(p.now, p.now, to);
        p.run(2.0);
        CHECK(p.worst_off < 0.005);
        for (std::size_t i = before; i < p.contacts.size(); ++i) {
            const KitContact& c = p.contacts[i];
            // As the song goes since: on time.
            CHECK(std::abs(c.time - sought - (strokes[c.stroke].time - to)) < 2e-4);
            for (std::size_t j = before; j < i; ++j) CHECK(p.contacts[j].stroke != c.stroke);
        }
        // What was passed over is what fell before a limb could be there.
        CHECK(p.drummer.passed_over() <= 3);
        CHECK(p.contacts.size() - before >= 8);
    }
}

TEST_CASE("live drummer: followed with a drift, contacts keep to the player to a millisecond") {
    Playing p;
    const auto strokes = hat_and_snare(p.drummer.kit(), 200);
    p.drummer.load(strokes);
    constexpr double kRate = 1.001;
    for (double told = 0.0; told < 40.0; told += 0.1) {
        p.clock.told(p.now, p.now, kRate * p.now - 1.0);
        p.run(0.1);
    }
    REQUIRE(p.contacts.size() > 150);
    double worst = 0.0;
    for (const KitContact& c : p.contacts) {
        worst = std::max(worst, std::abs(kRate * c.time - 1.0 - strokes[c.stroke].time));
    }
    CHECK(worst < 0.001);
    CHECK(p.worst_off < 0.005);
    CHECK(p.drummer.passed_over() == 0);
}

TEST_CASE("live drummer: while the song stands nothing moves and nothing is struck") {
    Playing p;
    p.drummer.load(hat_and_snare(p.drummer.kit(), 40));
    p.clock.told(0.0, 0.0, 2.0);
    p.run(1.1);
    p.clock.hold(std::nullopt);
    p.run(0.01);
    const std::size_t before = p.contacts.size();
    const auto there = p.drummer.placement().orientation;
    p.run(1.0);
    CHECK(p.contacts.size() == before);
    for (std::size_t i = 0; i < there.size(); ++i) {
        CHECK(there[i].angularDistance(p.drummer.placement().orientation[i]) < 1e-9);
    }
}

TEST_CASE("live drummer: a live note is struck by a limb that is there, no faster than it can") {
    Playing p;
    p.run(0.1);
    const score::Kit& kit = p.drummer.kit();
    for (std::size_t event = 0; event < kit.events.size(); ++event) {
        CAPTURE(kit.events[event].name);
        const auto before = p.drummer.placement();
        const body::LiveStroke stroke = p.drummer.strike(event, 0.7, false);
        REQUIRE(stroke.limb);
        if (kit.events[event].foot) CHECK(*stroke.limb == *kit.events[event].foot);
        const double way = (p.drummer.animation().limb_point(before, *stroke.limb, event) -
                            p.drummer.animation().target(*stroke.limb, event))
                               .norm();
        CHECK(stroke.time - p.now >= 0.040 - 1e-9);
        if (score::is_hand(*stroke.limb)) CHECK(way / (stroke.time - p.now) <= kit.limits.speed);
        CHECK(stroke.time - p.now <= 0.35);
        const std::size_t count = p.contacts.size();
        p.run(0.5);
        REQUIRE(p.contacts.size() == count + 1);
        CHECK(p.contacts.back().time == stroke.time);
        CHECK(p.contacts.back().event == event);
        CHECK(p.contacts.back().stroke == -1);
    }
    CHECK(p.worst_off < 0.005);
}

TEST_CASE("live drummer: a fast roll of live notes goes from hand to hand") {
    Playing p;
    p.run(0.1);
    const std::size_t snare = *p.drummer.kit().event_named("snare");
    for (int i = 0; i < 16; ++i) {
        CHECK(p.drummer.strike(snare, 0.6, false).limb);
        p.run(0.09);
    }
    p.run(1.0);
    REQUIRE(p.contacts.size() == 16);
    const auto left = std::count_if(p.contacts.begin(), p.contacts.end(),
                                    [](const KitContact& c) { return c.limb == Limb::left_hand; });
    CHECK(left >= 6);
    CHECK(left <= 10);
    CHECK(p.worst_off < 0.005);
}

TEST_CASE("live drummer: live notes cost the song none of its strokes") {
    Playing p;
    const auto strokes = hat_and_snare(p.drummer.kit(), 40, 0.3);
    p.play(strokes);
    int seen = 0;
    const std::size_t tom = *p.drummer.kit().event_named("snare");
    for (int i = 0; i < 60; ++i) {
        p.run(0.217);
        seen += p.drummer.strike(tom, 0.5, true).limb ? 1 : 0;
    }
    p.run(2.0);
    const auto of_song = std::count_if(p.contacts.begin(), p.contacts.end(),
                                       [](const KitContact& c) { return c.stroke >= 0; });
    CHECK(of_song == static_cast<long>(strokes.size()));
    CHECK(static_cast<long>(p.contacts.size()) - of_song == seen);
    CHECK(seen > 20);
    CHECK(p.drummer.passed_over() == 0);
    CHECK(p.worst_off < 0.005);
}

TEST_CASE("live drummer: a pose that is edited holds from the next step on, and only that joint") {
    Playing p;
    p.drummer.show(body::ShownPose{Limb::right_hand, *p.drummer.kit().event_named("snare"), true});
    p.run(0.01);
    const auto before = p.drummer.placement();
    score::PoseEdit edit{
        Limb::right_hand, *p.drummer.kit().event_named("snare"), true, "elbow", {0.1, 0.2, 0.3}};
    p.drummer.edit(edit);
    p.run(0.01);
    const int forearm = p.drummer.skeleton().index("right_forearm");
    const int upper_arm = p.drummer.skeleton().index("right_upper_arm");
    const auto& now = p.drummer.placement();
    CHECK(now.orientation[upper_arm].angularDistance(before.orientation[upper_arm]) < 1e-9);
    const auto elbow = now.orientation[upper_arm].conjugate() * now.orientation[forearm];
    CHECK((body::euler_zyx(elbow) - edit.angles).norm() < 1e-9);
    edit.joint = "knee";
    CHECK_THROWS_AS(p.drummer.edit(edit), std::invalid_argument);
    CHECK_THROWS_AS(p.drummer.edit(score::Script{"wrist", score::Phase::down, {0.0, 0.5}}),
                    std::invalid_argument);
    CHECK(p.drummer.kit().poses.size() == 1);
}

TEST_CASE("live drummer: the same notes at the same times give the same motion, to the last bit") {
    const auto course = [] {
        Playing p;
        p.play(hat_and_snare(p.drummer.kit(), 10));
        p.run(1.7);
        p.drummer.strike(0, 0.4, false);
        p.run(0.8);
        return p.drummer.placement().com;
    };
    CHECK(course() == course());
}
