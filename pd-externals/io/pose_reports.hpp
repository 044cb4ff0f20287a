// How well a tracker's poses come: rate, jitter and bytes lost, a report each second.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::io {

class PoseReports {
  public:
    struct Report {
        double rate = 0.0;    ///< [1/s]
        double jitter = 0.0;  ///< of the arrival about its instant, standard deviation [s]
    };

    void start(double now) {
        counts_ = {};
        began_ = now;
    }
    void add(int station, double late) {
        Count& count = counts_[static_cast<std::size_t>(station - 1)];
        ++count.poses;
        count.sum += late;
        count.squares += late * late;
    }
    bool due(double now) const { return now >= began_ + 1.0; }
    Report report(int station, double now) const {
        const Count& count = counts_[static_cast<std::size_t>(station - 1)];
        const double n = count.poses;
        const double mean = n > 0 ? count.sum / n : 0.0;
        const double variance = n > 0 ? count.squares / n - mean * mean : 0.0;
        return {n / (now - began_), std::sqrt(std::fmax(variance, 0.0))};
    }

  private:
    struct Count {
        double poses = 0, sum = 0.0, squares = 0.0;
    };
    std::array<Count, motion::kFastrakStations> counts_{};
    double began_ = 0.0;
};

}  // namespace percussionist::io
