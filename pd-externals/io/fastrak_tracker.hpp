// A FASTRAK, or a recording of one, in a thread of its own: opened, set up, listened to, lost and
// found again; what it says comes out of one lock-free queue.
//
// next() and all orders are for one other thread, which they never keep waiting. The destructor
// waits for the thread, which answers within milliseconds.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <thread>

#include "core/linear/pose.hpp"
#include "core/motion/fastrak_settings.hpp"
#include "io/serial_port.hpp"
#include "io/spsc_ring.hpp"

namespace percussionist::io {

/// Text in a fixed place, cut where it does not fit: a queue's items must not allocate.
/// What is longer is cut.
template <std::size_t Size>
std::array<char, Size> fixed_text(const std::string& text) {
    std::array<char, Size> fixed{};
    std::copy_n(text.begin(), std::min(text.size(), Size - 1), fixed.begin());
    return fixed;
}
using ShortText = std::array<char, 200>;
using PathText = std::array<char, 1024>;

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
    enum class Kind {
        kOpen,
        kClose,
        kSettings,
        kSend,
        kBoresight,
        kRecord,
        kPlay,
        kStop,
        kDevices
    };
    Kind kind = Kind::kStop;
    PathText text{};  ///< of kOpen the device, of kSend the command, of kRecord and kPlay the file
    int baud = 0;
    motion::FastrakSettings settings;
    int station = 1;                          ///< of kBoresight
    std::optional<linear::Quaternion> shown;  ///< of kBoresight: now; none: what the unit says
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
