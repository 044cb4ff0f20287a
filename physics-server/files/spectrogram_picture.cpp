#include "files/spectrogram_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "files/png.hpp"

namespace percussionist::files {

namespace {

using namespace listening;

constexpr double kLeft = 90.0, kRight = 20.0, kTop = 46.0;  ///< margins [px]
constexpr double kSpectrum = 320.0, kRow = 26.0, kGap = 14.0;
constexpr double kPixelsPerSecond = 70.0;
constexpr double kNarrowest = 900.0, kWidest = 16000.0;
constexpr std::size_t kMostColumns = 4000;
constexpr float kFaintest = 16.0F;  ///< below the loudest, drawn [nats]

constexpr std::array<const char*, kDrumClasses> kColours = {
    "#b03a2e", "#1f618d", "#b7950b", "#d68910", "#6c3483", "#148f77", "#2e86c1", "#616a6b"};

template <class... Values>
std::string text(const char* format, Values... values) {
    std::array<char, 512> out{};
    std::snprintf(out.data(), out.size(), format, values...);
    return out.data();
}

std::string escaped(const std::string& plain) {
    std::string out;
    for (const char c : plain) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

/// From white through blue to nearly black.
std::vector<Colour> palette() {
    std::vector<Colour> colours;
    for (int i = 0; i < 256; ++i) {
        const double dark = i / 255.0;
        const auto shade = [&](double most, double power) {
            return static_cast<std::uint8_t>(255.0 - most * std::pow(dark, power));
        };
        colours.push_back({shade(240.0, 0.9), shade(225.0, 1.2), shade(165.0, 2.2)});
    }
    return colours;
}

/// Levels of all bands, high ones on top, as a PNG.
std::vector<std::uint8_t> picture(const Heard& heard) {
    const std::size_t columns = std::clamp<std::size_t>(heard.frames.size(), 1, kMostColumns);
    std::vector<float> levels(columns * kLevels, -100.0F);
    float loudest = -100.0F;
    for (std::size_t f = 0; f < heard.frames.size(); ++f) {
        const std::size_t column = f * columns / heard.frames.size();
        for (std::size_t b = 0; b < kLevels; ++b) {
            float& level = levels[(kLevels - 1 - b) * columns + column];
            level = std::max(level, heard.frames[f].level[b]);
            loudest = std::max(loudest, level);
        }
    }
    std::vector<std::uint8_t> pixels(levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const float dark = std::clamp(1.0F + (levels[i] - loudest) / kFaintest, 0.0F, 1.0F);
        pixels[i] = static_cast<std::uint8_t>(255.0F * dark);
    }
    return png(columns, kLevels, pixels, palette());
}

class Drawing {
  public:
    Drawing(const Transcription& made, const Beats& beats, const std::string& title)
        : made_(made), beats_(beats) {
        duration_ =
            static_cast<double>(made.heard.frames.size() * made.heard.hop) / made.heard.rate;
        inner_ = std::clamp(duration_ * kPixelsPerSecond, kNarrowest, kWidest);
        rows_top_ = kTop + kSpectrum + kGap;
        bottom_ = rows_top_ + kRow * kDrumClasses;
        begin(title);
    }

    std::string svg() {
        spectrogram();
        attacks();
        rows();
        bars();
        strokes();
        time_axis();
        return out_ + "</svg>\n";
    }

  private:
    [[nodiscard]] double x(double time) const {
        return kLeft + inner_ * time / std::max(duration_, 1e-3);
    }

    void begin(const std::string& title) {
        const double width = kLeft + inner_ + kRight, height = bottom_ + 40.0;
        out_ = text(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 "
            "0 %.0f %.0f\" "
            "font-family=\"sans-serif\" font-size=\"12\">\n",
            width, height, width, height);
        out_ += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
        out_ += text("<text x=\"%.0f\" y=\"28\" font-size=\"16\">", kLeft) + escaped(title) +
                "</text>\n";
    }

    void label(double left, double y, const char* anchor, const std::string& what) {
        out_ +=
            text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"#333\">", left, y, anchor) +
            what + "</text>\n";
    }
    void line(double left, double top, double bottom, const char* colour, double width) {
        out_ += text(
            "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
            "stroke-width=\"%.2f\"/>\n",
            left, left, top, bottom, colour, width);
    }

    void spectrogram() {
        out_ += text(
            "<image x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
            "preserveAspectRatio=\"none\" href=\"data:image/png;base64,",
            kLeft, kTop, inner_, kSpectrum);
        out_ += base64(picture(made_.heard)) + "\"/>\n";
        for (const double hz : {50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0}) {
            const double low = level_frequency(0), high = level_frequency(kLevels - 1);
            const double up = std::log(hz / low) / std::log(high / low);
            const double band = (up * (kLevels - 1) + 0.5) / kLevels;
            label(kLeft - 8.0, kTop + kSpectrum * (1.0 - band) + 4.0, "end",
                  text(hz < 1000.0 ? "%.0f Hz" : "%.0f kHz", hz < 1000.0 ? hz : hz / 1000.0));
        }
    }
    void attacks() {
        for (const DrumStroke& s : made_.strokes) {
            line(x(s.time), kTop, kTop + kSpectrum, kColours[index(s.drum)], 0.6);
        }
    }
    void rows() {
        for (std::size_t c = 0; c < kDrumClasses; ++c) {
            const double top = rows_top_ + kRow * static_cast<double>(c);
            out_ +=
                text("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n",
                     kLeft, top, inner_, kRow, c % 2 == 0 ? "#f4f6f7" : "#ffffff");
            label(kLeft - 8.0, top + 0.68 * kRow, "end", std::string(kDrumNames[c]));
        }
    }
    void bars() {
        for (std::size_t b = 0; b < beats_.times.size(); ++b) {
            const auto from_bar =
                static_cast<std::ptrdiff_t>(b) - static_cast<std::ptrdiff_t>(beats_.first_downbeat);
            const bool first = from_bar % beats_.per_bar == 0;
            line(x(beats_.times[b]), rows_top_, bottom_, first ? "#808b96" : "#d5d8dc",
                 first ? 1.2 : 0.8);
        }
    }
    void strokes() {
        for (const DrumStroke& s : made_.strokes) {
            const double y = rows_top_ + kRow * (static_cast<double>(index(s.drum)) + 0.5);
            const double sure = std::clamp(0.25 + 1.5 * (s.confidence - 0.5), 0.25, 1.0);
            out_ += text(
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\" fill-opacity=\"%.2f\"/>\n",
                x(s.time), y, 2.5 + 6.5 * s.velocity, kColours[index(s.drum)], sure);
        }
    }
    void time_axis() {
        const double step =
            duration_ * kPixelsPerSecond <= kWidest ? 1.0 : std::ceil(40.0 * duration_ / inner_);
        for (double t = 0.0; t <= duration_; t += step) {
            line(x(t), bottom_, bottom_ + 5.0, "#333", 1.0);
            label(x(t), bottom_ + 20.0, "middle", text("%.0f s", t));
        }
    }

    const Transcription& made_;
    const Beats& beats_;
    double duration_ = 0.0, inner_ = 0.0, rows_top_ = 0.0, bottom_ = 0.0;
    std::string out_;
};

}  // namespace

std::string spectrogram_svg(const Transcription& transcription, const Beats& beats,
                            const std::string& title) {
    return Drawing(transcription, beats, title).svg();
}

}  // namespace percussionist::files
