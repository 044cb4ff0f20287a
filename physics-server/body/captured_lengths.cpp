#include "body/captured_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "body/captured_pose.hpp"

namespace percussionist::body {

namespace {

/// The units that motion capture comes in [m]; the last is the CMU's, an inch by 0.45.
constexpr std::array<double, 5> kUnits{1.0, 0.01, 0.001, 0.0254, 0.0254 / 0.45};
constexpr double kUsualStature = 1.7;    // [m]
constexpr double kBodyMassIndex = 24.5;  // [kg/m^2]
/// A length is believed if it is between these shares of what the stature suggests.
constexpr double kShortest = 0.4;
constexpr double kLongest = 2.2;

/// Mean of what is there of both sides.
std::optional<double> both(const CapturedPose& pose, const std::string& from,
                           const std::string& to) {
    double sum = 0.0;
    int count = 0;
    for (const char* side : {"left_", "right_"}) {
        const auto line = pose.line(side + from, side + to);
        if (!line) continue;
        sum += line->norm();
        ++count;
    }
    return count == 0 ? std::nullopt : std::optional(sum / count);
}

std::optional<double> length(const std::optional<Vector3>& line) {
    return line ? std::optional(line->norm()) : std::nullopt;
}

struct Measured {
    std::optional<double> upper_arm, forearm, hand, thigh, shank, foot, trunk, shoulders, hips;
};

/// Bones do not change their length: any frame will do.
Measured measure(const motion::Capture& capture, const SkeletonMatch& match) {
    CapturedPose pose(capture, match);
    pose.take(0);
    Measured m;
    m.upper_arm = both(pose, "upper_arm", "forearm");
    m.forearm = both(pose, "forearm", "hand");
    m.hand = length(pose.to_children("right_hand"));
    m.thigh = both(pose, "thigh", "shank");
    m.shank = both(pose, "shank", "foot");
    m.foot = length(pose.to_children("right_foot"));
    m.trunk = length(pose.line("pelvis", "neck"));
    m.shoulders = length(pose.line("left_upper_arm", "right_upper_arm"));
    m.hips = length(pose.line("left_thigh", "right_thigh"));
    return m;
}

/// In the file's unit: the median of what legs, arms and trunk suggest.
double stature(const Measured& m) {
    const Lengths l = lengths_of(1.0);
    std::vector<double> guesses;
    if (m.thigh && m.shank) guesses.push_back((*m.thigh + *m.shank) / (l.thigh + l.shank));
    if (m.upper_arm && m.forearm) {
        guesses.push_back((*m.upper_arm + *m.forearm) / (l.upper_arm + l.forearm));
    }
    if (m.trunk) guesses.push_back(*m.trunk / (l.neck_height - l.hip_height));
    if (guesses.empty()) return 0.0;
    std::sort(guesses.begin(), guesses.end());
    return guesses[guesses.size() / 2];
}

double find_unit(double raw_stature) {
    return *std::min_element(kUnits.begin(), kUnits.end(), [&](double a, double b) {
        const auto off = [&](double unit) {
            return std::abs(std::log(unit * raw_stature / kUsualStature));
        };
        return off(a) < off(b);
    });
}

}  // namespace

CapturedLengths captured_lengths(const motion::Capture& capture, const SkeletonMatch& match,
                                 double unit) {
    const Measured m = measure(capture, match);
    CapturedLengths out;
    const double raw = stature(m);
    if (!(raw > 0.0)) {
        out.remarks.push_back("no limb has a length; a body of 1.75 m is taken");
        return out;
    }
    out.unit = unit > 0.0 ? unit : find_unit(raw);
    out.person.stature = std::clamp(out.unit * raw, 0.5, 2.5);
    out.person.mass =
        std::clamp(kBodyMassIndex * out.person.stature * out.person.stature, 10.0, 300.0);

    Lengths l = lengths_of(out.person.stature);
    const auto take = [&](double& ours, const std::optional<double>& captured, double share,
                          const char* what) {
        if (!captured) return;
        const double metres = share * out.unit * *captured;
        if (metres > kShortest * ours && metres < kLongest * ours) {
            ours = metres;
        } else {
            out.remarks.push_back(std::string(what) + ": " + std::to_string(metres) +
                                  " m is no body's; taken from the stature");
        }
    };
    const Lengths usual = l;
    take(l.upper_arm, m.upper_arm, 1.0, "upper arm");
    take(l.forearm, m.forearm, 1.0, "forearm");
    take(l.hand, m.hand, 1.0, "hand");
    take(l.thigh, m.thigh, 1.0, "thigh");
    take(l.shank, m.shank, 1.0, "shank");
    take(l.foot, m.foot, 1.0, "foot");
    take(l.shoulder_half_width, m.shoulders, 0.5, "half the width of the shoulders");
    take(l.hip_half_width, m.hips, 0.5, "half the width of the hips");
    double trunk = l.neck_height - l.hip_height;
    take(trunk, m.trunk, 1.0, "trunk");

    // The body is built up from the floor: legs, then the trunk stretched as a whole.
    const double stretch = trunk / (usual.neck_height - usual.hip_height);
    l.hip_height += l.thigh + l.shank - usual.thigh - usual.shank;
    const auto above_hips = [&](double height) {
        return l.hip_height + stretch * (height - usual.hip_height);
    };
    l.lumbar_height = above_hips(usual.lumbar_height);
    l.thoracic_height = above_hips(usual.thoracic_height);
    l.neck_height = above_hips(usual.neck_height);
    l.shoulder_height = above_hips(usual.shoulder_height);
    for (double* part : {&l.lower_trunk, &l.middle_trunk, &l.upper_trunk}) *part *= stretch;
    // The clavicle, from 4 cm off the middle, has to have a length.
    l.shoulder_half_width = std::max(l.shoulder_half_width, 0.08);
    out.person.lengths = l;
    return out;
}

}  // namespace percussionist::body
