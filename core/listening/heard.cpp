#include "core/listening/heard.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace percussionist::listening {

namespace {

/// From where listeners put a stroke, some 4 ms after its first sound, to the end of the frame that
/// rises most; measured on recordings [s].
constexpr double kFromOnset = 0.0035;
constexpr double kUsualLevel = 0.1;  ///< to which recordings are brought: of the practice pieces
constexpr double kMostGain = 100.0;
constexpr std::size_t kTold = 500000;  ///< samples between reports of progress

struct Level {
    double sum = 0.0, square = 0.0;
    std::size_t count = 0;

    void add(std::span<const double> piece) {
        for (const double x : piece) {
            if (!std::isfinite(x)) {
                throw std::invalid_argument("listening: sample " + std::to_string(count) +
                                            ": expected a number, got NaN or infinity");
            }
            sum += x;
            square += x * x;
            ++count;
        }
    }
    /// What a recording stands off from 0 by.
    [[nodiscard]] double offset() const {
        return sum / static_cast<double>(std::max<std::size_t>(count, 1));
    }
    /// What brings a recording to the usual root mean square; not all the way for next to nothing.
    [[nodiscard]] double gain() const {
        const double power = square / static_cast<double>(std::max<std::size_t>(count, 1));
        const double level = std::sqrt(std::max(power - offset() * offset(), 0.0));
        return level < kUsualLevel / kMostGain ? kMostGain : kUsualLevel / level;
    }
};

/// From pieces of any size to frames.
class Framer {
  public:
    Framer(BandAnalyser& analyser, const Level& level, std::size_t expected)
        : analyser_(analyser),
          offset_(level.offset()),
          gain_(level.gain()),
          block_(analyser.hop(), 0.0) {
        frames_.reserve(expected);
    }
    void take(double x) {
        block_[filled_] = gain_ * (x - offset_);
        if (++filled_ == block_.size()) next();
    }
    /// Silence follows until the last sample has been seen.
    std::vector<BandFrame> end(std::size_t count) {
        std::fill(block_.begin() + static_cast<std::ptrdiff_t>(filled_), block_.end(), 0.0);
        while (frames_.size() < count) {
            next();
            std::fill(block_.begin(), block_.end(), 0.0);
        }
        return std::move(frames_);
    }

  private:
    void next() {
        analyser_.process(block_, frames_.emplace_back());
        filled_ = 0;
    }
    BandAnalyser& analyser_;
    double offset_, gain_;
    std::vector<double> block_;
    std::size_t filled_ = 0;
    std::vector<BandFrame> frames_;
};

}  // namespace

double time_of(double frame, std::size_t hop, double rate) {
    return std::max(0.0, (frame + 1.0) * static_cast<double>(hop) / rate - kFromOnset);
}

Playback playback_of(std::span<const double> signal) {
    return [signal](const std::function<void(std::span<const double>)>& take) { take(signal); };
}

Heard hear(const Playback& playback, double rate, const std::function<void(double)>& progress) {
    BandAnalyser analyser(rate);
    Heard heard;
    heard.rate = rate;
    heard.hop = analyser.hop();
    Level level;
    playback([&](std::span<const double> piece) { level.add(piece); });
    heard.duration = static_cast<double>(level.count) / rate;
    const std::size_t count = (level.count + heard.hop - 1) / heard.hop + 1;
    Framer framer(analyser, level, count);
    std::size_t done = 0;
    playback([&](std::span<const double> piece) {
        for (const double x : piece) {
            framer.take(x);
            if (++done % kTold == 0 && progress)
                progress(static_cast<double>(done) / static_cast<double>(level.count));
        }
    });
    heard.frames = framer.end(count);
    heard.hearing = hearing_of(heard.frames);
    Novelty novelty;
    for (const BandFrame& frame : heard.frames)
        heard.novelty.push_back(novelty.push(frame, heard.hearing));
    heard.attacks = attacks(heard.novelty);
    return heard;
}

}  // namespace percussionist::listening
