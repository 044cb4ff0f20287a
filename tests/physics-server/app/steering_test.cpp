#include "app/steering.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "osc/address_table.hpp"

using namespace percussionist;

namespace {

/// One player, steered by messages as they come over OSC.
class Steered {
  public:
    explicit Steered(std::vector<score::Stroke> strokes) {
        performance_.load(std::move(strokes));
        performance_.play();
    }
    void send(const std::string& path, const std::vector<osc::Argument>& arguments) {
        const auto said = osc::understand(path, arguments);
        CAPTURE(path);
        REQUIRE(std::holds_alternative<osc::Command>(said));
        CHECK(steering_.obey(std::get<osc::Command>(said)));
    }
    void until(double time) {
        while (performance_.simulation().time() < time) performance_.step();
    }
    void to_end() {
        while (performance_.playing()) performance_.step();
    }
    app::Performance& performance() { return performance_; }
    app::Steering& steering() { return steering_; }
    const std::vector<app::LoggedContact>& contacts() const {
        return performance_.log().contacts();
    }

  private:
    app::Performance performance_{{}};
    app::Steering steering_{performance_, body::built_in_gestures()};
};

std::vector<score::Stroke> strokes(int count, double interval, double speed = 1.9) {
    std::vector<score::Stroke> all;
    for (int i = 0; i < count; ++i) {
        score::Stroke s;
        s.time = interval * i;
        s.hand = i % 2;
        s.speed = speed;
        s.height = score::preparation_height(speed);
        all.push_back(s);
    }
    return all;
}

/// The mean speed of the contacts from `first` on [m/s].
double mean_speed(const Steered& player, std::size_t first) {
    double sum = 0.0;
    for (std::size_t i = first; i < player.contacts().size(); ++i) {
        sum -= player.contacts()[i].event.velocity.z();
    }
    return sum / static_cast<double>(player.contacts().size() - first);
}

void one_contact_each(Steered& player, int count) {
    const app::TimingSummary s = player.performance().summary();
    CHECK(s.strokes == count);
    CHECK(s.contacts == count);
    CHECK(s.uncalled == 0);
    CHECK(s.worst_error < 0.003);
}

}  // namespace

TEST_CASE("steering: a nuance is heard in the next strokes, and none is lost") {
    double last = 0.0;
    for (const char* nuance : {"staccato", "legato", "accent", "vertical-accent"}) {
        CAPTURE(nuance);
        Steered player(strokes(12, 0.6));
        player.until(3.5);
        const std::size_t before = player.contacts().size();
        player.send("/nuance", {std::string(nuance)});
        player.to_end();
        one_contact_each(player, 12);
        CHECK(mean_speed(player, before + 2) > 1.2 * last);
        last = mean_speed(player, before + 2);
    }
}

TEST_CASE("steering: an accelerando is played as it is asked for") {
    Steered player(strokes(30, 0.3));
    player.until(2.0);
    player.send("/tempo", {2.0, 3.0});
    player.send("/rubato", {0.2, 1.2});
    player.to_end();
    one_contact_each(player, 30);
}

TEST_CASE("steering: a stroke comes down where it is asked to, on a head of any height and size") {
    Steered player(strokes(16, 0.5));
    player.until(2.0);
    player.send("/place", {0.4, std::string("left")});
    player.send("/drum/height", {0.85});
    player.send("/membrane", {0.25, 3000.0, 0.3});
    player.to_end();
    one_contact_each(player, 16);
    const auto& last = player.contacts()[14].event;
    CHECK(std::hypot(last.place.x(), last.place.y()) ==
          doctest::Approx((last.hand == body::Hand::left ? 0.4 : 0.75) * 0.25).epsilon(0.03));
}

TEST_CASE("steering: a heavier stick is felt as heavier, a harder one touches for less long") {
    Steered player(strokes(20, 0.5));
    player.until(3.0);
    player.send("/mallet", {0.09, 1e8});
    player.until(6.0);
    const app::LoggedContact heavy = player.contacts().back();
    player.send("/mallet", {0.09, 1e10});
    player.to_end();
    one_contact_each(player, 20);
    CHECK(heavy.event.effective_mass > 1.5 * player.contacts().front().event.effective_mass);
    CHECK(player.contacts().back().event.duration < heavy.event.duration);
}

TEST_CASE("steering: the other hand leads from where neither has to strike again too soon") {
    Steered player(strokes(16, 0.3));
    player.until(2.0);
    player.send("/leading", {std::string("left")});
    player.to_end();
    one_contact_each(player, 16);
    const auto& contacts = player.contacts();
    CHECK(contacts[0].event.hand == body::Hand::left);
    CHECK(contacts[14].event.hand == body::Hand::right);
}

TEST_CASE(
    "steering: every control at once, ten thousand times, leaves it playing stroke by stroke") {
    std::mt19937 random(5);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    const auto one_of = [&](std::vector<std::string> words) {
        return words[random() % words.size()];
    };
    Steered player(strokes(160, 0.35));
    int changes = 0;
    double last_tip = 0.0;
    while (player.performance().playing()) {
        if (changes < 10000) {
            ++changes;
            const std::string hand = one_of({"left", "right", "both"});
            switch (random() % 8) {
                case 0:
                    player.send("/tempo", {between(0.7, 1.4), between(0.0, 2.0)});
                    break;
                case 1:
                    player.send("/rubato", {between(0.0, 0.3), between(0.5, 4.0)});
                    break;
                case 2:
                    player.send("/nuance", {one_of({"legato", "tenuto", "accent", "score",
                                                    "vertical-accent", "staccato", "piston"}),
                                            hand});
                    break;
                case 3:
                    player.send("/height", {between(0.5, 1.3)});
                    break;
                case 4:
                    player.send("/place", {between(0.1, 0.9), hand});
                    break;
                case 5:
                    player.send("/leading", {one_of({"left", "right"})});
                    break;
                case 6:
                    player.send("/drum/height", {between(0.85, 0.98)});
                    break;
                default:
                    player.send("/grip", {one_of({"german", "french"})});
            }
        }
        for (int i = 0; i < 5; ++i) player.performance().step();
        const double tip = player.performance().simulation().tip_asked(body::Hand::right).z();
        if (changes > 2) CHECK(std::abs(tip - last_tip) < 0.08);  // in 5 ms: no jump
        last_tip = tip;
    }
    CHECK(changes == 10000);
    const app::TimingSummary s = player.performance().summary();
    CHECK(s.strokes == 160);
    CHECK(s.missed == 0);
    CHECK(s.uncalled == 0);
}

TEST_CASE("steering: what it tells is what holds") {
    Steered player(strokes(4, 0.5));
    player.send("/nuance", {std::string("accent"), std::string("left")});
    player.send("/gain", {40.0, 0.8});
    player.send("/control", {std::string("joints")});
    CHECK(player.steering().take_changed());
    CHECK(!player.steering().take_changed());
    const osc::StateMessage state = player.steering().state(0.0);
    const auto value = [&](const std::string& name) {
        for (const auto& item : state.items) {
            if (item.name == name) return item.values;
        }
        return std::vector<osc::Argument>{};
    };
    CHECK(value("nuance") ==
          std::vector<osc::Argument>{std::string("accent"), std::string("score")});
    CHECK(value("gain") == std::vector<osc::Argument>{40.0, 0.8});
    CHECK(value("control") == std::vector<osc::Argument>{std::string("joints")});
    CHECK_THROWS_WITH_AS(player.steering().obey(osc::SetNuance{"pizzicato", {}}),
                         doctest::Contains("legato"), std::invalid_argument);
}
