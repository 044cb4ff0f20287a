// The simulated drummer plays a plan on his kit: key frames say what his body is asked for, physics
// which contacts come of it, and each stroke of the plan finds its contact, or none.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "body/kit_animation.hpp"
#include "sim/kit_simulation.hpp"

namespace percussionist::app {

struct KitPerformance {
    std::vector<sim::KitContact> contacts;              ///< in the order in which they ended
    std::vector<std::optional<std::size_t>> of_stroke;  ///< the contact of each stroke
    std::vector<std::size_t> bounces;   ///< contacts on what the limb struck last, none of a stroke
    std::vector<std::size_t> closings;  ///< of the hi-hat, silently, before a hand's stroke
    std::vector<std::size_t> strays;    ///< all other contacts
    double top_speed = 0.0;             ///< of a stick's tip [m/s]
    double top_speed_at = 0.0;          ///< [s]
    double largest_error = 0.0;         ///< of a tip against what was asked for [m]
    bool sane = true;
};

/// From before the first stroke to `end` [s]. `see` is told after every step from 0 on.
KitPerformance perform_on_kit(const score::Kit& kit, const std::vector<score::KitStroke>& strokes,
                              const body::KitAnimation& animation,
                              std::vector<modal::Resonator> bodies, double end,
                              const std::function<void(const sim::KitSimulation&)>& see);

/// The contacts as strokes that a kit's sound plays, each at the speed with which the striker of
/// its event has the same momentum; in order of time.
std::vector<score::KitStroke> heard(const score::Kit& kit,
                                    const std::vector<score::KitStroke>& strokes,
                                    const KitPerformance& performance);

/// Every contact: "time_s,object,limb,what,speed_m_s,impulse_ns,peak_n,duration_ms"; what: stroke,
/// bounce, closing or stray.
std::string all_contacts_csv(const score::Kit& kit, const KitPerformance& performance);

/// "time_s,bar,beat,key,event,object,limb,velocity,contact_s,late_ms,speed_m_s,off_mm,peak_n", a
/// line a stroke; of one without a contact the last five are empty.
std::string contacts_csv(const score::Kit& kit, const score::Score& score,
                         const std::vector<score::KitStroke>& strokes,
                         const KitPerformance& performance);

/// What came of it, in lines "what  value" as a report has them.
std::vector<std::pair<std::string, std::string>> account_of(
    const score::Kit& kit, const std::vector<score::KitStroke>& strokes,
    const KitPerformance& performance);

}  // namespace percussionist::app
