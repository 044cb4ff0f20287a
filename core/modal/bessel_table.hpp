// Bessel functions for thousands of modes at once: J_m(x) and exp(-x) I_m(x), of whole orders.
//
// All orders stand ready at every quarter of x, by Miller's downward recurrence; between, the
// addition theorems
//     J_m(x + d) = sum over k of J_k(d) J_{m-k}(x)      I_m(x + d) = sum over k of I_k(d)
//     I_{m-k}(x)
// are cut off after |k| = 8, where for |d| <= 1/8 the rest is below 1e-16 (DLMF 10.23.2, 10.44.3).
// Some 30 ns each, an error of a few 1e-16 against 1; `std::cyl_bessel_j` takes ten times as long.
//
// shared() allocates and takes some milliseconds the first time; the rest is noexcept.
#pragma once

#include <cstddef>
#include <vector>

namespace percussionist::modal {

class BesselTable {
  public:
    static constexpr int kOrders = 208;      ///< 0 <= m < kOrders
    static constexpr double kReach = 210.0;  ///< 0 <= x <= kReach

    static const BesselTable& shared();

    double j(int m, double x) const noexcept { return value(j_, m, x, -1.0); }
    /// exp(-x) I_m(x).
    double scaled_i(int m, double x) const noexcept;

  private:
    static constexpr int kTerms = 8;
    static constexpr int kRow = kOrders + 2 * kTerms;  // orders -kTerms to kOrders + kTerms - 1

    BesselTable();
    double value(const std::vector<double>& table, int m, double x, double sign) const noexcept;

    std::vector<double> j_, i_;
};

}  // namespace percussionist::modal
