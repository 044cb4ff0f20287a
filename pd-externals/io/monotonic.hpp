// The one clock that all arrivals and ticks are read from.
#pragma once

#include <ctime>

namespace percussionist::io {

inline double seconds(const timespec& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double read_clock(clockid_t clock) noexcept {
    timespec now{};
    clock_gettime(clock, &now);
    return seconds(now);
}

/// Never set, never back [s]. No system call on Linux: for any thread, the audio thread too.
inline double monotonic_seconds() noexcept {
    return read_clock(CLOCK_MONOTONIC);
}

}  // namespace percussionist::io
