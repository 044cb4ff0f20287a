// A small network of layers, each a weighted sum and a threshold: evaluated, not learnt, here.
//
//     h = max(0, W1 x + b1), ...,  p = 1 / (1 + exp(-(Wn h + bn)))
//
// Each output is a probability of its own: drums sound together. Learning is network_training.hpp.
//
// evaluate() does not allocate or throw; one thread at a time.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::listening {

struct Layer {
    Eigen::MatrixXf weights;  ///< a row for each output
    Eigen::VectorXf bias;
};

class Network {
  public:
    Network() = default;
    /// Throws std::invalid_argument where a layer does not fit the one before it.
    explicit Network(std::vector<Layer> layers);

    [[nodiscard]] std::size_t inputs() const;
    [[nodiscard]] std::size_t outputs() const;
    [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }

    /// The outputs before they become probabilities: logarithms of odds. Valid until the next call.
    std::span<const float> evaluate(std::span<const float> input) noexcept;

    /// What the layer before the last says: a description of the input. Valid until the next call.
    [[nodiscard]] std::span<const float> description() const noexcept;

  private:
    std::vector<Layer> layers_;
    std::vector<Eigen::VectorXf> values_;
};

}  // namespace percussionist::listening
