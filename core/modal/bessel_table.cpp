#include "core/modal/bessel_table.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::modal {

namespace {

constexpr double kStep = 0.25;
/// Above this order J_m(210) and I_m(210) are below 1e-30 of the largest: there recurrence starts.
constexpr int kStart = 420;

/// f_{m-1} = 2 m / x f_m + sign f_{m+1}, downwards, then scaled so that f_0 + 2 (f_2 + f_4 ..) = 1
/// (J: sign -1) or f_0 + 2 (f_1 + f_2 ..) = 1 (exp(-x) I: sign 1).
std::vector<double> all_orders(double x, double sign, int orders) {
    std::vector<double> f(kStart + 2, 0.0);
    if (x == 0.0) {
        f[0] = 1.0;
        f.resize(static_cast<std::size_t>(orders));
        return f;
    }
    constexpr double kLarge = 1e200;
    f[kStart] = 1e-200;
    for (int m = kStart; m > 0; --m) {
        f[m - 1] = 2 * m / x * f[m] + sign * f[m + 1];
        if (std::abs(f[m - 1]) > kLarge) {
            std::for_each(f.begin() + m - 1, f.end(), [](double& value) { value /= kLarge; });
        }
    }
    double sum = f[0];
    for (int m = sign < 0 ? 2 : 1; m <= kStart; m += sign < 0 ? 2 : 1) {
        sum += 2 * f[m];
    }
    f.resize(static_cast<std::size_t>(orders));
    for (double& value : f) {
        value /= sum;
    }
    return f;
}

}  // namespace

const BesselTable& BesselTable::shared() {
    static const BesselTable table;
    return table;
}

BesselTable::BesselTable() {
    const int rows = static_cast<int>(kReach / kStep) + 1;
    for (const double sign : {-1.0, 1.0}) {
        auto& table = sign < 0 ? j_ : i_;
        table.reserve(static_cast<std::size_t>(rows) * kRow);
        for (int row = 0; row < rows; ++row) {
            const auto f = all_orders(row * kStep, sign, kOrders + kTerms);
            for (int m = kTerms; m > 0; --m) {
                table.push_back(sign < 0 && m % 2 != 0 ? -f[m] : f[m]);
            }
            table.insert(table.end(), f.begin(), f.end());
        }
    }
}

double BesselTable::value(const std::vector<double>& table, int m, double x,
                          double sign) const noexcept {
    const double row = std::floor(x / kStep + 0.5);
    const double t = 0.5 * (x - row * kStep);
    const double z = sign * t * t;
    const double* const at =
        table.data() + static_cast<std::size_t>(row) * kRow + static_cast<std::size_t>(m + kTerms);
    double power = 1.0;  // t^k / k!
    double sum = 0.0;
    for (int k = 0; k <= kTerms; ++k) {
        const double series =
            1 + z / (k + 1) *
                    (1 + z / (2 * (k + 2)) * (1 + z / (3 * (k + 3)) * (1 + z / (4 * (k + 4)))));
        const double other = sign < 0 && k % 2 != 0 ? -at[k] : at[k];
        sum += power * series * (k == 0 ? at[0] : at[-k] + other);
        power *= t / (k + 1);
    }
    return sum;
}

double BesselTable::scaled_i(int m, double x) const noexcept {
    const double row = std::floor(x / kStep + 0.5);
    return std::exp(row * kStep - x) * value(i_, m, x, 1.0);
}

}  // namespace percussionist::modal
