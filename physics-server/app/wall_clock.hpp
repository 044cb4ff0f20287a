// The clock the running server goes by; tests give it one that they advance themselves.
#pragma once

namespace percussionist::app {

class WallClock {
  public:
    virtual ~WallClock() = default;
    WallClock() = default;
    WallClock(const WallClock&) = delete;
    WallClock& operator=(const WallClock&) = delete;

    /// Seconds since 1970 at the clock's start, steady since: it never jumps. Any thread.
    [[nodiscard]] virtual double now() const = 0;
    /// Returns at `time` or a little later.
    virtual void sleep_until(double time) = 0;
};

/// The machine's: real time at the start, the monotonic clock from there on.
class SystemClock : public WallClock {
  public:
    SystemClock();
    [[nodiscard]] double now() const override;
    void sleep_until(double time) override;

  private:
    double offset_;  ///< of real time against the monotonic clock, at the start [s]
};

}  // namespace percussionist::app
