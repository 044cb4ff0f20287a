#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "app/commands.hpp"
#include "app/gesture_library.hpp"
#include "app/simulation_flags.hpp"
#include "body/stroke_measure.hpp"
#include "sim/simulation.hpp"

namespace percussionist::app {

namespace {

using body::Hand;

struct GesturesCommand {
    std::filesystem::path library = "gestures.txt";
    std::string name;
    std::vector<std::string> names;
    std::vector<std::filesystem::path> files;
    std::filesystem::path output;
    double frame_rate = 250.0;
    double interval = 1.4;  ///< between two strokes [s]
    int strokes = 8;
    body::Grip grip = body::Grip::german;
    std::string position = "rim";
    sim::SimulationOptions simulation;
};

std::string row(const std::string& name, const body::StrokeShape& s, const std::string& more) {
    return fmt::format("{:<18} {:>8.1f} {:>10.2f} {:>8.2f} {:>8.2f} {:>10.1f}  {}\n", name,
                       100.0 * s.rise, s.peak_down, s.impact, s.peak_up, 100.0 * s.rebound, more);
}

std::string head() {
    return fmt::format("{:<18} {:>8} {:>10} {:>8} {:>8} {:>10}\n", "gesture", "rise cm",
                       "peak down", "impact", "up m/s", "rebound cm");
}

void list(const GesturesCommand& command) {
    fmt::print("{}", head());
    for (const body::Gesture& g : load_gestures(command.library)) {
        fmt::print("{}", row(g.name, g.shape, g.source));
    }
}

const body::Gesture& named(const std::vector<body::Gesture>& all, const std::string& name) {
    const body::Gesture* gesture = body::find_gesture(all, name);
    if (gesture != nullptr) return *gesture;
    std::string names;
    for (const body::Gesture& g : all) names += " " + g.name;
    throw std::runtime_error("gesture: expected one of" + names + ", got '" + name + "'");
}

/// The strokes of one gesture as the simulated tips made them, both hands in turn.
std::vector<body::StrokeShape> play(const body::Gesture& gesture, const GesturesCommand& command) {
    sim::SimulationOptions options = command.simulation;
    options.strike_radius = body::drum_position(command.position);
    sim::Simulation simulation(options);
    simulation.set_grip(command.grip);
    std::vector<sim::ContactEvent> contacts;
    std::array<body::HeightSeries, 2> series;
    for (body::HeightSeries& s : series) s.dt = simulation.step_length();
    constexpr double kFirst = 1.5;  // [s]
    int asked = 0;
    const double end = kFirst + command.interval * command.strokes + 1.0;
    while (simulation.time() < end) {
        const double next = kFirst + asked * command.interval;
        const Hand hand = asked % 2 == 0 ? Hand::right : Hand::left;
        if (asked < command.strokes && next - simulation.time() < 1.2) {
            simulation.strike(hand, next, gesture.shape);
            ++asked;
        }
        simulation.step(contacts);
        if (!simulation.sane()) throw std::runtime_error("the simulated body went astray");
        for (const Hand h : {Hand::left, Hand::right}) {
            series[static_cast<int>(h)].heights.push_back(simulation.tip(h).z());
        }
    }
    std::vector<body::StrokeShape> shapes;
    for (const sim::ContactEvent& contact : contacts) {
        if (contact.recontact) continue;
        const body::HeightSeries& s = series[static_cast<int>(contact.hand)];
        // The touch; the tip dips into the head after it, which is no part of rise or rebound.
        const auto at = static_cast<std::size_t>(std::lround(contact.instant / s.dt)) - 1;
        shapes.push_back(body::measure_stroke(s, at));
    }
    return shapes;
}

void play_all(const GesturesCommand& command) {
    const std::vector<body::Gesture> all = load_gestures(command.library);
    std::vector<std::string> names = command.names;
    if (names.empty()) {
        for (const body::Gesture& g : all) names.push_back(g.name);
    }
    fmt::print("{}", head());
    for (const std::string& name : names) {
        const body::Gesture& gesture = named(all, name);
        const std::vector<body::StrokeShape> shapes = play(gesture, command);
        fmt::print("{}",
                   row(name, gesture.shape, gesture.synthetic ? "asked (synthetic)" : "asked"));
        if (shapes.empty()) {
            fmt::print("{:<18} no contact with the head\n", "");
            continue;
        }
        fmt::print("{}", row("", body::median_shape(shapes),
                             fmt::format("played, median of {} of {} strokes", shapes.size(),
                                         command.strokes)));
    }
}

/// A synthetic recording of a left and a right mallet, in the form of real ones.
void write(const GesturesCommand& command) {
    const std::vector<body::Gesture> all = load_gestures(command.library);
    const body::Gesture& gesture = named(all, command.name);
    std::array<body::StrokePath, 2> paths;
    std::ofstream out(command.output, std::ios::binary);
    out << fmt::format("synthetic recording of two mallets: {}, {}\n{:.0f} Hz\n", gesture.name,
                       gesture.source, command.frame_rate)
        << "frame,left_rx,left_ry,left_rz,left_tx,left_ty,left_tz,right_rx,right_ry,right_rz,"
           "right_tx,right_ty,right_tz\n"
        << ",deg,deg,deg,mm,mm,mm,deg,deg,deg,mm,mm,mm\n";
    constexpr double kFirst = 1.0;  // [s]
    const double end = kFirst + command.interval * command.strokes;
    int asked = 0;
    for (int frame = 0; frame / command.frame_rate < end; ++frame) {
        const double t = frame / command.frame_rate;
        while (asked < command.strokes && kFirst + asked * command.interval - t < 0.9) {
            body::Aim aim;
            aim.time = kFirst + asked * command.interval;
            aim.shape = gesture.shape;
            // As a head would throw it back: half as fast, after 5 ms.
            aim.rebound = {0.5 * gesture.shape.impact, 0.005};
            paths[asked % 2].aim(t, aim);
            ++asked;
        }
        out << frame + 1;
        for (int h = 0; h < 2; ++h) {
            const double height = paths[h].tip(t).position;
            const double raised = std::max(0.0, height);
            // The mallet points along x and swings up about y.
            const double pitch = -std::asin(std::min(0.9, raised / 0.7)) * 180.0 / 3.14159265358979;
            out << fmt::format(",0,{:.3f},0,{:.3f},{:.3f},{:.3f}", pitch,
                               1e3 * (0.6 - 0.5 * raised * raised), h == 0 ? 85.0 : -85.0,
                               1e3 * (0.9 + height));
        }
        out << '\n';
    }
    out.flush();
    if (!out) throw std::runtime_error(command.output.string() + ": cannot be written");
}

void add(const GesturesCommand& command) {
    const body::Gesture gesture =
        gesture_from_files(command.name, command.files, command.frame_rate);
    add_gesture(command.library, gesture);
    fmt::print("{}{}added to {}\n", head(), row(gesture.name, gesture.shape, gesture.source),
               command.library.string());
}

}  // namespace

void add_gestures_command(CLI::App& program) {
    auto o = std::make_shared<GesturesCommand>();
    CLI::App& command = *program.add_subcommand(
        "gestures",
        "the gestures that the body knows: legato, tenuto, accent, vertical-accent, staccato, "
        "piston (built in: synthetic, made from medians of timpanists' strokes), and those you add "
        "from recordings of mallets. For example:\n"
        "  percussionist gestures add my-legato left.csv right.csv\n"
        "  percussionist gestures play my-legato --grip french --position third");
    command.add_option("--library", o->library, "the file that holds those added")
        ->capture_default_str();
    command.require_subcommand(0, 1);
    CLI::App& list_them = *command.add_subcommand("list", "all of them, with their numbers");
    list_them.callback([o] { list(*o); });

    CLI::App& adding = *command.add_subcommand(
        "add", "find the strokes in a recording (CSV) and add their median as a gesture");
    adding.add_option("name", o->name, "what to call it")->required();
    adding.add_option("files", o->files, "recordings of a mallet each, or of both")->required();
    adding.add_option("--frame-rate", o->frame_rate, "of recordings that count frames [Hz]")
        ->check(CLI::Range(24.0, 10000.0))
        ->capture_default_str();
    adding.callback([o] { add(*o); });

    CLI::App& playing = *command.add_subcommand(
        "play", "let the body play them on the head, and measure what its sticks did");
    playing.add_option("names", o->names, "which (without: all)");
    playing.add_option("--strokes", o->strokes, "of each")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    playing.add_option("--interval", o->interval, "between strokes, left and right in turn [s]")
        ->check(CLI::Range(0.5, 10.0))
        ->capture_default_str();
    const std::map<std::string, body::Grip> grips{{"french", body::Grip::french},
                                                  {"german", body::Grip::german}};
    playing.add_option("--grip", o->grip, "french (thumbs up) or german (palms down)")
        ->transform(CLI::CheckedTransformer(grips, CLI::ignore_case))
        ->default_str("german");
    playing.add_option("--position", o->position, "on the head")
        ->check(CLI::IsMember({"centre", "third", "rim"}))
        ->capture_default_str();
    add_simulation_flags(playing, o->simulation);
    playing.callback([o] { play_all(*o); });

    CLI::App& writing = *command.add_subcommand(
        "write",
        "a gesture as a synthetic recording of two mallets (CSV), to follow or to look at");
    writing.add_option("name", o->name, "which")->required();
    writing.add_option("-o,--output", o->output, "the file")->required();
    writing.add_option("--strokes", o->strokes, "how many")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    writing.add_option("--interval", o->interval, "between strokes [s]")
        ->check(CLI::Range(0.5, 10.0))
        ->capture_default_str();
    writing.callback([o] { write(*o); });
    command.callback([o, &command] {
        if (command.get_subcommands().empty()) list(*o);
    });
}

}  // namespace percussionist::app
