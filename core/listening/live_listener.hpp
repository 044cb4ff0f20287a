// Listening live: each attack told within 12 ms of its sound, which drums it was within 60 ms.
//
// Frames come every 5 ms. An attack is told at the first frame whose novelty passes the threshold;
// its features are taken around where the rise was steepest, once the 9 frames after that are in,
// and judged by the live network of the model and, where drums were learnt from strokes of the
// player's own (own_drums.hpp), by those.
//
// The constructor takes all memory; process() does not allocate, lock or throw. One thread.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/listening/band_analyser.hpp"
#include "core/listening/drum_model.hpp"
#include "core/listening/hearing.hpp"
#include "core/listening/judgement.hpp"
#include "core/listening/novelty.hpp"
#include "core/listening/own_drums.hpp"

namespace percussionist::listening {

struct LiveSettings {
    double rate = 48000.0;       ///< [Hz]
    float sensitivity = 1.5F;    ///< novelty from which something was struck
    double shortest_gap = 0.04;  ///< between two attacks [s]
    float quietest = -70.0F;     ///< below full scale nothing is heard [dB]
};

/// What process() tells.
struct LiveEvent {
    enum class Kind { attack, drum, own_drum };
    Kind kind = Kind::attack;
    double time = 0.0;  ///< of the stroke, from the first sample [s]
    DrumClass drum = DrumClass::other;
    std::size_t own = 0;      ///< which of the player's own drums
    double velocity = 0.0;    ///< above 0 and up to 1
    double confidence = 0.0;  ///< 0.5 to 1
};

class LiveListener {
  public:
    static constexpr std::size_t kMostEvents = 2 * kDrumClasses + 1;  ///< of one frame

    /// Throws std::invalid_argument for a rate that it cannot hear at.
    LiveListener(const LiveSettings& settings, DrumModel model);

    /// What is no number is heard as silence, and nothing as louder than kLoudest. The next
    /// samples, as many as you like; tell(event, samples) for each event, after so many of them.
    template <class Tell>
    void process(std::span<const float> samples, Tell tell) noexcept {
        for (std::size_t n = 0; n < samples.size(); ++n) {
            waiting_[filled_] = heard(samples[n]);
            if (++filled_ < waiting_.size()) continue;
            filled_ = 0;
            const std::size_t count = next_frame();
            for (std::size_t e = 0; e < count; ++e) tell(events_[e], n + 1);
        }
    }

    /// The next attacks are strokes of this drum: learns it from `strokes` of them. What is far
    /// softer than the loudest of them is an echo of it.
    void learn(std::size_t own, int strokes) noexcept;
    [[nodiscard]] bool learning() const { return left_to_learn_ > 0; }
    [[nodiscard]] const OwnDrums& own_drums() const { return own_; }
    /// Ends learning.
    void set_own_drums(const OwnDrums& drums) {
        own_ = drums;
        left_to_learn_ = 0;
    }
    /// The drums of another, and what it has yet to learn of them.
    void take_drums(const LiveListener& other) {
        own_ = other.own_;
        learning_ = other.learning_;
        left_to_learn_ = other.left_to_learn_;
    }
    void set_sensitivity(float novelty) { settings_.sensitivity = novelty; }
    void reset() noexcept;

  private:
    static constexpr std::size_t kKept = 32;   ///< frames
    static constexpr float kLoudest = 100.0F;  ///< 40 dB above full scale

    static double heard(float sample) {
        return std::isfinite(sample) ? std::clamp(sample, -kLoudest, kLoudest) : 0.0;
    }
    std::size_t next_frame() noexcept;
    void look_for_attack(float novelty) noexcept;
    void judge() noexcept;
    void judge_own(double time) noexcept;
    void tell(const LiveEvent& event) noexcept;
    [[nodiscard]] double time_of_frame(double frame) const noexcept;
    [[nodiscard]] double velocity(DrumClass drum) noexcept;

    LiveSettings settings_;
    DrumModel model_;
    BandAnalyser analyser_;
    RunningHearing hearing_;
    Novelty novelty_;
    OwnDrums own_;
    std::vector<double> waiting_;  ///< samples of the frame to come
    std::size_t filled_ = 0;
    std::vector<BandFrame> frames_;  ///< the last ones, oldest first
    std::vector<float> features_;
    std::array<float, kDrumClasses> loud_{};  ///< usual power of loud strokes [nats]
    std::array<LiveEvent, kMostEvents> events_{};
    std::size_t told_ = 0;
    std::ptrdiff_t frame_ = -1;      ///< number of the newest
    std::ptrdiff_t attack_ = -1000;  ///< number of the one an attack began at
    std::ptrdiff_t steepest_ = -1;   ///< of that attack; -1: judged
    std::array<float, 3> around_{};  ///< novelty before, at and after the steepest
    float before_ = 0.0F;            ///< novelty of the frame before
    std::size_t learning_ = 0;
    int left_to_learn_ = 0;
};

}  // namespace percussionist::listening
