// Whether what was recorded is what was played: the onsets heard in a recording against the times
// that the score asked for.
#pragma once

#include <filesystem>
#include <string>

namespace percussionist::app {

struct SoundCheck {
    int strokes = 0;      ///< asked for, as far as they made a contact
    int alone = 0;        ///< of them those with no other within 30 ms, which might cover it
    int heard = 0;        ///< of those alone, whose onset was found
    double offset = 0.0;  ///< from the score's time to the recording's, the constant part [s]
    double median_error = 0.0, worst_error = 0.0;  ///< of |heard - asked - offset| [s]
    double peak = 0.0;                             ///< largest magnitude
    bool finite = true;                            ///< no NaN, no infinity
};

/// Throws std::runtime_error naming the file that cannot be read or understood.
SoundCheck check_sound(const std::filesystem::path& recording,
                       const std::filesystem::path& contacts_csv);

/// In words, a few lines.
std::string describe(const SoundCheck& check);

}  // namespace percussionist::app
