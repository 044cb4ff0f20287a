#include "app/bvh_writer.hpp"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

namespace percussionist::app {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Digits that the frame count may take.
constexpr int kCountWidth = 10;

std::string offset(const body::Vector3& v) {
    return fmt::format("OFFSET {:.6f} {:.6f} {:.6f}\n", v.x(), v.y(), v.z());
}

}  // namespace

BvhWriter::BvhWriter(const std::filesystem::path& path, const body::Skeleton& skeleton,
                     double frame_time)
    : path_(path), out_(path, std::ios::binary), skeleton_(skeleton) {
    out_ << "HIERARCHY\n";
    joint(0, 0);
    out_ << "MOTION\nFrames: ";
    count_at_ = out_.tellp();
    out_ << fmt::format("{:<{}}\nFrame Time: {:.9f}\n", 0, kCountWidth, frame_time);
    if (!out_) throw std::runtime_error(path.string() + ": cannot be written");
}

void BvhWriter::joint(int index, int depth) {
    const std::string tab(static_cast<std::size_t>(2 * depth), ' ');
    const body::Segment& s = skeleton_.segments[index];
    order_.push_back(index);
    out_ << tab << (index == 0 ? "ROOT " : "JOINT ") << s.name << '\n' << tab << "{\n" << tab;
    out_ << "  "
         << offset(index == 0 ? s.joint_rest
                              : s.joint_rest - skeleton_.segments[s.parent].joint_rest);
    out_ << tab << "  CHANNELS 3 Zrotation Yrotation Xrotation\n";
    bool leaf = true;
    for (int i = index + 1; i < skeleton_.size(); ++i) {
        if (skeleton_.segments[i].parent != index) continue;
        leaf = false;
        joint(i, depth + 1);
    }
    if (leaf) {
        out_ << tab << "  End Site\n"
             << tab << "  {\n"
             << tab << "    " << offset(s.end_rest - s.joint_rest) << tab << "  }\n";
    }
    out_ << tab << "}\n";
}

void BvhWriter::add(const body::Placement& placement) {
    std::string line;
    for (const int i : order_) {
        const int parent = skeleton_.segments[i].parent;
        const body::Quaternion relative =
            parent < 0 ? placement.orientation[i]
                       : placement.orientation[parent].conjugate() * placement.orientation[i];
        const body::Vector3 angles = kDegrees * body::euler_zyx(relative);
        line += fmt::format("{:.4f} {:.4f} {:.4f} ", angles[0], angles[1], angles[2]);
    }
    line.back() = '\n';
    out_ << line;
    ++frames_;
}

void BvhWriter::finish() {
    out_.seekp(count_at_);
    out_ << fmt::format("{:<{}}", frames_, kCountWidth);
    out_.flush();
    if (!out_) throw std::runtime_error(path_.string() + ": could not be written");
}

}  // namespace percussionist::app
