#include "core/listening/network_training.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace percussionist::listening {

namespace {

using Eigen::ArrayXXf;
using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

/// Fast chance for noise and dropping, where millions are thrown.
class QuickDice {
  public:
    explicit QuickDice(std::uint64_t seed) : state_(seed | 1U) {}
    float uniform() {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return static_cast<float>(state_ >> 40U) * 0x1p-24F;
    }

  private:
    std::uint64_t state_;
};

/// Adam's memory of one array of parameters.
struct Momentum {
    ArrayXXf first, second;

    template <class Parameters>
    void step(Parameters& parameters, const MatrixXf& gradient, float rate, int count) {
        constexpr float kFirst = 0.9F, kSecond = 0.999F;
        if (first.size() == 0) {
            first = ArrayXXf::Zero(gradient.rows(), gradient.cols());
            second = first;
        }
        first += (1.0F - kFirst) * (gradient.array() - first);
        second += (1.0F - kSecond) * (gradient.array().square() - second);
        const float scale = rate * std::sqrt(1.0F - std::pow(kSecond, static_cast<float>(count))) /
                            (1.0F - std::pow(kFirst, static_cast<float>(count)));
        parameters.array() -= scale * first / (second.sqrt() + 1e-7F);
    }
};

class Trainer {
  public:
    Trainer(const Examples& examples, const TrainingOptions& options, practice::Dice& dice)
        : examples_(examples), options_(options), dice_(dice), quick_(dice.seed()) {
        mean_ = examples.inputs.rowwise().mean();
        const MatrixXf centred_square = (examples.inputs.colwise() - mean_).array().square();
        deviation_ = (centred_square.rowwise().mean().array() + 1e-4F).sqrt();
        std::vector<Index> sizes = {examples.inputs.rows()};
        sizes.insert(sizes.end(), options.hidden.begin(), options.hidden.end());
        sizes.push_back(examples.targets.rows());
        for (std::size_t l = 0; l + 1 < sizes.size(); ++l) {
            layers_.push_back({MatrixXf(sizes[l + 1], sizes[l]), VectorXf::Zero(sizes[l + 1])});
            const double scale = std::sqrt(2.0 / static_cast<double>(sizes[l]));
            for (float& w : layers_.back().weights.reshaped())
                w = static_cast<float>(scale * dice.normal());
        }
        momenta_.resize(2 * layers_.size());
        order_.resize(static_cast<std::size_t>(examples.inputs.cols()));
        std::iota(order_.begin(), order_.end(), 0);
    }

    double epoch(double done) {
        for (std::size_t i = order_.size(); i > 1; --i)
            std::swap(order_[i - 1], order_[dice_.whole(i)]);
        double loss = 0.0;
        const Index count = examples_.inputs.cols();
        for (Index at = 0; at + options_.batch <= count; at += options_.batch) {
            const double progress =
                done + static_cast<double>(at) / static_cast<double>(count) / options_.epochs;
            const auto rate = static_cast<float>(options_.rate * 0.5 *
                                                 (1.0 + std::cos(std::numbers::pi * progress)));
            loss += step(at, rate);
        }
        return loss / static_cast<double>(count);
    }

    [[nodiscard]] Network network() const {
        std::vector<Layer> layers = layers_;
        Layer& first = layers.front();
        first.weights = first.weights * deviation_.cwiseInverse().asDiagonal();
        first.bias -= first.weights * mean_;
        return Network(std::move(layers));
    }

  private:
    void gather(Index at) {
        input_.resize(examples_.inputs.rows(), options_.batch);
        target_.resize(examples_.targets.rows(), options_.batch);
        for (Index i = 0; i < options_.batch; ++i) {
            const Index from = order_[static_cast<std::size_t>(at + i)];
            input_.col(i) = (examples_.inputs.col(from) - mean_).cwiseQuotient(deviation_);
            target_.col(i) = examples_.targets.col(from);
        }
        for (float& x : input_.reshaped()) {
            const float chance = quick_.uniform();
            x = chance < options_.dropped_inputs
                    ? 0.0F
                    : x + options_.noise * 3.46F * (quick_.uniform() - 0.5F);
        }
    }

    double step(Index at, float rate) {
        gather(at);
        std::vector<MatrixXf> values = {input_};
        std::vector<MatrixXf> masks;
        for (std::size_t l = 0; l < layers_.size(); ++l) {
            MatrixXf next = (layers_[l].weights * values.back()).colwise() + layers_[l].bias;
            if (l + 1 < layers_.size()) {
                MatrixXf mask(next.rows(), next.cols());
                const float kept = 1.0F / (1.0F - options_.dropped);
                for (float& m : mask.reshaped())
                    m = quick_.uniform() < options_.dropped ? 0.0F : kept;
                mask.array() *= (next.array() > 0.0F).cast<float>();
                next.array() *= mask.array();
                masks.push_back(std::move(mask));
            }
            values.push_back(std::move(next));
        }
        const ArrayXXf odds = values.back().array();
        const ArrayXXf learnt = (target_.array() >= 0.0F).cast<float>();
        const ArrayXXf probability = 1.0F / (1.0F + (-odds).exp());
        const double loss = (learnt * (odds.max(0.0F) - odds * target_.array() +
                                       (1.0F + (-odds.abs()).exp()).log()))
                                .sum();
        MatrixXf gradient =
            learnt * (probability - target_.array()) / static_cast<float>(options_.batch);
        ++steps_;
        for (std::size_t l = layers_.size(); l-- > 0;) {
            const MatrixXf by_weights = gradient * values[l].transpose();
            const MatrixXf by_bias = gradient.rowwise().sum();
            MatrixXf below;
            if (l > 0)
                below = (layers_[l].weights.transpose() * gradient).array() * masks[l - 1].array();
            layers_[l].weights *= 1.0F - options_.decay * rate / static_cast<float>(options_.rate);
            momenta_[2 * l].step(layers_[l].weights, by_weights, rate, steps_);
            momenta_[2 * l + 1].step(layers_[l].bias, by_bias, rate, steps_);
            gradient = std::move(below);
        }
        return loss;
    }

    const Examples& examples_;
    const TrainingOptions& options_;
    practice::Dice& dice_;
    QuickDice quick_;
    VectorXf mean_, deviation_;
    std::vector<Layer> layers_;
    std::vector<Momentum> momenta_;
    std::vector<Index> order_;
    MatrixXf input_, target_;
    int steps_ = 0;
};

}  // namespace

Network train(const Examples& examples, const TrainingOptions& options, practice::Dice& dice,
              const std::function<void(double, double)>& progress) {
    Trainer trainer(examples, options, dice);
    for (int epoch = 0; epoch < options.epochs; ++epoch) {
        const double loss = trainer.epoch(static_cast<double>(epoch) / options.epochs);
        if (progress) progress(static_cast<double>(epoch + 1) / options.epochs, loss);
    }
    return trainer.network();
}

}  // namespace percussionist::listening
