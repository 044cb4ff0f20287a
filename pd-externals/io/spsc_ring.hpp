// A queue between two threads: one pushes, one pops, neither ever waits, allocates or locks.
//
// Room for `capacity` items is made at creation. push() is for the one thread, pop() for the other.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

namespace percussionist::io {

template <class T>
class SpscRing {
  public:
    /// Rounded up to a power of two.
    explicit SpscRing(std::size_t capacity) : items_(std::bit_ceil(capacity)) {}

    /// False, and the item still the caller's, if it is full.
    bool push(T&& item) noexcept {
        const std::size_t at = pushed_.load(std::memory_order_relaxed);
        if (at - popped_.load(std::memory_order_acquire) == items_.size()) {
            return false;
        }
        items_[at & (items_.size() - 1)] = std::move(item);
        pushed_.store(at + 1, std::memory_order_release);
        return true;
    }

    /// The same with a copy.
    bool push(const T& item) {
        T copy = item;
        return push(std::move(copy));
    }

    /// False if it is empty.
    bool pop(T& item) noexcept {
        const std::size_t at = popped_.load(std::memory_order_relaxed);
        if (at == pushed_.load(std::memory_order_acquire)) {
            return false;
        }
        item = std::move(items_[at & (items_.size() - 1)]);
        popped_.store(at + 1, std::memory_order_release);
        return true;
    }

  private:
    static constexpr std::size_t kCacheLine = 64;  // so that the threads do not share one
    std::vector<T> items_;
    alignas(kCacheLine) std::atomic<std::size_t> pushed_{0};
    alignas(kCacheLine) std::atomic<std::size_t> popped_{0};
};

}  // namespace percussionist::io
