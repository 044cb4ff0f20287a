#include "core/listening/practice/recipes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percussionist::listening::practice {

namespace {

/// Frequencies of a circular membrane over its lowest (Fletcher, Rossing 1998, section 3.5).
constexpr std::array<double, 8> kMembrane = {1.0, 1.594, 2.136, 2.296, 2.653, 2.918, 3.156, 3.501};

void add_skin(double frequency, double t60, double bend, double settle, double slope_db, Dice& dice,
              Recipe& to) {
    for (std::size_t m = 0; m < kMembrane.size(); ++m) {
        const double level =
            m == 0 ? 0.0 : -dice.uniform(2.0, 14.0) - slope_db * static_cast<double>(m);
        const double shorter = m == 0 ? 1.0 : dice.uniform(0.3, 0.9);
        to.rings.push_back({frequency * kMembrane[m] * (1.0 + 0.02 * dice.normal()), db(level),
                            t60 * shorter, bend, settle});
    }
}

void add_metal(std::size_t count, double low, double high, double t60_low, double t60_high,
               double level_db, Dice& dice, Recipe& to) {
    for (std::size_t m = 0; m < count; ++m) {
        const double frequency = dice.log_uniform(low, high);
        const double place = std::log(frequency / low) / std::log(high / low);
        const double t60 = t60_low * std::pow(t60_high / t60_low, place) * dice.uniform(0.5, 1.5);
        to.rings.push_back(
            {frequency, db(level_db + 5.0 * dice.normal()) / std::sqrt(static_cast<double>(count)),
             t60});
    }
}

/// What rings besides the skin: hoop, shell, a stick on the rim.
void add_shell(double level_db, Dice& dice, Recipe& to) {
    const std::size_t count = 2 + dice.whole(4);
    for (std::size_t m = 0; m < count; ++m) {
        to.rings.push_back({dice.log_uniform(350.0, 2800.0),
                            db(level_db + dice.uniform(-10.0, 0.0)), dice.log_uniform(0.03, 0.3)});
    }
}

/// Wires off: skin and shell alone.
Recipe bare_snare(Dice& dice) {
    Recipe made;
    add_skin(dice.log_uniform(160.0, 420.0), dice.log_uniform(0.06, 0.3), dice.uniform(1.0, 1.1),
             0.01, dice.uniform(-1.0, 1.5), dice, made);
    add_shell(dice.uniform(-8.0, 4.0), dice, made);
    made.hisses.push_back({300.0, dice.log_uniform(2000.0, 12000.0), db(dice.uniform(-10.0, 6.0)),
                           0.0005, 0.0, dice.log_uniform(0.01, 0.08)});
    return made;
}

}  // namespace

double db(double decibels) {
    return std::pow(10.0, decibels / 20.0);
}

Recipe kick(Dice& dice) {
    Recipe made;
    const double frequency = dice.log_uniform(40.0, 85.0);
    const double t60 = dice.log_uniform(0.1, 0.8);
    made.rings.push_back(
        {frequency, 1.0, t60, dice.log_uniform(1.0, 4.0), dice.log_uniform(0.006, 0.05)});
    if (dice.chance(0.7)) {
        add_skin(frequency * dice.uniform(1.3, 2.0), t60 * dice.uniform(0.2, 0.7),
                 dice.uniform(1.0, 1.8), 0.02, dice.uniform(1.0, 5.0), dice, made);
        for (std::size_t m = 1; m < made.rings.size(); ++m)
            made.rings[m].amplitude *= db(dice.uniform(-22.0, -4.0));
    }
    made.hisses.push_back({dice.uniform(100.0, 800.0), dice.log_uniform(1500.0, 9000.0),
                           db(dice.uniform(-34.0, -4.0)), dice.uniform(0.0, 0.003), 0.0,
                           dice.log_uniform(0.005, 0.06)});
    made.hisses.push_back({40.0, dice.log_uniform(150.0, 700.0), db(dice.uniform(-24.0, 0.0)),
                           dice.uniform(0.0, 0.004), 0.0, dice.log_uniform(0.03, 0.2)});
    if (dice.chance(0.5)) {  // the snare's wires answer
        made.hisses.push_back(
            {500.0, 7000.0, db(dice.uniform(-40.0, -18.0)), 0.005, 0.0, dice.uniform(0.08, 0.4)});
    }
    return made;
}

Recipe snare(Dice& dice) {
    if (dice.chance(0.12)) return bare_snare(dice);
    Recipe made;
    const bool brushed = dice.chance(0.08);
    const double skin = db(brushed ? dice.uniform(-30.0, -10.0) : dice.uniform(-14.0, 10.0));
    add_skin(dice.log_uniform(130.0, 320.0), dice.log_uniform(0.05, 0.35), dice.uniform(1.0, 1.3),
             0.01, dice.uniform(-1.0, 3.0), dice, made);
    for (Ring& ring : made.rings) ring.amplitude *= skin;
    if (!brushed && dice.chance(0.5)) add_shell(dice.uniform(-20.0, 2.0), dice, made);
    const double low = dice.log_uniform(180.0, 1800.0);
    const double high = dice.log_uniform(2000.0, 14000.0);
    const double rise = brushed ? dice.uniform(0.005, 0.03) : dice.uniform(0.0, 0.003);
    // Gated reverberation holds its noise up, then cuts it.
    const double hold = dice.chance(0.25) ? dice.uniform(0.02, 0.2) : 0.0;
    made.hisses.push_back({low, high, 1.0, rise, hold, dice.log_uniform(0.07, 0.6)});
    if (dice.chance(0.5)) {
        made.hisses.push_back({dice.log_uniform(120.0, 600.0), dice.log_uniform(700.0, 3000.0),
                               db(dice.uniform(-4.0, 10.0)), rise, hold,
                               dice.log_uniform(0.05, 0.3)});
    }
    made.hisses.push_back({300.0, dice.log_uniform(2000.0, 12000.0), db(dice.uniform(-10.0, 8.0)),
                           0.0005, 0.0, dice.log_uniform(0.008, 0.05)});
    if (dice.chance(0.15)) {  // claps along
        for (int hand = 0; hand < 3; ++hand) {
            made.hisses.push_back(
                {700.0, 4000.0, db(dice.uniform(-6.0, 4.0)), 0.001, 0.0, 0.03, 0.011 * hand});
        }
    }
    made.softest = dice.uniform(0.3, 0.8);
    return made;
}

Recipe side_stick(Dice& dice) {
    Recipe made;
    for (int m = 0; m < 4; ++m) {
        made.rings.push_back({dice.log_uniform(350.0, 3500.0), db(dice.uniform(-10.0, 0.0)),
                              dice.log_uniform(0.02, 0.12)});
    }
    made.hisses.push_back({800.0, dice.log_uniform(3000.0, 10000.0), db(dice.uniform(-12.0, 2.0)),
                           0.0, 0.0, dice.log_uniform(0.006, 0.04)});
    return made;
}

HatMaker::HatMaker(Dice& dice)
    : low_(dice.log_uniform(1500.0, 7000.0)),
      high_(dice.log_uniform(9000.0, 19000.0)),
      metal_db_(dice.uniform(-18.0, 4.0)),
      body_db_(dice.uniform(-28.0, -6.0)) {}

Recipe HatMaker::operator()(double t60, double rise, Dice& dice) const {
    Recipe made;
    made.hisses.push_back({low_, high_, 1.0, rise, 0.0, t60});
    made.hisses.push_back({low_ * 1.3, 19000.0, db(dice.uniform(-14.0, 4.0)), rise, 0.0,
                           std::min(t60, dice.uniform(0.01, 0.04))});
    add_metal(36, low_ * 0.6, 17000.0, t60, t60 * 0.8, metal_db_, dice, made);
    add_metal(6, 300.0, 1500.0, 0.06, 0.04, body_db_, dice, made);
    made.softest = 0.5;
    return made;
}

Recipe ride(Dice& dice, bool bell) {
    Recipe made;
    const double long_ring = dice.log_uniform(0.4, 3.0);
    add_metal(50, dice.log_uniform(250.0, 3000.0), 14000.0, long_ring, 0.6 * long_ring,
              dice.uniform(-10.0, 0.0), dice, made);
    made.hisses.push_back({dice.log_uniform(1000.0, 5000.0), 16000.0, db(dice.uniform(-20.0, 3.0)),
                           0.002, 0.0, dice.log_uniform(0.3, 1.5)});
    made.hisses.push_back({1500.0, dice.log_uniform(6000.0, 15000.0), db(dice.uniform(-8.0, 8.0)),
                           0.0, 0.0, dice.log_uniform(0.008, 0.05)});
    const double ping = bell ? db(dice.uniform(4.0, 12.0)) : db(dice.uniform(-12.0, 4.0));
    for (int m = 0; m < 5; ++m) {
        made.rings.push_back({dice.log_uniform(bell ? 600.0 : 2000.0, 6500.0),
                              ping * db(dice.uniform(-12.0, 0.0)), dice.log_uniform(0.1, 1.0)});
    }
    return made;
}

Recipe crash(Dice& dice) {
    Recipe made;
    const double ring = dice.log_uniform(0.5, 2.5);
    add_metal(60, dice.log_uniform(180.0, 600.0), 15000.0, ring, 0.5 * ring,
              dice.uniform(-12.0, 0.0), dice, made);
    made.hisses.push_back({dice.log_uniform(300.0, 3000.0), dice.log_uniform(8000.0, 18000.0), 1.0,
                           dice.log_uniform(0.001, 0.02), 0.0, ring * 0.8});
    made.hisses.push_back(
        {500.0, 16000.0, db(dice.uniform(-8.0, 6.0)), 0.001, 0.0, dice.log_uniform(0.05, 0.3)});
    return made;
}

Recipe tom(double frequency, double t60, double bend, double slope, double stick_db, Dice& dice) {
    Recipe made;
    add_skin(frequency, t60, bend, 0.04, slope, dice, made);
    made.hisses.push_back({200.0, dice.log_uniform(2000.0, 9000.0), db(stick_db), 0.0005, 0.0,
                           dice.log_uniform(0.008, 0.05)});
    return made;
}

Recipe by_hand(Dice& dice) {
    if (dice.chance(0.5)) {  // conga, bongo
        return tom(dice.log_uniform(180.0, 550.0), dice.log_uniform(0.06, 0.3), 1.02, 2.0,
                   dice.uniform(-14.0, 2.0), dice);
    }
    Recipe made;  // cowbell, block, claves
    const double low = dice.log_uniform(450.0, 2500.0);
    const double t60 = dice.log_uniform(0.03, 0.3);
    for (int m = 0; m < 6; ++m) {
        made.rings.push_back(
            {low * (1.0 + 0.5 * m + 0.1 * dice.uniform()), db(-3.0 * m * dice.uniform()), t60});
    }
    return made;
}

Recipe shaken(Dice& dice) {
    Recipe made;
    const double low = dice.log_uniform(2500.0, 7000.0);
    if (dice.chance(0.6)) {  // shaker, cabasa
        made.hisses.push_back({low, dice.log_uniform(9000.0, 18000.0), 1.0,
                               dice.uniform(0.008, 0.04), 0.0, dice.log_uniform(0.03, 0.12)});
    } else {  // tambourine
        made.hisses.push_back({low, 16000.0, db(-8.0), 0.003, 0.0, dice.log_uniform(0.05, 0.2)});
        add_metal(16, 5000.0, 15000.0, 0.25, 0.2, 0.0, dice, made);
    }
    return made;
}

}  // namespace percussionist::listening::practice
