// What a limb is asked to strike: what was the last, and what comes.
#pragma once

#include <array>
#include <cstddef>

namespace percussionist::body {

/// A stroke that is forecast.
struct ForecastStroke {
    double time = -1e9;  ///< [s]
    std::size_t event = 0;
};

/// The last until now, and the one to come.
struct LimbForecast {
    ForecastStroke last;
    ForecastStroke next{1e9, 0};
};
using LimbForecasts = std::array<LimbForecast, 4>;  ///< by score::Limb

}  // namespace percussionist::body
