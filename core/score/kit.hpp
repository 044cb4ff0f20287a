// A drum kit and who sits at it, as plain values: what stands where, in which ways it is struck,
// and what a drummer does by preference. kit_file.hpp reads and writes it as text.
//
// After the drum kit model of Kragtwijk, Nijholt and Zwiers, "An animated virtual drummer" (2001):
// the percussion keys of General MIDI are mapped onto the kit's own events; each event has a
// preferred hand and an elasticity (how far of its way the stick bounces back), each pair of events
// a preferred distribution over the hands.
//
// World: x to the front, y to the left, z up, the origin on the floor below the drummer. Values, no
// thread contract but that of values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/linear/rotation.hpp"

namespace percussionist::score {

using linear::Vector3;

enum class Limb { left_hand, right_hand, left_foot, right_foot };
inline constexpr std::array<std::string_view, 4> kLimbNames{"left-hand", "right-hand", "left-foot",
                                                            "right-foot"};
constexpr std::size_t index(Limb limb) {
    return static_cast<std::size_t>(limb);
}
constexpr std::string_view name(Limb limb) {
    return kLimbNames[index(limb)];
}
constexpr bool is_hand(Limb limb) {
    return limb == Limb::left_hand || limb == Limb::right_hand;
}
constexpr Limb other_hand(Limb hand) {
    return hand == Limb::left_hand ? Limb::right_hand : Limb::left_hand;
}

enum class ObjectKind { drum, cymbal, hi_hat, bell };
inline constexpr std::array<std::string_view, 4> kObjectKindNames{"drum", "cymbal", "hi-hat",
                                                                  "bell"};

struct KitObject {
    std::string name;
    ObjectKind kind = ObjectKind::drum;
    Vector3 middle = Vector3::Zero();  ///< of the face that is struck, world [m]
    double lean_back = 0.0;            ///< of the face towards the drummer [rad]
    double lean_left = 0.0;            ///< then to the left [rad]
    double radius = 0.15;              ///< [m]
    double depth = 0.0;                ///< of a shell, below the face [m]
    std::string sound;                 ///< a drum of the program's set, or a mode file
    double level = 1.0;                ///< in the mix
    double wires = 0.0;                ///< of a snare drum: how loud they rattle

    [[nodiscard]] linear::Quaternion orientation() const;
    /// Out of the struck face, unit.
    [[nodiscard]] Vector3 normal() const { return orientation() * Vector3::UnitZ(); }
};

/// A plate under a foot, which turns about its heel end.
struct Pedal {
    std::size_t object = 0;  ///< what it plays
    Limb foot = Limb::right_foot;
    Vector3 heel = Vector3::Zero();  ///< of the plate, world [m]
    double length = 0.28;            ///< [m]
    double direction = 0.0;          ///< from the front to the left [rad]
    double down = 0.05;              ///< the plate's angle above the floor when pressed [rad]
    double up = 0.35;                ///< and when let go [rad]
};

/// What the hi-hat's pedal does for an event of the hands.
enum class HatState { any, closed, open };
inline constexpr std::array<std::string_view, 3> kHatStateNames{"any", "closed", "open"};

/// How high the hi-hat's upper cymbal is with the pedal up [m], and how far of this way the foot
/// lets it go for hands that play it open.
inline constexpr double kHatOpens = 0.03;
inline constexpr double kOpenHat = 0.8;

/// A way in which an object is struck.
struct KitEvent {
    std::string name;
    std::size_t object = 0;
    std::optional<Limb> foot;  ///< that strikes it; none: hands do
    double forward = 0.0;      ///< where on the face, along it, from its middle [m]
    double left = 0.0;         ///< [m]
    double apart = 0.0;        ///< how far apart both hands strike there [m]
    std::optional<Limb> hand;  ///< that it is left to by preference
    double elasticity = 0.5;   ///< share of its way that the stick bounces back, 0 to 1
    HatState hat = HatState::any;
    double mass = 0.012;                    ///< of the striker, as the object feels it [kg]
    double stiffness = 1e8;                 ///< of the striker, see modal::Mallet
    double t60 = 0.0;                       ///< within which its sound is damped [s]; 0: it rings
    std::array<bool, 2> reach{true, true};  ///< whether the left and the right hand get there
};

/// If `first` and `second` come close together, `hand` takes the first, the other the second.
struct PairPreference {
    Limb hand = Limb::right_hand;
    bool may_cross = false;  ///< the arms cross for it: usual, and no fault
};

/// What hands and feet can do at best.
struct LimbLimits {
    double interval = 0.098;  ///< between two strokes of one hand [s]
    double bounce = 0.0630;   ///< before the second of a bounced pair, on the same object [s]
    double speed = 7.5;       ///< of a hand from object to object, on average [m/s]
    double settling = 0.020;  ///< of the time between two strokes that is no way [s]
    double foot = 0.075;      ///< between two strokes of one foot [s]
};

/// The part of a stroke that a script is for.
enum class Phase { down, up, between };
inline constexpr std::array<std::string_view, 3> kPhaseNames{"down", "up", "between"};

/// How a joint goes from one key frame to the next: the share of the way, at equal parts of the
/// time between them.
struct Script {
    std::string joint;  ///< "elbow" (of either side)
    Phase phase = Phase::down;
    std::vector<double> curve;  ///< begins with 0 and ends with 1
};

/// A joint of a pose that was set by hand: Euler angles z y x [rad].
struct PoseEdit {
    Limb limb = Limb::right_hand;
    std::size_t event = 0;
    bool up = false;
    std::string joint;
    Vector3 angles = Vector3::Zero();
};

struct Drummer {
    double stature = 1.75;        ///< [m]
    double mass = 75.0;           ///< [kg]
    double hips = 0.60;           ///< height of the hip joints, sitting [m]
    double stick_length = 0.406;  ///< [m]
    double stick_held = 0.11;     ///< from its butt [m]
    double stick_mass = 0.055;    ///< [kg]
    double rise = 0.30;           ///< how far above a face the tip is raised for the loudest [m]
};

inline constexpr int kKeys = 128;
inline constexpr int kNotOfTheKit = -1;

struct Kit {
    std::string name;
    Drummer drummer;
    LimbLimits limits;
    std::vector<KitObject> objects;
    std::vector<Pedal> pedals;
    std::vector<KitEvent> events;  ///< in order of importance: what is left out last comes first
    std::array<int, kKeys> keys = no_keys();  ///< event of a MIDI key
    /// By first and second event, row by row; none: as the places are.
    std::vector<std::optional<PairPreference>> pairs;
    std::vector<Script> scripts;
    std::vector<PoseEdit> poses;

    static constexpr std::array<int, kKeys> no_keys() {
        std::array<int, kKeys> keys{};
        keys.fill(kNotOfTheKit);
        return keys;
    }
    [[nodiscard]] std::optional<std::size_t> object_named(std::string_view name) const;
    [[nodiscard]] std::optional<std::size_t> event_named(std::string_view name) const;
    [[nodiscard]] const KitObject& object_of(std::size_t event) const {
        return objects[events[event].object];
    }
    [[nodiscard]] const std::optional<PairPreference>& pair(std::size_t a, std::size_t b) const {
        return pairs[a * events.size() + b];
    }
    [[nodiscard]] const Pedal* pedal_of(Limb foot) const;
};

/// Where the tip of a hand's stick meets the face, world [m]; a hi-hat played open is that open.
Vector3 spot_of(const Kit& kit, std::size_t event, Limb hand);

/// Throws std::invalid_argument naming what cannot be: an index, a size, a limit, a preference.
void check(const Kit& kit);

}  // namespace percussionist::score
