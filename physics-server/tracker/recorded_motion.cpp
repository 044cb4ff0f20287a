#include "tracker/recorded_motion.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "core/motion/pose_table.hpp"

namespace percussionist::tracker {

namespace {

using motion::Pose;
using motion::StationPose;
using Tracks = std::array<std::vector<StationPose>, motion::kFastrakStations>;

[[noreturn]] void fail(const std::string& name, std::size_t line, const std::string& what) {
    throw std::runtime_error(name + ", line " + std::to_string(line) + ": " + what);
}

Tracks read_tracks(std::istream& stream, const std::string& name) {
    Tracks tracks;
    std::string row;
    for (std::size_t line = 1; std::getline(stream, row); ++line) {
        if (line == 1 && row.starts_with("time")) {
            continue;
        }
        const auto pose = motion::from_row(row);
        if (!pose) {
            fail(name, line, "expected \"" + std::string(motion::kPoseTableHeader) + "\"");
        }
        auto& track = tracks[static_cast<std::size_t>(pose->station - 1)];
        if (!track.empty() && !(track.back().time < pose->time)) {
            fail(name, line, "expected a later time than before");
        }
        track.push_back(*pose);
    }
    return tracks;
}

Pose pose_at(const std::vector<StationPose>& track, double time) {
    if (track.empty()) {
        return {.position = {0.3, 0.0, 0.0}, .orientation = motion::Quaternion::Identity()};
    }
    const auto next = std::upper_bound(track.begin(), track.end(), time,
                                       [](double t, const StationPose& p) { return t < p.time; });
    if (next == track.begin() || next == track.end()) {
        return next == track.begin() ? track.front().pose : track.back().pose;
    }
    const StationPose& before = *(next - 1);
    return interpolate(before.pose, next->pose, (time - before.time) / (next->time - before.time));
}

}  // namespace

Recording read_recording(std::istream& stream, const std::string& name) {
    const auto tracks = std::make_shared<const Tracks>(read_tracks(stream, name));
    Recording recording;
    double start = 0.0, end = 0.0;
    bool any = false;
    for (std::size_t i = 0; i < tracks->size(); ++i) {
        const auto& track = (*tracks)[i];
        if (!track.empty()) {
            start = any ? std::min(start, track.front().time) : track.front().time;
            end = any ? std::max(end, track.back().time) : track.back().time;
            recording.receivers = static_cast<int>(i) + 1;
            any = true;
        }
    }
    if (!any) {
        fail(name, 1, "expected poses, found none");
    }
    recording.duration = std::max(end - start, 1e-3);
    recording.motion = [tracks, start, duration = recording.duration](int station, double time) {
        const double within = time - duration * std::floor(time / duration);
        return pose_at((*tracks)[static_cast<std::size_t>(station - 1)], start + within);
    };
    return recording;
}

Recording read_recording(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw std::runtime_error(path + ": cannot be opened");
    }
    return read_recording(file, path);
}

}  // namespace percussionist::tracker
