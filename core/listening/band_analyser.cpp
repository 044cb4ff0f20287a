#include "core/listening/band_analyser.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

namespace percussionist::listening {

namespace {

constexpr double kHop = 0.005;        ///< [s]
constexpr double kLong = 0.0426;      ///< [s]: just under 2048 samples at 48 kHz
constexpr double kShort = 0.0106;     ///< [s]: just under 512
constexpr double kLowest = 30.0;      ///< [Hz]
constexpr double kHighest = 17000.0;  ///< [Hz]
constexpr float kSilence = 1e-12F;    ///< power below which nothing is heard

constexpr std::array<double, kQuick + 1> kQuickEdges = {30.0,   130.0,  300.0,   700.0,  1500.0,
                                                        3000.0, 6000.0, 10000.0, 17000.0};

double checked(double rate) {
    if (!(rate >= 8000.0 && rate <= 400000.0)) {
        throw std::invalid_argument("listening: expected a sample rate from 8000 to 400000 Hz");
    }
    return rate;
}

std::array<double, kLevels + 1> level_edges() {
    std::array<double, kLevels + 1> edges{};
    for (std::size_t b = 0; b <= kLevels; ++b) {
        edges[b] = kLowest * std::pow(kHighest / kLowest, static_cast<double>(b) / kLevels);
    }
    return edges;
}

/// The bins of a band: at least one, and none where the rate leaves nothing to hear.
struct Bins {
    Eigen::Index first = 0, count = 0;
};

Bins bins_between(double low, double high, double rate, std::size_t size) {
    const double bin = rate / static_cast<double>(size);
    const auto nyquist = static_cast<Eigen::Index>(size / 2);
    const auto first = static_cast<Eigen::Index>(std::lround(low / bin));
    const auto end = std::max(first + 1, static_cast<Eigen::Index>(std::lround(high / bin)));
    return {std::min(first, nyquist), std::max<Eigen::Index>(0, std::min(end, nyquist) - first)};
}

}  // namespace

double level_frequency(std::size_t band) noexcept {
    return kLowest * std::pow(kHighest / kLowest, (static_cast<double>(band) + 0.5) / kLevels);
}

struct BandAnalyser::Window {
    Window(double seconds, double rate, std::span<const double> edges)
        : length(static_cast<std::size_t>(seconds * rate)),
          shape(length),
          padded(std::bit_ceil(length), 0.0F),
          spectrum(padded.size() / 2 + 1) {
        double sum = 0.0;
        for (std::size_t n = 0; n < length; ++n) {
            const double turn = (static_cast<double>(n) + 0.5) / static_cast<double>(length);
            shape[n] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn);
            sum += shape[n];
        }
        for (double& s : shape) s /= sum;
        for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
            bands.push_back(bins_between(edges[b], edges[b + 1], rate, padded.size()));
        }
        power.setZero(static_cast<Eigen::Index>(spectrum.size()));
        logarithm = power;
        fft.SetFlag(Eigen::FFT<float>::HalfSpectrum);
        transform();  // takes its memory now
    }

    void transform() noexcept {
        fft.fwd(spectrum.data(), padded.data(), static_cast<Eigen::Index>(padded.size()));
    }

    void analyse(std::span<const double> samples) noexcept {
        for (std::size_t n = 0; n < length; ++n) {
            padded[n] = static_cast<float>(shape[n] * samples[n]);
        }
        transform();
        power = Eigen::Map<const Eigen::ArrayXcf>(spectrum.data(), power.size()).abs2() + kSilence;
    }

    [[nodiscard]] float level(std::size_t b) const noexcept {
        if (bands[b].count == 0) return std::log(kSilence);
        return std::log(power.segment(bands[b].first, bands[b].count).mean());
    }
    [[nodiscard]] float floor(std::size_t b) const noexcept {
        if (bands[b].count == 0) return std::log(kSilence);
        return logarithm.segment(bands[b].first, bands[b].count).mean();
    }

    std::size_t length;
    std::vector<double> shape;
    std::vector<float> padded;
    std::vector<std::complex<float>> spectrum;
    std::vector<Bins> bands;
    Eigen::ArrayXf power, logarithm;
    Eigen::FFT<float> fft;
};

BandAnalyser::BandAnalyser(double rate)
    : hop_(static_cast<std::size_t>(std::lround(kHop * checked(rate)))) {
    long_ = std::make_unique<Window>(kLong, rate, level_edges());
    short_ = std::make_unique<Window>(kShort, rate, kQuickEdges);
    heard_.assign(std::max(long_->length, hop_), 0.0);
}

BandAnalyser::~BandAnalyser() = default;
BandAnalyser::BandAnalyser(BandAnalyser&&) noexcept = default;
BandAnalyser& BandAnalyser::operator=(BandAnalyser&&) noexcept = default;

void BandAnalyser::process(std::span<const double> samples, BandFrame& frame) noexcept {
    std::copy(heard_.begin() + static_cast<std::ptrdiff_t>(hop_), heard_.end(), heard_.begin());
    std::copy(samples.begin(), samples.end(), heard_.end() - static_cast<std::ptrdiff_t>(hop_));
    const std::span<const double> all(heard_);
    long_->analyse(all.last(long_->length));
    short_->analyse(all.last(short_->length));
    const Eigen::Index from = long_->bands[kLevels - kFloors].first;
    const Eigen::Index size = long_->power.size() - from;
    long_->logarithm.tail(size) = long_->power.tail(size).log();
    for (std::size_t b = 0; b < kLevels; ++b) frame.level[b] = long_->level(b);
    for (std::size_t b = 0; b < kFloors; ++b) frame.floor[b] = long_->floor(kLevels - kFloors + b);
    for (std::size_t b = 0; b < kQuick; ++b) frame.quick[b] = short_->level(b);
}

void BandAnalyser::reset() noexcept {
    std::fill(heard_.begin(), heard_.end(), 0.0);
}

}  // namespace percussionist::listening
