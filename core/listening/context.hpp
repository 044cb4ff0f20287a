// What a recording says of each of its attacks: the second hearing.
//
// The first classifier judges each attack by itself. But the strokes of one drum sound alike
// through a piece, and they come back bar after bar. So, per attack and class, beside the first
// judgement:
//   - what this recording's own drums say: the judgements explained by ridge regression on what the
//     attacks sound like, in this recording alone; a stroke that sounds like the sure ones gains;
//   - what the attacks most like it are, by the spectrum that they add;
//   - what stands a beat and a bar before and after, at the lags at which the judgements repeat;
//   - the attacks right before and after, and how common each class is here.
// A second network, learnt on practice pieces as the first one is, weighs all that.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "core/listening/drum_class.hpp"
#include "core/listening/evidence.hpp"
#include "core/listening/judgement.hpp"

namespace percussionist::listening {

constexpr std::size_t kContext = 9 * kDrumClasses + 3;

/// A column of kContext numbers for each attack.
Eigen::MatrixXf context_of(const Evidence& evidence, const Judgement& first);

}  // namespace percussionist::listening
