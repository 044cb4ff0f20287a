// What was learnt of drums: three networks and where each class's decision lies.
//
//   live    an attack and the 50 ms after it          -> odds of each class
//   first   an attack and the 200 ms after it         -> the same, more surely
//   second  what the recording says of it (context.hpp) -> the same, as surely as can be
//
// Outputs are logarithms of odds in the order of DrumClass, but for closed_hat, which stands for
// any hat: open_hat then tells which. So does ride for any cymbal that rings, and crash tells
// which.
//
// As text a model is a list of quoted lines, so that the compiler can take it in as it is: the
// model the project comes with is learnt_drums.inc, which `percussionist learn-drums` makes.
// Weights have 12 bits each, two characters.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/listening/drum_class.hpp"
#include "core/listening/network.hpp"

namespace percussionist::listening {

using Odds = std::array<float, kDrumClasses>;

struct DrumModel {
    Network live, first, second;
    Odds live_threshold{};  ///< log odds from which a class counts as struck
    Odds second_threshold{};
};

/// The model the project comes with.
DrumModel learnt_drums();

std::string to_text(const DrumModel& model);
/// Throws std::invalid_argument, which says what was expected in which line.
DrumModel model_from_text(std::string_view text);

}  // namespace percussionist::listening
