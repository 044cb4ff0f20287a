// Strikes of a round tip on a plane, told ahead of time.
//
// The tip is a sphere: its centre is one radius from the head at contact, whatever the angle of the
// stick (Marshall, Moynihan, Rath 2002, "The Vodhran", 3.2). On its way in, the centre's last few
// points, moving towards the plane, are fitted with a parabola; where that meets the radius is the
// strike's instant, between samples. It is told
//  - ahead, once the hand can no longer stop: from speed v at distance d that takes v^2 / 2d, more
//    than `hardest_stop`; at most `ahead` before;
//  - when a sample is through the plane;
//  - when the parabola was through but the next sample is where only a bounce can bring it, or the
//    next two come from the head when followed back.
// Then the tip has to leave the head before it can strike again. It strikes on the side it is on;
// passing through what is not there does not change the side, staying beyond does.
// Pure; real-time safe; one detector for each tip.
#pragma once

#include <optional>

#include "core/motion/drum_plane.hpp"
#include "core/motion/local_fit.hpp"
#include "core/motion/recent.hpp"

namespace percussionist::motion {

struct PlaneStrikeSettings {
    double tip_radius = 0.0125;    ///< [m]
    double ahead = 0.02;           ///< at most so long before [s]; 0: only what has happened
    double least_speed = 0.15;     ///< into the head; slower is laying it down [m/s]
    double hardest_stop = 150.0;   ///< what a hand can do to a stick's end [m/s^2]
    double clearance = 0.003;      ///< off the head before the next strike [m]
    double rest = 0.03;            ///< between strikes of one tip at least [s]
    double change_of_side = 0.15;  ///< beyond the plane so long, it plays on the other side [s]
    double drum_radius = 0.0;      ///< beyond it there is no head [m]; 0: no limit
};

struct PlaneStrike {
    double time = 0.0;                   ///< [s]
    double speed = 0.0;                  ///< into the head [m/s]
    Vector3 velocity = Vector3::Zero();  ///< of the tip in the drum's frame [m/s]
    Place place;
    int side = 1;  ///< 1: from where z points, -1: from behind
};

class PlaneStrikeDetector {
  public:
    explicit PlaneStrikeDetector(const PlaneStrikeSettings& settings) : settings_(settings) {}

    /// Where the tip's centre is in the drum's frame, in order of time.
    std::optional<PlaneStrike> add(const PathPoint& tip_drum) noexcept;
    void reset() noexcept { points_.clear(); }
    void set(const PlaneStrikeSettings& settings) { settings_ = settings; }

  private:
    double distance(const PathPoint& point) const noexcept {
        return side_ * point.position.z() - settings_.tip_radius;
    }
    void follow_side(const PathPoint& point) noexcept;
    void follow_clearance(const PathPoint& point) noexcept;
    std::size_t approach(std::size_t newest) const noexcept;
    LocalFit fit_approach(std::size_t newest, std::size_t count) const noexcept;
    std::optional<double> meeting(const LocalFit& fit, double from) const noexcept;
    bool bounced(const LocalFit& fit, double meets, const PathPoint& before,
                 const PathPoint& after) const noexcept;
    bool leaves_head(double meets, const PathPoint& after, const PathPoint& next) const noexcept;
    std::optional<PlaneStrike> strike_behind(std::size_t newest) noexcept;
    std::optional<PlaneStrike> strike_ahead() noexcept;
    std::optional<PlaneStrike> strike_at(const LocalFit& fit, double time) noexcept;

    PlaneStrikeSettings settings_;
    Recent<PathPoint, 8> points_;
    double side_ = 1.0;
    std::optional<double> beyond_since_;
    bool armed_ = false;
    double last_strike_ = -1e9;
};

}  // namespace percussionist::motion
