// A FASTRAK, or a recording of one, in a thread of its own: opened, set up, listened to, lost and
// found again; what it says comes out of one lock-free queue.
//
// next() and all orders are for one other thread, which they never keep waiting. The destructor
// waits for the thread, which answers within milliseconds.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <thread>

#include "core/motion/fastrak_settings.hpp"
#include "io/serial_port.hpp"
#include "io/spsc_ring.hpp"

namespace percussionist::io {

/// Text in a fixed place, cut where it does not fit: a queue's items must not allocate.
using ShortText = std::array<char, 200>;
ShortText short_text(const std::string& text);

struct TrackerEvent {
    enum class Kind { kPose, kStatus };
    Kind kind = Kind::kPose;
    // A pose:
    double time = 0.0;  ///< when it was measured, on the steady clock [s]
    int station = 1;
    linear::Pose pose;
    // A status: its name, up to two numbers, and words.
    ShortText name{};
    std::array<double, 2> numbers{};
    int number_count = 0;
    ShortText words{};
};

struct TrackerOrder {
    enum class Kind { kOpen, kClose, kSettings, kSend, kRecord, kPlay, kStop, kDevices };
    Kind kind = Kind::kStop;
    ShortText text{};  ///< of kOpen the device, of kSend the command, of kRecord and kPlay the file
    int baud = 0;
    motion::FastrakSettings settings;
};

/// On the steady clock [s].
double steady_now();

class FastrakTracker {
  public:
    FastrakTracker();
    ~FastrakTracker();
    FastrakTracker(const FastrakTracker&) = delete;
    FastrakTracker& operator=(const FastrakTracker&) = delete;

    /// False if too many wait.
    bool order(const TrackerOrder& order);
    /// False if there is nothing.
    bool next(TrackerEvent& event) { return events_.pop(event); }

  private:
    class Worker;
    SpscRing<TrackerOrder> orders_{32};
    SpscRing<TrackerEvent> events_{1024};
    Waker waker_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace percussionist::io
