#include "app/track_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "app/fit_axes.hpp"
#include "files/plot.hpp"
#include "files/text_file.hpp"

namespace percussionist::app {

namespace {

namespace fs = std::filesystem;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMillimetres = 1e3;
constexpr const char* kSides[] = {"left", "right"};
constexpr const char* kJoints[] = {"shoulder", "elbow", "wrist", "grip"};
constexpr const char* kColours[] = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e"};

std::string summary_csv(const std::vector<TrackRun>& runs) {
    std::string text =
        "law,control,stable,lasted_s,tip_rms_mm,tip_worst_mm,asked_tip_rms_mm,asked_tip_worst_mm,"
        "joint_rms_deg,joint_worst_deg,joint_captured_rms_deg,elbow_asked_rms_deg,elbow_rms_deg,"
        "elbow_worst_deg,worst_torque_N_m,computing_s,times_real_time\n";
    for (const TrackRun& r : runs) {
        text += fmt::format(
            "{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.5f},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f},"
            "{:.3f},{:.4f},{:.2f}\n",
            law_name(r.control.law), r.control.name, r.stable ? 1 : 0, r.lasted,
            kMillimetres * r.tip.rms(), kMillimetres * r.tip.worst,
            kMillimetres * r.asked_tip.rms(), kMillimetres * r.asked_tip.worst,
            kDegrees * r.joint.rms(), kDegrees * r.joint.worst, kDegrees * r.joint_captured.rms(),
            kDegrees * r.elbow_asked.rms(), kDegrees * r.elbow.rms(), kDegrees * r.elbow.worst,
            r.worst_torque, r.computing, r.times_real_time());
    }
    return text;
}

std::string series_csv(const TrackRun& run) {
    std::string text = "time_s";
    for (const char* side : kSides) {
        for (const char* what :
             {"captured_x_m", "captured_y_m", "captured_z_m", "tip_x_m", "tip_y_m", "tip_z_m",
              "elbow_captured_deg", "elbow_asked_deg", "elbow_deg"}) {
            text += fmt::format(",{}_{}", side, what);
        }
        for (const char* joint : kJoints) text += fmt::format(",{}_{}_torque_N_m", side, joint);
    }
    text += '\n';
    for (const TrackSample& s : run.samples) {
        text += fmt::format("{:.6f}", s.time);
        for (const TrackSample::Arm& arm : s.arms) {
            for (const auto* v : {&arm.tip_captured, &arm.tip}) {
                text += fmt::format(",{:.6f},{:.6f},{:.6f}", v->x(), v->y(), v->z());
            }
            for (const double angle : {arm.elbow_captured, arm.elbow_asked, arm.elbow}) {
                text += fmt::format(",{:.4f}", kDegrees * angle);
            }
            for (const double torque : arm.torque) text += fmt::format(",{:.4f}", torque);
        }
        text += '\n';
    }
    return text;
}

using Value = std::function<double(const TrackSample&)>;

files::Series line(const std::string& name, const std::string& colour, const TrackRun& run,
                   const Value& x, const Value& y) {
    files::Series out{name, files::Series::Kind::line, colour, {}};
    for (const TrackSample& s : run.samples) out.points.emplace_back(x(s), y(s));
    return out;
}

double time_of(const TrackSample& s) {
    return s.time;
}

/// One chart for a law and a side: what was captured in black, every control in its colour.
files::Chart chart(const std::string& what, const std::string& unit, sim::Law law, int side,
                   const std::vector<TrackRun>& runs, const Value& captured, const Value& of_body) {
    files::Chart plot;
    plot.title = fmt::format("{}, {}, {} law", what, kSides[side], law_name(law));
    plot.x.title = "time [s]";
    plot.y.title = unit;
    std::size_t colour = 0;
    bool first = true;
    for (const TrackRun& run : runs) {
        if (run.control.law != law) continue;
        if (first && captured) {
            plot.series.push_back(line("captured", "black", run, time_of, captured));
            first = false;
        }
        plot.series.push_back(line(run.control.name, kColours[colour++ % std::size(kColours)], run,
                                   time_of, of_body));
    }
    fit_axes(plot);
    return plot;
}

/// Charts for each law and side that there is.
std::vector<files::Chart> charts(const std::string& what, const std::string& unit,
                                 const std::vector<TrackRun>& runs,
                                 const std::function<Value(int)>& captured,
                                 const std::function<Value(int)>& of_body) {
    std::vector<files::Chart> all;
    for (const sim::Law law : {sim::Law::paper, sim::Law::implicit}) {
        for (int side = 0; side < 2; ++side) {
            files::Chart plot = chart(what, unit, law, side, runs,
                                      captured ? captured(side) : Value(), of_body(side));
            if (!plot.series.empty()) all.push_back(std::move(plot));
        }
    }
    return all;
}

/// From the side: the paths of the tips as the body's left sees them.
std::vector<files::Chart> side_views(const std::vector<TrackRun>& runs) {
    std::vector<files::Chart> all;
    for (const sim::Law law : {sim::Law::paper, sim::Law::implicit}) {
        for (int side = 0; side < 2; ++side) {
            const Value x = [side](const TrackSample& s) { return s.arms[side].tip.x(); };
            const Value z = [side](const TrackSample& s) { return s.arms[side].tip.z(); };
            const Value x0 = [side](const TrackSample& s) { return s.arms[side].tip_captured.x(); };
            const Value z0 = [side](const TrackSample& s) { return s.arms[side].tip_captured.z(); };
            files::Chart plot;
            plot.title = fmt::format("tip from the side, {}, {} law", kSides[side], law_name(law));
            plot.x.title = "forwards [m]";
            plot.y.title = "height [m]";
            std::size_t colour = 0;
            for (const TrackRun& run : runs) {
                if (run.control.law != law) continue;
                if (plot.series.empty()) {
                    plot.series.push_back(line("captured", "black", run, x0, z0));
                }
                plot.series.push_back(
                    line(run.control.name, kColours[colour++ % std::size(kColours)], run, x, z));
            }
            fit_axes(plot);
            if (!plot.series.empty()) all.push_back(std::move(plot));
        }
    }
    return all;
}

void write_pictures(const fs::path& folder, const std::vector<TrackRun>& runs) {
    const auto elbow_captured = [](int side) -> Value {
        return [side](const TrackSample& s) { return kDegrees * s.arms[side].elbow_captured; };
    };
    const auto elbow_asked = [](int side) -> Value {
        return [side](const TrackSample& s) { return kDegrees * s.arms[side].elbow_asked; };
    };
    const auto elbow = [](int side) -> Value {
        return [side](const TrackSample& s) { return kDegrees * s.arms[side].elbow; };
    };
    const auto height_captured = [](int side) -> Value {
        return [side](const TrackSample& s) { return s.arms[side].tip_captured.z(); };
    };
    const auto height = [](int side) -> Value {
        return [side](const TrackSample& s) { return s.arms[side].tip.z(); };
    };
    const auto error = [](int side) -> Value {
        return [side](const TrackSample& s) {
            return kMillimetres * (s.arms[side].tip - s.arms[side].tip_captured).norm();
        };
    };
    files::write_svg(folder / "elbow-asked.svg", charts("elbow flexion asked for", "flexion [deg]",
                                                        runs, elbow_captured, elbow_asked));
    files::write_svg(folder / "elbow.svg", charts("elbow flexion of the body", "flexion [deg]",
                                                  runs, elbow_captured, elbow));
    files::write_svg(folder / "tip-height.svg",
                     charts("height of the tip", "height [m]", runs, height_captured, height));
    files::write_svg(folder / "tip-path.svg", side_views(runs));
    files::write_svg(folder / "tip-error.svg",
                     charts("error of the tip", "error [mm]", runs, nullptr, error));
    std::vector<files::Chart> torques;
    for (int joint = 0; joint < 4; ++joint) {
        const auto torque = [joint](int side) -> Value {
            return [side, joint](const TrackSample& s) { return s.arms[side].torque[joint]; };
        };
        for (files::Chart& plot : charts(fmt::format("torque of the {}", kJoints[joint]),
                                         "torque [N m]", runs, nullptr, torque)) {
            torques.push_back(std::move(plot));
        }
    }
    files::write_svg(folder / "torques.svg", torques);
}

}  // namespace

std::string track_table(const std::vector<TrackRun>& runs) {
    std::string text =
        fmt::format("{:<9} {:<10} {:>6} | {:>17} | {:>15} | {:>17} | {:>17} | {:>8} | {:>6}\n",
                    "law", "control", "stable", "tip mm rms  worst", "asked rms worst",
                    "joint deg   worst", "elbow asked  body", "torque", "x real");
    for (const TrackRun& r : runs) {
        text += fmt::format(
            "{:<9} {:<10} {:>6} | {:>8.3f} {:>8.3f} | {:>7.3f} {:>7.2f} | {:>8.4f} {:>8.3f} | "
            "{:>8.3f} {:>8.3f} | {:>8.1f} | {:>6.1f}\n",
            law_name(r.control.law), r.control.name, r.stable ? "yes" : "NO",
            kMillimetres * r.tip.rms(), kMillimetres * r.tip.worst,
            kMillimetres * r.asked_tip.rms(), kMillimetres * r.asked_tip.worst,
            kDegrees * r.joint.rms(), kDegrees * r.joint.worst, kDegrees * r.elbow_asked.rms(),
            kDegrees * r.elbow.rms(), r.worst_torque, r.times_real_time());
    }
    return text;
}

void write_track_report(const fs::path& folder, const LoadedClip& clip, const TrackOptions& options,
                        const std::vector<TrackRun>& runs) {
    fs::create_directories(folder);
    std::string report;
    for (const std::string& remark : clip.report) report += remark + '\n';
    report += fmt::format(
        "steps of {:.3g} ms; gains: ours {:.3g} Hz, damping {:.3g}; the papers' "
        "{:.3g} Hz; masses wrong by {:.0f} %\n\n",
        1e3 / options.rate, options.frequency, options.damping, options.paper_frequency,
        100.0 * options.mass_error);
    report += track_table(runs);
    report +=
        "\ntip: of the body against the one captured; asked: of what inverse kinematics asks\n"
        "for against the one captured; joint: all 19, of the body against what was asked for;\n"
        "elbow: flexion asked for, and of the body, against the one captured, RMS degrees;\n"
        "torque: the largest of an arm's joint, N m; x real: times real time.\n";
    files::write_text(folder / "report.txt", report);
    files::write_text(folder / "summary.csv", summary_csv(runs));
    for (const TrackRun& run : runs) {
        files::write_text(
            folder / fmt::format("{}-{}.csv", law_name(run.control.law), run.control.name),
            series_csv(run));
    }
    write_pictures(folder, runs);
}

}  // namespace percussionist::app
