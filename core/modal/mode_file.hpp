// Mode files: modes as text, one a line, that a person can read and change.
//
//     percussionist modes 1            the format and its version: the first line
//     # what a line begins with is told apart by its first word
//     name bodhran
//     origin computed: a membrane of ...
//     radius 0.22                      [m]
//     places 0 0.2 0.4 0.6 0.8 1       r over radius
//     mode 74.3 0.9 0 1.2 1.1 ...      frequency [Hz], t60 [s], nodal diameters, a weight a place
//     heard 0.8                        by a microphone, of the mode of the line above; may be left
//     out
//
// See given_modes.hpp for what the numbers mean. Numbers are written so that they are read back the
// same. Text in, text out: no file. Both allocate.
#pragma once

#include <string>
#include <string_view>

#include "core/modal/given_modes.hpp"

namespace percussionist::modal {

std::string write_modes(const GivenModes& given);

/// Throws std::invalid_argument naming line and fault, or what check(GivenModes) finds.
GivenModes parse_modes(std::string_view text);

}  // namespace percussionist::modal
