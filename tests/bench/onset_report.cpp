// How many strokes on a synthetic ringing drum are heard, and how well in time: a row for each
// mallet (its time in contact) and each range of loudness.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/listening/onset.hpp"
#include "core/listening/onset_match.hpp"
#include "support/struck_drum.hpp"

using namespace percussionist;

namespace {

void report(double contact, double range_db) {
    const auto strokes = test::wandering(120, range_db);
    const auto times = test::times_of(strokes);
    const auto signal = test::drum(strokes, contact, 8.0);
    std::vector<double> found;
    for (const auto& onset : listening::find_onsets(signal, test::kRate)) {
        found.push_back(onset.time);
    }
    std::vector<double> near;
    for (const auto& time : listening::onsets_near(signal, test::kRate, times, 0.02)) {
        if (time) {
            near.push_back(*time);
        }
    }
    const auto blind = listening::match(times, found, 0.005);
    const auto knowing = listening::match(times, near, 0.005);
    const auto astray = static_cast<std::size_t>(
        std::count_if(knowing.pairs.begin(), knowing.pairs.end(),
                      [](const auto& pair) { return std::abs(pair.error) > 0.0005; }));
    std::printf("| %.1f | %.0f | %zu | %zu | %.3f | %.3f | %.3f | %zu | %zu |\n", 1e3 * contact,
                range_db, blind.pairs.size(), blind.extra.size(), 1e3 * blind.offset,
                1e3 * blind.median_error, 1e3 * blind.worst_error, knowing.pairs.size(), astray);
}

}  // namespace

int main() {
    std::puts(
        "| contact ms | range dB | found of 120 | extra | offset ms | median error ms | worst ms "
        "| found when expected | off by > 0.5 ms |\n|---|---|---|---|---|---|---|---|---|");
    for (const double contact : {0.0005, 0.001, 0.002, 0.003, 0.0055}) {
        for (const double range_db : {6.0, 12.0, 40.0}) {
            report(contact, range_db);
        }
    }
}
