// Kit files: a drum kit as text, a line a thing, that a person reads and edits.
//
//     percussionist kit 1            the format and its version: the first line
//     # what follows this sign is no part of the line
//     drummer stature 1.75 hips 0.60
//     object snare drum at 0.46 0.06 0.66 tilt 4 0 radius 0.178 depth 0.14 sound snare
//     pedal kick right-foot heel 0.42 -0.17 0.03 direction 0 down 3 up 20
//     event snare on snare spot -0.02 0 apart 0.05 prefers left elasticity 0.6
//     key 38 40 snare
//     pair closed-hat snare right crossed      the right hand takes the first; arms may cross
//     script wrist down 0 0.02 0.1 0.4 1
//     pose right-hand ride down elbow 10 -20 5
//
// A line is a word, its names, then fields in any order: a word and its numbers. Metres, kilograms,
// seconds; angles in degrees. In a pair the name of an object stands for all that hands play on it.
// See core/score/kit.hpp for what the fields mean, kits/standard.kit for a whole kit.
//
// Text in, values out; both allocate, neither touches a file but for read_kit_file().
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/score/kit.hpp"

namespace percussionist::files {

/// what(): "my.kit: line 12: expected a number after 'radius', found 'wide'"
struct KitError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// `name` is what errors call the file. Throws KitError.
score::Kit parse_kit(std::string_view text, std::string_view name);
/// Throws KitError, also for a file that cannot be opened or is above 1 MB.
score::Kit read_kit_file(const std::filesystem::path& path);

/// The kit that comes with the program: kits/standard.kit.
score::Kit standard_kit();
/// The text of it.
std::string_view standard_kit_text();

/// "wrist down 0 0.02 0.1 0.4 1": a script without its word. Throws KitError.
score::Script parse_script(std::string_view text);
/// The lines that say the kit's scripts.
std::string script_lines(const score::Kit& kit);

/// The lines that say `poses`, to be added to a kit file.
std::string pose_lines(const score::Kit& kit, const std::vector<score::PoseEdit>& poses);

}  // namespace percussionist::files
