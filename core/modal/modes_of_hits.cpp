#include "core/modal/modes_of_hits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/modal/decay.hpp"

namespace percussionist::modal {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// Of the bands [Hz]: the wider, the fewer modes can be told apart in one, and the shorter the
/// filter, which takes its length off the recordings.
constexpr double kBandWidths[] = {240.0, 480.0};
constexpr double kLongestT60 = 30.0;   // [s]
constexpr double kShortestT60 = 0.02;  // [s]
/// Two found closer than this part of their frequency, and their bandwidths, are one.
constexpr double kSame = 0.001;
/// A mode's energy over that of the residue within its bandwidth.
constexpr double kAboveResidue = 4.0;
/// How far apart strokes' beginnings may be [s].
constexpr double kLargestShift = 0.002;
/// Phases further than this from a half turn tell no sign [rad].
constexpr double kUnsure = 1.0;

void check_hits(std::span<const Hit> hits, double sample_rate) {
    if (hits.empty()) {
        throw std::invalid_argument("modes: expected at least one recording");
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const double place = hits[i].place;
        const bool again = std::any_of(hits.begin(), hits.begin() + static_cast<long>(i),
                                       [&](const Hit& hit) { return hit.place == place; });
        if (!(place >= 0.0 && place <= 1.0) || again) {
            throw std::invalid_argument("modes: expected different places from 0 to 1, got " +
                                        std::to_string(place));
        }
        if (static_cast<double>(hits[i].samples.size()) < 0.1 * sample_rate) {
            throw std::invalid_argument("modes: recording " + std::to_string(i + 1) +
                                        " is shorter than 0.1 s");
        }
        const auto good = [](double x) { return std::isfinite(x); };
        if (!std::all_of(hits[i].samples.begin(), hits[i].samples.end(), good)) {
            throw std::invalid_argument("modes: recording " + std::to_string(i + 1) +
                                        " has samples that are no numbers");
        }
    }
}

/// The recordings from their strokes on, and the skipped milliseconds after them.
std::vector<std::span<const double>> ringing(std::span<const Hit> hits,
                                             std::span<const std::size_t> begins,
                                             double sample_rate, const HitAnalysis& analysis) {
    const auto skip = static_cast<std::size_t>(analysis.skip * sample_rate);
    const auto longest = static_cast<std::size_t>(analysis.longest * sample_rate);
    std::vector<std::span<const double>> parts;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const std::span samples(hits[i].samples);
        const std::size_t start = std::min(begins[i] + skip, samples.size());
        parts.push_back(samples.subspan(start, std::min(longest, samples.size() - start)));
    }
    return parts;
}

/// The decaying sines of one band, with frequencies from `low` up to `high`.
std::vector<DecayingSine> sines_of(std::span<const std::span<const double>> parts,
                                   const BandFilter& filter, double centre, double low,
                                   double high) {
    std::vector<SubBand> bands;
    for (const auto& part : parts) {
        bands.push_back(filter.apply(part, centre));
    }
    auto found = decaying_sines(bands, filter.width());
    std::erase_if(found, [&](const DecayingSine& sine) {
        const bool sounds =
            sine.loss < loss_of_t60(kShortestT60) && sine.loss > loss_of_t60(kLongestT60);
        return !sounds || sine.frequency < low || sine.frequency > high;
    });
    return found;
}

std::vector<DecayingSine> all_sines(std::span<const std::span<const double>> parts,
                                    double sample_rate, const HitAnalysis& analysis, double width) {
    const BandFilter filter(sample_rate, width);
    const double high = std::min(analysis.high, 0.45 * sample_rate);
    std::vector<DecayingSine> found;
    for (double centre = analysis.low; centre < high + width / 2; centre += width / 2) {
        // Bands overlap: each keeps its middle half.
        const auto sines =
            sines_of(parts, filter, centre, std::max(analysis.low, centre - width / 4),
                     std::min(high, centre + width / 4));
        found.insert(found.end(), sines.begin(), sines.end());
    }
    return found;
}

/// What a mode gives a recording in all: the sum of its squares.
double energy(const DecayingSine& sine, Complex amplitude, double sample_rate) {
    return std::norm(amplitude) / 4 / sine.loss * sample_rate;
}

std::vector<std::vector<Complex>> fit(std::span<const DecayingSine> sines,
                                      std::span<const std::span<const double>> parts,
                                      double sample_rate) {
    std::vector<std::vector<Complex>> all;
    for (const auto& part : parts) {
        all.push_back(amplitudes(sines, part, sample_rate));
    }
    return all;
}

/// The power density of a residue about a frequency [per sample and Hz], by correlation with the
/// mode's own shape: noise gives as much to a decaying sine of its loss at a neighbouring
/// frequency.
double residue_energy(std::span<const double> residue, const DecayingSine& sine,
                      double sample_rate) {
    double sum = 0.0;
    constexpr std::array<double, 4> kAside{-7.0, -4.0, 4.0, 7.0};
    for (const double aside : kAside) {
        DecayingSine near = sine;
        near.frequency = std::max(5.0, sine.frequency + aside * sine.loss / pi);
        const std::array<DecayingSine, 1> one{near};
        sum += energy(near, amplitudes(one, residue, sample_rate)[0], sample_rate);
    }
    return sum / kAside.size();
}

/// Keeps the strongest of the modes that stand out of the residue in some recording.
std::vector<DecayingSine> significant(const std::vector<DecayingSine>& sines,
                                      std::span<const std::span<const double>> parts,
                                      double sample_rate, std::size_t most) {
    const auto all = fit(sines, parts, sample_rate);
    std::vector<double> strength(sines.size(), 0.0);
    std::vector<bool> stands(sines.size(), false);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto residue = resynthesis(sines, all[i], parts[i].size(), sample_rate);
        std::transform(parts[i].begin(), parts[i].end(), residue.begin(), residue.begin(),
                       std::minus<>());
        for (std::size_t k = 0; k < sines.size(); ++k) {
            const double own = energy(sines[k], all[i][k], sample_rate);
            strength[k] = std::max(strength[k], own);
            stands[k] =
                stands[k] || own > kAboveResidue * residue_energy(residue, sines[k], sample_rate);
        }
    }
    std::vector<std::size_t> order(sines.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return strength[a] > strength[b]; });
    std::vector<DecayingSine> kept;
    for (const std::size_t k : order) {
        const bool twin = std::any_of(kept.begin(), kept.end(), [&](const DecayingSine& other) {
            return std::abs(other.frequency - sines[k].frequency) < kSame * sines[k].frequency;
        });
        if (stands[k] && !twin && kept.size() < most) {
            kept.push_back(sines[k]);
        }
    }
    std::sort(kept.begin(), kept.end(),
              [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
    return kept;
}

/// Power up to `high` [Hz], by the filter that passes it.
double power(std::span<const double> signal, const BandFilter& filter) {
    // Between silences as long as the filter: all of it counts, the loud beginning most.
    std::vector<double> padded(signal.size() + 2 * filter.length(), 0.0);
    std::copy(signal.begin(), signal.end(), padded.begin() + static_cast<long>(filter.length()));
    double sum = 0.0;
    for (const Complex x : filter.apply(padded, 0.0).samples) {
        sum += std::norm(x);
    }
    return sum;
}

/// How much of the recordings the sines do not explain: power over all, up to `high` [Hz].
std::vector<double> left_of(std::span<const DecayingSine> sines,
                            std::span<const std::span<const double>> parts, double sample_rate,
                            double high) {
    const BandFilter filter(sample_rate, std::min(2 * high, 0.9 * sample_rate));
    const auto all = fit(sines, parts, sample_rate);
    std::vector<double> left;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto rest = resynthesis(sines, all[i], parts[i].size(), sample_rate);
        std::transform(parts[i].begin(), parts[i].end(), rest.begin(), rest.begin(),
                       std::minus<>());
        const double whole = power(parts[i], filter);
        left.push_back(whole > 0.0 ? power(rest, filter) / whole : 1.0);
    }
    return left;
}

/// Modes found in bands of one width or another, whichever explain the recordings best.
std::vector<DecayingSine> best_sines(std::span<const std::span<const double>> parts,
                                     double sample_rate, const HitAnalysis& analysis) {
    std::vector<DecayingSine> best;
    double least = std::numeric_limits<double>::infinity();
    for (const double width : kBandWidths) {
        auto kept = significant(all_sines(parts, sample_rate, analysis, width), parts, sample_rate,
                                analysis.most);
        const auto left = left_of(kept, parts, sample_rate, analysis.high);
        const double sum = std::accumulate(left.begin(), left.end(), 0.0);
        if (sum < least) {
            best = std::move(kept);
            least = sum;
        }
    }
    return best;
}

/// By how much later a hit's stroke began than another's [s]: the shift that makes phases alike but
/// for half turns.
double shift_between(std::span<const DecayingSine> sines, std::span<const Complex> hit,
                     std::span<const Complex> other) {
    double best = 0.0, best_sum = -1.0;
    constexpr double kStep = 1e-5;
    for (double shift = -kLargestShift; shift <= kLargestShift; shift += kStep) {
        double sum = 0.0;
        for (std::size_t k = 0; k < sines.size(); ++k) {
            const Complex ratio =
                hit[k] * std::conj(other[k]) * std::polar(1.0, 2 * pi * sines[k].frequency * shift);
            sum += std::abs(ratio) > 0.0 ? (ratio * ratio).real() / std::abs(ratio) : 0.0;
        }
        // Of two that explain as much, the smaller.
        if (sum > best_sum * (1 + 1e-9) + (std::abs(shift) < std::abs(best) ? -1e-12 : 0.0)) {
            best = shift;
            best_sum = sum;
        }
    }
    return best;
}

std::size_t strongest(const std::vector<std::vector<Complex>>& all, std::size_t k) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
        best = std::abs(all[i][k]) > std::abs(all[best][k]) ? i : best;
    }
    return best;
}

/// Weights with signs, hits in the order of their places.
void set_modes(MeasuredModes& measured, std::span<const std::size_t> order) {
    const auto& all = measured.amplitudes;
    std::vector<std::vector<double>> shifts(all.size(), std::vector<double>(all.size(), 0.0));
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            shifts[i][j] = shift_between(measured.sines, all[i], all[j]);
            shifts[j][i] = -shifts[i][j];
        }
    }
    double loudest = 0.0;
    for (std::size_t k = 0; k < measured.sines.size(); ++k) {
        loudest = std::max(loudest, std::abs(all[strongest(all, k)][k]));
    }
    for (std::size_t k = 0; k < measured.sines.size(); ++k) {
        const auto& sine = measured.sines[k];
        const std::size_t reference = strongest(all, k);
        const double most = std::abs(all[reference][k]);
        GivenMode mode;
        mode.frequency = sine.frequency;
        mode.t60 = loss_of_t60(1.0) / sine.loss;
        for (const std::size_t i : order) {
            const double angle = 2 * pi * sine.frequency * shifts[i][reference];
            const Complex ratio = all[i][k] * std::conj(all[reference][k]) * std::polar(1.0, angle);
            const double phase = std::abs(std::arg(ratio));
            const bool unsure = std::min(phase, pi - phase) > kUnsure;
            measured.unknown_signs += unsure ? 1 : 0;
            const double sign = !unsure && phase > pi / 2 ? -1.0 : 1.0;
            mode.weights.push_back(sign * std::abs(all[i][k]) / most / std::sqrt(kTypicalMass));
        }
        // In the middle, if it was struck there, weights are positive.
        if (mode.weights[0] < 0.0) {
            for (double& weight : mode.weights) {
                weight = -weight;
            }
        }
        mode.heard = kTypicalPressure * most / loudest * std::sqrt(kTypicalMass) / kTypicalImpulse;
        measured.modes.modes.push_back(mode);
    }
}

}  // namespace

std::size_t stroke_begin(std::span<const double> samples, double sample_rate) {
    const auto window = std::max<std::size_t>(1, static_cast<std::size_t>(0.0005 * sample_rate));
    double most = 0.0;
    for (const double x : samples) {
        most = std::max(most, std::abs(x));
    }
    if (!(most > 0.0)) {
        throw std::invalid_argument("modes: a recording is silent");
    }
    // The first half millisecond a tenth as loud as the loudest sample; from there back to where
    // it was still quiet.
    std::size_t n = 0;
    while (n < samples.size() && std::abs(samples[n]) < 0.1 * most) {
        ++n;
    }
    double noise = 0.0;
    const std::size_t before = n > 4 * window ? n - 2 * window : 0;
    for (std::size_t i = 0; i < before; ++i) {
        noise = std::max(noise, std::abs(samples[i]));
    }
    const double quiet = std::max(1.5 * noise, 0.01 * most);
    const std::size_t earliest = n > 4 * window ? n - 4 * window : 0;
    while (n > earliest && std::abs(samples[n - 1]) > quiet) {
        --n;
    }
    return n;
}

MeasuredModes modes_of_hits(std::span<const Hit> hits, double sample_rate,
                            const HitAnalysis& analysis) {
    check_hits(hits, sample_rate);
    MeasuredModes measured;
    for (const Hit& hit : hits) {
        measured.begins.push_back(stroke_begin(hit.samples, sample_rate));
    }
    const auto parts = ringing(hits, measured.begins, sample_rate, analysis);
    measured.sines = best_sines(parts, sample_rate, analysis);
    if (measured.sines.empty()) {
        throw std::invalid_argument("modes: none found from " + std::to_string(analysis.low) +
                                    " to " + std::to_string(analysis.high) + " Hz");
    }
    measured.amplitudes = fit(measured.sines, parts, sample_rate);
    measured.left = left_of(measured.sines, parts, sample_rate, analysis.high);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        // Back to the stroke.
        const double back = -std::floor(analysis.skip * sample_rate) / sample_rate;
        for (std::size_t k = 0; k < measured.sines.size(); ++k) {
            const auto& sine = measured.sines[k];
            measured.amplitudes[i][k] *=
                std::exp(Complex(-sine.loss, 2 * pi * sine.frequency) * back);
        }
    }
    std::vector<std::size_t> order(hits.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return hits[a].place < hits[b].place; });
    measured.modes.radius = analysis.radius;
    measured.modes.places.clear();
    for (const std::size_t i : order) {
        measured.modes.places.push_back(hits[i].place);
    }
    set_modes(measured, order);
    return measured;
}

}  // namespace percussionist::modal
