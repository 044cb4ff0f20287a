#include "core/listening/context.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/listening/stroke_features.hpp"

namespace percussionist::listening {

namespace {

using Eigen::ArrayXXf;
using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr auto kClasses = static_cast<Index>(kDrumClasses);
constexpr std::size_t kLike = 6;     ///< attacks most like one, that are asked
constexpr Index kAmong = 1500;       ///< attacks before and after it
constexpr float kStiffness = 0.15F;  ///< of the regression, per attack
constexpr double kGrid = 0.01;       ///< of the rhythm [s]
constexpr double kNear = 0.045;      ///< in time, still at the same place of the bar [s]
constexpr double kLongestGap = 1.0;  ///< told of neighbours [s]

/// Where in the features the levels of a step of kLongSteps begin.
constexpr Index levels_at(std::size_t step) {
    return static_cast<Index>(kLevels + kFloors + kQuickSteps.size() * kQuick +
                              step * (kLevels + kFloors));
}
constexpr Index kBefore = levels_at(1);
constexpr std::array<Index, 3> kAfter = {levels_at(4), levels_at(6), levels_at(8)};

/// The spectrum that each attack adds, two bands together: a column each.
MatrixXf added_spectra(const MatrixXf& features) {
    constexpr auto kBands = static_cast<Index>(kLevels);
    MatrixXf added(kBands / 2 * static_cast<Index>(kAfter.size()), features.cols());
    Index row = 0;
    for (const Index after : kAfter) {
        const MatrixXf rise =
            features.middleRows(after, kBands) - features.middleRows(kBefore, kBands);
        for (Index b = 0; b < kBands; b += 2, ++row) {
            added.row(row) = (0.5F * (rise.row(b) + rise.row(b + 1))).cwiseMax(0.0F).cwiseMin(6.0F);
        }
    }
    return added;
}

void standardise(MatrixXf& rows) {
    for (Index r = 0; r < rows.rows(); ++r) {
        auto row = rows.row(r).array();
        row -= row.mean();
        row /= std::sqrt(row.square().mean() + 0.05F);
    }
}

/// The judgements as this recording's sounds explain them.
MatrixXf explained(const MatrixXf& sounds, const MatrixXf& chances) {
    const VectorXf usual = chances.rowwise().mean();
    MatrixXf covariance = sounds * sounds.transpose();
    covariance.diagonal().array() += kStiffness * static_cast<float>(sounds.cols()) + 1.0F;
    const MatrixXf weights =
        covariance.ldlt().solve(sounds * (chances.colwise() - usual).transpose());
    return (weights.transpose() * sounds).colwise() + usual;
}

/// The mean judgement of the attacks most like each.
MatrixXf of_the_alike(const MatrixXf& sounds, const MatrixXf& chances) {
    const Index count = sounds.cols();
    MatrixXf mean = MatrixXf::Zero(kClasses, count);
    std::vector<Index> order;
    VectorXf distance(count);
    for (Index i = 0; i < count; ++i) {
        const Index first = std::max<Index>(i - kAmong, 0);
        const Index size = std::min(i + kAmong + 1, count) - first;
        distance.segment(first, size) =
            (sounds.middleCols(first, size).colwise() - sounds.col(i)).colwise().squaredNorm();
        order.resize(static_cast<std::size_t>(size));
        std::iota(order.begin(), order.end(), first);
        const std::size_t asked = std::min(kLike + 1, order.size());
        std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(asked),
                          order.end(), [&](Index a, Index b) {
                              return distance(a) != distance(b) ? distance(a) < distance(b) : a < b;
                          });
        for (std::size_t k = 0; k < asked; ++k) {
            if (order[k] != i)
                mean.col(i) +=
                    chances.col(order[k]) / static_cast<float>(std::max<std::size_t>(asked - 1, 1));
        }
    }
    return mean;
}

class Rhythm {
  public:
    Rhythm(const std::vector<double>& times, const MatrixXf& chances)
        : times_(times), chances_(chances) {
        const double end = times.empty() ? 0.0 : times.back();
        pulses_ = ArrayXXf::Zero(kClasses, static_cast<Index>(end / kGrid) + 8);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const auto at = static_cast<Index>(std::lround(times[i] / kGrid));
            for (Index spread = -2; spread <= 2; ++spread) {
                if (at + spread < 0) continue;
                const float share = 1.0F - 0.3F * static_cast<float>(std::abs(spread));
                auto column = pulses_.col(at + spread);
                column = column.max(share * chances.col(static_cast<Index>(i)).array());
            }
        }
    }

    /// The lag between two at which the judgements repeat best [s].
    [[nodiscard]] double best_lag(double shortest, double longest) const {
        double best = shortest;
        float most = -1.0F;
        for (auto lag = static_cast<Index>(shortest / kGrid);
             static_cast<double>(lag) * kGrid <= longest && lag < pulses_.cols(); ++lag) {
            const Index size = pulses_.cols() - lag;
            const float sum = (pulses_.leftCols(size) * pulses_.rightCols(size)).sum() /
                              (static_cast<float>(size) + 200.0F);
            if (sum > most) {
                most = sum;
                best = static_cast<double>(lag) * kGrid;
            }
        }
        return best;
    }

    /// The mean of what is judged `lag` before and after each attack.
    [[nodiscard]] MatrixXf around(double lag) const {
        MatrixXf mean = MatrixXf::Zero(kClasses, chances_.cols());
        for (std::size_t i = 0; i < times_.size(); ++i) {
            for (const double at : {times_[i] - lag, times_[i] + lag}) {
                mean.col(static_cast<Index>(i)) += 0.5F * judged_at(at);
            }
        }
        return mean;
    }

  private:
    [[nodiscard]] VectorXf judged_at(double time) const {
        VectorXf most = VectorXf::Zero(kClasses);
        auto it = std::lower_bound(times_.begin(), times_.end(), time - kNear);
        for (; it != times_.end() && *it <= time + kNear; ++it) {
            most = most.cwiseMax(chances_.col(it - times_.begin()));
        }
        return most;
    }

    const std::vector<double>& times_;
    const MatrixXf& chances_;
    ArrayXXf pulses_;
};

float quantile(Eigen::RowVectorXf values, double part) {
    auto* nth = values.data() + static_cast<Index>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.data(), nth, values.data() + values.size());
    return *nth;
}

}  // namespace

Eigen::MatrixXf context_of(const Evidence& evidence, const Judgement& first) {
    const auto count = static_cast<Index>(evidence.times.size());
    MatrixXf context = MatrixXf::Zero(static_cast<Index>(kContext), count);
    if (count == 0) return context;
    const MatrixXf odds = first.odds.cwiseMax(-8.0F).cwiseMin(8.0F);
    const MatrixXf chances = 1.0F / (1.0F + (-odds.array()).exp());
    const std::vector<double>& times = evidence.times;

    MatrixXf sounds = added_spectra(evidence.features);
    MatrixXf described(sounds.rows() + first.descriptions.rows(), count);
    described << sounds, first.descriptions;
    standardise(described);
    standardise(sounds);
    const Rhythm rhythm(times, chances);

    context.middleRows(0, kClasses) = odds;
    context.middleRows(kClasses, kClasses) = explained(described, chances);
    context.middleRows(2 * kClasses, kClasses) = of_the_alike(sounds, chances);
    context.middleRows(3 * kClasses, kClasses) = rhythm.around(rhythm.best_lag(0.25, 0.9));
    context.middleRows(4 * kClasses, kClasses) = rhythm.around(rhythm.best_lag(0.9, 4.0));
    const VectorXf usual = chances.rowwise().mean();
    for (Index i = 0; i < count; ++i) {
        const Index before = std::max<Index>(i - 1, 0);
        const Index after = std::min(i + 1, count - 1);
        const auto n = static_cast<std::size_t>(i);
        context.col(i).segment(5 * kClasses, kClasses) = chances.col(before);
        context.col(i).segment(6 * kClasses, kClasses) = chances.col(after);
        context.col(i).segment(7 * kClasses, kClasses) = usual;
        context(9 * kClasses, i) = static_cast<float>(
            std::min(times[n] - times[static_cast<std::size_t>(before)], kLongestGap));
        context(9 * kClasses + 1, i) = static_cast<float>(
            std::min(times[static_cast<std::size_t>(after)] - times[n], kLongestGap));
        context(9 * kClasses + 2, i) = evidence.strengths[n];
    }
    for (Index k = 0; k < kClasses; ++k)
        context.row(8 * kClasses + k).setConstant(quantile(odds.row(k), 0.95));
    return context;
}

}  // namespace percussionist::listening
