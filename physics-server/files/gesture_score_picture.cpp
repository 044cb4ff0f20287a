#include "files/gesture_score_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/text_file.hpp"

namespace percussionist::files {

namespace {

constexpr double kWidth = 1120, kLeft = 64, kRight = 16;
constexpr double kStaff = 96;  ///< the line the notes stand on
constexpr double kPanelTop[2] = {170, 350};
constexpr double kPanelHeight = 160;
constexpr double kHeight = 560;
constexpr double kTopOfPanel = 0.70;  ///< height of the tip at a panel's top [m]
constexpr double kLowest = -0.05;
constexpr const char* kInk = "#203040";
constexpr const char* kGrey = "#d4d8dc";
constexpr const char* kHandColour[2] = {"#c05020", "#305070"};

class Picture {
  public:
    explicit Picture(const GestureScore& score) : score_(score) {}

    std::string text() {
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" "
            "font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
            kWidth, kHeight);
        label(kLeft, 22, score_.title, "start", 15);
        panel(0, "right", score_.right_asked, score_.right, kHandColour[1]);
        panel(1, "left", score_.left_asked, score_.left, kHandColour[0]);
        staff();
        tempo();
        for (const int t : whole_seconds()) {
            label(x(t), kPanelTop[1] + kPanelHeight + 18, std::to_string(t), "middle");
        }
        label(kWidth - kRight, kHeight - 14, "time [s]", "end");
        return out_ + "</svg>\n";
    }

  private:
    [[nodiscard]] double x(double t) const {
        return kLeft + (t - score_.from) / (score_.to - score_.from) * (kWidth - kLeft - kRight);
    }
    [[nodiscard]] std::vector<int> whole_seconds() const {
        std::vector<int> all;
        for (int t = static_cast<int>(std::ceil(score_.from)); t <= score_.to; ++t) {
            all.push_back(t);
        }
        return all;
    }
    [[nodiscard]] bool shown(double t) const { return t >= score_.from && t <= score_.to; }

    void label(double at_x, double at_y, const std::string& text, const char* anchor,
               int size = 12) {
        std::string safe;
        for (const char c : text)
            safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
        out_ += fmt::format(
            "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\">{}"
            "</text>\n",
            at_x, at_y, anchor, size, kInk, safe);
    }

    void line(double x1, double y1, double x2, double y2, const char* colour, double width = 1.0) {
        out_ += fmt::format(
            "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
            "stroke-width=\"{}\"/>\n",
            x1, y1, x2, y2, colour, width);
    }

    static double y(int panel, double height) {
        const double share = (height - kLowest) / (kTopOfPanel - kLowest);
        return kPanelTop[panel] + kPanelHeight * (1.0 - std::clamp(share, 0.0, 1.0));
    }

    void panel(int index, const std::string& name, const Heights& asked, const Heights& made,
               const char* colour) {
        for (const int t : whole_seconds()) {
            line(x(t), kPanelTop[index], x(t), kPanelTop[index] + kPanelHeight, kGrey);
        }
        for (const double height : {0.0, 0.2, 0.4, 0.6}) {
            line(kLeft, y(index, height), kWidth - kRight, y(index, height),
                 height == 0.0 ? kInk : kGrey);
            label(kLeft - 6, y(index, height) + 4, fmt::format("{:.1f}", height), "end");
        }
        label(kLeft, kPanelTop[index] - 6, name + ": height of the tip above the head [m]",
              "start");
        curve(index, asked, "#b0b4b8", 3.0);
        curve(index, made, colour, 1.4);
        for (const PicturedNote& note : score_.notes) {
            if ((note.hand == 1) != (index == 0) || !shown(note.time)) continue;
            out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.2\" fill=\"{}\"/>\n",
                                x(note.time), y(index, 0.0), colour);
        }
    }

    void curve(int panel, const Heights& heights, const char* colour, double width) {
        std::string path;
        for (const auto& [t, height] : heights) {
            if (!shown(t)) continue;
            path +=
                fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", x(t), y(panel, height));
        }
        if (path.empty()) return;
        out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
                            path, colour, width);
    }

    /// Right-hand notes have their stems up, left-hand ones down.
    void staff() {
        line(kLeft, kStaff, kWidth - kRight, kStaff, kInk);
        int bar = 0;
        for (const PicturedNote& note : score_.notes) {
            if (bar != 0 && note.bar != bar && shown(note.time)) {
                const double at = x(note.time) - 9;
                line(at, kStaff - 14, at, kStaff + 14, kInk);
            }
            bar = note.bar;
            if (shown(note.time)) draw(note);
        }
    }

    void draw(const PicturedNote& note) {
        const double at = x(note.time);
        const bool up = note.hand == 1;
        out_ += fmt::format(
            "<ellipse cx=\"{:.1f}\" cy=\"{:.1f}\" rx=\"5.6\" ry=\"4.2\" "
            "transform=\"rotate(-20 {:.1f} {:.1f})\" fill=\"{}\" stroke=\"{}\"/>\n",
            at, kStaff, at, kStaff, note.played ? kHandColour[up ? 1 : 0] : "#ffffff", kInk);
        const double side = up ? 5.0 : -5.0;
        const double end = up ? kStaff - 28 : kStaff + 28;
        line(at + side, kStaff, at + side, end, kInk, 1.4);
        label(at, up ? kStaff + 22 : kStaff + 42, up ? "R" : "L", "middle", 10);
        mark(at, note.nuance, 56);
    }

    /// As notation has them; a piston stroke is a wedge.
    void mark(double at, score::Nuance nuance, double top) {
        using score::Nuance;
        const auto path = [&](const std::string& d, const char* fill) {
            out_ += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.4\"/>\n",
                                d, fill, kInk);
        };
        switch (nuance) {
            case Nuance::legato:
                break;
            case Nuance::tenuto:
                line(at - 6, top, at + 6, top, kInk, 2.0);
                break;
            case Nuance::accent:
                path(fmt::format("M{:.1f} {:.1f} l12 4 l-12 4", at - 6, top - 4), "none");
                break;
            case Nuance::vertical_accent:
                path(fmt::format("M{:.1f} {:.1f} l5 -11 l5 11", at - 5, top + 5), "none");
                break;
            case Nuance::staccato:
                out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\" fill=\"{}\"/>\n",
                                    at, top, kInk);
                break;
            case Nuance::piston:
                path(fmt::format("M{:.1f} {:.1f} l3 9 l3 -9 z", at - 3, top - 5), kInk);
                break;
        }
    }

    /// Where the tempo is another by a tenth, and at the beginning.
    void tempo() {
        double said = -1.0;
        for (const auto& [t, factor] : score_.tempo) {
            if (!shown(t) || std::abs(factor - said) < 0.1) continue;
            said = factor;
            label(x(t), 42, fmt::format("x {:.2g}", factor), "start", 11);
        }
    }

    const GestureScore& score_;
    std::string out_;
};

}  // namespace

std::string svg(const GestureScore& score) {
    return Picture(score).text();
}

void write_svg(const std::filesystem::path& path, const GestureScore& score) {
    write_text(path, svg(score));
}

}  // namespace percussionist::files
