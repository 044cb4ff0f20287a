// Linear contacts solved at once: springs and dampers that touch the head at several ports.
//
// Over one step of h seconds a port's displacement changes by y = y_free - sum C F, C the head's
// compliance from port to port, and its spring and damper answer, by the trapezium rule,
//     F = k (e + y / 2) + r y / h,     e the spring's elongation, which grows by y.
// So (C + 1/D) F = y_free + k e / D with D = k / 2 + r / h: symmetric and positive, by Cholesky.
// The work F y is the change of k e^2 / 2 plus what the damper takes, r y^2 / h: passive, whatever
// k and r. A spring that relaxes (a damper of k tau in series: e' = y' - e / tau) does so after the
// step, e becoming e exp(-h / tau), which only takes energy. What remains at other ports is the
// same head with a smaller compliance (condense()).
//
// No function allocates or throws.
#pragma once

#include <array>
#include <cstddef>

namespace percussionist::modal {

struct Spring {
    double stiffness = 0.0;   ///< k [N/m]
    double resistance = 0.0;  ///< r [N s/m]
    double elongation = 0.0;  ///< e [m]
    double force = 0.0;       ///< F, during the last step [N]

    double energy() const { return 0.5 * stiffness * elongation * elongation; }
};

class Springs {
  public:
    static constexpr std::size_t kMost = 17;
    using Row = std::array<double, kMost>;

    /// The number of ports, their compliances (symmetric) and D of each, above 0.
    void factor(std::size_t count, const std::array<Row, kMost>& compliance,
                const Row& hold) noexcept;
    /// Solves (C + 1/D) x = b in place.
    void solve(Row& b) const noexcept;

    std::size_t count() const { return count_; }

  private:
    std::size_t count_ = 0;
    std::array<Row, kMost> lower_{};
};

}  // namespace percussionist::modal
