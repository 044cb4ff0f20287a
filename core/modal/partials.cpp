#include "core/modal/partials.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

namespace percussionist::modal {

namespace {

using Complex = std::complex<double>;

Complex pole(const DecayingSine& sine, double rate) {
    return std::exp(Complex(-sine.loss, 2 * std::numbers::pi * sine.frequency) / rate);
}

/// 1 + p + p^2 .. of so many terms.
Complex geometric(Complex p, double terms) {
    const Complex below = 1.0 - p;
    return std::abs(below) < 1e-12 ? Complex(terms) : (1.0 - std::pow(p, terms)) / below;
}

}  // namespace

std::vector<Complex> amplitudes(std::span<const DecayingSine> sines,
                                std::span<const double> recording, double sample_rate) {
    const auto count = static_cast<Eigen::Index>(sines.size());
    if (count == 0 || recording.empty()) {
        return std::vector<Complex>(sines.size());
    }
    std::vector<Complex> z;
    for (const auto& sine : sines) {
        z.push_back(pole(sine, sample_rate));
    }
    // Unknowns: real and imaginary parts. Re(a z^n) = Re a Re z^n - Im a Im z^n.
    Eigen::MatrixXd normal(2 * count, 2 * count);
    Eigen::VectorXd right(2 * count);
    const double terms = static_cast<double>(recording.size());
    for (Eigen::Index j = 0; j < count; ++j) {
        for (Eigen::Index k = 0; k < count; ++k) {
            const Complex same = geometric(z[j] * z[k], terms);
            const Complex other = geometric(z[j] * std::conj(z[k]), terms);
            normal(j, k) = 0.5 * (same.real() + other.real());
            normal(count + j, count + k) = 0.5 * (other.real() - same.real());
            normal(j, count + k) = -0.5 * (same.imag() - other.imag());
            normal(count + k, j) = normal(j, count + k);
        }
        Complex power = 1.0, sum = 0.0;
        for (const double x : recording) {
            sum += x * power;
            power *= z[j];
        }
        right(j) = sum.real();
        right(count + j) = -sum.imag();
    }
    // Where two sines are all but one, they share it rather than cancel.
    normal.diagonal() *= 1 + 1e-9;
    const Eigen::VectorXd solved = normal.ldlt().solve(right);
    std::vector<Complex> found;
    for (Eigen::Index k = 0; k < count; ++k) {
        found.emplace_back(solved(k), solved(count + k));
    }
    return found;
}

std::vector<double> resynthesis(std::span<const DecayingSine> sines,
                                std::span<const Complex> amplitudes, std::size_t length,
                                double sample_rate) {
    std::vector<double> sound(length, 0.0);
    for (std::size_t k = 0; k < sines.size(); ++k) {
        const Complex z = pole(sines[k], sample_rate);
        Complex state = amplitudes[k];
        for (double& sample : sound) {
            sample += state.real();
            state *= z;
        }
    }
    return sound;
}

}  // namespace percussionist::modal
