// Where a swing turns or stops, and how sharply: told from a path alone, in any direction.
//
// A point is a turn where, along the direction in which the swing was fastest, none within `kLag`
// before or after it lies further out than the noise. The swing goes back from there to the point
// that is furthest from it. Of a turn are measured
//  - speed: of the swing at its fastest, chords of 0.6 kLag;
//  - deceleration: the greatest loss of speed on the way in, over kLag before and after each point,
//    2 (v_in - max(v_out, 0)) / (t_out - t_in): what the way out gains does not count, so that a
//    rest at the top, left quickly, is no sharp turn. Its uncertainty is sqrt(6) noise / kLag^2;
//    what is not well above that, and blunt enough, is measured over twice the lag;
//  - lasts = speed / deceleration: 1 / omega of a sinusoid, 0.33 T of a movement of minimum jerk
//    that takes T, half the lag at an impact. It does not depend on how large the movement is.
// Its instant is where the ways in and out meet, if that is sharp; else the middle of what lies
// within 4 % of the swing's depth, or where a stop of that deceleration would end, if that is
// sooner. Pure; real-time safe.
#pragma once

#include <algorithm>
#include <optional>

#include "core/motion/local_fit.hpp"
#include "core/motion/recent.hpp"

namespace percussionist::motion {

using RecentPath = Recent<PathPoint, 128>;

struct SwingTurn {
    double time = 0.0;                     ///< [s]
    double peak_time = 0.0;                ///< of the greatest deceleration [s]
    double speed = 0.0;                    ///< of the swing, at its fastest [m/s]
    double deceleration = 0.0;             ///< at its greatest [m/s^2]
    double depth = 0.0;                    ///< of the swing [m]
    Vector3 direction = Vector3::UnitX();  ///< of the swing at its fastest
    PathPoint bottom;                      ///< that was judged

    double lasts() const { return speed / deceleration; }  ///< [s]
    /// How far `position` is back from the turn [m].
    double retreat(const Vector3& position) const {
        return direction.dot(bottom.position - position);
    }
    double level(double noise) const { return std::max(2.5 * noise, 0.04 * depth); }
};

class SwingMeter {
  public:
    static constexpr double kLag = 0.025;  ///< [s]

    /// The path, how far its points are off [m], and since when it may be looked at.
    SwingMeter(const RecentPath& path, double noise, double since)
        : path_(path), noise_(noise), since_(since) {}

    /// The first point before `from` by `span`, or nearly [s].
    std::optional<std::size_t> before(std::size_t from, double span) const noexcept;
    /// The turn at that point, with an instant as good as what is known by now.
    std::optional<SwingTurn> turn(std::size_t at) const noexcept;
    void locate(SwingTurn& turn) const noexcept;

  private:
    std::size_t after(std::size_t from, double span) const noexcept;
    std::size_t start(std::size_t at, double& depth) const noexcept;
    bool is_extreme(const SwingTurn& turn, std::size_t at) const noexcept;
    Vector3 fastest(std::size_t at, std::size_t start, std::size_t& where) const noexcept;
    void decelerate(SwingTurn& turn, std::size_t at, std::size_t fastest,
                    double lag) const noexcept;
    std::optional<double> meeting(const SwingTurn& turn, std::size_t at) const noexcept;

    const RecentPath& path_;
    double noise_;
    double since_;
};

}  // namespace percussionist::motion
