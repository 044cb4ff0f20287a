#include "core/listening/drum_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/listening/context.hpp"
#include "core/listening/stroke_features.hpp"

namespace percussionist::listening {

namespace {

constexpr std::string_view kTitle = "percussionist drums 1";
constexpr std::string_view kDigits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";
constexpr int kZero = 2048;  ///< the middle of 12 bits
constexpr long kMostRows = 4096;

/// A line that stands for itself and an end of line in C++.
std::string quoted(const std::string& line) {
    return '"' + line + "\\n\"\n";
}

std::string number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", static_cast<double>(value));
    return text;
}

std::string row_text(const Layer& layer, Eigen::Index row) {
    const float most = std::max(layer.weights.row(row).cwiseAbs().maxCoeff(), 1e-12F);
    const float step = most / (kZero - 1);
    std::string text = number(layer.bias(row)) + ' ' + number(step) + ' ';
    for (const float weight : layer.weights.row(row)) {
        const auto code = static_cast<std::size_t>(kZero + std::lround(weight / step));
        text += kDigits[code / 64];
        text += kDigits[code % 64];
    }
    return quoted(text);
}

std::string network_text(std::string_view name, const Network& network) {
    std::string text = quoted(std::string(name) + ' ' + std::to_string(network.layers().size()));
    for (const Layer& layer : network.layers()) {
        text += quoted("layer " + std::to_string(layer.weights.rows()) + ' ' +
                       std::to_string(layer.weights.cols()));
        for (Eigen::Index row = 0; row < layer.weights.rows(); ++row) text += row_text(layer, row);
    }
    return text;
}

std::string odds_text(std::string_view name, const Odds& odds) {
    std::string text(name);
    for (const float value : odds) text += ' ' + number(value);
    return quoted(text);
}

class Reader {
  public:
    explicit Reader(std::string_view text) : rest_(text) {}

    DrumModel model() {
        expect(next_line() == kTitle, kTitle);
        DrumModel model;
        model.live = network("live", kLiveFeatures);
        model.first = network("first", kFeatures);
        model.second = network("second", kContext);
        model.live_threshold = odds("live_threshold");
        model.second_threshold = odds("second_threshold");
        return model;
    }

  private:
    void expect(bool holds, std::string_view what) const {
        if (!holds) {
            throw std::invalid_argument("drum model: line " + std::to_string(line_) +
                                        ": expected " + std::string(what));
        }
    }

    std::string next_line() {
        ++line_;
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string line(rest_.substr(0, end));
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        std::erase(line, '"');
        std::erase(line, '\r');
        if (line.ends_with("\\n")) line.erase(line.size() - 2);
        return line;
    }

    /// The next word of a line, taken off it.
    static std::string word(std::string& line) {
        const std::size_t end = std::min(line.find(' '), line.size());
        std::string first = line.substr(0, end);
        line.erase(0, std::min(end + 1, line.size()));
        return first;
    }
    float real(std::string& line, std::string_view what) {
        const std::string text = word(line);
        char* end = nullptr;
        const float value = std::strtof(text.c_str(), &end);
        expect(!text.empty() && *end == '\0' && std::isfinite(value), what);
        return value;
    }
    long whole(std::string& line, std::string_view what) {
        const float value = real(line, what);
        expect(value >= 1.0F && value <= kMostRows && value == std::floor(value), what);
        return static_cast<long>(value);
    }

    Network network(std::string_view name, std::size_t inputs) {
        std::string line = next_line();
        expect(word(line) == name, std::string(name) + " and its number of layers");
        const long count = whole(line, "a number of layers");
        std::vector<Layer> layers;
        for (long l = 0; l < count; ++l) layers.push_back(layer());
        Network made(std::move(layers));
        expect(made.inputs() == inputs && made.outputs() == kDrumClasses,
               std::string(name) + " with " + std::to_string(inputs) + " inputs and " +
                   std::to_string(kDrumClasses) + " outputs");
        return made;
    }

    Layer layer() {
        std::string line = next_line();
        expect(word(line) == "layer", "layer, rows and columns");
        const long rows = whole(line, "a number of rows");
        const long columns = whole(line, "a number of columns");
        Layer layer{Eigen::MatrixXf(rows, columns), Eigen::VectorXf(rows)};
        for (long row = 0; row < rows; ++row) {
            std::string text = next_line();
            layer.bias(row) = real(text, "a bias");
            const float step = real(text, "a step");
            expect(text.size() == 2 * static_cast<std::size_t>(columns), "two characters a weight");
            for (long c = 0; c < columns; ++c) {
                layer.weights(row, c) =
                    step *
                    static_cast<float>(weight(text.substr(2 * static_cast<std::size_t>(c), 2)));
            }
        }
        return layer;
    }

    int weight(const std::string& pair) const {
        const std::size_t high = kDigits.find(pair[0]);
        const std::size_t low = kDigits.find(pair[1]);
        expect(high < 64 && low < 64, "digits, letters, + and -");
        return static_cast<int>(64 * high + low) - kZero;
    }

    Odds odds(std::string_view name) {
        std::string line = next_line();
        expect(word(line) == name, name);
        Odds odds{};
        for (float& value : odds) value = real(line, "a number for each class");
        return odds;
    }

    std::string_view rest_;
    int line_ = 0;
};

}  // namespace

std::string to_text(const DrumModel& model) {
    return quoted(std::string(kTitle)) + network_text("live", model.live) +
           network_text("first", model.first) + network_text("second", model.second) +
           odds_text("live_threshold", model.live_threshold) +
           odds_text("second_threshold", model.second_threshold);
}

DrumModel model_from_text(std::string_view text) {
    return Reader(text).model();
}

}  // namespace percussionist::listening
