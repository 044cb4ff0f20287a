#include "core/listening/network.hpp"

#include <doctest/doctest.h>

#include <array>
#include <stdexcept>

#include "core/listening/network_training.hpp"

using namespace percussionist::listening;

namespace {

/// Two inputs; whether one of them, and whether exactly one of them, is above 0.
Examples exclusive_or(Eigen::Index count) {
    practice::Dice dice(3);
    Examples all{Eigen::MatrixXf(2, count), Eigen::MatrixXf(2, count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index k = 0; k < 2; ++k)
            all.inputs(k, i) = static_cast<float>(5.0 + 3.0 * dice.normal());
        const bool a = all.inputs(0, i) > 5.0F, b = all.inputs(1, i) > 5.0F;
        all.targets(0, i) = a || b ? 1.0F : 0.0F;
        all.targets(1, i) = a != b ? 1.0F : 0.0F;
    }
    return all;
}

Network learnt(std::uint64_t seed) {
    practice::Dice dice(seed);
    return train(
        exclusive_or(4000),
        {.hidden = {16, 8}, .epochs = 20, .rate = 5e-3, .dropped = 0.0F, .dropped_inputs = 0.0F},
        dice);
}

}  // namespace

TEST_CASE("a network learns what no weighted sum can tell") {
    Network network = learnt(5);
    int right = 0;
    const Examples asked = exclusive_or(1000);
    for (Eigen::Index i = 0; i < 1000; ++i) {
        const auto odds = network.evaluate({asked.inputs.col(i).data(), 2});
        right += (odds[0] > 0.0F) == (asked.targets(0, i) > 0.5F) &&
                 (odds[1] > 0.0F) == (asked.targets(1, i) > 0.5F);
    }
    CHECK(right > 900);
}

TEST_CASE("the same examples and dice make the same network") {
    const Network one = learnt(6), other = learnt(6);
    for (std::size_t l = 0; l < one.layers().size(); ++l) {
        CHECK(one.layers()[l].weights == other.layers()[l].weights);
    }
}

TEST_CASE("layers that do not fit each other are refused") {
    const Layer two_to_three{Eigen::MatrixXf::Zero(3, 2), Eigen::VectorXf::Zero(3)};
    CHECK_THROWS_AS(Network({two_to_three, two_to_three}), std::invalid_argument);
    CHECK_THROWS_AS(Network({{Eigen::MatrixXf::Zero(3, 2), Eigen::VectorXf::Zero(2)}}),
                    std::invalid_argument);
}
