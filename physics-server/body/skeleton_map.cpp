#include "body/skeleton_map.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "body/ready_skeleton_maps.hpp"

namespace percussionist::body {

namespace {

constexpr std::array<std::string_view, 21> kSegments{
    "pelvis",        "abdomen",        "chest",        "neck",           "head",
    "left_clavicle", "left_upper_arm", "left_forearm", "left_hand",      "left_stick",
    "left_thigh",    "left_shank",     "left_foot",    "right_clavicle", "right_upper_arm",
    "right_forearm", "right_hand",     "right_stick",  "right_thigh",    "right_shank",
    "right_foot"};

/// Small letters and digits only, from after the last colon.
std::string plain(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    if (colon != std::string_view::npos) name.remove_prefix(colon + 1);
    std::string out;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) out += static_cast<char>(std::tolower(byte));
    }
    return out;
}

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view take_until(std::string_view& text, char end) {
    const std::size_t at = text.find(end);
    const std::string_view part = text.substr(0, at);
    text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
    return part;
}

/// What all names have before the root's own: "bip01" of "Bip01 Pelvis".
std::string common_prefix(const std::vector<std::string>& names,
                          const std::vector<std::string>& roots) {
    for (const std::string& name : names) {
        for (const std::string& candidate : roots) {
            const std::string root = plain(candidate);
            if (!name.ends_with(root) || name.size() == root.size()) continue;
            std::string prefix = name.substr(0, name.size() - root.size());
            const auto sharing = std::count_if(
                names.begin(), names.end(), [&](const auto& n) { return n.starts_with(prefix); });
            if (2 * sharing > static_cast<std::ptrdiff_t>(names.size())) return prefix;
        }
    }
    return {};
}

}  // namespace

SkeletonMap parse_skeleton_map(std::string_view text, std::string_view name) {
    SkeletonMap map;
    map.name = name;
    int number = 0;
    while (!text.empty()) {
        std::string_view line = take_until(text, '\n');
        ++number;
        const std::string shown(trim(line));
        line = trim(take_until(line, '#'));
        if (line.empty()) continue;
        const auto fail = [&](const std::string& expected) {
            throw MapError(std::string(name) + ": line " + std::to_string(number) + ": expected " +
                           expected + ", got '" + shown + "'");
        };
        if (line.find(':') == std::string_view::npos) fail("'segment: joint, joint'");
        const std::string segment(trim(take_until(line, ':')));
        if (std::find(kSegments.begin(), kSegments.end(), segment) == kSegments.end()) {
            fail(
                "a segment of the body (pelvis, abdomen, chest, neck, head; left_ or right_ "
                "clavicle, upper_arm, forearm, hand, stick, thigh, shank, foot)");
        }
        std::vector<std::string>& names = map.names[segment];
        while (!line.empty()) {
            const std::string joint(trim(take_until(line, ',')));
            if (!joint.empty()) names.push_back(joint);
        }
        if (names.empty()) fail("names of joints after the colon");
    }
    if (map.names.empty()) throw MapError(std::string(name) + ": expected a line a segment");
    return map;
}

const std::vector<SkeletonMap>& ready_skeleton_maps() {
    static const std::vector<SkeletonMap> maps = [] {
        std::vector<SkeletonMap> all;
        for (const auto& [name, text] : kReadySkeletonMaps) {
            all.push_back(parse_skeleton_map(text, name));
        }
        return all;
    }();
    return maps;
}

SkeletonMatch match(const motion::Capture& capture, const SkeletonMap& map) {
    std::vector<std::string> names;
    for (const motion::CapturedJoint& joint : capture.joints) names.push_back(plain(joint.name));
    const auto roots = map.names.find("pelvis");
    const std::string prefix =
        roots == map.names.end() ? std::string() : common_prefix(names, roots->second);
    SkeletonMatch found;
    found.map = map.name;
    for (const auto& [segment, candidates] : map.names) {
        for (const std::string& candidate : candidates) {
            const std::string wanted = plain(candidate);
            const auto at = std::find_if(names.begin(), names.end(), [&](const auto& name) {
                return name == wanted || name == prefix + wanted;
            });
            if (at == names.end()) continue;
            const auto index = static_cast<int>(at - names.begin());
            if (capture.joints[index].end) continue;
            found.joints[segment] = index;
            break;
        }
    }
    return found;
}

SkeletonMatch match_best(const motion::Capture& capture) {
    SkeletonMatch best;
    for (const SkeletonMap& map : ready_skeleton_maps()) {
        SkeletonMatch found = match(capture, map);
        if (best.map.empty() || found.joints.size() > best.joints.size()) best = std::move(found);
    }
    return best;
}

}  // namespace percussionist::body
