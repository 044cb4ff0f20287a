#include "files/plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace percussionist::files {

namespace {

constexpr int kLeft = 70, kRight = 190, kTop = 30, kBottom = 45;  // margins [px]

std::string text_of(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", value);
    return buffer;
}

std::string pixel(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1f", value);
    return buffer;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '<') {
            out += "&lt;";
        } else if (c == '&') {
            out += "&amp;";
        } else {
            out += c;
        }
    }
    return out;
}

std::string label(double x, double y, const std::string& text, const std::string& more) {
    return "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" " + more + ">" + escaped(text) +
           "</text>\n";
}

/// The part of an axis that is shown, and the distance between its marks.
struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void settle(double margin) {
        if (!(low <= high)) low = 0.0, high = 1.0;
        const double size = std::max(high - low, 1e-9 + 1e-6 * std::abs(high));
        low -= margin * size;
        high += margin * size;
    }
    void widen(double size) {
        const double middle = 0.5 * (low + high);
        low = middle - 0.5 * size;
        high = middle + 0.5 * size;
    }
    [[nodiscard]] double step() const {
        const double raw = (high - low) / 6.0;
        const double ten = std::pow(10.0, std::floor(std::log10(raw)));
        for (const double round : {1.0, 2.0, 5.0}) {
            if (raw <= round * ten) return round * ten;
        }
        return 10.0 * ten;
    }
};

class Chart {
  public:
    Chart(const Plot& plot, double top, int width, int height)
        : plot_(plot),
          top_(top + kTop),
          width_(width - kLeft - kRight),
          height_(height - kTop - kBottom) {
        for (const PlotLine& line : plot.lines) {
            for (const double x : line.x) x_.take(x);
            for (const double y : line.y) y_.take(y);
        }
        x_.settle(0.0);
        y_.settle(0.05);
        if (plot.same_scale) {
            const double scale =
                std::max((x_.high - x_.low) / width_, (y_.high - y_.low) / height_);
            x_.widen(1.05 * scale * width_);
            y_.widen(1.05 * scale * height_);
        }
    }

    [[nodiscard]] std::string svg() const {
        std::string out = frame();
        double legend = top_ + 8.0;
        for (const PlotLine& line : plot_.lines) {
            out += curve(line);
            if (line.name.empty()) continue;
            const double x = kLeft + width_ + 12.0;
            out += "<line x1=\"" + pixel(x) + "\" x2=\"" + pixel(x + 20.0) + "\" y1=\"" +
                   pixel(legend) + "\" y2=\"" + pixel(legend) + "\" stroke=\"" + line.colour +
                   "\" stroke-width=\"3\"/>\n" + label(x + 26.0, legend + 4.0, line.name, "");
            legend += 18.0;
        }
        return out;
    }

  private:
    [[nodiscard]] double at_x(double x) const {
        return kLeft + (x - x_.low) / (x_.high - x_.low) * width_;
    }
    [[nodiscard]] double at_y(double y) const {
        return top_ + height_ - (y - y_.low) / (y_.high - y_.low) * height_;
    }

    [[nodiscard]] std::string frame() const {
        std::string out = "<rect x=\"" + pixel(kLeft) + "\" y=\"" + pixel(top_) + "\" width=\"" +
                          pixel(width_) + "\" height=\"" + pixel(height_) +
                          "\" fill=\"none\" stroke=\"#888\"/>\n";
        const std::string middle = "text-anchor=\"middle\"";
        out += label(kLeft + 0.5 * width_, top_ - 10.0, plot_.title,
                     middle + " font-weight=\"bold\"");
        out += label(kLeft + 0.5 * width_, top_ + height_ + 36.0, plot_.x_label, middle);
        const std::string turned =
            middle + " transform=\"rotate(-90 14 " + pixel(top_ + 0.5 * height_) + ")\"";
        out += label(14.0, top_ + 0.5 * height_, plot_.y_label, turned);
        for (double x = std::ceil(x_.low / x_.step()) * x_.step(); x <= x_.high; x += x_.step()) {
            out += grid(at_x(x), top_, at_x(x), top_ + height_);
            out += label(at_x(x), top_ + height_ + 17.0, rounded(x, x_.step()), middle);
        }
        for (double y = std::ceil(y_.low / y_.step()) * y_.step(); y <= y_.high; y += y_.step()) {
            out += grid(kLeft, at_y(y), kLeft + width_, at_y(y));
            out += label(kLeft - 6.0, at_y(y) + 4.0, rounded(y, y_.step()), "text-anchor=\"end\"");
        }
        return out;
    }

    static std::string rounded(double value, double step) {
        return text_of(std::round(value / step) * step + 0.0);
    }

    static std::string grid(double x1, double y1, double x2, double y2) {
        return "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) +
               "\" y2=\"" + pixel(y2) + "\" stroke=\"#ddd\"/>\n";
    }

    [[nodiscard]] std::string curve(const PlotLine& line) const {
        std::string out;
        std::string points;
        const auto end_piece = [&] {
            if (!points.empty()) {
                out += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + line.colour +
                       "\" stroke-width=\"" + text_of(line.width) + "\"/>\n";
            }
            points.clear();
        };
        for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
            if (!std::isfinite(line.x[i]) || !std::isfinite(line.y[i])) {
                end_piece();
                continue;
            }
            const std::string x = pixel(at_x(line.x[i]));
            const std::string y = pixel(at_y(line.y[i]));
            if (line.width > 0.0) {
                points += x + "," + y + " ";
            } else {
                out += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"1.5\" fill=\"" + line.colour +
                       "\"/>\n";
            }
        }
        end_piece();
        return out;
    }

    const Plot& plot_;
    double top_, width_, height_;
    Range x_, y_;
};

}  // namespace

std::string plot_svg(const std::vector<Plot>& plots, int width, int height) {
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) +
                      "\" height=\"" + std::to_string(height * static_cast<int>(plots.size())) +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    double top = 0.0;
    for (const Plot& plot : plots) {
        out += Chart(plot, top, width, height).svg();
        top += height;
    }
    return out + "</svg>\n";
}

void write_plot(const std::filesystem::path& path, const std::vector<Plot>& plots, int width,
                int height) {
    std::ofstream file(path, std::ios::binary);
    file << plot_svg(plots, width, height);
    file.flush();
    if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace percussionist::files
