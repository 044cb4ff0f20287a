#include "io/spsc_ring.hpp"

#include <doctest/doctest.h>

#include <thread>

using percussionist::io::SpscRing;

TEST_CASE("what goes in comes out, in order, until it is full") {
    SpscRing<int> ring(3);
    int item = 0;
    CHECK_FALSE(ring.pop(item));
    for (int round = 0; round < 5; ++round) {
        CHECK((ring.push(1) && ring.push(2) && ring.push(3)));
        CHECK_FALSE(ring.push(4));
        for (const int expected : {1, 2, 3}) {
            REQUIRE(ring.pop(item));
            CHECK(item == expected);
        }
    }
}

TEST_CASE("between two threads nothing is lost or doubled") {
    SpscRing<int> ring(16);
    constexpr int kItems = 100'000;
    std::thread writer([&ring] {
        for (int i = 0; i < kItems;) {
            i += ring.push(i) ? 1 : 0;
        }
    });
    int expected = 0, item = 0;
    bool in_order = true;
    while (expected < kItems) {
        if (ring.pop(item)) {
            in_order = in_order && item == expected++;
        }
    }
    writer.join();
    CHECK(in_order);
}
