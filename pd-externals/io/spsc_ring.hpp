// A queue from one thread to one other, without locks or waiting.
//
// push() is for one thread, pop() for one other; neither allocates once the ring is made, if
// copying T does not. Capacity is fixed.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace percussionist::io {

template <class T>
class SpscRing {
  public:
    explicit SpscRing(std::size_t capacity) : items_(capacity + 1) {}

    /// False if it is full.
    bool push(const T& item) {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        const std::size_t next = (tail + 1) % items_.size();
        if (next == head_.load(std::memory_order_acquire)) {
            return false;
        }
        items_[tail] = item;
        tail_.store(next, std::memory_order_release);
        return true;
    }

    /// False if it is empty.
    bool pop(T& item) {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        if (head == tail_.load(std::memory_order_acquire)) {
            return false;
        }
        item = items_[head];
        head_.store((head + 1) % items_.size(), std::memory_order_release);
        return true;
    }

  private:
    std::vector<T> items_;
    alignas(64) std::atomic<std::size_t> head_{0};
    alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace percussionist::io
