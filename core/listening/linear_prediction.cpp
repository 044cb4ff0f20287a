#include "core/listening/linear_prediction.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace percussionist::listening {

namespace {

using Matrix = Eigen::Matrix<double, kPredictionOrder + 1, kPredictionOrder + 1>;

/// x[n - k] before the signal's start is 0.
double past(std::span<const double> x, std::size_t n, std::size_t k) {
    return n < k ? 0.0 : x[n - k];
}

/// phi(i, k) = sum over n in [begin, end) of x[n-i] x[n-k]. Only the first row is summed; the rest
/// follows from its upper left neighbour by one product at each end.
Matrix covariance(std::span<const double> x, std::size_t begin, std::size_t end) {
    Matrix phi;
    for (int k = 0; k <= kPredictionOrder; ++k) {
        double sum = 0.0;
        for (std::size_t n = begin; n < end; ++n) {
            sum += x[n] * past(x, n, k);
        }
        phi(0, k) = phi(k, 0) = sum;
    }
    for (int i = 1; i <= kPredictionOrder; ++i) {
        for (int k = i; k <= kPredictionOrder; ++k) {
            phi(i, k) = phi(k, i) = phi(i - 1, k - 1) + past(x, begin, i) * past(x, begin, k) -
                                    past(x, end, i) * past(x, end, k);
        }
    }
    return phi;
}

}  // namespace

std::vector<double> predictor(std::span<const double> signal, std::size_t begin, std::size_t end) {
    // Keeps the equations solvable for silence and for fewer partials than coefficients; as noise
    // it lies 100 dB below the signal.
    constexpr double kRelativeNoise = 1e-10;
    constexpr double kLeast = 1e-300;
    Matrix phi = covariance(signal, begin, end);
    phi.diagonal().array() += kRelativeNoise * phi(0, 0) + kLeast;
    const Eigen::Matrix<double, kPredictionOrder, 1> a =
        phi.bottomRightCorner<kPredictionOrder, kPredictionOrder>().ldlt().solve(
            phi.col(0).tail<kPredictionOrder>());
    return {a.begin(), a.end()};
}

std::vector<double> residual(std::span<const double> signal, std::span<const double> predictor,
                             std::size_t begin, std::size_t end) {
    std::vector<double> rest(end - begin);
    for (std::size_t n = begin; n < end; ++n) {
        double predicted = 0.0;
        for (std::size_t k = 0; k < predictor.size(); ++k) {
            predicted += predictor[k] * past(signal, n, k + 1);
        }
        rest[n - begin] = signal[n] - predicted;
    }
    return rest;
}

}  // namespace percussionist::listening
