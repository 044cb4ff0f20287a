// Charts as SVG text: axes, straight or logarithmic, lines, points and stems.
//
//     Chart chart{.title = "Decays", .x = {"Hz", 50, 5000, true}, .y = {"s", 0, 2}};
//     chart.series.push_back({.name = "found", .kind = Series::Kind::points, .points =
//     {{100, 1.5}}}); write_svg("decays.svg", {chart});
//
// The same charts give the same bytes. What lies outside an axis, or is no number, is left out.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace percussionist::files {

struct Axis {
    std::string title;
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
};

struct Series {
    enum class Kind { line, points, stems };
    std::string name;
    Kind kind = Kind::line;
    std::string colour = "#305070";
    std::vector<std::pair<double, double>> points;
};

struct Chart {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
};

/// The charts below each other.
std::string svg(std::span<const Chart> charts);

/// Throws std::runtime_error naming the file.
void write_svg(const std::filesystem::path& path, std::span<const Chart> charts);

}  // namespace percussionist::files
