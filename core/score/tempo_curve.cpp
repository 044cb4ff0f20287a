#include "core/score/tempo_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percussionist::score {

void TempoCurve::begin(double now, double x) {
    from_u_ = swayed(x);
    from_ = factor(now);
    length_ = std::max(0.0, start_ + length_ - now);
    start_ = now;
}

void TempoCurve::glide(double now, double factor, double seconds) {
    from_u_ = measured(now);
    from_ = seconds > 0.0 ? this->factor(now) : factor;
    to_ = factor;
    start_ = now;
    length_ = seconds;
}

void TempoCurve::sway(double now, double depth, double period) {
    const double u = measured(now);
    const double x = position(now);
    depth_ = depth;
    period_ = period;
    shift_ += u - swayed(x);
}

double TempoCurve::factor(double t) const {
    if (length_ <= 0.0) return to_;
    const double share = std::clamp((t - start_) / length_, 0.0, 1.0);
    return from_ + share * (to_ - from_);
}

double TempoCurve::swayed(double x) const {
    const double turn = 2.0 * std::numbers::pi / period_;
    return x + shift_ + depth_ / turn * (1.0 - std::cos(turn * x));
}

/// Before the glide its first factor holds.
double TempoCurve::measured(double t) const {
    const double s = t - start_;
    if (s <= 0.0) return from_u_ + from_ * s;
    if (s >= length_) return from_u_ + 0.5 * (from_ + to_) * length_ + to_ * (s - length_);
    return from_u_ + from_ * s + 0.5 * (to_ - from_) / length_ * s * s;
}

double TempoCurve::time_at(double u) const {
    const double done = u - from_u_;
    const double all = 0.5 * (from_ + to_) * length_;
    if (done <= 0.0) return start_ + done / from_;
    if (done >= all) return start_ + length_ + (done - all) / to_;
    // The root of from s + (to - from) / (2 length) s^2 = done, in the form that never cancels.
    const double growth = 2.0 * (to_ - from_) / length_;
    return start_ + 2.0 * done / (from_ + std::sqrt(from_ * from_ + growth * done));
}

double TempoCurve::position(double t) const {
    const double u = measured(t) - shift_;
    // u - x lies between 0 and twice the sway's depth.
    double low = u - depth_ * period_ / std::numbers::pi;
    double high = u;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (swayed(middle) - shift_ < u ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace percussionist::score
