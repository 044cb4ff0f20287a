#include "app/clip_loader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "body/limits_from_motion.hpp"
#include "body/retarget.hpp"
#include "body/stick_motion.hpp"
#include "files/bvh_file.hpp"
#include "files/text_lines.hpp"
#include "files/trajectory_file.hpp"

namespace percussionist::app {

namespace {

namespace fs = std::filesystem;

std::string small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

body::SkeletonMatch find_match(const motion::Capture& capture, const std::string& map) {
    if (map.empty()) return body::match_best(capture);
    std::string names;
    for (const body::SkeletonMap& ready : body::ready_skeleton_maps()) {
        if (ready.name == map) return body::match(capture, ready);
        names += ready.name + " ";
    }
    if (!fs::exists(map)) {
        throw std::runtime_error(map + ": expected a file, or one of the ready maps: " + names);
    }
    constexpr std::uintmax_t kMost = 1U << 20U;
    const std::string text = files::read_text<std::runtime_error>(map, kMost);
    return body::match(capture, body::parse_skeleton_map(text, map));
}

void report_match(const motion::Capture& capture, const body::SkeletonMatch& match,
                  const body::Skeleton& skeleton, std::vector<std::string>& report) {
    std::string missing;
    int matched = 0;
    for (const body::Segment& s : skeleton.segments) {
        const auto found = match.joints.find(s.name);
        if (found != match.joints.end()) {
            ++matched;
            report.push_back(
                fmt::format("  {:<16} {}", s.name, capture.joints[found->second].name));
        } else {
            missing += " " + s.name;
        }
    }
    report.insert(report.end() - matched,
                  fmt::format("skeleton: map '{}' matches {} of {} segments", match.map, matched,
                              skeleton.size()));
    if (matched == 0) {
        report.push_back(
            "  NOTHING MATCHED: the body stays at rest. Write a map (--map FILE); the "
            "file's joints are:");
        std::string names = "   ";
        for (const auto& joint : capture.joints) {
            if (!joint.end) names += " " + joint.name;
        }
        report.push_back(names);
    } else if (!missing.empty()) {
        report.push_back("  not captured, at rest:" + missing);
    }
}

LoadedClip load_bvh(const ClipOptions& options) {
    const motion::Capture capture = files::read_bvh_file(options.files.front());
    LoadedClip out;
    const body::SkeletonMatch match = find_match(capture, options.map);
    body::RetargetOptions retargeting;
    retargeting.unit = options.unit;
    retargeting.mass = options.mass;
    body::RetargetedMotion motion = body::retarget(capture, match, retargeting);
    out.person = motion.person;
    out.skeleton = body::make_skeleton(out.person);
    out.report.push_back(fmt::format("{}: {} frames at {:.4g} Hz", capture.name, capture.frames(),
                                     1.0 / capture.frame_time));
    report_match(capture, match, out.skeleton, out.report);
    out.report.push_back(
        fmt::format("body: stature {:.3f} m, mass {:.1f} kg; a unit of the file is {:.5g} m",
                    out.person.stature, out.person.mass, motion.unit));
    for (const std::string& warning : capture.warnings) out.report.push_back(warning);
    for (const std::string& remark : motion.remarks) out.report.push_back(remark);
    const std::string repairs = motion.repairs.describe();
    if (!repairs.empty()) out.report.push_back("mended: " + repairs);
    out.postures = std::move(motion.postures);
    out.clip =
        std::make_shared<body::Clip>(capture.name, out.skeleton, out.postures, motion.frame_time);
    return out;
}

int hand_of(const ClipOptions& options, const fs::path& file) {
    const std::string name = small_letters(options.hand + " " + file.stem().string());
    const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
    if (!options.hand.empty()) return options.hand == "left" ? 0 : 1;
    return has("left") || name.ends_with("_l") || name.ends_with("-l") ? 0 : 1;
}

LoadedClip load_csv(const ClipOptions& options) {
    files::TrajectoryOptions reading;
    reading.rate = options.rate;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, options.tip_offset.size()); ++i) {
        reading.tip_offset[static_cast<int>(i)] = options.tip_offset[i];
    }
    LoadedClip out;
    std::array<std::optional<motion::Trajectory>, 2> paths;
    for (std::size_t i = 0; i < options.files.size(); ++i) {
        auto read = files::read_trajectory_file(options.files[i], reading);
        int hand =
            options.files.size() == 2 ? static_cast<int>(i) : hand_of(options, options.files[i]);
        if (read.size() == 2) hand = 0;
        for (motion::Trajectory& path : read) {
            out.report.push_back(fmt::format("{}: {} samples in {:.3f} s, the {} stick", path.name,
                                             path.samples.size(), path.samples.back().time,
                                             hand == 0 ? "left" : "right"));
            for (const std::string& warning : path.warnings) out.report.push_back(warning);
            paths[std::min(hand++, 1)] = std::move(path);
        }
    }
    out.person = options.person;
    if (options.mass > 0.0) out.person.mass = options.mass;
    out.skeleton = body::make_skeleton(out.person);
    body::StickMotion motion = body::follow_sticks(options.files.front().filename().string(),
                                                   out.skeleton, std::move(paths));
    for (const std::string& remark : motion.remarks) out.report.push_back(remark);
    out.report.push_back(fmt::format(
        "body: {:.2f} m, {:.0f} kg; its tips can be brought within {:.2f} mm of those recorded; "
        "there is no captured posture: \"captured\" joints are those of inverse kinematics",
        out.person.stature, out.person.mass, 1e3 * motion.worst_reach));
    out.clip = motion.clip;
    return out;
}

bool is_csv(const fs::path& file) {
    const std::string extension = small_letters(file.extension().string());
    return extension == ".csv" || extension == ".txt" || extension == ".tsv";
}

}  // namespace

std::vector<body::Quaternion> rotations_of(const std::vector<body::Posture>& postures, int joint) {
    std::vector<body::Quaternion> all;
    for (const body::Posture& posture : postures) all.push_back(posture.joints[joint]);
    return all;
}

LoadedClip load_clip(const ClipOptions& options) {
    if (options.files.empty() || options.files.size() > 2) {
        throw std::invalid_argument("clip: expected one file, or two of sticks (left, right)");
    }
    const bool csv = is_csv(options.files.front());
    if (options.files.size() == 2 && !csv) {
        throw std::invalid_argument("clip: two files are a left and a right stick, as CSV");
    }
    LoadedClip out = csv ? load_csv(options) : load_bvh(options);
    if (options.wide_limits) {
        for (int i = 1; i < out.skeleton.size() && !out.postures.empty(); ++i) {
            body::JointLimits& limits = out.skeleton.segments[i].limits;
            limits = body::widened(limits, rotations_of(out.postures, i));
        }
    }
    return out;
}

}  // namespace percussionist::app
