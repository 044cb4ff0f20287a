#include "core/listening/network.hpp"

#include <stdexcept>
#include <utility>

namespace percussionist::listening {

namespace {

std::span<const float> view(const Eigen::VectorXf& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
}

}  // namespace

Network::Network(std::vector<Layer> layers) : layers_(std::move(layers)) {
    for (std::size_t l = 0; l < layers_.size(); ++l) {
        const Layer& layer = layers_[l];
        if (layer.bias.size() != layer.weights.rows() ||
            (l > 0 && layer.weights.cols() != layers_[l - 1].weights.rows())) {
            throw std::invalid_argument("network: layers that do not fit each other");
        }
        values_.emplace_back(Eigen::VectorXf::Zero(layer.bias.size()));
    }
}

std::size_t Network::inputs() const {
    return layers_.empty() ? 0 : static_cast<std::size_t>(layers_.front().weights.cols());
}

std::size_t Network::outputs() const {
    return layers_.empty() ? 0 : static_cast<std::size_t>(layers_.back().weights.rows());
}

std::span<const float> Network::evaluate(std::span<const float> input) noexcept {
    for (std::size_t l = 0; l < layers_.size(); ++l) {
        Eigen::VectorXf& out = values_[l];
        out = layers_[l].bias;
        if (l == 0) {
            const Eigen::Map<const Eigen::VectorXf> x(input.data(),
                                                      static_cast<Eigen::Index>(input.size()));
            out.noalias() += layers_[l].weights * x;
        } else {
            out.noalias() += layers_[l].weights * values_[l - 1];
        }
        if (l + 1 < layers_.size()) out = out.cwiseMax(0.0F);
    }
    return view(values_.back());
}

std::span<const float> Network::description() const noexcept {
    return view(values_[values_.size() - 2]);
}

}  // namespace percussionist::listening
