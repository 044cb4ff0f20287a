#include "core/listening/own_drums.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace percussionist::listening {

namespace {

constexpr std::array<std::size_t, 3> kMoments = {4, 6, 9};  ///< frames after the attack
constexpr std::size_t kBefore = 3;                          ///< frames before it
constexpr float kLeastShare = 1e-4F;                        ///< of all power added, that counts
constexpr float kLeastVariance = 1.0F;                      ///< of a print [nats^2]
constexpr const char* kTitle = "percussionist-own-drums-1";

float power(const BandFrame& frame, std::size_t pair) noexcept {
    return std::exp(frame.level[2 * pair]) + std::exp(frame.level[2 * pair + 1]);
}

bool fits(std::string_view name) noexcept {
    return !name.empty() && name.size() <= OwnDrum::kLongestName &&
           std::none_of(name.begin(), name.end(),
                        [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == 0; });
}

}  // namespace

StrokePrint print_of(std::span<const BandFrame> frames, std::size_t at) noexcept {
    constexpr std::size_t kPairs = kLevels / 2;
    StrokePrint print{};
    const BandFrame& before = frames[at - std::min(at, kBefore)];
    float all = 1e-12F;
    for (std::size_t m = 0; m < kMoments.size(); ++m) {
        const BandFrame& after = frames[std::min(at + kMoments[m], frames.size() - 1)];
        for (std::size_t pair = 0; pair < kPairs; ++pair) {
            const float added = std::max(power(after, pair) - power(before, pair), 0.0F);
            print[m * kPairs + pair] = added;
            all += added;
        }
    }
    for (float& p : print) p = std::log(std::max(p / all, kLeastShare));
    return print;
}

void OwnDrum::learn(const StrokePrint& print, float power_added) noexcept {
    const float share = 1.0F / static_cast<float>(++strokes);
    for (std::size_t i = 0; i < kPrint; ++i) {
        if (strokes == 1) mean[i] = square[i] = 0.0F;
        mean[i] += share * (print[i] - mean[i]);
        square[i] += share * (print[i] * print[i] - square[i]);
    }
    loudest = strokes == 1 ? power_added : std::max(loudest, power_added);
}

float OwnDrum::distance(const StrokePrint& print) const noexcept {
    float sum = 0.0F;
    for (std::size_t i = 0; i < kPrint; ++i) {
        const float variance = std::max(square[i] - mean[i] * mean[i], 0.0F) + kLeastVariance;
        sum += (print[i] - mean[i]) * (print[i] - mean[i]) / variance;
    }
    return std::sqrt(sum / static_cast<float>(kPrint));
}

std::optional<std::size_t> OwnDrums::named(std::string_view name) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
        if (name == drums_[i].name.data()) return i;
    }
    if (count_ == kMost || !fits(name)) return std::nullopt;
    drums_[count_] = {};
    std::copy(name.begin(), name.end(), drums_[count_].name.begin());
    return count_++;
}

std::optional<OwnDrums::Match> OwnDrums::nearest(const StrokePrint& print) const noexcept {
    std::optional<Match> best;
    float nearest = kFar, second = kFar;
    for (std::size_t i = 0; i < count_; ++i) {
        if (drums_[i].strokes == 0) continue;
        const float distance = drums_[i].distance(print);
        if (distance < nearest) {
            second = nearest;
            nearest = distance;
            best = Match{i, 0.5};
        } else {
            second = std::min(second, distance);
        }
    }
    if (best)
        best->confidence =
            static_cast<double>(second) / static_cast<double>(second + nearest + 1e-6F);
    return best;
}

std::string to_text(const OwnDrums& drums) {
    std::ostringstream out;
    out.precision(7);
    out << kTitle << '\n';
    for (std::size_t i = 0; i < drums.size(); ++i) {
        const OwnDrum& drum = drums[i];
        out << drum.name.data() << ' ' << drum.strokes << ' ' << drum.loudest;
        for (const float m : drum.mean) out << ' ' << m;
        for (const float s : drum.square) out << ' ' << s;
        out << '\n';
    }
    return out.str();
}

OwnDrums own_drums_from_text(std::string_view text) {
    std::istringstream in{std::string(text)};
    const auto expect = [line = 1](bool holds, const char* what, int at) {
        if (!holds)
            throw std::invalid_argument("own drums: line " + std::to_string(at + line) +
                                        ": expected " + what);
    };
    std::string line;
    expect(std::getline(in, line) && line == kTitle, kTitle, 0);
    OwnDrums drums;
    for (int at = 1; std::getline(in, line); ++at) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        const std::size_t before = drums.size();
        const auto index = drums.named(name);
        expect(index && drums.size() == before + 1, "a name of its own, of up to 31 characters",
               at);
        OwnDrum& drum = drums[*index];
        words >> drum.strokes >> drum.loudest;
        for (float& m : drum.mean) words >> m;
        for (float& s : drum.square) words >> s;
        expect(!words.fail() && drum.strokes >= 0, "strokes, loudness and 96 numbers", at);
    }
    return drums;
}

}  // namespace percussionist::listening
