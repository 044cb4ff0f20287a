#include <doctest/doctest.h>

#include <string>

#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"
#include "support/strike_trials.hpp"

extern "C" void setup_gesture0x2dfeatures();

using namespace percussionist;
using namespace percussionist::pdx;

namespace {

FakeObject& create(FakeHost& host) {
    if (!find_class("gesture-features")) {
        setup_gesture0x2dfeatures();
    }
    FakeObject* const object = host.create("gesture-features");
    REQUIRE(object);
    return *object;
}

void send_pose(FakeHost& host, FakeObject& object, int station, const test::TimedPose& pose) {
    const auto& p = pose.pose.position;
    const auto& q = pose.pose.orientation;
    host.advance_to(pose.time);
    object.message("pose",
                   {static_cast<double>(station), p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
}

void send_drum(FakeObject& object, const motion::Pose& world_from_drum) {
    const auto& p = world_from_drum.position;
    const motion::Vector3 n = world_from_drum.orientation * motion::Vector3::UnitZ();
    object.message("plane", {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
}

std::vector<Sent> from(FakeObject& object, std::size_t outlet) {
    std::vector<Sent> chosen;
    for (const Sent& sent : object.sent()) {
        if (sent.outlet == outlet) {
            chosen.push_back(sent);
        }
    }
    return chosen;
}

test::Trial quiet_trial() {
    return test::make_trial({.seed = 5,
                             .duration = 10,
                             .noise = 1e-5,
                             .turn_noise = 1e-5,
                             .repeats = 0,
                             .jumps = 0,
                             .lost = 0,
                             .missed = 0,
                             .both_ends = false});
}

}  // namespace

TEST_CASE("strikes come out as modal-drum~ takes them, at their time, with their place") {
    const test::Trial trial = quiet_trial();
    FakeHost host;
    FakeObject& features = create(host);
    const auto tip = trial.motion.tip(0);
    features.message("tip", {1.0, tip.x(), tip.y(), tip.z()});
    features.message("radius", {trial.stick.tip_radius});
    send_drum(features, trial.world_from_drum);
    for (const auto& pose : trial.poses) {
        send_pose(host, features, 1, pose);
    }
    host.advance_to(host.now() + 0.1);
    CHECK(host.errors().empty());
    const auto strikes = from(features, 0);
    REQUIRE(strikes.size() == trial.strokes.size());
    for (std::size_t i = 0; i < strikes.size(); ++i) {
        const auto number = [&](std::size_t k) { return std::get<double>(strikes[i].atoms.at(k)); };
        CHECK(strikes[i].selector == "strike");
        CHECK(std::abs(strikes[i].time - trial.strokes[i].time) < 0.0085);
        CHECK(number(0) == doctest::Approx(trial.strokes[i].velocity).epsilon(0.25));
        CHECK(number(1) == doctest::Approx(trial.strokes[i].r).epsilon(0.2));
    }
}

TEST_CASE("seen from the player, leaning and turning change nothing") {
    const test::Trial trial = quiet_trial();
    const auto lean = [](double time) {
        return motion::Pose{
            {0.05 * std::sin(2 * time), 0.03 * std::sin(3 * time), 0.4},
            linear::quaternion_exp({0.2 * std::sin(1.7 * time), 0.0, 0.3 * std::sin(1.1 * time)})};
    };
    FakeHost host;
    FakeObject& features = create(host);
    const auto tip = trial.motion.tip(0);
    features.message("tip", {1.0, tip.x(), tip.y(), tip.z()});
    features.message("radius", {trial.stick.tip_radius});
    features.message("frame", {2.0});
    send_drum(features, trial.world_from_drum);
    for (std::size_t i = 0; i < trial.poses.size(); ++i) {
        // The stations are measured one after the other.
        const auto& pose = trial.poses[i];
        const double time = pose.time;
        send_pose(host, features, i % 2 == 0 ? 2 : 1,
                  {time, i % 2 == 0 ? lean(time) : lean(time) * pose.pose});
    }
    host.advance_to(host.now() + 0.1);
    std::vector<double> truths, found;
    for (const auto& stroke : trial.strokes) {
        truths.push_back(stroke.time);
    }
    for (const Sent& sent : from(features, 0)) {
        found.push_back(sent.time);
    }
    CHECK(test::score(truths, found, 0.025).f() > 0.95);
}

TEST_CASE("a frame that was out of sight and is back elsewhere makes no strike") {
    FakeHost host;
    FakeObject& features = create(host);
    features.message("frame", {2.0});
    features.message("plane", {0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    const auto still = [](double time, double z) {
        return test::TimedPose{time, {{0.05, 0.0, z}, linear::quaternion_exp({1e-3 * time, 0, 0})}};
    };
    for (int i = 0; i < 240; ++i) {
        const double time = i / 120.0;
        const bool seen = i < 40 || i >= 120;
        send_pose(host, features, 1, still(time, 0.15));
        if (seen) {
            send_pose(host, features, 2, still(time + 0.004, i < 40 ? 0.0 : 0.2));
        }
    }
    host.advance_to(3.0);
    CHECK(host.errors().empty());
    CHECK(from(features, 0).empty());
}

TEST_CASE("taps on a real surface make the plane") {
    const test::Trial trial = quiet_trial();
    FakeHost host;
    FakeObject& features = create(host);
    const auto tip = trial.motion.tip(0);
    features.message("tip", {1.0, tip.x(), tip.y(), tip.z()});
    features.message("radius", {trial.stick.tip_radius});
    features.message("calibrate", {1.0});
    for (const auto& pose : trial.poses) {
        send_pose(host, features, 1, pose);
    }
    features.message("calibrate", {0.0});
    CHECK(host.errors().empty());
    const auto told = from(features, 4);
    REQUIRE(told.back().selector == "plane");
    const auto number = [&](std::size_t k) { return std::get<double>(told.back().atoms.at(k)); };
    const motion::Vector3 normal(number(3), number(4), number(5));
    CHECK(normal.dot(trial.world_from_drum.orientation * motion::Vector3::UnitZ()) > 0.98);
    const motion::Vector3 middle(number(0), number(1), number(2));
    CHECK(std::abs((trial.world_from_drum.inverse() * middle).z()) < 0.03);
}

TEST_CASE("after a reset strikes are told from the movement alone, and no tap is kept") {
    const test::Trial trial = quiet_trial();
    const auto played = [&](const std::vector<std::pair<std::string, std::vector<Atom>>>& before) {
        FakeHost host;
        FakeObject& features = create(host);
        for (const auto& [selector, atoms] : before) {
            features.message(selector, atoms);
        }
        features.sent();
        for (const auto& pose : trial.poses) {
            send_pose(host, features, 1, pose);
        }
        CHECK(host.errors().empty());
        std::vector<double> told;
        for (const Sent& sent : features.sent()) {
            if (sent.selector == "strike" || sent.selector == "taps") {
                told.push_back(sent.time);
            }
        }
        return told;
    };
    const auto free = played({});
    CHECK(free.size() > 10);
    CHECK(played({{"plane", {0.0, 0.0, 0.0, 0.0, 0.0, 1.0}}, {"reset", {}}}) == free);
    CHECK(played({{"calibrate", {1.0}}, {"reset", {}}}) == free);
    CHECK(played({{"detect", {"none"}}, {"reset", {}}}).empty());
}

TEST_CASE("a hand that presses in from behind damps as far as it presses") {
    FakeHost host;
    FakeObject& features = create(host);
    features.message("plane", {0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    features.message("hand", {3.0, 0.02, 0.03});
    double time = 0.0;
    for (const double z : {-0.1, -0.03, -0.02, -0.005}) {
        send_pose(host, features, 3,
                  {time += 0.01, {{0.0, 0.1, z}, linear::Quaternion::Identity()}});
    }
    const auto damps = from(features, 3);
    REQUIRE(damps.size() == 4);
    const auto pressure = [&](std::size_t i) { return std::get<double>(damps[i].atoms.at(2)); };
    CHECK(pressure(0) == 0);
    CHECK(pressure(1) == doctest::Approx(0));
    CHECK(pressure(2) == doctest::Approx(0.5));
    CHECK(pressure(3) == 1);
    CHECK(std::get<double>(damps[0].atoms.at(0)) == doctest::Approx(0.1));
}

TEST_CASE("bad messages get one error each and what was set stays") {
    FakeHost host;
    FakeObject& features = create(host);
    const std::vector<std::pair<std::string, std::vector<Atom>>> bad = {
        {"pose", {1.0, 0.0, 0.0}},
        {"pose", {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}},
        {"pose", {5.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}},
        {"detect", {"plane"}},
        {"detect", {"magic"}},
        {"plane", {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}},
        {"tap", {}},
        {"fit", {}},
        {"calibrate", {0.0}},
        {"tip", {1.0}},
        {"tip", {1.0, 0.3}},
        {"tip", {2.0, 0.3, 0.0}},
        {"tip", {3.0, 0.0, 0.0, 0.0}},
        {"window", {-1.0}},
    };
    for (const auto& [selector, atoms] : bad) {
        CAPTURE(selector);
        features.message(selector, atoms);
        const auto errors = host.errors();
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].find("gesture-features: " + selector) == 0);
    }
}
