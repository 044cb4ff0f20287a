// Charts as SVG pictures: lines and points over an axis, several charts one below the other.
//
// Plain text out; no library. The axes choose round numbers. Values that are not finite are gaps.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace percussionist::files {

struct PlotLine {
    std::string name;           ///< in the legend; empty: not in it
    std::vector<double> x, y;
    std::string colour = "black";  ///< as SVG knows it
    double width = 1.5;            ///< of the line; 0: points alone
};

struct Plot {
    std::string title, x_label, y_label;
    std::vector<PlotLine> lines;
    bool same_scale = false;  ///< x and y drawn in the same scale
};

/// The plots below each other, each `width` by `height` pixels.
std::string plot_svg(const std::vector<Plot>& plots, int width = 900, int height = 300);

/// Throws std::runtime_error naming the file that cannot be written.
void write_plot(const std::filesystem::path& path, const std::vector<Plot>& plots,
                int width = 900, int height = 300);

}  // namespace percussionist::files
