#include "app/gesture_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "body/path_repair.hpp"
#include "body/spline.hpp"
#include "body/stroke_measure.hpp"
#include "files/trajectory_file.hpp"

namespace percussionist::app {

namespace {

bool one_word(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_';
    });
}

std::optional<body::Gesture> parse(const std::string& line) {
    std::istringstream words(line);
    body::Gesture g;
    body::StrokeShape& s = g.shape;
    words >> g.name >> s.rise >> s.peak_down >> s.impact >> s.peak_up >> s.rebound;
    if (!words || !one_word(g.name)) return std::nullopt;
    for (const double number : {s.rise, s.peak_down, s.impact, s.peak_up, s.rebound}) {
        constexpr double kMost = 20.0;
        if (!(number > 0.0 && number < kMost)) return std::nullopt;
    }
    std::getline(words >> std::ws, g.source);
    g.synthetic = false;
    return g;
}

}  // namespace

std::vector<body::Gesture> load_gestures(const std::filesystem::path& library) {
    std::vector<body::Gesture> all = body::built_in_gestures();
    std::ifstream in(library);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        const auto gesture = parse(line);
        if (!gesture) {
            throw std::runtime_error(fmt::format(
                "{}: line {}: expected a name, five numbers between 0 and 20 (rise m, speeds down, "
                "at the impact and up m/s, rebound m) and a source, got '{}'",
                library.string(), number, line));
        }
        std::erase_if(all, [&](const body::Gesture& g) { return g.name == gesture->name; });
        all.push_back(*gesture);
    }
    return all;
}

void add_gesture(const std::filesystem::path& library, const body::Gesture& gesture) {
    if (!one_word(gesture.name)) {
        throw std::runtime_error("gesture: expected a name of letters, digits, - and _, got '" +
                                 gesture.name + "'");
    }
    std::ofstream out(library, std::ios::app);
    const body::StrokeShape& s = gesture.shape;
    out << fmt::format("{} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {}\n", gesture.name, s.rise,
                       s.peak_down, s.impact, s.peak_up, s.rebound, gesture.source);
    out.flush();
    if (!out) throw std::runtime_error(library.string() + ": cannot be written");
}

body::Gesture gesture_from_files(const std::string& name,
                                 const std::vector<std::filesystem::path>& files,
                                 double frame_rate) {
    std::vector<body::StrokeShape> shapes;
    files::TrajectoryOptions options;
    options.rate = frame_rate;
    body::Gesture gesture{name, {}, false, "recorded:"};
    for (const std::filesystem::path& file : files) {
        gesture.source += " " + file.filename().string();
        for (motion::Trajectory& path : files::read_trajectory_file(file, options)) {
            body::repair(path);
            if (path.samples.size() < 2) continue;
            std::vector<double> times;
            std::vector<double> heights;
            for (const auto& sample : path.samples) {
                times.push_back(sample.time);
                heights.push_back(sample.position.z());
            }
            const body::Spline spline(times, heights, 1);
            body::HeightSeries series;
            for (double t = 0.0; t <= spline.end(); t += series.dt) {
                double z = 0.0;
                spline.at(t, std::span(&z, 1));
                series.heights.push_back(z);
            }
            for (const std::size_t low : body::find_strokes(series)) {
                shapes.push_back(body::measure_stroke(series, low));
            }
        }
    }
    if (shapes.empty()) {
        throw std::runtime_error(files.front().string() + ": no strokes found in it");
    }
    gesture.shape = body::median_shape(shapes);
    gesture.source += fmt::format(", median of {} strokes", shapes.size());
    return gesture;
}

}  // namespace percussionist::app
