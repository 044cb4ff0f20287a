#include "body/spline.hpp"

#include <algorithm>
#include <stdexcept>

namespace percussionist::body {

Spline::Spline(std::vector<double> times, std::vector<double> values, std::size_t dimension)
    : times_(std::move(times)), values_(std::move(values)), dimension_(dimension) {
    if (times_.empty() || values_.size() != times_.size() * dimension) {
        throw std::invalid_argument("spline: expected samples, and as many values as times");
    }
    for (std::size_t i = 1; i < times_.size(); ++i) {
        if (!(times_[i] > times_[i - 1])) {
            throw std::invalid_argument("spline: expected times that ascend");
        }
    }
    find_bends();
}

void Spline::find_bends() {
    const std::size_t n = times_.size();
    bends_.assign(values_.size(), 0.0);
    if (n < 3) return;
    // The tridiagonal system of continuous second derivatives, zero at both ends; by elimination.
    std::vector<double> upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = times_[i] - times_[i - 1];
        const double after = times_[i + 1] - times_[i];
        const double pivot = 2.0 * (before + after) - before * upper[i - 1];
        upper[i] = after / pivot;
        for (std::size_t d = 0; d < dimension_; ++d) {
            const std::size_t k = i * dimension_ + d;
            const double rise = (values_[k + dimension_] - values_[k]) / after -
                                (values_[k] - values_[k - dimension_]) / before;
            bends_[k] = (6.0 * rise - before * bends_[k - dimension_]) / pivot;
        }
    }
    for (std::size_t i = n - 2; i > 0; --i) {
        for (std::size_t d = 0; d < dimension_; ++d) {
            const std::size_t k = i * dimension_ + d;
            bends_[k] -= upper[i] * bends_[k + dimension_];
        }
    }
}

void Spline::at(double t, std::span<double> out) const {
    if (times_.size() == 1) {
        std::copy_n(values_.begin(), dimension_, out.begin());
        return;
    }
    const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
    const auto i = static_cast<std::size_t>(next - times_.begin()) - 1;
    const double h = times_[i + 1] - times_[i];
    const double inside = std::clamp(t, times_.front(), times_.back());
    const double beyond = t - inside;
    const double b = (inside - times_[i]) / h;
    const double a = 1.0 - b;
    const double* v = values_.data() + i * dimension_;
    const double* m = bends_.data() + i * dimension_;
    const double ca = (a * a * a - a) * h * h / 6.0;
    const double cb = (b * b * b - b) * h * h / 6.0;
    for (std::size_t d = 0; d < dimension_; ++d) {
        const double v1 = v[dimension_ + d];
        const double m1 = m[dimension_ + d];
        out[d] = a * v[d] + b * v1 + ca * m[d] + cb * m1;
        if (beyond != 0.0) {
            const double slope =
                (v1 - v[d]) / h + h / 6.0 * ((3.0 * b * b - 1.0) * m1 - (3.0 * a * a - 1.0) * m[d]);
            out[d] += beyond * slope;
        }
    }
}

}  // namespace percussionist::body
