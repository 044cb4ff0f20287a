#include "body/retarget.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "body/captured_lengths.hpp"
#include "body/captured_pose.hpp"

namespace percussionist::body {

namespace {

using Line = std::optional<Vector3>;

Line unit(const Line& v) {
    return v ? Line(v->normalized()) : v;
}

Line across(const Line& a, const Line& b) {
    if (!a || !b) return std::nullopt;
    return a->cross(*b);
}

/// The bone and the line across it that a segment has in one frame; the second weighs by its
/// length.
struct Anatomy {
    Line bone, lateral;
};

/// The same at rest in our body.
struct RestAnatomy {
    Vector3 bone, lateral;
};

std::string side_of(const std::string& segment) {
    if (segment.starts_with("left_")) return "left_";
    return segment.starts_with("right_") ? "right_" : "";
}

RestAnatomy rest_anatomy(const std::string& segment) {
    const std::string side = side_of(segment);
    const std::string part = segment.substr(side.size());
    const Vector3 x = Vector3::UnitX();
    const Vector3 y = Vector3::UnitY();
    const Vector3 z = Vector3::UnitZ();
    // An elbow bends about -y, which bone and next bone span; a knee about y.
    if (part == "upper_arm") return {-z, -y};
    if (part == "forearm" || part == "hand" || part == "stick") return {x, -y};
    if (part == "clavicle") return {side == "left_" ? y : Vector3(-y), z};
    if (part == "thigh" || part == "shank") return {-z, y};
    if (part == "foot") return {x, y};
    return {z, y};
}

/// Up, in the file's axes: the axis nearest to where the trunk points on average.
Vector3 find_up(CapturedPose& pose, std::size_t frames) {
    constexpr std::size_t kLooks = 200;
    Vector3 sum = Vector3::Zero();
    for (std::size_t f = 0; f < frames; f += std::max<std::size_t>(1, frames / kLooks)) {
        pose.take(f);
        for (const char* above : {"head", "neck", "chest", "abdomen"}) {
            const Line trunk = pose.line("pelvis", above);
            if (!trunk) continue;
            sum += trunk->normalized();
            break;
        }
        for (const char* below : {"left_foot", "right_foot"}) {
            const Line leg = pose.line("pelvis", below);
            if (leg) sum -= 0.5 * leg->normalized();
        }
    }
    int axis = 1;
    if (sum.cwiseAbs().maxCoeff(&axis) < 1e-6) return Vector3::UnitY();
    return Vector3::Unit(axis) * (sum[axis] < 0.0 ? -1.0 : 1.0);
}

class Anatomist {
  public:
    Anatomist(const CapturedPose& pose, Vector3 up) : pose_(pose), up_(std::move(up)) {}

    [[nodiscard]] Anatomy of(const std::string& segment) const {
        const std::string side = side_of(segment);
        const std::string part = segment.substr(side.size());
        if (part == "pelvis") return {up_, hips()};
        if (part == "abdomen") return {or_up(pose_.line("abdomen", "chest")), hips()};
        if (part == "chest") return {spine(), shoulders()};
        if (part == "head") return {spine(), shoulders()};
        if (part == "clavicle") return {pose_.line(segment, side + "upper_arm"), spine()};
        if (part == "upper_arm") return {upper_arm(side), elbow_axis(side)};
        if (part == "forearm") return {forearm(side), elbow_axis(side)};
        if (part == "hand" || part == "stick") return hand(segment, side);
        if (part == "thigh") return {thigh(side), knee_axis(side)};
        if (part == "shank") return {shank(side), knee_axis(side)};
        return foot(segment, side);
    }

    /// The lateral line to take where a limb never bends.
    [[nodiscard]] Line straight_lateral(const std::string& segment, const Vector3& bone) const {
        const RestAnatomy rest = rest_anatomy(segment);
        const bool arm = segment.find("arm") != std::string::npos ||
                         segment.find("hand") != std::string::npos ||
                         segment.find("stick") != std::string::npos;
        const Line left = arm ? shoulders() : hips();
        if (!left) return std::nullopt;
        // A limb that hangs down has it to the left or right; from there it swings to where it is.
        const Vector3 hanging = (rest.lateral.y() > 0.0 ? 1.0 : -1.0) * left->normalized();
        const Vector3 down = -or_up(spine());
        return Quaternion::FromTwoVectors(down, bone) * hanging;
    }

  private:
    [[nodiscard]] Vector3 or_up(const Line& line) const { return line ? line->normalized() : up_; }
    [[nodiscard]] Line hips() const {
        const Line line = pose_.line("right_thigh", "left_thigh");
        return unit(line ? line : pose_.line("right_upper_arm", "left_upper_arm"));
    }
    [[nodiscard]] Line shoulders() const {
        const Line line = pose_.line("right_upper_arm", "left_upper_arm");
        return line ? unit(line) : hips();
    }
    [[nodiscard]] Vector3 spine() const {
        const Line chest = pose_.line("chest", "neck");
        if (chest) return chest->normalized();
        const Line trunk = pose_.line("pelvis", "neck");
        return or_up(trunk ? trunk : pose_.line("pelvis", "chest"));
    }
    [[nodiscard]] Line upper_arm(const std::string& side) const {
        return unit(pose_.line(side + "upper_arm", side + "forearm"));
    }
    [[nodiscard]] Line forearm(const std::string& side) const {
        const Line line = pose_.line(side + "forearm", side + "hand");
        return unit(line ? line : pose_.to_children(side + "forearm"));
    }
    [[nodiscard]] Line elbow_axis(const std::string& side) const {
        return across(upper_arm(side), forearm(side));
    }
    [[nodiscard]] Anatomy hand(const std::string& segment, const std::string& side) const {
        const Line fingers = unit(pose_.to_children(segment));
        return {fingers ? fingers : forearm(side), elbow_axis(side)};
    }
    [[nodiscard]] Line thigh(const std::string& side) const {
        return unit(pose_.line(side + "thigh", side + "shank"));
    }
    [[nodiscard]] Line shank(const std::string& side) const {
        const Line line = pose_.line(side + "shank", side + "foot");
        return unit(line ? line : pose_.to_children(side + "shank"));
    }
    [[nodiscard]] Line knee_axis(const std::string& side) const {
        return across(thigh(side), shank(side));
    }
    [[nodiscard]] Anatomy foot(const std::string& segment, const std::string& side) const {
        const Line toes = unit(pose_.to_children(segment));
        if (toes) return {toes, hips()};
        return {across(hips(), Vector3(-or_up(shank(side)))), hips()};
    }

    const CapturedPose& pose_;
    Vector3 up_;
};

/// Columns: the bone, the lateral line made orthogonal to it, and the third. Nothing if the two are
/// one.
std::optional<Matrix3> frame(const Vector3& bone, const Vector3& lateral) {
    const Vector3 b = bone.normalized();
    const Vector3 l = lateral - lateral.dot(b) * b;
    if (!(l.norm() > 1e-3 * lateral.norm()) || !(lateral.norm() > 0.0)) return std::nullopt;
    Matrix3 m;
    m << b, l.normalized(), b.cross(l.normalized());
    return m;
}

/// A segment of ours that a captured joint moves, and the constant turn between the two.
struct Link {
    std::string segment;
    int ours = 0, joint = 0;
    Vector3 bone = Vector3::Zero(), lateral = Vector3::Zero(), straight = Vector3::Zero();
    Quaternion turn = Quaternion::Identity();

    /// Adds one frame's anatomy, as seen from the captured joint.
    void look(const Anatomist& anatomist, const Quaternion& captured) {
        const Anatomy a = anatomist.of(segment);
        if (!a.bone) return;
        bone += captured.conjugate() * *a.bone;
        // Large bends say more about the axis than small ones.
        if (a.lateral) lateral += captured.conjugate() * (*a.lateral * a.lateral->norm());
        const Line s = anatomist.straight_lateral(segment, *a.bone);
        if (s) straight += captured.conjugate() * *s;
    }

    bool settle(std::size_t looks) {
        constexpr double kFew = 0.02;  // an elbow bent by 8 degrees throughout
        const bool bends = lateral.norm() > kFew * static_cast<double>(looks);
        const auto captured = frame(bone, bends ? lateral : straight);
        if (!captured) return false;
        const RestAnatomy rest = rest_anatomy(segment);
        turn = Quaternion(*captured * frame(rest.bone, rest.lateral)->transpose());
        return true;
    }
};

std::vector<Link> make_links(const motion::Capture& capture, const SkeletonMatch& match,
                             const Skeleton& skeleton, CapturedPose& pose,
                             std::vector<std::string>& remarks) {
    const std::size_t frames = capture.frames();
    const Anatomist anatomist(pose, find_up(pose, frames));
    std::vector<Link> links;
    for (int i = 0; i < skeleton.size(); ++i) {
        const auto found = match.joints.find(skeleton.segments[i].name);
        if (found == match.joints.end()) continue;
        Link link;
        link.segment = found->first;
        link.ours = i;
        link.joint = found->second;
        links.push_back(link);
    }
    constexpr std::size_t kLooks = 1000;
    const std::size_t stride = std::max<std::size_t>(1, frames / kLooks);
    std::size_t looks = 0;
    for (std::size_t f = 0; f < frames; f += stride, ++looks) {
        pose.take(f);
        for (Link& link : links) link.look(anatomist, pose.turn(link.joint));
    }
    std::vector<Link> settled;
    for (Link& link : links) {
        if (link.settle(looks)) {
            settled.push_back(link);
        } else {
            remarks.push_back(link.segment + ": no direction to be had; it stays at rest");
        }
    }
    return settled;
}

}  // namespace

RetargetedMotion retarget(const motion::Capture& capture, const SkeletonMatch& match,
                          const RetargetOptions& options) {
    if (capture.frames() == 0) throw std::invalid_argument(capture.name + ": no frame");
    RetargetedMotion out;
    out.frame_time = capture.frame_time;
    CapturedPose pose(capture, match);
    const CapturedLengths lengths = captured_lengths(capture, match, options.unit);
    out.person = lengths.person;
    out.unit = lengths.unit;
    out.remarks = lengths.remarks;
    out.person.stick = options.stick;
    if (options.mass > 0.0) out.person.mass = options.mass;

    const Skeleton skeleton = make_skeleton(out.person);
    const std::vector<Link> links = make_links(capture, match, skeleton, pose, out.remarks);
    const std::size_t joints = skeleton.segments.size();
    std::vector<Quaternion> relative;
    relative.reserve(capture.frames() * joints);
    std::vector<Quaternion> turned(joints);
    for (std::size_t f = 0; f < capture.frames(); ++f) {
        pose.take(f);
        for (Quaternion& q : turned) q = Quaternion::Identity();
        std::vector<bool> known(joints, false);
        for (const Link& link : links) {
            turned[link.ours] = pose.turn(link.joint) * link.turn;
            known[link.ours] = true;
        }
        // What was not captured goes with its parent; all is seen from the pelvis.
        const Quaternion pelvis = turned[0];
        for (int i = 0; i < skeleton.size(); ++i) {
            const int parent = skeleton.segments[i].parent;
            if (parent < 0) {
                turned[i] = Quaternion::Identity();
                relative.push_back(Quaternion::Identity());
                continue;
            }
            turned[i] = known[i] ? Quaternion(pelvis.conjugate() * turned[i]) : turned[parent];
            relative.push_back((turned[parent].conjugate() * turned[i]).normalized());
        }
    }
    out.repairs = repair_rotations(relative, joints, out.frame_time);
    for (std::size_t f = 0; f < relative.size() / joints; ++f) {
        Posture posture(skeleton);
        std::copy_n(relative.begin() + static_cast<std::ptrdiff_t>(f * joints), joints,
                    posture.joints.begin());
        out.postures.push_back(std::move(posture));
    }
    return out;
}

}  // namespace percussionist::body
