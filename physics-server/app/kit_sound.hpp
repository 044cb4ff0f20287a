// The sound of a kit: every object a modal voice, struck where and as hard as the drummer does.
//
// A drum is a membrane, a cymbal a plate, out of what the program's drum of that name is made of
// and of the object's own size; or the modes of a file. Each object is brought to one loudness: a
// stroke of velocity 0.8 peaks at a quarter of full scale times its level. Wires under a snare
// drum rattle while the head moves: noise with the head's envelope. Seen from the drummer, objects
// to his left are heard to the left.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "core/modal/resonator.hpp"
#include "core/score/kit_plan.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

struct KitSoundOptions {
    int rate = 48000;              ///< [Hz]
    double duration = 0.0;         ///< [s]
    std::filesystem::path folder;  ///< where mode files that the kit names are
};

/// What each object of a kit is made of: its 64 lowest modes, enough for what a stick feels. Throws
/// as kit_sound().
std::vector<modal::Resonator> kit_bodies(const score::Kit& kit,
                                         const std::filesystem::path& folder);

/// Stereo. Throws std::runtime_error naming the object whose sound is none. `progress` hears from 0
/// to 1.
files::Audio kit_sound(
    const score::Kit& kit, std::span<const score::KitStroke> strokes,
    const KitSoundOptions& options, const std::function<void(double)>& progress = [](double) {});

}  // namespace percussionist::app
