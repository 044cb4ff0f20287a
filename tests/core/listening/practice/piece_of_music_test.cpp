#include "core/listening/practice/piece_of_music.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace percussionist::listening;

TEST_CASE("the same seed makes the same piece, another one another") {
    const auto one = practice::piece_of_music(3, 2.0), same = practice::piece_of_music(3, 2.0);
    CHECK(one.signal == same.signal);
    CHECK(practice::piece_of_music(4, 2.0).signal != one.signal);
}

TEST_CASE("practice pieces are finite, in order, and between them hold every drum") {
    std::array<int, kDrumClasses> each{};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto piece = practice::piece_of_music(seed, 6.0);
        CHECK(std::all_of(piece.signal.begin(), piece.signal.end(),
                          [](double x) { return std::isfinite(x); }));
        CHECK(std::is_sorted(piece.strokes.begin(), piece.strokes.end(),
                             [](const auto& a, const auto& b) { return a.time < b.time; }));
        for (const auto& s : piece.strokes) {
            CHECK(s.time >= 0.0);
            CHECK(s.time < 6.0);
            ++each[index(s.drum)];
        }
    }
    CHECK(std::all_of(each.begin(), each.end(), [](int count) { return count > 0; }));
}
