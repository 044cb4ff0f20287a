#include "body/skeleton.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace percussionist::body {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// de Leva 1996, table 4, male: shares of body mass, centre of mass from the proximal end and radii
/// of gyration as fractions of the segment's length. For head and trunk the paper counts from the
/// cranial end, for the foot from the heel; ours hang from the lower end and the ankle.
struct Share {
    double mass;
    double com;
    double sagittal;
    double transverse;
    double longitudinal;
};
constexpr Share kHead{0.0694, 1 - 0.598, 0.362, 0.376, 0.312};
constexpr Share kUpperTrunk{0.1596, 1 - 0.300, 0.716, 0.454, 0.659};
constexpr Share kMiddleTrunk{0.1633, 1 - 0.450, 0.482, 0.383, 0.468};
constexpr Share kLowerTrunk{0.1117, 1 - 0.612, 0.615, 0.551, 0.587};
constexpr Share kUpperArm{0.0271, 0.577, 0.285, 0.269, 0.158};
constexpr Share kForearm{0.0162, 0.457, 0.276, 0.265, 0.121};
constexpr Share kHand{0.0061, 0.790, 0.628, 0.513, 0.401};
constexpr Share kThigh{0.1416, 0.410, 0.329, 0.329, 0.149};
constexpr Share kShank{0.0433, 0.440, 0.251, 0.246, 0.102};
constexpr Share kFoot{0.0137, 0.442 - 0.23, 0.257, 0.245, 0.124};
/// Share of the body's mass that goes with each clavicle, taken from the upper trunk.
constexpr double kClavicleMass = 0.0078;

/// Lengths and places as fractions of stature (Winter 2009; trunk parts from de Leva's mean man).
constexpr double kShoulderHeight = 0.818, kShoulderHalfWidth = 0.1085, kHipHeight = 0.530;
constexpr double kHipHalfWidth = 0.0515, kUpperArmLength = 0.186, kForearmLength = 0.146;
constexpr double kHandLength = 0.0495;  // wrist to the third knuckle's middle, as de Leva has it
constexpr double kThighLength = 0.245, kShankLength = 0.246, kFootLength = 0.148;
constexpr double kLowerTrunkLength = 0.0837, kMiddleTrunkLength = 0.1238;
constexpr double kUpperTrunkLength = 0.0980, kHeadLength = 0.1168;
constexpr double kLumbarHeight = 0.600, kThoracicHeight = 0.691, kNeckHeight = 0.846;

JointLimits limits(double z0, double z1, double y0, double y1, double x0, double x1) {
    JointLimits l;
    l.lower_zyx = kDegree * Vector3(z0, y0, x0);
    l.upper_zyx = kDegree * Vector3(z1, y1, x1);
    return l;
}

Vector3 moments(const Share& share, double mass, double length, const Vector3& along) {
    const auto square = [&](double fraction) {
        return mass * fraction * length * fraction * length;
    };
    // An upright segment has its long axis on z; one that points forward was turned about y, which
    // brings the long axis to x and the sagittal axis (front to back) to z.
    if (std::abs(along.x()) > 0.5) {
        return {square(share.longitudinal), square(share.transverse), square(share.sagittal)};
    }
    return {square(share.sagittal), square(share.transverse), square(share.longitudinal)};
}

class Builder {
  public:
    explicit Builder(const Anthropometry& anthropometry)
        : person_(anthropometry),
          l_(anthropometry.lengths.value_or(lengths_of(anthropometry.stature))) {
        skeleton_.stick = anthropometry.stick;
    }

    Skeleton build() {
        const Vector3 up = Vector3::UnitZ();
        add("pelvis", "", -1, {0, 0, l_.hip_height}, up, kLowerTrunk, l_.lower_trunk,
            {0.20, 0.32, 0.16}, 0, 0, {});
        const int abdomen = add("abdomen", "lumbar", 0, {0, 0, l_.lumbar_height}, up, kMiddleTrunk,
                                l_.middle_trunk, {0.20, 0.30, 0.17}, 200, 0.03, spine());
        Share chest_share = kUpperTrunk;
        chest_share.mass -= 2 * kClavicleMass;
        const int chest = add("chest", "thoracic", abdomen, {0, 0, l_.thoracic_height}, up,
                              chest_share, l_.upper_trunk, {0.22, 0.32, 0.24}, 200, 0.03, spine());
        add("head", "neck", chest, {0, 0, l_.neck_height}, up, kHead, l_.head, {0.18, 0.15, 0.24},
            50, 0, spine());
        for (const Hand hand : {Hand::left, Hand::right}) {
            add_arm(hand, chest);
            add_leg(hand);
        }
        return std::move(skeleton_);
    }

  private:
    static JointLimits spine() { return limits(-30, 30, -30, 30, -20, 45); }

    int add(const std::string& name, const std::string& joint, int parent, const Vector3& at,
            const Vector3& along, const Share& share, double length, const Vector3& size,
            double torque, double reach, const JointLimits& joint_limits) {
        Segment s;
        s.name = name;
        s.joint = joint;
        s.parent = parent;
        s.joint_rest = at;
        s.mass = share.mass * person_.mass;
        s.com_rest = at + share.com * length * along;
        s.end_rest = at + length * along;
        s.inertia = moments(share, s.mass, length, along);
        s.size = size;
        s.torque_limit = torque;
        s.reach = reach;
        s.limits = joint_limits;
        skeleton_.segments.push_back(s);
        return skeleton_.size() - 1;
    }

    /// Limits of a joint on the left, or its mirror image on the right.
    static JointLimits sided(Hand hand, double z0, double z1, double y0, double y1, double x0,
                             double x1) {
        return hand == Hand::left ? limits(z0, z1, y0, y1, x0, x1)
                                  : limits(-z1, -z0, y0, y1, -x1, -x0);
    }

    void add_arm(Hand hand, int chest) {
        const double y = hand == Hand::left ? 1.0 : -1.0;
        const std::string side = Skeleton::side(hand);
        const double half_width = l_.shoulder_half_width;
        const Vector3 down = -Vector3::UnitZ();
        const Vector3 front = Vector3::UnitX();
        const Vector3 sternum(0, 0.04 * y, l_.shoulder_height);
        const Vector3 shoulder(0, half_width * y, l_.shoulder_height);
        const int clavicle =
            add(side + "clavicle", side + "clavicle", chest, sternum, y * Vector3::UnitY(),
                {kClavicleMass, 0.5, 0.30, 0.12, 0.30}, half_width - 0.04, {0.05, 0.14, 0.05}, 100,
                0.05, sided(hand, -20, 20, -20, 20, -20, 20));
        // Elevation and rotation of the upper arm; flexion (about -y) as far as the arm goes up.
        const double upper = l_.upper_arm;
        const int upper_arm =
            add(side + "upper_arm", side + "shoulder", clavicle, shoulder, down, kUpperArm, upper,
                {0.08, 0.08, upper}, 100, 1.0, sided(hand, -90, 90, -90, 90, -60, 90));
        // At rest the elbow is bent by 90 degrees: 170 of flexion from straight is 80 from here.
        const double fore = l_.forearm;
        const Vector3 elbow = shoulder + upper * down;
        const int forearm =
            add(side + "forearm", side + "elbow", upper_arm, elbow, front, kForearm, fore,
                {fore, 0.07, 0.07}, 60, 1.0, sided(hand, -30, 30, -80, 88, -90, 90));
        const Vector3 wrist = elbow + fore * front;
        const double palm = l_.hand;
        const int palm_index =
            add(side + "hand", side + "wrist", forearm, wrist, front, kHand, palm,
                {0.17, 0.08, 0.03}, 20, 1.0, sided(hand, -45, 45, -88, 88, -45, 45));
        add_stick(hand, palm_index, wrist + (palm - 0.005) * front);
    }

    void add_stick(Hand hand, int palm, const Vector3& grip) {
        const Stick& stick = person_.stick;
        const Vector3 front = Vector3::UnitX();
        const std::string side = Skeleton::side(hand);
        Segment s;
        s.name = side + "stick";
        s.joint = side + "grip";
        s.parent = palm;
        s.joint_rest = grip;
        s.mass = stick.mass;
        s.com_rest = grip + (0.5 * stick.length - stick.held_at) * front;
        s.end_rest = grip + stick.reach() * front;
        const double across = stick.mass * stick.length * stick.length / 12.0;
        const double around = stick.mass * stick.diameter * stick.diameter / 6.0;
        s.inertia = {around, across, across};
        s.size = {stick.length, stick.diameter, stick.diameter};
        s.torque_limit = 10.0;
        s.reach = 1.0;
        s.limits = limits(-60, 60, -80, 80, -60, 60);
        skeleton_.segments.push_back(s);
    }

    void add_leg(Hand hand) {
        const double y = hand == Hand::left ? 1.0 : -1.0;
        const std::string side = Skeleton::side(hand);
        const Vector3 down = -Vector3::UnitZ();
        const Vector3 hip(0, l_.hip_half_width * y, l_.hip_height);
        const Vector3 knee = hip + l_.thigh * down;
        const Vector3 ankle = knee + l_.shank * down;
        const int thigh =
            add(side + "thigh", side + "hip", 0, hip, down, kThigh, l_.thigh,
                {0.14, 0.14, l_.thigh}, 200, 0, sided(hand, -60, 70, -88, 20, -30, 70));
        const int shank =
            add(side + "shank", side + "knee", thigh, knee, down, kShank, l_.shank,
                {0.10, 0.10, l_.shank}, 150, 0, sided(hand, -20, 20, -10, 88, -20, 20));
        add(side + "foot", side + "ankle", shank, ankle, Vector3::UnitX(), kFoot, l_.foot,
            {0.25, 0.09, 0.06}, 80, 0, sided(hand, -30, 30, -40, 40, -30, 30));
    }

    Anthropometry person_;
    Lengths l_;
    Skeleton skeleton_;
};

void check_range(double value, double low, double high, const char* name, const char* unit) {
    if (!(value >= low && value <= high)) {
        throw std::invalid_argument(std::string("body: ") + name + ": expected " +
                                    std::to_string(low) + " to " + std::to_string(high) + " " +
                                    unit + ", got " + std::to_string(value));
    }
}

}  // namespace

int Skeleton::index(const std::string& name) const {
    for (int i = 0; i < size(); ++i) {
        if (segments[i].name == name) return i;
    }
    throw std::out_of_range("skeleton: no segment '" + name + "'");
}

Vector3 Skeleton::tip_rest(Hand hand) const {
    return segments[stick_index(hand)].end_rest;
}

bool Skeleton::moves(int ancestor, int segment) const {
    while (segment > ancestor) segment = segments[segment].parent;
    return segment == ancestor;
}

Lengths lengths_of(double h) {
    Lengths l{};
    l.hip_height = kHipHeight * h;
    l.hip_half_width = kHipHalfWidth * h;
    l.lumbar_height = kLumbarHeight * h;
    l.thoracic_height = kThoracicHeight * h;
    l.neck_height = kNeckHeight * h;
    l.shoulder_height = kShoulderHeight * h;
    l.shoulder_half_width = kShoulderHalfWidth * h;
    l.upper_arm = kUpperArmLength * h;
    l.forearm = kForearmLength * h;
    l.hand = kHandLength * h;
    l.thigh = kThighLength * h;
    l.shank = kShankLength * h;
    l.foot = kFootLength * h;
    l.lower_trunk = kLowerTrunkLength * h;
    l.middle_trunk = kMiddleTrunkLength * h;
    l.upper_trunk = kUpperTrunkLength * h;
    l.head = kHeadLength * h;
    return l;
}

Skeleton make_skeleton(const Anthropometry& anthropometry) {
    check_range(anthropometry.stature, 0.5, 2.5, "stature", "m");
    check_range(anthropometry.mass, 10, 300, "mass", "kg");
    if (anthropometry.lengths) {
        const Lengths& l = *anthropometry.lengths;
        for (const double length :
             {l.hip_height, l.hip_half_width, l.lumbar_height, l.thoracic_height, l.neck_height,
              l.shoulder_height, l.shoulder_half_width, l.upper_arm, l.forearm, l.hand, l.thigh,
              l.shank, l.foot, l.lower_trunk, l.middle_trunk, l.upper_trunk, l.head}) {
            check_range(length, 0.001, 3.0, "a measured length", "m");
        }
    }
    check_range(anthropometry.stick.mass, 0.001, 2.0, "stick mass", "kg");
    check_range(anthropometry.stick.length, 0.1, 1.0, "stick length", "m");
    check_range(anthropometry.stick.held_at, 0.0, 0.5 * anthropometry.stick.length, "stick held at",
                "m");
    check_range(anthropometry.stick.tip_radius, 0.001, 0.1, "stick tip radius", "m");
    return Builder(anthropometry).build();
}

}  // namespace percussionist::body
