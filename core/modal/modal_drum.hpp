// The drum as an instrument: strokes at given samples in, sound out. [modal-drum~] and the renderer
// of the server play it.
//
// A stroke throws a mallet that touches the head at its sample, wherever the head then is; from
// there on head and felt decide (struck_head.hpp). A harder stroke presses the felt where it is
// stiffer: shorter contact, more high modes, brighter. The mallet is out of the game once it has
// risen well clear of the head. Up to eight strike at once; a ninth takes the place of the oldest.
// One of the eight may be a follower, which a signal moves: a tracker's stick.
//
// What is heard is the head's velocity or displacement at a pickup, or the pressure a metre away
// (of given modes, what their microphone hears).
// The gains are chosen so that the default mallet at 2 m/s peaks near 0.3 on the default drum; what
// exceeds 0.6 is bent so as to stay below 1. Another place to listen, other modes or another body
// are faded in over a chunk of samples, while the old ones ring on: nothing clicks.
//
// The head rings in chunks counted from its last contact or change, not from the blocks' borders:
// blocks of any size give the same bits.
//
// The constructor, choose(), set_pickup() and, but within the same kind of body, tune() allocate.
// All else does not, unless it throws, and process() is noexcept: for the audio thread. All from
// one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/modal/struck_head.hpp"

namespace percussionist::modal {

struct Stroke {
    double velocity = 2.0;  ///< of the mallet towards the head [m/s]
    double r = 0.1;         ///< where [m]
    double theta = 0.0;     ///< [rad]
    Mallet mallet{};
    double slide_x = 0.0;  ///< how the mallet moves along the head meanwhile [m/s]
    double slide_y = 0.0;
};

/// Throws std::invalid_argument unless 0 < velocity <= 100, r and theta are finite, r is 0 or more,
/// the slide is at most 100 m/s each way, and the mallet passes its own check.
void check(const Stroke& stroke);

struct Pickup {
    enum class Hears { velocity, position, pressure };
    Hears hears = Hears::velocity;
    double r = 0.2;          ///< [m]; of no matter to pressure
    double theta = 2.0;      ///< [rad]
    double elevation = 0.6;  ///< from the head's axis, for pressure [rad]
};

struct DrumSettings {
    Body body = Membrane{};
    Loss loss = Decay{};
    Choice choice{};
    std::vector<Pickup> pickups{1};  ///< 1 to kMaxPickups
};

/// What goes through the drum in one process(): one output a pickup.
template <class Sample>
struct DrumSignals {
    std::span<Sample* const> outputs;
    std::size_t size = 0;
    const Sample* force = nullptr;     ///< on the head, upwards, at force_at() [N]
    const Sample* position = nullptr;  ///< of the follower's felt above the head at rest [m]
};

class ModalDrum {
  public:
    static constexpr std::size_t kMaxModes = kMostModes;
    static constexpr std::size_t kMaxPickups = StruckHead::kMaxPickups;
    static constexpr std::size_t kQueue = 64;  ///< strokes waiting at most

    ModalDrum(const DrumSettings& settings, double sample_rate);

    /// A stroke `offset` samples after the first of the next process(). False if too many wait.
    bool strike(std::size_t offset, const Stroke& stroke);

    void process(const DrumSignals<float>& signals) noexcept { render(signals); }
    void process(const DrumSignals<double>& signals) noexcept { render(signals); }
    void process(std::span<float> out) noexcept { render_one(out); }  ///< the first pickup
    void process(std::span<double> out) noexcept { render_one(out); }

    // All of these keep what sounds sounding; they throw std::invalid_argument and then change
    // nothing.
    void tune(const Body& body, const Loss& loss);
    void choose(const Choice& choice);
    void set_pickup(std::size_t i, const Pickup& pickup);
    void lay(std::size_t i, const Hand& hand);  ///< see StruckHead
    void force_at(double r, double theta);
    /// From now on a felt follows the position signal; at another place it glides there.
    void follow(double r, double theta, const Mallet& mallet);
    void unfollow() noexcept;

    /// All dies within t60 [s], until the next stroke.
    void mute(double t60);
    /// At rest at once, no stroke waiting.
    void reset() noexcept;

    const DrumSettings& settings() const { return settings_; }
    const StruckHead& head() const { return *head_; }
    bool silent() const noexcept { return at_rest_ && waiting_ == 0; }

  private:
    static constexpr std::size_t kChunk = ModeBank::kChunk;

    struct Waiting {
        std::size_t offset = 0;
        Stroke stroke;
    };
    /// What a striker needs besides its motion.
    struct Course {
        std::size_t age = 0;  ///< samples since launch
        bool follower = false;
        double x = 0.0, y = 0.0;              ///< where on the head [m]
        double slide_x = 0.0, slide_y = 0.0;  ///< [m/s]
    };
    /// What a pickup hears of each mode.
    struct Ear {
        Values shape;
        Values later;  ///< a quarter of a period later; empty but for pressure
        ModeBank::Weights weights;
    };
    using Readings = std::array<double, kMaxPickups>;

    template <class Sample>
    void render_one(std::span<Sample> out) noexcept;
    template <class Sample>
    void render(const DrumSignals<Sample>& signals) noexcept;
    template <class Sample>
    std::size_t free_length(const DrumSignals<Sample>& signals, std::size_t from,
                            std::size_t most) const noexcept;
    template <class Sample>
    void ring(const DrumSignals<Sample>& signals, std::size_t from, std::size_t length) noexcept;
    template <class Sample>
    void step(const DrumSignals<Sample>& signals, std::size_t at) noexcept;
    template <class Sample>
    void put(const DrumSignals<Sample>& signals, std::size_t at, const Readings& readings) noexcept;

    void look_ahead() noexcept;
    void land() noexcept;
    void count(std::size_t samples) noexcept;
    void launch(const Stroke& stroke) noexcept;
    void add(const Striker& striker, const Course& course) noexcept;
    void steer(double position) noexcept;
    void release() noexcept;
    void remove(std::size_t i) noexcept;
    std::size_t follower() const noexcept;

    void fade() noexcept;
    void read_pickups();
    void weigh_pickups() noexcept;

    DrumSettings settings_;
    double sample_rate_;
    std::optional<StruckHead> head_;
    std::array<Ear, kMaxPickups> ears_;
    std::optional<double> mute_t60_;  // [s]

    std::array<Waiting, kQueue> queue_;  // in order of offset
    std::size_t waiting_ = 0;

    std::array<Striker, StruckHead::kMaxStrikers> strikers_;  // oldest first
    std::array<Course, StruckHead::kMaxStrikers> courses_;
    std::size_t active_ = 0;
    double follow_x_ = 0.0, follow_y_ = 0.0;  // where the follower glides to [m]

    // What will be heard if nothing happens, and how much of it has been.
    std::array<std::array<double, kChunk>, kMaxPickups> ahead_{};
    std::size_t ahead_size_ = 0;
    std::size_t heard_ = 0;
    // What would have been heard before a change, fading out.
    std::array<std::array<double, kChunk>, kMaxPickups> fading_{};
    std::size_t faded_ = kChunk;

    bool at_rest_ = true;
    bool coupled_ = false;         // see StruckHead::coupled(), as of the last look
    std::size_t since_check_ = 0;  // samples since the energy was looked at, or something happened
};

}  // namespace percussionist::modal
