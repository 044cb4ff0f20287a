// Learning a network from examples: stochastic gradient descent on the cross entropy.
//
// Inputs are brought to mean 0 and deviation 1 first; the network that comes out has that folded
// into its first layer. Hidden values are dropped by chance while learning, so that none relies on
// another. Source of the step: Kingma, Ba 2015 (Adam). Deterministic: the dice decide.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/listening/network.hpp"
#include "core/listening/practice/dice.hpp"

namespace percussionist::listening {

struct Examples {
    Eigen::MatrixXf inputs;   ///< a column for each
    Eigen::MatrixXf targets;  ///< 0 to 1; below 0: not to be learnt from
};

struct TrainingOptions {
    std::vector<Eigen::Index> hidden = {64, 32};
    int epochs = 30;
    Eigen::Index batch = 128;
    double rate = 1.5e-3;  ///< of the first step; falls to nothing
    float dropped = 0.2F;  ///< share of hidden values
    float dropped_inputs = 0.05F;
    float noise = 0.1F;   ///< added to inputs, of their deviation
    float decay = 1e-4F;  ///< of weights, each step, times the rate's share
};

/// progress(done, loss) after each epoch, done from 0 to 1.
Network train(const Examples& examples, const TrainingOptions& options, practice::Dice& dice,
              const std::function<void(double, double)>& progress = {});

}  // namespace percussionist::listening
