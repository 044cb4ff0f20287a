#include "files/plot.hpp"
#include "files/text_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

namespace percussionist::files {

namespace {

constexpr double kWidth = 960, kHeight = 320;
constexpr double kLeft = 70, kRight = 20, kTop = 36, kBottom = 46;

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return out;
}

/// 0 to 1 along an axis; none outside.
std::optional<double> along(const Axis& axis, double value) {
    const auto scaled = [&](double x) { return axis.logarithmic ? std::log(x) : x; };
    const double share =
        (scaled(value) - scaled(axis.low)) / (scaled(axis.high) - scaled(axis.low));
    return share >= 0.0 && share <= 1.0 ? std::optional(share) : std::nullopt;
}

/// Where numbers stand: 1, 2 and 5 in each decade, or some ten steps of such a size.
std::vector<double> ticks(const Axis& axis) {
    std::vector<double> values;
    if (axis.logarithmic) {
        for (double decade = std::pow(10, std::floor(std::log10(axis.low))); decade <= axis.high;
             decade *= 10) {
            for (const double step : {1.0, 2.0, 5.0}) {
                values.push_back(step * decade);
            }
        }
        return values;
    }
    const double rough = (axis.high - axis.low) / 8;
    double step = std::pow(10, std::floor(std::log10(rough)));
    step *= rough / step > 5 ? 10 : rough / step > 2 ? 5 : rough / step > 1 ? 2 : 1;
    for (double n = std::ceil(axis.low / step); n * step <= axis.high + 1e-9 * step; ++n) {
        values.push_back(n * step);
    }
    return values;
}

class Drawing {
  public:
    Drawing(const Chart& chart, double top) : chart_(chart), top_(top) {}

    std::string text() {
        frame();
        double legend = kLeft + 200;
        for (const auto& series : chart_.series) {
            draw(series);
            label(legend, top_ + 22, series.name, series.colour, "start");
            legend += 30 + 8.0 * static_cast<double>(series.name.size());
        }
        return out_;
    }

  private:
    double x(double share) const { return kLeft + share * (kWidth - kLeft - kRight); }
    double y(double share) const {
        return top_ + kHeight - kBottom - share * (kHeight - kTop - kBottom);
    }

    void label(double at_x, double at_y, const std::string& text, const std::string& colour,
               const char* anchor) {
        out_ += "<text x=\"" + number(at_x) + "\" y=\"" + number(at_y) + "\" fill=\"" + colour +
                "\" text-anchor=\"" + anchor + "\">" + escaped(text) + "</text>\n";
    }

    void line(double x1, double y1, double x2, double y2, const std::string& colour) {
        out_ += "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
                "\" y2=\"" + number(y2) + "\" stroke=\"" + colour + "\"/>\n";
    }

    void frame() {
        const std::string grey = "#d8dce0", dark = "#404850";
        for (const double value : ticks(chart_.x)) {
            if (const auto share = along(chart_.x, value)) {
                line(x(*share), y(0), x(*share), y(1), grey);
                label(x(*share), y(0) + 16, number(value), dark, "middle");
            }
        }
        for (const double value : ticks(chart_.y)) {
            if (const auto share = along(chart_.y, value)) {
                line(x(0), y(*share), x(1), y(*share), grey);
                label(x(0) - 6, y(*share) + 4, number(value), dark, "end");
            }
        }
        label(kLeft, top_ + 22, chart_.title, "#000000", "start");
        label(x(1), y(0) + 34, chart_.x.title, dark, "end");
        label(8, top_ + 22, chart_.y.title, dark, "start");
    }

    void draw(const Series& series) {
        std::string path;
        bool pen_down = false;
        for (const auto& [at_x, at_y] : series.points) {
            const auto sx = along(chart_.x, at_x), sy = along(chart_.y, at_y);
            if (!sx || !sy) {
                pen_down = false;
                continue;
            }
            if (series.kind == Series::Kind::line) {
                path += (pen_down ? " L" : " M") + number(x(*sx)) + " " + number(y(*sy));
                pen_down = true;
                continue;
            }
            if (series.kind == Series::Kind::stems) {
                line(x(*sx), y(0), x(*sx), y(*sy), series.colour);
            }
            out_ += "<circle cx=\"" + number(x(*sx)) + "\" cy=\"" + number(y(*sy)) +
                    "\" r=\"3\" fill=\"" + series.colour + "\"/>\n";
        }
        if (!path.empty()) {
            out_ += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + series.colour + "\"/>\n";
        }
    }

    const Chart& chart_;
    double top_;
    std::string out_;
};

}  // namespace

std::string svg(std::span<const Chart> charts) {
    const double height = kHeight * static_cast<double>(charts.size());
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kWidth) +
                      "\" height=\"" + number(height) +
                      "\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    for (std::size_t i = 0; i < charts.size(); ++i) {
        out += Drawing(charts[i], kHeight * static_cast<double>(i)).text();
    }
    return out + "</svg>\n";
}

void write_svg(const std::filesystem::path& path, std::span<const Chart> charts) {
    write_text(path, svg(charts));
}

}  // namespace percussionist::files
