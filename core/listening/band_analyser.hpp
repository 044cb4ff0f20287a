// A signal as levels in bands, 200 times a second: the ear that offline and live listening share.
//
// Two windows end at the same sample. The long one (43 ms) tells bands of a third of an octave
// apart, each in two ways: the logarithm of its mean power, which partials decide, and the mean of
// the logarithms of its bins, which partials hardly move, since they fill few bins: a stroke, which
// fills all of them, does. Their difference tells harmonic from percussive without separating them.
// The short one (11 ms) says when.
//
// process() does not allocate, lock or throw; one thread at a time.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace percussionist::listening {

constexpr std::size_t kLevels = 32;  ///< bands of the long window, 30 Hz to 17 kHz
constexpr std::size_t kFloors = 20;  ///< of them, the upper ones, where a band has many bins
constexpr std::size_t kQuick = 8;    ///< bands of the short window

/// Natural logarithms of power; the samples' full scale being 1.
struct BandFrame {
    std::array<float, kLevels> level{};
    std::array<float, kFloors> floor{};
    std::array<float, kQuick> quick{};
};

/// The middle of a band of BandFrame::level [Hz].
double level_frequency(std::size_t band) noexcept;

class BandAnalyser {
  public:
    /// Throws std::invalid_argument for a rate below 8000 Hz or above 400 kHz.
    explicit BandAnalyser(double rate);
    ~BandAnalyser();
    BandAnalyser(BandAnalyser&&) noexcept;
    BandAnalyser& operator=(BandAnalyser&&) noexcept;

    /// Samples from one frame to the next: 5 ms, rounded.
    [[nodiscard]] std::size_t hop() const { return hop_; }

    /// The next hop() samples; the frame whose windows end with them.
    void process(std::span<const double> samples, BandFrame& frame) noexcept;
    /// Forgets what it heard.
    void reset() noexcept;

  private:
    struct Window;
    std::size_t hop_;
    std::vector<double> heard_;  ///< the longer window, oldest first
    std::unique_ptr<Window> long_, short_;
};

}  // namespace percussionist::listening
