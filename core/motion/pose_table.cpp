#include "core/motion/pose_table.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace percussionist::motion {

namespace {

constexpr std::size_t kColumns = 9;

void append(std::string& row, double value, int decimals) {
    std::array<char, 400> text{};  // holds any double without an exponent
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, decimals);
    row += row.empty() ? "" : ",";
    row.append(text.data(), end.ptr);
}

std::optional<double> number(std::string_view field) {
    const auto first = field.find_first_not_of(" \t");
    const auto last = field.find_last_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    field = field.substr(first, last - first + 1);
    double value = 0.0;
    const auto end = std::from_chars(field.data(), field.data() + field.size(), value);
    const bool whole = end.ec == std::errc() && end.ptr == field.data() + field.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string to_row(const StationPose& pose) {
    std::string row;
    append(row, pose.time, 6);
    append(row, pose.station, 0);
    for (int i = 0; i < 3; ++i) {
        append(row, pose.pose.position[i], 6);
    }
    const auto& q = pose.pose.orientation;
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) {
        append(row, value, 7);
    }
    return row;
}

std::optional<StationPose> from_row(std::string_view row) {
    std::array<double, kColumns> v{};
    for (std::size_t i = 0; i < kColumns; ++i) {
        const auto comma = row.find(',');
        const bool last = i + 1 == kColumns;
        const auto value = number(row.substr(0, comma));
        if (!value || last != (comma == std::string_view::npos)) {
            return std::nullopt;
        }
        v[i] = *value;
        row.remove_prefix(last ? row.size() : comma + 1);
    }
    const linear::Quaternion q(v[5], v[6], v[7], v[8]);
    if (v[1] < 1 || v[1] > 4 || v[1] != std::floor(v[1]) || std::abs(q.norm() - 1.0) > 0.01) {
        return std::nullopt;
    }
    return StationPose{v[0], static_cast<int>(v[1]), {{v[2], v[3], v[4]}, q.normalized()}};
}

}  // namespace percussionist::motion
