// What a network says of attacks, and what it comes to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "core/listening/drum_class.hpp"
#include "core/listening/drum_model.hpp"
#include "core/listening/network.hpp"

namespace percussionist::listening {

/// Of all attacks of a recording: a column for each.
struct Judgement {
    Eigen::MatrixXf odds;          ///< logarithms, a row for each class
    Eigen::MatrixXf descriptions;  ///< Network::description()
};

Judgement judge_all(Network& network, const Eigen::MatrixXf& inputs);

struct Verdict {
    DrumClass drum = DrumClass::kick;
    double confidence = 0.5;  ///< 0.5 to 1
};

/// The drums that sound together in one attack, at most one for each class.
class Verdicts {
  public:
    void add(const Verdict& verdict) noexcept { verdicts_[count_++] = verdict; }
    [[nodiscard]] const Verdict* begin() const noexcept { return verdicts_.data(); }
    [[nodiscard]] const Verdict* end() const noexcept { return verdicts_.data() + count_; }
    [[nodiscard]] std::size_t size() const noexcept { return count_; }

  private:
    std::array<Verdict, kDrumClasses> verdicts_{};
    std::size_t count_ = 0;
};

/// Of log odds less their thresholds; a hat is either closed or open, a cymbal
/// that rings a crash or a ride. Does not allocate.
Verdicts verdicts(const Odds& odds) noexcept;

}  // namespace percussionist::listening
