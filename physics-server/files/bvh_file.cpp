#include "files/bvh_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "files/bvh_hierarchy.hpp"

namespace percussionist::files {

namespace {

constexpr std::uintmax_t kMostBytes = 512U << 20U;
/// Rotations that are held at most: ten minutes of 60 joints at 250 Hz are half of it.
constexpr std::size_t kMostRotations = 20'000'000;
constexpr double kDegree = std::numbers::pi / 180.0;
/// Frames last from a millisecond to ten seconds.
constexpr double kShortestFrame = 1e-3;
constexpr double kLongestFrame = 10.0;

class MotionReader {
  public:
    MotionReader(LineReader& lines, std::string_view name, const BvhHierarchy& tree)
        : lines_(lines), name_(name), tree_(tree) {}

    motion::Capture read() {
        const double frames = header("Frames");
        if (!(frames >= 0.0) || frames != std::floor(frames)) {
            fail("a whole number of frames", in_quotes(line_));
        }
        capture_.frame_time = header("Frame Time");
        if (!(capture_.frame_time >= kShortestFrame && capture_.frame_time <= kLongestFrame)) {
            fail("a frame time of 0.001 to 10 s", in_quotes(line_));
        }
        read_values();
        const auto read = static_cast<double>(values_.size() / tree_.channel_count);
        if (read != frames) {
            constexpr double kManyFrames = 1e12;
            warn("the header promises " +
                 std::to_string(static_cast<long long>(std::min(frames, kManyFrames))) +
                 " frames, " + std::to_string(static_cast<long long>(read)) + " are there");
        }
        if (values_.empty()) fail("a frame of numbers", "the end of the file");
        bridge();
        to_rotations();
        return std::move(capture_);
    }

  private:
    [[noreturn]] void fail(const std::string& expected, const std::string& got) const {
        throw_bvh_error(name_, lines_.number(), expected, got);
    }
    void warn(const std::string& what) {
        capture_.warnings.push_back(std::string(name_) + ": " + what);
    }

    bool next_line() {
        do {
            const auto line = lines_.next();
            if (!line) return false;
            line_ = trimmed(*line);
        } while (line_.empty());
        return true;
    }

    /// The number on a line "Frames: 3" or "Frame Time: 0.01".
    double header(std::string_view title) {
        if (!next_line()) fail("'" + std::string(title) + ":'", "the end of the file");
        const std::size_t colon = line_.find(':');
        if (colon == std::string_view::npos || !same_word(trimmed(line_.substr(0, colon)), title)) {
            fail("'" + std::string(title) + ": NUMBER'", in_quotes(line_));
        }
        const auto value = number_in(trimmed(line_.substr(colon + 1)));
        if (!value || !std::isfinite(*value)) {
            fail("'" + std::string(title) + ": NUMBER'", in_quotes(line_));
        }
        return *value;
    }

    void read_values() {
        std::vector<std::string_view> words;
        while (next_line()) {
            split(line_, " \t,;", words);
            const int line = lines_.number();
            if (words.size() != tree_.channel_count) {
                const bool cut = words.size() < tree_.channel_count && !next_line();
                if (!cut) {
                    throw_bvh_error(name_, line,
                                    std::to_string(tree_.channel_count) + " numbers, one a channel",
                                    std::to_string(words.size()));
                }
                warn("line " + std::to_string(line) + ": the last frame is cut and left out");
                return;
            }
            for (const std::string_view word : words) {
                const auto value = number_in(word);
                if (!value) throw_bvh_error(name_, line, "a number", in_quotes(word));
                values_.push_back(*value);
            }
            if (values_.size() / tree_.channel_count * tree_.joints.size() > kMostRotations) {
                fail("at most " + std::to_string(kMostRotations) + " rotations", "more");
            }
        }
    }

    /// What is no number takes the last value of its channel, or the first that is one.
    void bridge() {
        const std::size_t count = tree_.channel_count;
        std::size_t bridged = 0;
        for (std::size_t c = 0; c < count; ++c) {
            double last = 0.0;
            for (std::size_t i = c; i < values_.size(); i += count) {
                if (!std::isfinite(values_[i])) continue;
                last = values_[i];
                break;
            }
            for (std::size_t i = c; i < values_.size(); i += count) {
                if (std::isfinite(values_[i])) {
                    last = values_[i];
                } else {
                    values_[i] = last;
                    ++bridged;
                }
            }
        }
        if (bridged > 0) {
            warn(std::to_string(bridged) + " values are no numbers; bridged from the frame before");
        }
    }

    void to_rotations() {
        capture_.joints = tree_.joints;
        const std::size_t joints = tree_.joints.size();
        const std::size_t frames = values_.size() / tree_.channel_count;
        capture_.rotations.assign(frames * joints, linear::Quaternion::Identity());
        std::vector<linear::Vector3> moved(joints, linear::Vector3::Zero());
        const double* value = values_.data();
        for (std::size_t f = 0; f < frames; ++f) {
            for (std::size_t j = 0; j < joints; ++j) {
                linear::Quaternion& q = capture_.rotations[f * joints + j];
                for (const BvhChannel& channel : tree_.channels[j]) {
                    const linear::Vector3 axis = linear::Vector3::Unit(channel.axis);
                    if (channel.rotation) {
                        // Whole turns are taken out first: an angle of 1e9 degrees stays one.
                        const double angle = kDegree * std::remainder(*value, 360.0);
                        q = q * linear::Quaternion(Eigen::AngleAxisd(angle, axis));
                    } else {
                        moved[j] += *value * axis / static_cast<double>(frames);
                    }
                    ++value;
                }
            }
        }
        // Position channels below the root replace the offset, unless they are not used.
        for (std::size_t j = 0; j < joints; ++j) {
            const bool used = moved[j].norm() > 1e-9 && moved[j].allFinite();
            if (tree_.joints[j].parent >= 0 && used) capture_.joints[j].offset = moved[j];
        }
    }

    LineReader& lines_;
    std::string_view name_;
    const BvhHierarchy& tree_;
    std::string_view line_;
    std::vector<double> values_;
    motion::Capture capture_;
};

}  // namespace

motion::Capture parse_bvh(std::string_view text, std::string_view name) {
    LineReader lines(text);
    const BvhHierarchy tree = read_bvh_hierarchy(lines, name);
    motion::Capture capture = MotionReader(lines, name, tree).read();
    capture.name = name;
    return capture;
}

motion::Capture read_bvh_file(const std::filesystem::path& path) {
    return parse_bvh(read_text<BvhError>(path, kMostBytes), path.filename().string());
}

}  // namespace percussionist::files
