// A smooth curve through samples: the natural cubic spline, in any number of dimensions.
//
// Twice continuously differentiable, which inverse dynamics needs of a target; exact at the
// samples, which may lie at any distances in time (gaps are bridged). Before the first and after
// the last sample it goes on straight, at constant speed. de Boor 2001, "A practical guide to
// splines", ch. 4.
//
// Building allocates; at() is pure and real-time safe.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::body {

class Spline {
  public:
    Spline() = default;
    /// `values` holds `dimension` numbers for each of `times` [s], which ascend. Throws
    /// std::invalid_argument if they do not, or are none.
    Spline(std::vector<double> times, std::vector<double> values, std::size_t dimension);

    /// The value at t into `out` (of `dimension` numbers).
    void at(double t, std::span<double> out) const;

    [[nodiscard]] double start() const { return times_.front(); }
    [[nodiscard]] double end() const { return times_.back(); }
    [[nodiscard]] bool empty() const { return times_.empty(); }
    [[nodiscard]] const std::vector<double>& times() const { return times_; }

  private:
    void find_bends();

    std::vector<double> times_;
    std::vector<double> values_;
    std::vector<double> bends_;  ///< second derivatives at the samples
    std::size_t dimension_ = 0;
};

}  // namespace percussionist::body
