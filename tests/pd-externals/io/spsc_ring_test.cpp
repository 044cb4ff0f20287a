#include "io/spsc_ring.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <thread>

using percussionist::io::SpscRing;

TEST_CASE("a full ring refuses, and the item stays the caller's") {
    SpscRing<std::unique_ptr<int>> ring(4);
    for (int i = 0; i < 4; ++i) {
        CHECK(ring.push(std::make_unique<int>(i)));
    }
    auto more = std::make_unique<int>(4);
    CHECK(!ring.push(std::move(more)));
    CHECK(*more == 4);
    std::unique_ptr<int> item;
    for (int i = 0; i < 4; ++i) {
        REQUIRE(ring.pop(item));
        CHECK(*item == i);
    }
    CHECK(!ring.pop(item));
}

TEST_CASE("between two threads everything arrives once and in order") {
    SpscRing<int> ring(64);
    constexpr int kMany = 200000;
    std::thread producer([&ring] {
        for (int i = 0; i < kMany; ++i) {
            while (!ring.push(int(i))) {
                std::this_thread::yield();
            }
        }
    });
    int wrong = 0;
    for (int expected = 0, item = 0; expected < kMany;) {
        if (ring.pop(item)) {
            wrong += item != expected++;
        } else {
            std::this_thread::yield();
        }
    }
    producer.join();
    CHECK(wrong == 0);
}
