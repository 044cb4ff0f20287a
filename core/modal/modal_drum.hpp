// The drum as an instrument: strokes at given samples in, sound out. [modal-drum~] and the renderer
// of the server play it.
//
// A stroke throws a mallet that touches the head at its sample, wherever the head then is; from
// there on head and felt decide (struck_membrane.hpp). A harder stroke presses the felt where it is
// stiffer: shorter contact, more high modes, brighter. The mallet is out of the game once it has
// risen well clear of the head. Up to eight strike at once; a ninth takes the place of the oldest.
//
// What is heard is the head's velocity at the pickup: it has no part at 0 Hz, for the head ends
// where it began. The gain is chosen so that the default mallet at 2 m/s peaks near 0.3 on the
// default drum; what exceeds 0.6 is bent so as to stay below 1.
//
// The constructor, set_modes() and set_pickup() allocate. strike(), process() and tune() do not,
// unless they throw, and process() is noexcept: for the audio thread. All from one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/modal/struck_membrane.hpp"

namespace percussionist::modal {

struct Stroke {
    double velocity = 2.0;  ///< of the mallet towards the head [m/s]
    double r = 0.1;         ///< where [m]
    double theta = 0.0;     ///< [rad]
    Mallet mallet{};
};

/// Throws std::invalid_argument unless 0 < velocity <= 100, r and theta are finite, r is 0 or more,
/// and the mallet passes its own check.
void check(const Stroke& stroke);

struct DrumSettings {
    Membrane membrane{};
    Decay decay{};
    std::size_t modes = 240;    ///< 1 to kMaxModes
    double pickup_r = 0.2;      ///< [m]
    double pickup_theta = 2.0;  ///< [rad]
};

class ModalDrum {
  public:
    static constexpr std::size_t kMaxModes = 2048;
    static constexpr std::size_t kQueue = 64;  ///< strokes waiting at most

    ModalDrum(const DrumSettings& settings, double sample_rate);

    /// A stroke `offset` samples after the first of the next process(). False if too many wait.
    bool strike(std::size_t offset, const Stroke& stroke);

    void process(std::span<float> out) noexcept { render(out); }
    void process(std::span<double> out) noexcept { render(out); }

    // All of these keep what sounds sounding; they throw std::invalid_argument and then change
    // nothing.
    void tune(const Membrane& membrane, const Decay& decay);
    void set_modes(std::size_t count);
    void set_pickup(double r, double theta);

    /// A hand on the head: all dies within t60 [s], until the next stroke lifts it.
    void mute(double t60);
    /// At rest at once, no stroke waiting.
    void reset() noexcept;

    const DrumSettings& settings() const { return settings_; }
    const StruckMembrane& head() const { return *head_; }
    bool silent() const noexcept { return at_rest_ && waiting_ == 0; }

  private:
    struct Waiting {
        std::size_t offset = 0;
        Stroke stroke;
    };

    template <class Sample>
    void render(std::span<Sample> out) noexcept;
    std::size_t run_length(std::size_t most) const noexcept;
    void run(std::span<double> velocities) noexcept;
    void launch(const Stroke& stroke) noexcept;
    void release_mallets() noexcept;
    void remove_mallet(std::size_t i) noexcept;
    void settle();

    DrumSettings settings_;
    double sample_rate_;
    std::optional<StruckMembrane> head_;
    std::vector<double> pickup_shapes_;
    ModeBank::VelocityWeights pickup_;
    std::optional<double> hand_t60_;  // of the hand that mutes [s]

    std::array<Waiting, kQueue> queue_;  // in order of offset
    std::size_t waiting_ = 0;

    std::array<Striker, StruckMembrane::kMaxStrikers> mallets_;     // oldest first
    std::array<std::size_t, StruckMembrane::kMaxStrikers> ages_{};  // since launch [samples]
    std::size_t active_ = 0;

    bool at_rest_ = true;
    std::size_t since_check_ = 0;  // samples since the energy was looked at, or a stroke began
};

}  // namespace percussionist::modal
