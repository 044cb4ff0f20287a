// A serial line's own slowness: bytes leave one after the other, each after its ten bits.
#pragma once

#include <algorithm>
#include <deque>
#include <span>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::tracker {

class TimedWire {
  public:
    explicit TimedWire(int baud) : byte_time_(10.0 / baud) {}

    void set_baud(int baud) { byte_time_ = 10.0 / baud; }
    double byte_time() const { return byte_time_; }  ///< [s]

    /// What waits to be sent then [s].
    double backlog(double now) const { return std::max(0.0, busy_until_ - now); }

    void send(std::span<const std::uint8_t> bytes, double now) {
        busy_until_ = std::max(busy_until_, now);
        for (const std::uint8_t byte : bytes) {
            busy_until_ += byte_time_;
            bytes_.push_back({byte, busy_until_});
        }
    }

    /// Appends what has left by then.
    void arrive(double now, motion::Bytes& out) {
        while (!bytes_.empty() && bytes_.front().time <= now) {
            out.push_back(bytes_.front().byte);
            bytes_.pop_front();
        }
    }

    void clear() { bytes_.clear(); }

  private:
    struct TimedByte {
        std::uint8_t byte;
        double time;
    };
    std::deque<TimedByte> bytes_;
    double byte_time_;
    double busy_until_ = 0.0;
};

}  // namespace percussionist::tracker
