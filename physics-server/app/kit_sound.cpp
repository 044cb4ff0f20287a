#include "app/kit_sound.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

#include "core/modal/drum_set.hpp"
#include "core/modal/modal_drum.hpp"
#include "core/modal/mode_file.hpp"
#include "core/score/stroke_plan.hpp"
#include "files/text_lines.hpp"

namespace percussionist::app {

namespace {

using score::KitObject;
using score::KitStroke;

constexpr std::size_t kModesOfDrum = 160;
constexpr std::size_t kModesOfPlate = 700;
constexpr std::uintmax_t kLargestModeFile = 4'000'000;
constexpr double kReference = 0.8;  // velocity of the stroke that loudness is told by
constexpr double kPeak = 0.25;

modal::DrumSettings settings_of(const KitObject& object, const std::filesystem::path& folder) {
    modal::DrumSettings settings;
    if (object.sound.ends_with(".modes")) {
        settings.body = modal::parse_modes(
            files::read_text<std::runtime_error>(folder / object.sound, kLargestModeFile));
        std::get<modal::GivenModes>(settings.body).radius = object.radius;
    } else {
        const modal::DrumOfSet& drum = modal::drum_of_set(object.sound);
        settings.body = drum.body;
        settings.loss = drum.loss;
        if (auto* membrane = std::get_if<modal::Membrane>(&settings.body)) {
            membrane->radius = object.radius;
        } else if (auto* plate = std::get_if<modal::Plate>(&settings.body)) {
            plate->radius = object.radius;
        }
    }
    const bool plate = std::holds_alternative<modal::Plate>(settings.body);
    settings.choice.count = plate ? kModesOfPlate : kModesOfDrum;
    settings.pickups[0].r = 0.6 * object.radius;
    settings.pickups[0].theta = 0.0;
    return settings;
}

modal::Stroke stroke_of(const score::Kit& kit, const KitStroke& stroke) {
    const score::KitEvent& event = kit.events[stroke.event];
    const double side = stroke.limb == score::Limb::left_hand    ? 0.5
                        : stroke.limb == score::Limb::right_hand ? -0.5
                                                                 : 0.0;
    const double left = event.left + side * event.apart;
    modal::Stroke s;
    s.velocity = score::impact_speed(stroke.velocity);
    s.r = std::hypot(event.forward, left);
    s.theta = std::atan2(left, event.forward);
    s.mallet.mass = event.mass;
    s.mallet.stiffness = event.stiffness;
    return s;
}

/// Snare wires: noise that is as loud as the head moves.
class Wires {
  public:
    Wires(double amount, int rate) : amount_(amount), falls_(std::exp(-1.0 / (kFall * rate))) {}
    double rattle(double head) {
        envelope_ = std::max(std::abs(head), envelope_ * falls_);
        state_ = state_ * 1664525U + 1013904223U;
        const double noise = static_cast<double>(state_) / 2147483648.0 - 1.0;
        const double bright = noise - last_noise_;
        last_noise_ = noise;
        return amount_ * envelope_ * bright;
    }

  private:
    static constexpr double kFall = 0.035;  // [s]
    double amount_, falls_;
    double envelope_ = 0.0, last_noise_ = 0.0;
    std::uint32_t state_ = 1;
};

/// One object's sound over the piece.
class Voice {
  public:
    Voice(const score::Kit& kit, std::size_t object, const KitSoundOptions& options)
        : kit_(kit),
          object_(kit.objects[object]),
          rate_(options.rate),
          settings_(settings_of(object_, options.folder)),
          drum_(settings_, rate_),
          wires_(object_.wires, rate_) {
        const double side = std::clamp(object_.middle.y() / kWide, -1.0, 1.0);
        const double angle = 0.25 * std::numbers::pi * (1.0 - kSpread * side);
        pan_ = {std::cos(angle), std::sin(angle)};
    }

    /// Adds the strokes, all of this object, to the stereo samples.
    void play(std::span<const KitStroke> strokes, std::vector<double>& stereo) {
        if (strokes.empty()) return;
        const double gain = gain_of(strokes.front());
        const std::size_t size = stereo.size() / 2;
        std::size_t at = 0;
        for (const KitStroke& stroke : strokes) {
            const auto start =
                static_cast<std::size_t>(std::llround(std::max(0.0, stroke.time) * rate_));
            ring(at, std::min(start, size), gain, stereo);
            at = std::min(std::max(at, start), size);
            if (start >= size) break;
            strike(stroke);
        }
        ring(at, size, gain, stereo);
    }

  private:
    static constexpr double kWide = 0.7;    ///< [m]
    static constexpr double kSpread = 0.7;  ///< of the way to hard left
    static constexpr std::size_t kBlock = 256;

    void strike(const KitStroke& stroke) {
        drum_.strike(0, stroke_of(kit_, stroke));
        damp_ = kit_.events[stroke.event].t60;
    }

    /// A stroke's damping holds from its first sample on.
    void ring(std::size_t from, std::size_t to, double gain, std::vector<double>& stereo) {
        if (from >= to) return;
        std::size_t at = from;
        if (damp_ > 0.0) {
            add(at, 1, gain, stereo);
            ++at;
            drum_.mute(damp_);
            damp_ = 0.0;
        }
        for (; at < to; at += kBlock) {
            if (drum_.silent()) return;
            add(at, std::min(kBlock, to - at), gain, stereo);
        }
    }

    void add(std::size_t at, std::size_t size, double gain, std::vector<double>& stereo) {
        block_.resize(size);
        drum_.process(std::span(block_));
        for (std::size_t i = 0; i < size; ++i) {
            double sample = gain * block_[i];
            if (object_.wires > 0.0) sample += wires_.rattle(sample);
            stereo[2 * (at + i)] += pan_[0] * sample;
            stereo[2 * (at + i) + 1] += pan_[1] * sample;
        }
    }

    /// What brings the reference stroke to its peak.
    double gain_of(const KitStroke& like) {
        modal::ModalDrum drum(settings_, rate_);
        KitStroke reference = like;
        reference.velocity = kReference;
        drum.strike(0, stroke_of(kit_, reference));
        std::vector<double> sound(static_cast<std::size_t>(0.25 * rate_));
        drum.process(std::span(sound));
        double peak = 1e-9;
        for (const double sample : sound) peak = std::max(peak, std::abs(sample));
        return object_.level * kPeak / peak;
    }

    const score::Kit& kit_;
    const KitObject& object_;
    int rate_;
    modal::DrumSettings settings_;
    modal::ModalDrum drum_;
    Wires wires_;
    std::array<double, 2> pan_{};
    double damp_ = 0.0;  ///< t60 to be set after the next sample [s]; 0: none
    std::vector<double> block_;
};

}  // namespace

std::vector<modal::Resonator> kit_bodies(const score::Kit& kit,
                                         const std::filesystem::path& folder) {
    constexpr std::size_t kModes = 64;
    std::vector<modal::Resonator> bodies;
    for (const KitObject& object : kit.objects) {
        try {
            const modal::DrumSettings settings = settings_of(object, folder);
            bodies.emplace_back(settings.body, settings.loss, modal::Choice{.count = kModes});
        } catch (const std::exception& fault) {
            throw std::runtime_error("the sound of " + object.name + ": " + fault.what());
        }
    }
    return bodies;
}

files::Audio kit_sound(const score::Kit& kit, std::span<const KitStroke> strokes,
                       const KitSoundOptions& options,
                       const std::function<void(double)>& progress) {
    files::Audio audio;
    audio.rate = options.rate;
    audio.channels = 2;
    audio.samples.assign(2 * static_cast<std::size_t>(std::ceil(options.duration * options.rate)),
                         0.0);
    for (std::size_t o = 0; o < kit.objects.size(); ++o) {
        std::vector<KitStroke> own;
        std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(own),
                     [&](const KitStroke& s) { return kit.events[s.event].object == o; });
        try {
            Voice(kit, o, options).play(own, audio.samples);
        } catch (const std::exception& fault) {
            throw std::runtime_error("the sound of " + kit.objects[o].name + ": " + fault.what());
        }
        progress(static_cast<double>(o + 1) / static_cast<double>(kit.objects.size()));
    }
    return audio;
}

}  // namespace percussionist::app
