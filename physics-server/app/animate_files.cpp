#include "app/animate_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace percussionist::app {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::array<score::Limb, 4> kLimbs{score::Limb::left_hand, score::Limb::right_hand,
                                            score::Limb::left_foot, score::Limb::right_foot};

}  // namespace

std::string strokes_csv(const score::Kit& kit, const score::Score& score,
                        const std::vector<score::KitStroke>& strokes,
                        const std::vector<body::StrokeCheck>& checks) {
    std::string text =
        "time_s,bar,beat,key,event,object,limb,velocity,bounced,reason,off_mm,early_ms\n";
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const score::KitStroke& s = strokes[i];
        const score::Note& note = score.notes[s.note];
        text += fmt::format("{:.6f},{},{:.3f},{},{},{},{},{:.3f},{},{},{:.3f},{:.1f}\n", s.time,
                            note.position.bar, note.position.beat, note.instrument,
                            kit.events[s.event].name, kit.object_of(s.event).name,
                            score::name(s.limb), s.velocity, s.bounces ? 1 : 0,
                            score::kReasonNames[static_cast<std::size_t>(s.reason)],
                            1e3 * checks[i].off, 1e3 * checks[i].early);
    }
    return text;
}

void write_keys(const std::filesystem::path& path, const body::KitAnimation& animation) {
    std::ofstream out(path, std::ios::binary);
    out << "time_s,limb,kind,joint,z_deg,y_deg,x_deg\n";
    for (const score::Limb limb : kLimbs) {
        const std::vector<int>& parts = animation.poses().parts(limb).segments;
        for (const body::KeyFrame& key : animation.motion(limb).keys()) {
            for (std::size_t j = 0; j < parts.size(); ++j) {
                const body::Vector3 angles = kDegrees * body::euler_zyx(key.pose[j]);
                out << fmt::format(
                    "{:.6f},{},{},{},{:.3f},{:.3f},{:.3f}\n", key.time, score::name(limb),
                    body::kKeyKindNames[static_cast<std::size_t>(key.kind)],
                    animation.skeleton().segments[parts[j]].joint, angles[0], angles[1], angles[2]);
            }
        }
    }
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

ObjectsWriter::ObjectsWriter(const std::filesystem::path& path, const score::Kit& kit)
    : path_(path), out_(path, std::ios::binary), kit_(kit) {
    out_ << "time_s";
    for (std::size_t o = 0; o < kit.objects.size(); ++o) {
        const std::string& name = kit.objects[o].name;
        out_ << fmt::format(",{0}_flash,{0}_x_deg,{0}_y_deg,{0}_z_deg,{0}_lift_m", name);
        if (has_pedal(o)) out_ << fmt::format(",{0}_pedal,{0}_beater_deg", name);
    }
    out_ << '\n';
}

bool ObjectsWriter::has_pedal(std::size_t object) const {
    return std::any_of(kit_.pedals.begin(), kit_.pedals.end(),
                       [object](const score::Pedal& p) { return p.object == object; });
}

void ObjectsWriter::add(double time, const std::vector<body::ObjectState>& states) {
    std::string line = fmt::format("{:.6f}", time);
    for (std::size_t o = 0; o < states.size(); ++o) {
        const body::ObjectState& s = states[o];
        const body::Vector3 turn = kDegrees * s.turn;
        line += fmt::format(",{:.3f},{:.3f},{:.3f},{:.3f},{:.4f}", s.flash, turn.x(), turn.y(),
                            turn.z(), s.lift);
        if (has_pedal(o)) line += fmt::format(",{:.4f},{:.3f}", s.pedal, kDegrees * s.beater);
    }
    out_ << line << '\n';
}

void ObjectsWriter::finish() {
    if (!out_.flush()) throw std::runtime_error(path_.string() + ": could not be written");
}

}  // namespace percussionist::app
