// What messages ask for at their logical time, until the block comes that holds that time.
//
//     queue.push(now(), stroke);                                       in a message's handler
//     queue.take(block, [&](std::size_t offset, const Stroke& s) ...)  in process()
//
// Capacity is fixed, first in first out: logical time never runs back. What waited while signals
// were off is stale and is dropped. All in Pd's one thread; take() is for process().
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "pdx/object.hpp"

namespace percussionist::pdx {

template <class T, std::size_t Capacity>
class TimedQueue {
  public:
    /// False if it is full.
    bool push(double time, const T& item) {
        if (count_ == Capacity) {
            return false;
        }
        items_[(first_ + count_++) % Capacity] = {time, item};
        return true;
    }

    /// Calls take_one(offset, item) for each whose time is in the block or shortly before it.
    template <class TakeOne>
    void take(const Block& block, TakeOne take_one) noexcept {
        while (count_ > 0) {
            const Timed& next = items_[first_];
            const double offset = std::round((next.time - block.start) * block.sample_rate);
            if (offset >= static_cast<double>(block.size)) {
                return;
            }
            if (next.time > block.start - kStale) {
                take_one(offset > 0.0 ? static_cast<std::size_t>(offset) : 0, next.item);
            }
            first_ = (first_ + 1) % Capacity;
            --count_;
        }
    }

    void clear() { count_ = 0; }

  private:
    static constexpr double kStale = 0.1;  // [s]
    struct Timed {
        double time = 0.0;
        T item;
    };
    std::array<Timed, Capacity> items_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace percussionist::pdx
