#include "core/timing/sequence_filter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

using percussionist::timing::SequenceFilter;

namespace {

constexpr std::int64_t kSecond = 1000;

}  // namespace

TEST_CASE("each event is new once, whatever is lost, repeated or out of order") {
    std::mt19937 random(1);
    for (int run = 0; run < 20; ++run) {
        // Event i at 50 i ms; each packet carries four; a fifth of the packets is lost; they come
        // out of order by a few.
        std::vector<std::int64_t> arrivals;
        std::set<std::int64_t> arrived;
        for (std::int64_t i = 0; i < 500; ++i) {
            for (int again = 0; again < 3; ++again) {
                for (std::int64_t k = i; k >= std::max<std::int64_t>(0, i - 3); --k) {
                    if (random() % 5 != 0) {
                        arrivals.push_back(k);
                        arrived.insert(k);
                    }
                }
            }
        }
        for (std::size_t i = 0; i + 8 < arrivals.size(); i += 8) {
            std::shuffle(arrivals.begin() + static_cast<long>(i),
                         arrivals.begin() + static_cast<long>(i) + 8, random);
        }
        SequenceFilter filter(kSecond);
        std::set<std::int64_t> heard;
        for (const auto number : arrivals) {
            if (filter.is_new(number, 50 * number)) {
                CHECK(heard.insert(number).second);
            }
        }
        CHECK(heard == arrived);
        CHECK(filter.lost() ==
              *arrived.rbegin() - *arrived.begin() + 1 - static_cast<std::int64_t>(arrived.size()));
        CHECK(filter.repeated() == static_cast<std::int64_t>(arrivals.size() - arrived.size()));
    }
}

TEST_CASE("what never comes is lost, what comes late is not") {
    SequenceFilter filter(kSecond);
    CHECK(filter.is_new(0, 0));
    CHECK(filter.is_new(5, 500));
    CHECK(filter.lost() == 4);
    CHECK(filter.is_new(3, 300));
    CHECK(filter.lost() == 3);
    CHECK(!filter.is_new(3, 300));
    CHECK(filter.lost() == 3);
}

TEST_CASE("whoever comes late has lost nothing of what was before") {
    SequenceFilter filter(kSecond);
    CHECK(filter.is_new(1000, 0));
    CHECK(filter.is_new(1001, 50));
    CHECK(filter.lost() == 0);
}

TEST_CASE("events before the first heard fill their gaps in any order") {
    SequenceFilter filter(kSecond);
    CHECK(filter.is_new(5, 500));
    CHECK(filter.is_new(2, 470));
    CHECK(filter.lost() == 2);
    CHECK(filter.is_new(3, 480));
    CHECK(filter.is_new(4, 490));
    CHECK(filter.lost() == 0);
}

TEST_CASE("a sender that starts anew is heard from 0 again, and its repeats are dropped") {
    for (const std::int64_t first_run : {1, 3, 57, 5000}) {
        CAPTURE(first_run);
        SequenceFilter filter(kSecond);
        for (std::int64_t i = 0; i < first_run; ++i) {
            filter.is_new(i, 50 * i);
        }
        const std::int64_t later = 50 * first_run + 2 * kSecond;
        for (std::int64_t i = 0; i < 100; ++i) {
            if (i == 7) {
                continue;
            }
            CHECK(filter.is_new(i, later + 50 * i));
            CHECK(!filter.is_new(i, later + 50 * i));
        }
        CHECK(filter.lost() == 1);
        CHECK(filter.is_new(7, later + 50 * 7));
        CHECK(filter.lost() == 0);
    }
}

TEST_CASE("a sender that starts anew with its clock set back is heard too") {
    SequenceFilter filter(kSecond);
    for (std::int64_t i = 0; i < 50; ++i) {
        filter.is_new(i, 10'000'000 + 50 * i);
    }
    for (std::int64_t i = 0; i < 60; ++i) {
        CHECK(filter.is_new(i, 50 * i));
        CHECK(!filter.is_new(i, 50 * i));
    }
    CHECK(filter.lost() == 0);
}

TEST_CASE("tags wrap: what is heard over the end of all tags is one run") {
    SequenceFilter filter(kSecond);
    const auto last = std::numeric_limits<std::int64_t>::max();
    CHECK(filter.is_new(0, last - 40));
    CHECK(filter.is_new(1, last));
    const auto wrapped = static_cast<std::int64_t>(static_cast<std::uint64_t>(last) + 40);
    CHECK(filter.is_new(2, wrapped));
    CHECK(!filter.is_new(1, last));
    CHECK(filter.is_new(4, wrapped + 80));
    CHECK(filter.lost() == 1);
}

TEST_CASE("numbers and tags of any size are counted within bounds") {
    std::mt19937_64 random(1);
    SequenceFilter filter(kSecond);
    for (int i = 0; i < 100000; ++i) {
        const auto number = static_cast<std::int64_t>(random());
        filter.is_new(number, static_cast<std::int64_t>(random()));
        REQUIRE(filter.lost() >= -i);
    }
}
