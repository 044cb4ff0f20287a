// [fastrak~] on a simulated unit, through a pseudo-terminal: in the time that it takes, as both
// ends have threads and clocks of their own.
#include <doctest/doctest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/motion/bodhran_player.hpp"
#include "io/fastrak_tracker.hpp"
#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"
#include "tracker/simulated_device.hpp"

extern "C" void fastrak_tilde_setup();

using namespace percussionist;
using namespace percussionist::pdx;

namespace {

constexpr double kPatience = 10.0;  // [s] for a loaded machine; nothing waits that long

std::string temporary(const std::string& name) {
    return (std::filesystem::temp_directory_path() / (name + std::to_string(getpid()))).string();
}

/// Pd and a unit, both moved along by until().
class Studio {
  public:
    explicit Studio(tracker::SimulatedDeviceSettings settings = {})
        : device_(
              with_link(std::move(settings)),
              [this](int station, double time) { return player_.receiver(station, time); },
              [](const std::string&) {}) {
        if (!find_class("fastrak~")) {
            fastrak_tilde_setup();
        }
    }

    FakeObject& create(std::vector<Atom> arguments) {
        FakeObject* const object = host.create("fastrak~", std::move(arguments));
        REQUIRE(object);
        return *object;
    }

    /// Runs both until done; answers how long it took [s].
    double until(const std::function<bool()>& done) {
        const double start = io::steady_now();
        double now = start;
        while (!done() && now < start + kPatience) {
            now = io::steady_now();
            device_.run(now - start_);
            host.advance_to(now - start_);
        }
        CHECK(done());
        return now - start;
    }
    void pass(double seconds) {
        const double end = io::steady_now() + seconds;
        until([end] { return io::steady_now() >= end; });
    }
    void order(const std::string& line) { device_.order(line, io::steady_now() - start_); }

    const std::string link = temporary("fastrak-test-");
    FakeHost host;

  private:
    tracker::SimulatedDeviceSettings with_link(tracker::SimulatedDeviceSettings settings) {
        settings.link = link;
        return settings;
    }
    motion::BodhranPlayer player_;
    tracker::SimulatedDevice device_;
    double start_ = io::steady_now();
};

/// Collects what an object says.
struct Listener {
    FakeObject& object;
    std::vector<Sent> poses, statuses;

    void listen() {
        for (Sent& sent : object.sent()) {
            (sent.outlet == 3 ? poses : statuses).push_back(std::move(sent));
        }
    }
    bool heard(const std::string& name) {
        listen();
        return std::any_of(statuses.begin(), statuses.end(),
                           [&](const Sent& s) { return s.selector == name; });
    }
    bool has_poses(std::size_t count) {
        listen();
        return poses.size() >= count;
    }
};

tracker::SimulatedDeviceSettings receivers(int count) {
    tracker::SimulatedDeviceSettings settings;
    settings.unit.receivers = count;
    return settings;
}

double number(const Sent& sent, std::size_t i) {
    return std::get<double>(sent.atoms.at(i));
}

/// A loaded machine holds single ones up.
double median_step(const std::vector<Sent>& sent) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < sent.size(); ++i) {
        steps.push_back(sent[i].time - sent[i - 1].time);
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

}  // namespace

TEST_CASE("the first pose is there within a second, and then 120 come each second, evenly") {
    Studio studio(receivers(1));
    Listener fastrak{studio.create({studio.link.c_str()}), {}, {}};
    CHECK(studio.until([&] { return fastrak.has_poses(1); }) < 1.0);
    studio.until([&] { return fastrak.has_poses(60); });
    CHECK(median_step(fastrak.poses) == doctest::Approx(1 / 120.0).epsilon(0.05));
    CHECK(fastrak.poses.back().selector == "pose");
    CHECK(number(fastrak.poses.back(), 0) == 1);
    CHECK(studio.host.errors().empty());
}

TEST_CASE("every format and attitude gives the same place") {
    Studio studio(receivers(2));
    FakeObject& object = studio.create({studio.link.c_str()});
    for (const auto& [format, attitude] :
         std::vector<std::pair<const char*, const char*>>{{"ascii", "euler"},
                                                          {"ascii", "cosines"},
                                                          {"float32", "cosines"},
                                                          {"float32", "euler"},
                                                          {"16bit", "euler"},
                                                          {"16bit", "quaternion"}}) {
        CAPTURE(format);
        CAPTURE(attitude);
        object.message("format", {format});
        object.message("attitude", {attitude});
        studio.pass(0.05);
        Listener fastrak{object, {}, {}};
        object.sent();
        studio.until([&] { return fastrak.has_poses(30); });
        for (std::size_t i = 20; i < 30; ++i) {
            if (number(fastrak.poses[i], 0) == 2) {  // the chest hardly moves
                CHECK(number(fastrak.poses[i], 1) == doctest::Approx(0.30).epsilon(0.1));
                CHECK(number(fastrak.poses[i], 3) == doctest::Approx(0.35).epsilon(0.02));
                CHECK(number(fastrak.poses[i], 4) > 0.95);
            }
        }
    }
}

TEST_CASE("another rate is found and told, and a unit without 16BIT gets float32") {
    tracker::SimulatedDeviceSettings settings = receivers(1);
    settings.strict_baud = true;
    settings.unit.baud = 38400;
    settings.unit.has_16bit = false;
    Studio studio(settings);
    Listener fastrak{studio.create({}), {}, {}};
    fastrak.object.message("format", {"16bit"});
    fastrak.object.message("open", {studio.link.c_str(), 115200.0});
    studio.until([&] { return fastrak.has_poses(5); });
    CHECK(fastrak.heard("baud"));
    CHECK(fastrak.heard("note"));
}

TEST_CASE("unplugged it says so once, and plugged in again it is as it was set") {
    Studio studio(receivers(1));
    Listener fastrak{studio.create({studio.link.c_str()}), {}, {}};
    fastrak.object.message("align", {1.0, 0.3, 0.0, 0.0, 1.3, 0.0, 0.0, 0.3, 1.0, 0.0});
    studio.until([&] { return fastrak.has_poses(30); });
    const double aligned_x = number(fastrak.poses.back(), 1);
    CHECK(aligned_x < 0.5);  // the stick is about 0.6 m in front of the transmitter
    studio.order("unplug 0.3");
    studio.until([&] { return fastrak.heard("lost-device"); });
    fastrak.poses.clear();
    studio.until([&] { return fastrak.has_poses(30); });
    CHECK(number(fastrak.poses.back(), 1) < 0.5);
    CHECK(studio.host.errors().size() == 1);
}

TEST_CASE("a boresight outlives an unplugging") {
    Studio studio(receivers(1));
    Listener fastrak{studio.create({studio.link.c_str()}), {}, {}};
    const auto mean_turn = [&] {
        fastrak.poses.clear();
        studio.until([&] { return fastrak.has_poses(60); });
        double sum = 0.0;
        for (const Sent& pose : fastrak.poses) {
            sum += 2 * std::acos(std::min(1.0, std::abs(number(pose, 4))));
        }
        return sum / static_cast<double>(fastrak.poses.size());
    };
    const double as_it_is = mean_turn();
    fastrak.object.message("boresight", {1.0, 0.0, 0.0, 0.0});
    studio.pass(0.1);
    CHECK(mean_turn() < 0.7 * as_it_is);
    studio.order("unplug 0.3");
    studio.until([&] { return fastrak.heard("lost-device"); });
    CHECK(mean_turn() < 0.7 * as_it_is);
    fastrak.object.message("unboresight", {1.0});
    studio.pass(0.1);
    CHECK(mean_turn() == doctest::Approx(as_it_is).epsilon(0.2));
}

TEST_CASE("what is recorded beside the patch plays as it was, without a unit") {
    const std::filesystem::path place = temporary("fastrak-recording-");
    Studio studio(receivers(2));
    studio.host.set_patch_folder(place.parent_path().string());
    const std::string file = place.filename().string();
    std::vector<Sent> recorded;
    {
        Listener fastrak{studio.create({studio.link.c_str()}), {}, {}};
        studio.until([&] { return fastrak.has_poses(30); });
        fastrak.object.message("record", {file.c_str()});
        studio.until([&] { return fastrak.heard("recording"); });
        fastrak.poses.clear();
        studio.until([&] { return fastrak.has_poses(40); });
        fastrak.object.message("stop");
        recorded = fastrak.poses;
        studio.pass(0.05);
        studio.host.destroy(&fastrak.object);
    }
    Listener player{studio.create({}), {}, {}};
    player.object.message("play", {file.c_str()});
    studio.until([&] { return player.heard("played"); });
    CHECK(std::filesystem::remove(place));
    REQUIRE(player.poses.size() >= 20);
    // Poses that were on their way when recording began are not in it.
    std::size_t late = 0;
    while (late < 8 && std::abs(number(player.poses[0], 1) - number(recorded[late], 1)) > 2e-6) {
        ++late;
    }
    REQUIRE(late < 8);
    for (std::size_t i = 0; i < 15; ++i) {
        CHECK(number(player.poses[i], 1) ==
              doctest::Approx(number(recorded[i + late], 1)).epsilon(1e-4));
    }
    CHECK(median_step(player.poses) == doctest::Approx(1 / 120.0).epsilon(0.05));
}

TEST_CASE("signals follow the chosen station") {
    Studio studio(receivers(2));
    FakeObject& object = studio.create({studio.link.c_str()});
    object.message("station", {2.0});
    Listener fastrak{object, {}, {}};
    studio.host.start_dsp();
    studio.until([&] { return fastrak.has_poses(60); });
    CHECK(object.output(0).back() == doctest::Approx(0.30).epsilon(0.1));
    CHECK(object.output(2).back() == doctest::Approx(0.35).epsilon(0.02));
}

TEST_CASE("bad messages and files get one error each") {
    Studio studio(receivers(1));
    FakeObject& object = studio.create({});
    for (const auto& [selector, atoms] : std::vector<std::pair<const char*, std::vector<Atom>>>{
             {"format", {"text"}},
             {"attitude", {"up"}},
             {"stations", {"two"}},
             {"stations", {7.0}},
             {"align", {1.0, 2.0}},
             {"align", {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0}},
             {"filter", {"taste"}},
             {"tip", {1.0, 9.0, 0.0, 0.0}},
             {"open", {}}}) {
        CAPTURE(selector);
        object.message(selector, atoms);
        const auto errors = studio.host.errors();
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].find(std::string("fastrak~: ") + selector) == 0);
    }
    Listener fastrak{object, {}, {}};
    object.message("play", {"/nowhere/at-all.csv"});
    object.message("record", {"/nowhere/at-all.csv"});
    studio.until([&] {
        fastrak.listen();
        return fastrak.statuses.size() >= 2;
    });
    CHECK(studio.host.errors().size() == 2);
    object.message("open", {"/nowhere/tty"});
    studio.until([&] { return fastrak.heard("lost-device"); });
}

TEST_CASE("what is refused changes nothing, also not with the next setting") {
    Studio studio(receivers(2));
    Listener fastrak{studio.create({studio.link.c_str()}), {}, {}};
    fastrak.object.message("align", {1.0, 0.3, 0.0, 0.0, 1.3, 0.0, 0.0, 0.3, 1.0, 0.0});
    studio.until([&] { return fastrak.has_poses(30); });
    CHECK(studio.host.errors().empty());
    fastrak.object.message("stations", {2.0, "three"});
    fastrak.object.message("align", {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0});
    CHECK(studio.host.errors().size() == 2);
    fastrak.object.message("twice", {1.0});
    studio.pass(0.1);
    fastrak.poses.clear();
    studio.until([&] { return fastrak.has_poses(30); });
    int of_stick = 0;
    for (const Sent& pose : fastrak.poses) {
        if (number(pose, 0) == 1) {
            ++of_stick;
            CHECK(number(pose, 1) < 0.5);  // without the alignment about 0.6
        }
    }
    CHECK(of_stick > 5);
}
