#include "app/modes_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "files/plot.hpp"

namespace percussionist::app {

namespace {

using files::Axis;
using files::Chart;
using files::Series;

constexpr std::array kColours{"#305070", "#c05020", "#408040", "#8040a0", "#a08020", "#208090"};

/// Of the second after the stroke, Hann's window falling only; in dB of its maximum.
std::vector<std::pair<double, double>> spectrum(std::span<const double> samples, std::size_t begin,
                                                double rate) {
    const auto length = std::min(samples.size() - begin, static_cast<std::size_t>(rate));
    std::size_t size = 1;
    while (size < length) {
        size *= 2;
    }
    std::vector<double> windowed(size, 0.0);
    for (std::size_t n = 0; n < length; ++n) {
        const double angle =
            std::numbers::pi * static_cast<double>(n) / static_cast<double>(length);
        windowed[n] = samples[begin + n] * 0.5 * (1 + std::cos(angle));
    }
    std::vector<std::complex<double>> bins;
    Eigen::FFT<double> fft;
    fft.fwd(bins, windowed);
    double most = 1e-300;
    for (std::size_t i = 0; i <= size / 2; ++i) {
        most = std::max(most, std::abs(bins[i]));
    }
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 1; i <= size / 2; ++i) {
        points.emplace_back(static_cast<double>(i) * rate / static_cast<double>(size),
                            20 * std::log10(std::max(std::abs(bins[i]) / most, 1e-9)));
    }
    return points;
}

std::size_t loudest(std::span<const modal::Hit> hits) {
    const auto power = [](const modal::Hit& hit) {
        double sum = 0.0;
        for (const double x : hit.samples) {
            sum += x * x;
        }
        return sum;
    };
    return static_cast<std::size_t>(
        std::max_element(hits.begin(), hits.end(),
                         [&](const auto& a, const auto& b) { return power(a) < power(b); }) -
        hits.begin());
}

}  // namespace

void draw_modes(const std::string& path, const modal::MeasuredModes& measured,
                std::span<const modal::Hit> hits, double rate) {
    const auto& modes = measured.modes.modes;
    const std::size_t shown = loudest(hits);
    const Axis hertz{"Hz", std::max(10.0, 0.7 * modes.front().frequency),
                     std::min(rate / 2, 1.5 * modes.back().frequency), true};
    Chart lines{.title = "Spectrum", .x = hertz, .y = {"dB", -90, 5, false}, .series = {}};
    lines.series.push_back({.name = "recorded",
                            .colour = "#909aa4",
                            .points = spectrum(hits[shown].samples, measured.begins[shown], rate)});
    const auto sound =
        modal::resynthesis(measured.sines, measured.amplitudes[shown],
                           hits[shown].samples.size() - measured.begins[shown], rate);
    lines.series.push_back(
        {.name = "made of the modes", .colour = "#305070", .points = spectrum(sound, 0, rate)});
    Series found{.name = "modes", .kind = Series::Kind::points, .colour = "#c05020", .points = {}};
    Series decays{.name = "t60", .kind = Series::Kind::stems, .colour = "#c05020", .points = {}};
    double longest = 0.1;
    for (const auto& mode : modes) {
        found.points.emplace_back(mode.frequency, 2.0);
        decays.points.emplace_back(mode.frequency, mode.t60);
        longest = std::max(longest, mode.t60);
    }
    lines.series.push_back(found);
    const Chart times{
        .title = "Decays", .x = hertz, .y = {"s", 0, 1.1 * longest, false}, .series = {decays}};
    Chart weights{.title = "Weights",
                  .x = {"r / radius", 0, 1, false},
                  .y = {"", -1.05, 1.05, false},
                  .series = {}};
    for (std::size_t k = 0; k < std::min(modes.size(), kColours.size()); ++k) {
        Series series{.name = fmt::format("{:.1f} Hz", modes[k].frequency),
                      .colour = kColours[k],
                      .points = {}};
        for (std::size_t i = 0; i < measured.modes.places.size(); ++i) {
            series.points.emplace_back(measured.modes.places[i],
                                       modes[k].weights[i] * std::sqrt(modal::kTypicalMass));
        }
        weights.series.push_back(series);
    }
    files::write_svg(path, std::array{lines, times, weights});
}

}  // namespace percussionist::app
