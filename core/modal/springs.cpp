#include "core/modal/springs.hpp"

#include <cmath>

namespace percussionist::modal {

void Springs::factor(std::size_t count, const std::array<Row, kMost>& compliance,
                     const Row& hold) noexcept {
    count_ = count;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = compliance[i][j] + (i == j ? 1 / hold[i] : 0.0);
            for (std::size_t k = 0; k < j; ++k) {
                sum -= lower_[i][k] * lower_[j][k];
            }
            // Positive but for rounding, when ports lie upon each other.
            lower_[i][j] = i == j ? std::sqrt(std::fmax(sum, 1e-30)) : sum / lower_[j][j];
        }
    }
}

void Springs::solve(Row& b) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            b[i] -= lower_[i][k] * b[k];
        }
        b[i] /= lower_[i][i];
    }
    for (std::size_t i = count_; i-- > 0;) {
        for (std::size_t k = i + 1; k < count_; ++k) {
            b[i] -= lower_[k][i] * b[k];
        }
        b[i] /= lower_[i][i];
    }
}

}  // namespace percussionist::modal
