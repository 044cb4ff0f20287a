// What OSC messages carry here.
#pragma once

#include <string>
#include <variant>

namespace percussionist::osc {

/// An OSC argument; numbers of any type become double.
using Argument = std::variant<double, std::string>;

}  // namespace percussionist::osc
