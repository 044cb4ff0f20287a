// The value in the middle: a mean that a few outliers do not move.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace percussionist::listening {

/// The mean of the middle two if there are as many above as below; 0 of nothing.
inline double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) {
        return *middle;
    }
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace percussionist::listening
