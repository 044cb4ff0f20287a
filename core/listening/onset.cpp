#include "core/listening/onset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/listening/linear_prediction.hpp"
#include "core/listening/median.hpp"

namespace percussionist::listening {

namespace {

/// What a head radiates when struck by felt or wood ends at a few kHz: a higher rate would leave
/// the predictor fewer milliseconds to see and more noise to mind [Hz].
constexpr double kWorkingRate = 12000.0;
constexpr double kLearn = 0.030;         ///< the stretch a predictor is learnt from [s]
constexpr double kTry = 0.002;           ///< the stretch it is then tried on [s]
constexpr double kBlock = 0.0005;        ///< over which energy is averaged [s]
constexpr double kAttack = 0.003;        ///< from touch to the peak of the force, at most [s]
constexpr double kDip = 0.0005;          ///< a rising force may pause for [s]
constexpr double kClearly = 0.5;         ///< of the greatest force
constexpr double kClearlyAbove = 6.0;    ///< times what was before it
constexpr double kFractionOfPeak = 0.2;  ///< of the force, where a stroke counts as begun
constexpr double kAboveBefore = 4.0;     ///< times what was before it, at least
constexpr double kMasked = 1e-3;         ///< strength over that of a neighbour

std::size_t decimation(double rate) {
    if (!(std::isfinite(rate) && rate >= kWorkingRate)) {
        throw std::invalid_argument("onsets: the rate must be 12000 Hz or more");
    }
    return static_cast<std::size_t>(rate / kWorkingRate);
}

/// Every step-th sample of the signal smoothed by a triangle, which, unlike a sharper filter, rings
/// neither before nor after an attack.
std::vector<double> decimated(std::span<const double> x, std::size_t step) {
    const auto reach = static_cast<std::ptrdiff_t>(step);
    const auto size = static_cast<std::ptrdiff_t>(x.size());
    std::vector<double> coarse;
    for (std::ptrdiff_t middle = 0; middle < size; middle += reach) {
        double sum = 0.0;
        for (std::ptrdiff_t k = 1 - reach; k < reach; ++k) {
            if (middle + k >= 0 && middle + k < size) {
                sum += static_cast<double>(reach - std::abs(k)) * x[middle + k];
            }
        }
        coarse.push_back(sum / static_cast<double>(reach * reach));
    }
    return coarse;
}

std::vector<double> amplitudes(std::vector<double> x) {
    for (double& value : x) {
        value = std::abs(value);
    }
    return x;
}

class Listener {
  public:
    Listener(std::span<const double> signal, double rate)
        : signal_(decimated(signal, decimation(rate))),
          rate_(rate / static_cast<double>(decimation(rate))) {}

    /// The onsets between two times [s].
    [[nodiscard]] std::vector<Onset> find(double from, double to,
                                          const OnsetOptions& options) const {
        std::vector<Onset> found;
        double rest_until = 0.0;
        const std::size_t hop = samples(kTry);
        for (std::size_t at = samples(std::max(from, 0.0)); at < signal_.size() && seconds(at) < to;
             at += hop) {
            const auto leap = leap_between(at, std::min(at + hop, signal_.size()), options.rise);
            if (!leap || seconds(*leap) < rest_until) {
                continue;
            }
            const auto onset = look_closer(*leap, options.contrast);
            if (onset &&
                (found.empty() || onset->time - found.back().time >= options.min_interval)) {
                found.push_back(*onset);
                rest_until = onset->time + options.min_interval;
            }
        }
        return found;
    }

  private:
    [[nodiscard]] std::size_t samples(double time) const {
        return static_cast<std::size_t>(std::llround(time * rate_));
    }
    [[nodiscard]] double seconds(std::size_t sample) const {
        return static_cast<double>(sample) / rate_;
    }

    /// The first block of [at, end) with more unexplained energy than the stretch before.
    [[nodiscard]] std::optional<std::size_t> leap_between(std::size_t at, std::size_t end,
                                                          double rise) const {
        const std::size_t start = at - std::min(at, samples(kLearn));
        const std::vector<double> a = predictor(signal_, start, at);
        const double before = median(energies(residual(signal_, a, start, at)));
        const std::vector<double> now = energies(residual(signal_, a, at, end));
        for (std::size_t b = 0; b < now.size(); ++b) {
            if (now[b] > rise * before) {
                return at + b * samples(kBlock);
            }
        }
        return std::nullopt;
    }

    /// The mean square of each block.
    [[nodiscard]] std::vector<double> energies(const std::vector<double>& x) const {
        const std::size_t size = samples(kBlock);
        std::vector<double> energy;
        for (std::size_t i = 0; i + size <= x.size(); i += size) {
            double sum = 0.0;
            for (std::size_t n = i; n < i + size; ++n) {
                sum += x[n] * x[n];
            }
            energy.push_back(sum / static_cast<double>(size));
        }
        return energy;
    }

    /// The force around a leap, as a predictor learnt after it leaves it; none if it does not stand
    /// out from what was before it.
    [[nodiscard]] std::optional<Onset> look_closer(std::size_t leap, double contrast) const {
        const std::size_t attack = samples(kAttack);
        const std::size_t from = leap - std::min(leap, 2 * attack);
        const std::size_t to = std::min(leap + attack, signal_.size());
        const std::size_t learnt = std::min(to + samples(kLearn), signal_.size());
        const std::vector<double> a = predictor(signal_, to, learnt);
        const std::vector<double> force = amplitudes(residual(signal_, a, from, to));
        const auto peak = std::max_element(force.begin(), force.end());
        // At the very start nothing was before; then what comes after tells noise from a stroke.
        const bool has_before = leap - from >= attack;
        const double before = has_before
                                  ? median({force.begin(), force.begin() + (leap - from) / 2})
                                  : median(amplitudes(residual(signal_, a, to, learnt)));
        if (!(*peak > contrast * before)) {
            return std::nullopt;
        }
        // Where the mallet leaves, the force may have its sharpest edge: the first clear one
        // counts.
        const double clearly = std::max(kClearly * *peak, kClearlyAbove * before);
        const auto touch =
            std::find_if(force.begin(), peak, [&](double f) { return f >= clearly; });
        const double threshold = std::max(kFractionOfPeak * *touch, kAboveBefore * before);
        const double rise = risen(force, touch - force.begin(), threshold);
        return Onset{(static_cast<double>(from) + rise) / rate_, *peak * *peak};
    }

    /// Back from the peak to where the force comes through the threshold, between two samples.
    [[nodiscard]] double risen(const std::vector<double>& force, std::size_t peak,
                               double threshold) const {
        std::size_t first = peak;
        for (std::size_t i = peak; i-- > 0 && first - i <= samples(kDip);) {
            if (force[i] >= threshold) {
                first = i;
            }
        }
        if (first == 0 || force[first] <= force[first - 1]) {
            return static_cast<double>(first);
        }
        const double above = (force[first] - threshold) / (force[first] - force[first - 1]);
        return static_cast<double>(first) - std::min(above, 1.0);
    }

    std::vector<double> signal_;
    double rate_;
};

void leave_out_weaker_than(double fraction, std::vector<Onset>& onsets) {
    double strongest = 0.0;
    for (const Onset& onset : onsets) {
        strongest = std::max(strongest, onset.strength);
    }
    std::erase_if(onsets,
                  [&](const Onset& onset) { return onset.strength < fraction * strongest; });
}

std::optional<double> nearest_to(double time, double window, const Listener& listener,
                                 const OnsetOptions& options) {
    std::vector<Onset> found = listener.find(time - window, time + window, options);
    leave_out_weaker_than(kMasked, found);
    std::optional<double> nearest;
    for (const Onset& onset : found) {
        const double away = std::abs(onset.time - time);
        if (away <= window && (!nearest || away < std::abs(*nearest - time))) {
            nearest = onset.time;
        }
    }
    return nearest;
}

}  // namespace

std::vector<Onset> find_onsets(std::span<const double> signal, double rate,
                               const OnsetOptions& options) {
    constexpr double kAlways = std::numeric_limits<double>::infinity();
    std::vector<Onset> found = Listener(signal, rate).find(0.0, kAlways, options);
    leave_out_weaker_than(options.floor, found);
    return found;
}

std::vector<std::optional<double>> onsets_near(std::span<const double> signal, double rate,
                                               std::span<const double> times, double window) {
    constexpr OnsetOptions kUsual;
    constexpr OnsetOptions kSharp{.rise = 3.0, .contrast = 5.0};
    const Listener listener(signal, rate);
    std::vector<std::optional<double>> nearest;
    for (const double time : times) {
        nearest.push_back(nearest_to(time, window, listener, kUsual));
        if (!nearest.back()) {
            nearest.back() = nearest_to(time, window, listener, kSharp);
        }
    }
    return nearest;
}

}  // namespace percussionist::listening
