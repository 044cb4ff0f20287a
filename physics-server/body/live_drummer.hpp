// The key-framed drummer while the music plays (LiveKit).
//
// He moves as KitAnimation has it at the song's place. Where the song jumps each limb bends from
// where it is to its place in the song; what falls before it can be there, at the kit's speed of a
// hand, is passed over. So is nothing else: strokes that a jump leaps over were never due.
//
// A live note is struck at once by a short stroke, as Kragtwijk, Nijholt and Zwiers, "An animated
// virtual drummer" (2001), 3, have it: by its foot, or by the hand of the least HandEffort and wait
// that can be there within 350 ms and back in time for its next stroke of the song. The wait is
//     max(40 ms, way / speed + settling),
// more where the hand has just struck or is about to. If no limb is free nothing moves.
#pragma once

#include <array>
#include <memory>

#include "body/kit_animation.hpp"
#include "body/limb_forecast.hpp"
#include "body/live_kit.hpp"
#include "body/live_limb.hpp"
#include "core/score/kit_effort.hpp"

namespace percussionist::body {

/// A pose that is looked at, and edited.
struct ShownPose {
    score::Limb limb = score::Limb::right_hand;
    std::size_t event = 0;
    bool up = false;
};

class LiveDrummer : public LiveKit {
  public:
    /// Throws std::invalid_argument for a kit that nobody can play.
    explicit LiveDrummer(score::Kit kit);

    void load(std::vector<score::KitStroke> strokes) override;
    void step(double now, const score::SongStep& song) override;
    LiveStroke strike(std::size_t event, double velocity, bool sounded) override;

    [[nodiscard]] const Skeleton& skeleton() const override { return animation_->skeleton(); }
    [[nodiscard]] const Placement& placement() const override { return placement_; }
    [[nodiscard]] const std::vector<ObjectState>& objects() const override { return objects_; }
    [[nodiscard]] const std::vector<KitContact>& contacts() const override { return contacts_; }
    [[nodiscard]] int passed_over() const override { return passed_over_; }

    [[nodiscard]] const score::Kit& kit() const { return kit_; }
    [[nodiscard]] const Posture& posture() const { return posture_; }
    /// As of the last step.
    [[nodiscard]] LimbForecasts forecasts() const;
    [[nodiscard]] const KitAnimation& animation() const { return *animation_; }

    /// Holds a pose of a limb, to be looked at; none: plays on. Throws std::invalid_argument if the
    /// limb does not play the event.
    void show(const std::optional<ShownPose>& pose);
    [[nodiscard]] const std::optional<ShownPose>& shown() const { return shown_; }
    /// Holds from the next step on. Throw std::invalid_argument saying what was expected.
    void edit(const score::PoseEdit& pose);
    void edit(const score::Script& script);

  private:
    struct Past {
        score::HandHit hit;
        bool any = false, bounced = false;
    };
    struct LimbState {
        LiveLimb motion;
        std::vector<std::size_t> strokes;  ///< of the song, indices in strokes_
        std::vector<KitContact> coming;    ///< of live notes, in order of time
        double ready = 0.0;                ///< strokes of the song before that are passed over [s]
        Past past;                         ///< the last one struck, or to come
        ForecastStroke struck{};           ///< the last one
    };
    void build();
    void settle(score::Limb limb, double now);
    void strike_song(double now, const score::SongStep& song);
    void strike_coming(double now);
    void add(const KitContact& contact);
    void move(double now);
    [[nodiscard]] LimbState& of(score::Limb limb) { return limbs_[index(limb)]; }
    [[nodiscard]] const LimbState& of(score::Limb limb) const { return limbs_[index(limb)]; }
    [[nodiscard]] std::vector<std::size_t>::const_iterator next_in_song(score::Limb limb) const;
    [[nodiscard]] double due(std::size_t stroke) const;
    [[nodiscard]] ForecastStroke coming(score::Limb limb) const;
    [[nodiscard]] double way(score::Limb limb, std::size_t event) const;
    [[nodiscard]] double gap(score::Limb limb, const Past& past, std::size_t event) const;
    [[nodiscard]] std::optional<double> earliest(score::Limb limb, std::size_t event) const;
    [[nodiscard]] double burden(score::Limb hand, std::size_t event, double time) const;
    [[nodiscard]] std::vector<KeyFrame> keys(score::Limb limb, const KitContact& contact) const;
    void work_hat(const score::KitEvent& event, double time);

    score::Kit kit_;
    score::HandEffort effort_;
    std::vector<score::KitStroke> strokes_;
    std::unique_ptr<KitAnimation> animation_;
    std::unique_ptr<KitMotion> kit_motion_;
    std::vector<LimbState> limbs_;  ///< by Limb
    Posture posture_;
    Placement placement_;
    std::vector<ObjectState> objects_;
    std::vector<KitContact> contacts_;
    std::optional<ShownPose> shown_;
    double now_ = 0.0;      ///< of the last step [s]
    score::SongStep song_;  ///< the last
    int passed_over_ = 0;
};

}  // namespace percussionist::body
