// Filters of second order: low pass, high pass, band pass, bell, shelf.
// Source: Bristow-Johnson, "Cookbook formulae for audio EQ biquad filter coefficients".
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace percussionist::listening::practice {

class Biquad {
  public:
    static Biquad low_pass(double hz, double rate, double q = 0.707) {
        const Turn t(hz, rate, q);
        const double b = 0.5 * (1.0 - t.cosine);
        return {b, 2.0 * b, b, 1.0 + t.alpha, -2.0 * t.cosine, 1.0 - t.alpha};
    }
    static Biquad high_pass(double hz, double rate, double q = 0.707) {
        const Turn t(hz, rate, q);
        const double b = 0.5 * (1.0 + t.cosine);
        return {b, -2.0 * b, b, 1.0 + t.alpha, -2.0 * t.cosine, 1.0 - t.alpha};
    }
    static Biquad band_pass(double hz, double rate, double q) {
        const Turn t(hz, rate, q);
        return {t.alpha, 0.0, -t.alpha, 1.0 + t.alpha, -2.0 * t.cosine, 1.0 - t.alpha};
    }
    static Biquad bell(double hz, double rate, double q, double gain_db) {
        const Turn t(hz, rate, q);
        const double a = std::pow(10.0, gain_db / 40.0);
        return {1.0 + t.alpha * a, -2.0 * t.cosine, 1.0 - t.alpha * a,
                1.0 + t.alpha / a, -2.0 * t.cosine, 1.0 - t.alpha / a};
    }

    double operator()(double x) {
        const double y = b0_ * x + s1_;
        s1_ = b1_ * x - a1_ * y + s2_;
        s2_ = b2_ * x - a2_ * y;
        return y;
    }
    void operator()(std::vector<double>& signal) {
        for (double& x : signal) x = (*this)(x);
    }

  private:
    struct Turn {
        Turn(double hz, double rate, double q)
            : Turn(2.0 * std::numbers::pi * std::min(hz, 0.49 * rate) / rate, q) {}
        Turn(double angle, double q) : cosine(std::cos(angle)), alpha(0.5 * std::sin(angle) / q) {}
        double cosine, alpha;
    };
    Biquad(double b0, double b1, double b2, double a0, double a1, double a2)
        : b0_(b0 / a0), b1_(b1 / a0), b2_(b2 / a0), a1_(a1 / a0), a2_(a2 / a0) {}

    double b0_, b1_, b2_, a1_, a2_;
    double s1_ = 0.0, s2_ = 0.0;
};

}  // namespace percussionist::listening::practice
