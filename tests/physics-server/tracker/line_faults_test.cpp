// Four stations on a damaged line: whole records arrive, all of them, and no others.
#include "tracker/line_faults.hpp"

#include <doctest/doctest.h>

#include "core/motion/bodhran_player.hpp"
#include "core/motion/fastrak_settings.hpp"
#include "core/motion/fastrak_stream.hpp"

using namespace percussionist;
using namespace percussionist::motion;

namespace {

struct Outcome {
    int sent = 0, whole = 0, arrived = 0, false_poses = 0;
};

/// Each record that arrives has to be the next that was sent, or a later one: nothing made up.
Outcome over_damaged_line(Encoding encoding, int records) {
    FastrakSettings settings;
    settings.encoding = encoding;
    const FastrakLayout layout = layout_for(settings);
    FastrakStream stream;
    for (int station = 1; station <= kFastrakStations; ++station) {
        stream.expect(station, layout);
    }
    tracker::LineFaults faults({.garbage = 0.05, .cut = 0.02, .seed = 7});
    const BodhranPlayer player;
    Outcome outcome;
    std::vector<FastrakReading> truths;
    std::size_t next = 0;
    for (int i = 0; i < records; ++i) {
        FastrakReading reading;
        reading.station = 1 + i % kFastrakStations;
        reading.pose = player.receiver(reading.station, i * kFastrakCycle);
        Bytes bytes;
        encode(reading, layout, bytes);
        const auto as_sent = decode(bytes, layout);
        REQUIRE(as_sent);
        ++outcome.sent;
        outcome.whole += faults.damage(bytes) ? 0 : 1;
        truths.push_back(*as_sent);
        for (const auto& arrived : stream.receive(bytes, 0.0, 0.0)) {
            ++outcome.arrived;
            std::size_t match = next;
            while (match < truths.size() &&
                   truths[match].pose.position != arrived.reading.pose.position) {
                ++match;
            }
            outcome.false_poses += match == truths.size() ? 1 : 0;
            next = match == truths.size() ? next : match + 1;
        }
    }
    return outcome;
}

}  // namespace

TEST_CASE("of 100,000 records with 5 % garbage and 2 % cut, the damaged ones are lost, no more") {
    for (const Encoding encoding : {Encoding::kFloat32, Encoding::k16Bit}) {
        const Outcome outcome = over_damaged_line(encoding, 100'000);
        MESSAGE(outcome.whole << " whole, " << outcome.arrived << " arrived");
        CHECK(outcome.whole < 0.9 * outcome.sent);
        CHECK(outcome.arrived >= outcome.whole);
        // A byte put before its own like leaves a record whole.
        CHECK(outcome.arrived - outcome.whole < 20);
        CHECK(outcome.false_poses == 0);
    }
}
