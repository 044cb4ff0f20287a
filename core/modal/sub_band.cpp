#include "core/modal/sub_band.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percussionist::modal {

namespace {

using std::numbers::pi;

constexpr double kKaiserBeta = 6.8;  // 70 dB

}  // namespace

BandFilter::BandFilter(double sample_rate, double width)
    : sample_rate_(sample_rate),
      width_(width),
      step_(std::max<std::size_t>(1, static_cast<std::size_t>(sample_rate / (2 * width)))) {
    // Kaiser's rule: length for 70 dB over a transition of width / 2.
    const double transition = pi * width / sample_rate;
    const auto half = static_cast<std::size_t>(std::ceil((70 - 7.95) / (2.285 * transition) / 2));
    taps_.resize(2 * half + 1);
    const double cutoff = 0.75 * width / sample_rate;
    double sum = 0.0;
    for (std::size_t i = 0; i < taps_.size(); ++i) {
        const double t = static_cast<double>(i) - static_cast<double>(half);
        const double u = t / static_cast<double>(half);
        const double sinc = t == 0.0 ? 2 * cutoff : std::sin(2 * pi * cutoff * t) / (pi * t);
        taps_[i] = sinc * std::cyl_bessel_i(0.0, kKaiserBeta * std::sqrt(1 - u * u));
        sum += taps_[i];
    }
    std::for_each(taps_.begin(), taps_.end(), [sum](double& tap) { tap /= sum; });
}

/// Only where the filter lies within the recording: what began before it is not smeared in.
SubBand BandFilter::apply(std::span<const double> signal, double centre) const {
    SubBand band;
    band.centre = centre;
    band.rate = sample_rate_ / static_cast<double>(step_);
    band.delay = static_cast<double>(taps_.size() / 2) / sample_rate_;
    std::vector<std::complex<double>> shifted(signal.size());
    for (std::size_t n = 0; n < signal.size(); ++n) {
        const double angle = -2 * pi * centre * static_cast<double>(n) / sample_rate_;
        shifted[n] = signal[n] * std::complex(std::cos(angle), std::sin(angle));
    }
    for (std::size_t start = 0; start + taps_.size() <= signal.size(); start += step_) {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < taps_.size(); ++i) {
            sum += taps_[i] * shifted[start + i];
        }
        band.samples.push_back(sum);
    }
    return band;
}

}  // namespace percussionist::modal
