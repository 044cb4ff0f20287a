#include "body/limits_text.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <vector>

namespace percussionist::body {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

void add(std::string& text, double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, " %.9g", value);
    text += buffer;
}

JointLimits box_of(const std::vector<double>& v) {
    JointLimits limits;
    for (int a = 0; a < 3; ++a) {
        limits.lower_zyx[a] = kDegree * v[2 * a];
        limits.upper_zyx[a] = kDegree * v[2 * a + 1];
    }
    return limits;
}

JointLimits ellipsoid_of(const std::vector<double>& v) {
    JointLimits limits;
    limits.shape = LimitShape::ellipsoid;
    limits.mean = Quaternion(v[0], v[1], v[2], v[3]);
    for (int i = 0; i < 9; ++i) limits.axes(i / 3, i % 3) = v[4 + i];
    limits.semi_axes = kDegree * Vector3(v[13], v[14], v[15]);
    return limits;
}

/// What is wrong with them; empty: nothing.
std::string flaw(const JointLimits& limits) {
    constexpr double kNear = 1e-4;
    if (limits.shape == LimitShape::box) {
        const bool ordered = (limits.lower_zyx.array() <= limits.upper_zyx.array()).all();
        return ordered ? "" : "lower limits not above the upper ones";
    }
    if (std::abs(limits.mean.norm() - 1.0) > kNear) return "a mean of length 1";
    const Matrix3 product = limits.axes.transpose() * limits.axes;
    if (!product.isIdentity(kNear)) return "axes at right angles, of length 1";
    if (!((limits.semi_axes.array() > 0.0).all() &&
          (limits.semi_axes.array() <= std::numbers::pi).all())) {
        return "semi-axes above 0, at most 180 degrees";
    }
    return "";
}

}  // namespace

std::string limits_text(const LimitsBySegment& limits) {
    std::string text = "# Joint limits by segment; degrees. See body/limits_text.hpp.\n";
    for (const auto& [segment, l] : limits) {
        if (l.shape == LimitShape::free) continue;
        text += segment;
        if (l.shape == LimitShape::box) {
            text += " euler";
            for (int a = 0; a < 3; ++a) {
                add(text, l.lower_zyx[a] / kDegree);
                add(text, l.upper_zyx[a] / kDegree);
            }
        } else {
            text += " quaternion";
            for (const double c : {l.mean.w(), l.mean.x(), l.mean.y(), l.mean.z()}) add(text, c);
            for (int i = 0; i < 9; ++i) add(text, l.axes(i / 3, i % 3));
            for (int a = 0; a < 3; ++a) add(text, l.semi_axes[a] / kDegree);
        }
        text += '\n';
    }
    return text;
}

LimitsBySegment parse_limits(std::string_view text, std::string_view name) {
    LimitsBySegment all;
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        std::string segment;
        std::string kind;
        if (!(words >> segment)) continue;
        words >> kind;
        const auto fail = [&](const std::string& expected) {
            throw LimitsError(std::string(name) + ": line " + std::to_string(number) +
                              ": expected " + expected + ", got '" + line + "'");
        };
        std::vector<double> values;
        for (double v = 0.0; words >> v;) values.push_back(v);
        const bool box = kind == "euler";
        if (!box && kind != "quaternion") fail("'SEGMENT euler' or 'SEGMENT quaternion'");
        const std::size_t count = box ? 6 : 16;
        if (values.size() != count || !words.eof()) {
            fail(std::to_string(count) + " numbers after " + kind);
        }
        JointLimits limits = box ? box_of(values) : ellipsoid_of(values);
        const std::string wrong = flaw(limits);
        if (!wrong.empty()) fail(wrong);
        limits.mean.normalize();
        all[segment] = limits;
    }
    return all;
}

}  // namespace percussionist::body
