#include "core/listening/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::listening {

Judgement judge_all(Network& network, const Eigen::MatrixXf& inputs) {
    Judgement all;
    all.odds.resize(static_cast<Eigen::Index>(network.outputs()), inputs.cols());
    all.descriptions.resize(static_cast<Eigen::Index>(network.description().size()), inputs.cols());
    for (Eigen::Index i = 0; i < inputs.cols(); ++i) {
        const auto odds = network.evaluate({inputs.col(i).data(), network.inputs()});
        const auto description = network.description();
        std::copy(odds.begin(), odds.end(), all.odds.col(i).begin());
        std::copy(description.begin(), description.end(), all.descriptions.col(i).begin());
    }
    return all;
}

Verdicts verdicts(const Odds& odds) noexcept {
    Verdicts all;
    for (std::size_t c = 0; c < kDrumClasses; ++c) {
        auto drum = static_cast<DrumClass>(c);
        if (odds[c] < 0.0F || drum == DrumClass::open_hat || drum == DrumClass::crash) continue;
        if (drum == DrumClass::closed_hat && odds[index(DrumClass::open_hat)] >= 0.0F) {
            drum = DrumClass::open_hat;
        }
        if (drum == DrumClass::ride && odds[index(DrumClass::crash)] >= 0.0F) {
            drum = DrumClass::crash;
        }
        all.add({drum, 1.0 / (1.0 + std::exp(-static_cast<double>(odds[c])))});
    }
    return all;
}

}  // namespace percussionist::listening
