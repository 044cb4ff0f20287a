// The instants at which a tracker measured, out of the jittered times at which its records came.
//
// A FASTRAK measures on a grid of one cycle (8.33 ms), whatever the stations; system and line only
// ever delay what it sends. So the grid is drawn along the earliest arrivals: early ones move it at
// once, late ones hardly. A second-order loop also learns the true period (external sync, a quartz
// off by some 100 ppm). What lies off the grid by more than half a cycle, and stays there, starts a
// new grid; until then its own time stands. Pure; real-time safe; one thread.
#pragma once

namespace percussionist::motion {

class CycleClock {
  public:
    explicit CycleClock(double period);

    /// The grid's time for what came then [s].
    double smooth(double arrival) noexcept;
    double period() const { return period_; }

  private:
    double nominal_;
    double period_;
    double last_ = 0.0;
    bool locked_ = false;
    int astray_ = 0;
};

}  // namespace percussionist::motion
