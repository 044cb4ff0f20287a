#include "core/score/kit_plan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "core/score/kit_effort.hpp"
#include "core/score/kit_feet.hpp"
#include "core/score/kit_sticking.hpp"
#include "support/small_kit.hpp"

using namespace percussionist;
using namespace percussionist::score;
using namespace percussionist::test;

namespace {

/// "RLRR", of the hands alone.
std::string sticking(const KitPlan& plan) {
    std::string hands;
    for (const KitStroke& s : plan.strokes) {
        if (is_hand(s.limb)) hands += s.limb == Limb::left_hand ? 'L' : 'R';
    }
    return hands;
}

Score random_score(unsigned seed, int count, double mean_gap) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> gap(1.0 / mean_gap);
    const std::vector<int> keys{kKick, kSnare, kFloorTom, kHat, kMidTom, kHighTom, kRide, 71};
    std::uniform_int_distribution<std::size_t> key(0, keys.size() - 1);
    std::uniform_int_distribution<int> velocity(1, 127);
    Score score;
    double time = 0.0;
    for (int i = 0; i < count; ++i) {
        time += i % 4 == 0 ? 0.0 : gap(random);
        score.notes.push_back(kit_note(time, keys[key(random)], velocity(random) / 127.0));
    }
    return score;
}

void check_no_note_is_lost(const Score& score, const KitPlan& plan) {
    std::vector<int> seen(score.notes.size(), 0);
    for (const auto& s : plan.strokes) ++seen.at(s.note);
    for (const auto* list : {&plan.left_out, &plan.doubles}) {
        for (const auto& l : *list) ++seen.at(l.note);
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<long>(seen.size()));
}

void check_limbs_can(const KitPlan& plan, const Kit& kit) {
    std::array<const KitStroke*, 4> last{};
    bool possible = true;
    for (const KitStroke& s : plan.strokes) {
        const KitStroke*& own = last[index(s.limb)];
        if (own != nullptr) {
            const double gap = s.time - own->time;
            const double least = !is_hand(s.limb) ? kit.limits.foot
                                 : s.bounces      ? kit.limits.bounce
                                                  : kit.limits.interval;
            possible = possible && gap >= least && !(s.bounces && own->bounces);
        }
        own = &s;
    }
    CHECK(possible);
}

/// The least effort of playing all of the hits, by trying everything.
double least_effort(const HandEffort& effort, const std::vector<HandHit>& hits, std::size_t i,
                    const std::array<HandPast, 2>& past) {
    if (i == hits.size()) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const Limb hand : {Limb::left_hand, Limb::right_hand}) {
        const auto h = index(hand);
        const Effort e = effort.of(hits[i], hand, past[h], past[1 - h]);
        if (!e.possible()) continue;
        auto next = past;
        next[h] = {&hits[i], e.bounces};
        least = std::min(least, e.total() + least_effort(effort, hits, i + 1, next));
    }
    return least;
}

double effort_of(const HandEffort& effort, const std::vector<HandHit>& hits,
                 const std::vector<Played>& played) {
    std::array<HandPast, 2> past{};
    double sum = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (played[i] == Played::not_at_all) return -1.0;
        const Limb hand = played[i] == Played::left ? Limb::left_hand : Limb::right_hand;
        const auto h = index(hand);
        const Effort e = effort.of(hits[i], hand, past[h], past[1 - h]);
        if (!e.possible()) return -1.0;
        sum += e.total();
        past[h] = {&hits[i], e.bounces};
    }
    return sum;
}

}  // namespace

TEST_CASE("kit plan: no note is lost unsaid, no limb does what it cannot, no arms cross unasked") {
    const Kit kit = small_kit();
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Score score = random_score(seed, 300, 0.01 * (1 + seed % 20));
        const KitPlan plan = plan_kit(score, kit);
        check_no_note_is_lost(score, plan);
        check_limbs_can(plan, kit);
        const KitAudit counts = audit(plan, kit);
        CHECK(counts.crossed == 0);
        CHECK(counts.too_fast == 0);
        CHECK(counts.too_often == 0);
    }
}

TEST_CASE("kit plan: the hands found are those of least effort") {
    const Kit kit = small_kit();
    const HandEffort effort(kit);
    int tried = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> gap(0.05, 0.35);
        std::uniform_int_distribution<std::size_t> event(1, kit.events.size() - 1);
        std::vector<HandHit> hits;
        std::vector<HitGroup> groups;
        double time = 0.0;
        for (std::size_t i = 0; i < 9; ++i) {
            hits.push_back({time, 0.5, 1.0 + 0.25 * static_cast<double>(i), event(random)});
            groups.push_back({i, 1});
            time += gap(random);
        }
        const double least = least_effort(effort, hits, 0, {});
        if (!std::isfinite(least) || hits.back().time > 10.0 * HandEffort::kMemory) continue;
        ++tried;
        // What is forgotten after 0.8 s costs the search less than it costs here.
        const double found = effort_of(effort, hits, assign_hands(kit, hits, groups));
        CHECK(found == doctest::Approx(least).epsilon(0.02));
    }
    CHECK(tried > 50);
}

TEST_CASE("kit plan: a rock groove has the right hand on the hi-hat, the left on the snare") {
    Score score;
    for (int eighth = 0; eighth < 16; ++eighth) {
        const double time = 0.25 * eighth;
        score.notes.push_back(kit_note(time, kHat));
        if (eighth % 8 == 2 || eighth % 8 == 6) score.notes.push_back(kit_note(time, kSnare));
        if (eighth % 4 == 0) score.notes.push_back(kit_note(time, kKick));
    }
    const Kit kit = small_kit();
    const KitPlan plan = plan_kit(score, kit);
    CHECK(plan.left_out.empty());
    for (const KitStroke& s : plan.strokes) {
        const std::string& event = kit.events[s.event].name;
        if (event == "hat") CHECK(s.limb == Limb::right_hand);
        if (event == "snare") CHECK(s.limb == Limb::left_hand);
        if (event == "kick") CHECK(s.limb == Limb::right_foot);
    }
}

TEST_CASE("kit plan: a paradiddle between hi-hat and snare is played as one") {
    const std::vector<int> keys{kHat, kSnare, kHat, kHat, kSnare, kHat, kSnare, kSnare};
    std::vector<int> twice = keys;
    twice.insert(twice.end(), keys.begin(), keys.end());
    // All but the last note, which nothing follows.
    const std::string hands = sticking(plan_kit(kit_line(twice, 0.125), small_kit()));
    CHECK(hands.substr(0, 15) == "RLRRLRLLRLRRLRL");
}

TEST_CASE("kit plan: a fast roll alternates") {
    for (const double interval : {0.07, 0.09, 0.125}) {
        const std::string hands =
            sticking(plan_kit(kit_line(std::vector<int>(32, kSnare), interval), small_kit()));
        REQUIRE(hands.size() == 32);
        for (std::size_t i = 1; i < hands.size(); ++i) CHECK(hands[i] != hands[i - 1]);
    }
}

TEST_CASE("kit plan: a fill around the toms loses nothing and crosses nothing") {
    const std::vector<int> fill{kSnare,    kSnare,    kSnare,    kSnare,    kHighTom, kHighTom,
                                kHighTom,  kHighTom,  kMidTom,   kMidTom,   kMidTom,  kMidTom,
                                kFloorTom, kFloorTom, kFloorTom, kFloorTom, kRide};
    const KitPlan plan = plan_kit(kit_line(fill, 0.11), small_kit());
    CHECK(plan.left_out.empty());
    CHECK(audit(plan, small_kit()).crossed == 0);
    CHECK(sticking(plan).back() == 'R');
}

TEST_CASE("kit plan: left-handed preferences mirror the hands") {
    Kit kit = small_kit();
    for (KitObject& o : kit.objects) o.middle.y() *= -1.0;
    for (KitEvent& e : kit.events) {
        if (e.hand) e.hand = other_hand(*e.hand);
    }
    for (auto& pair : kit.pairs) {
        if (pair) pair->hand = other_hand(pair->hand);
    }
    // On off-beats neither hand leads.
    const std::vector<int> keys{0, kHat, kSnare, kHat, 0, kHat, kSnare, kHat};
    std::string mirrored = sticking(plan_kit(kit_line(keys, 0.25), kit));
    for (char& c : mirrored) c = c == 'L' ? 'R' : 'L';
    CHECK(mirrored == sticking(plan_kit(kit_line(keys, 0.25), small_kit())));
}

TEST_CASE("kit plan: of three at once the two loudest stay, then the first of the kit") {
    Score score;
    score.notes = {kit_note(1.0, kHighTom, 0.5), kit_note(1.0, kSnare, 0.9),
                   kit_note(1.0, kFloorTom, 0.5)};
    const KitPlan plan = plan_kit(score, small_kit());
    REQUIRE(plan.left_out.size() == 1);
    CHECK(plan.left_out[0].note == 2);
    CHECK(describe(plan.left_out[0], score).find("third note") != std::string::npos);
}

TEST_CASE("kit plan: doubles are what one object would get at one instant") {
    Score score;
    score.notes = {kit_note(1.0, kSnare, 0.5), kit_note(1.0005, kSnare, 0.9),
                   kit_note(1.0, kKick, 0.5)};
    const KitPlan plan = plan_kit(score, small_kit());
    REQUIRE(plan.doubles.size() == 1);
    CHECK(plan.doubles[0].note == 0);
    CHECK(plan.strokes.size() == 2);
}

TEST_CASE("kit plan: of what a foot cannot play the fewest are left out") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> gap(0.01, 0.12);
    for (int round = 0; round < 100; ++round) {
        std::vector<FootHit> hits;
        double time = 0.0;
        for (int i = 0; i < 11; ++i) {
            hits.push_back({time, 0.5});
            time += gap(random);
        }
        long most = 0;
        for (unsigned choice = 0; choice < 1U << hits.size(); ++choice) {
            double last = -1.0;
            long count = 0;
            for (std::size_t i = 0; i < hits.size() && count >= 0; ++i) {
                if ((choice >> i & 1U) == 0) continue;
                count = hits[i].time - last >= 0.075 ? count + 1 : -1;
                last = hits[i].time;
            }
            most = std::max(most, count);
        }
        const auto played = thin(hits, 0.075);
        CHECK(std::count(played.begin(), played.end(), true) == most);
    }
}

TEST_CASE("kit plan: what cannot be is refused") {
    Kit kit = small_kit();
    kit.keys[40] = 99;
    CHECK_THROWS_AS(plan_kit({}, kit), std::invalid_argument);
    Score score;
    score.notes = {kit_note(1.0, kSnare, 0.0)};
    CHECK_THROWS_AS(plan_kit(score, small_kit()), std::invalid_argument);
    score.notes = {kit_note(std::nan(""), kSnare)};
    CHECK_THROWS_AS(plan_kit(score, small_kit()), std::invalid_argument);
}
