#include "core/modal/decaying_sines.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace percussionist::modal {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kLongestWindow = 160;
constexpr std::size_t kMostInBand = 40;
/// How far above the noise's an eigenvalue is a sine's.
constexpr double kAboveNoise = 6.0;
/// The recordings are used until they have sunk to so much above their end.
constexpr double kAboveEnd = 4.0;

/// How many samples of the bands are more than noise.
std::size_t worth_reading(std::span<const SubBand> bands) {
    std::size_t length = bands[0].samples.size();
    for (const auto& band : bands) {
        length = std::min(length, band.samples.size());
    }
    const std::size_t part = std::max<std::size_t>(8, length / 40);
    std::vector<double> powers;
    for (std::size_t start = 0; start + part <= length; start += part) {
        double power = 0.0;
        for (const auto& band : bands) {
            for (std::size_t n = start; n < start + part; ++n) {
                power += std::norm(band.samples[n]);
            }
        }
        powers.push_back(power);
    }
    if (powers.size() < 8) {
        return length;
    }
    const double end =
        *std::min_element(powers.end() - static_cast<long>(powers.size() / 4), powers.end());
    std::size_t last = powers.size();
    while (last > 6 && powers[last - 1] < kAboveEnd * end) {
        --last;
    }
    return std::min(length, last * part);
}

Eigen::MatrixXcd covariance(std::span<const SubBand> bands, std::size_t length,
                            std::size_t window) {
    const auto size = static_cast<Eigen::Index>(window);
    const auto columns = static_cast<Eigen::Index>(length - window + 1);
    Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(size, size);
    Eigen::MatrixXcd windows(size, columns);
    for (const auto& band : bands) {
        for (Eigen::Index c = 0; c < columns; ++c) {
            for (Eigen::Index r = 0; r < size; ++r) {
                windows(r, c) = band.samples[static_cast<std::size_t>(r + c)];
            }
        }
        sum.noalias() += windows * windows.adjoint();
    }
    return sum;
}

/// Eigenvalues rising. The filter leaves half of them to the noise it lets through, and sines are
/// few: three tenths from the top is noise.
Eigen::Index order_of(const Eigen::VectorXd& eigenvalues) {
    const Eigen::Index n = eigenvalues.size();
    const double noise = std::max(eigenvalues(n - 1 - 3 * n / 10), 1e-12 * eigenvalues(n - 1));
    Eigen::Index order = 0;
    while (order < std::min<Eigen::Index>(static_cast<Eigen::Index>(kMostInBand), 3 * n / 10) &&
           eigenvalues(n - 1 - order) > kAboveNoise * noise) {
        ++order;
    }
    return order;
}

}  // namespace

std::vector<DecayingSine> decaying_sines(std::span<const SubBand> bands, double width) {
    const std::size_t length = bands.empty() ? 0 : worth_reading(bands);
    const std::size_t window = std::min(kLongestWindow, length / 3);
    if (window < 8) {
        return {};
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(covariance(bands, length, window));
    const Eigen::Index order = order_of(solver.eigenvalues());
    if (order == 0) {
        return {};
    }
    const Eigen::MatrixXcd signal = solver.eigenvectors().rightCols(order);
    const Eigen::Index rows = signal.rows() - 1;
    const Eigen::MatrixXcd turn =
        signal.topRows(rows).colPivHouseholderQr().solve(signal.bottomRows(rows));
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> poles(turn, false);
    std::vector<DecayingSine> sines;
    for (const Complex z : poles.eigenvalues()) {
        const double offset = std::arg(z) / (2 * std::numbers::pi) * bands[0].rate;
        const double loss = -std::log(std::abs(z)) * bands[0].rate;
        if (std::abs(offset) <= width / 2 && loss > 0.0) {
            sines.push_back({bands[0].centre + offset, loss});
        }
    }
    return sines;
}

}  // namespace percussionist::modal
