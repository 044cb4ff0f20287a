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
#include <span>
#include <vector>

#include "core/listening/drum_class.hpp"
#include "core/listening/heard.hpp"

namespace percussionist::listening {

/// The first classifier's view of all attacks of a recording: a column for each.
struct FirstJudgement {
    Eigen::MatrixXf odds;          ///< logarithms, a row for each class
    Eigen::MatrixXf descriptions;  ///< Network::description()
};


constexpr std::size_t kContext = 9 * kDrumClasses + 3;

/// A column of kContext numbers for each attack.
Eigen::MatrixXf context_of(const Heard& heard, const FirstJudgement& first);

}  // namespace percussionist::listening
