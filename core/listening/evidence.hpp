// All that is known of a recording's attacks before anything is judged.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/listening/heard.hpp"

namespace percussionist::listening {

struct Evidence {
    std::vector<double> times;     ///< in order [s]
    std::vector<float> strengths;  ///< novelty
    Eigen::MatrixXf features;      ///< kFeatures, a column for each
};

Evidence evidence_of(const Heard& heard);

}  // namespace percussionist::listening
