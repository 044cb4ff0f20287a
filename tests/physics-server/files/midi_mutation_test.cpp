#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "core/score/stroke_plan.hpp"
#include "files/midi_file.hpp"
#include "support/midi_writer.hpp"
#include "support/plan_laws.hpp"

using namespace percussionist;
using test::Bytes;

namespace {

/// One to six changes: a byte, a bit, a piece cut out, doubled or moved, the end cut off.
Bytes mutated(Bytes bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return random() % n; };
    for (std::size_t i = 1 + below(6); i > 0 && bytes.size() > 4; --i) {
        const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() - 3));
        const auto to = at + static_cast<std::ptrdiff_t>(
                                 1 + below(std::min<std::size_t>(16, bytes.end() - at)));
        switch (below(6)) {
            case 0:
                *at = static_cast<std::uint8_t>(random());
                break;
            case 1:
                *at = static_cast<std::uint8_t>(*at ^ (1U << below(8)));
                break;
            case 2:
                bytes.erase(at, std::min(to, bytes.end()));
                break;
            case 3: {
                const Bytes piece(at, std::min(to, bytes.end()));
                bytes.insert(at, piece.begin(), piece.end());
                break;
            }
            case 4:
                std::fill(at, std::min(to, bytes.end()), std::uint8_t{0xFF});
                break;
            default:
                bytes.erase(to, bytes.end());
                break;
        }
    }
    return bytes;
}

}  // namespace

TEST_CASE("no damage to a file crashes the reader, and what is read can be planned") {
    std::mt19937 random(20);
    int read = 0;
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        const Bytes bytes = mutated(test::rich_midi_file(i % 3), random);
        try {
            const files::MidiFile file = files::parse_midi(bytes, "x.mid");
            const score::Score score = files::midi_to_score(file);
            ++read;
            CHECK(std::is_sorted(score.notes.begin(), score.notes.end(),
                                 [](const auto& a, const auto& b) { return a.time < b.time; }));
            CHECK(file.notes.size() <= bytes.size() / 3);
            CHECK(file.warnings.size() <= 32);
            if (i % 20 == 0) {
                test::check_no_note_is_lost(score, score::plan_strokes(score));
            }
        } catch (const files::MidiError& error) {
            ++refused;
            CHECK(std::string(error.what()).find("x.mid: byte ") == 0);
        }
    }
    CHECK(read > 10000);
    CHECK(refused > 500);
}
