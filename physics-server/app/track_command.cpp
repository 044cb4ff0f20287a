#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>

#include "app/clip_flags.hpp"
#include "app/commands.hpp"
#include "app/track_report.hpp"
#include "body/limits_text.hpp"
#include "files/text_lines.hpp"

namespace percussionist::app {

namespace {

struct TrackCommand {
    ClipOptions clip;
    TrackOptions track;
    std::filesystem::path report;
    std::filesystem::path limits;
    std::vector<std::string> controls;
    std::string law = "both";
};

bool wanted(const TrackCommand& command, const TrackControl& control) {
    if (command.law != "both" && command.law != law_name(control.law)) return false;
    return command.controls.empty() || std::find(command.controls.begin(), command.controls.end(),
                                                 control.name) != command.controls.end();
}

void use_limits(LoadedClip& clip, const std::filesystem::path& path) {
    constexpr std::uintmax_t kMost = 1U << 20U;
    const std::string text = files::read_text<std::runtime_error>(path, kMost);
    for (const auto& [segment, limits] : body::parse_limits(text, path.string())) {
        clip.skeleton.segments[clip.skeleton.index(segment)].limits = limits;
    }
}

void run(const TrackCommand& command) {
    LoadedClip clip = load_clip(command.clip);
    if (!command.limits.empty()) use_limits(clip, command.limits);
    for (const std::string& remark : clip.report) fmt::print("{}\n", remark);
    std::vector<TrackRun> runs;
    for (const TrackControl& control : all_track_controls()) {
        if (wanted(command, control)) runs.push_back(track(clip, control, command.track));
    }
    fmt::print("{}", track_table(runs));
    if (!command.report.empty()) write_track_report(command.report, clip, command.track, runs);
}

}  // namespace

void add_track_command(CLI::App& program) {
    auto o = std::make_shared<TrackCommand>();
    CLI::App& command = *program.add_subcommand(
        "track",
        "follow a captured motion with the simulated body, by its joints and by its tips alone, "
        "under the papers' law and ours, and say how well: errors, torques, computing time");
    add_clip_flags(command, o->clip);
    command.add_option("--report", o->report,
                       "folder for tables, time series (CSV), pictures (SVG)");
    command.add_option("--law", o->law, "paper (torque = ks e - kd w), implicit (ours), or both")
        ->check(CLI::IsMember({"paper", "implicit", "both"}))
        ->capture_default_str();
    command
        .add_option(
            "--control", o->controls,
            "joints (the captured joints), or tips by inverse kinematics: dls (damped least "
            "squares), transpose, learnt; several may be named (without: all)")
        ->check(CLI::IsMember({"joints", "dls", "transpose", "learnt"}));
    command.add_option("--rate", o->track.rate, "steps a second [Hz]")
        ->check(CLI::Range(250.0, 4000.0))
        ->capture_default_str();
    command.add_option("--gain", o->track.frequency, "of all joints under our law [Hz]")
        ->check(CLI::Range(0.1, 1000.0))
        ->capture_default_str();
    command.add_option("--damping", o->track.damping, "under our law; 1 is critical")
        ->check(CLI::Range(0.01, 10.0))
        ->capture_default_str();
    command.add_option("--paper-gain", o->track.paper_frequency, "under the papers' law [Hz]")
        ->check(CLI::Range(0.1, 1000.0))
        ->capture_default_str();
    command
        .add_option("--mass-error", o->track.mass_error,
                    "the simulated body weighs this share more than control reckons with")
        ->check(CLI::Range(-0.9, 9.0))
        ->capture_default_str();
    command.add_option("--limits", o->limits,
                       "joint limits, as 'percussionist limits' writes them");
    command.add_option("--start", o->track.start, "where in the clip to begin [s]")
        ->check(CLI::Range(0.0, 1e9));
    command.add_option("--seconds", o->track.seconds, "how much of it to follow [s]")
        ->check(CLI::Range(0.01, 1e9));
    command.callback([o] { run(*o); });
}

}  // namespace percussionist::app
