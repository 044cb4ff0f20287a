// What travels through Pd's cords, without Pd: numbers and words, and samples.
#pragma once

#include <string>
#include <variant>

namespace percussionist::pdx {

#if defined(PD_FLOATSIZE) && PD_FLOATSIZE == 64
using Sample = double;
#else
using Sample = float;
#endif

/// A number or a word. A word that came from Pd lives for ever; one on its way out is copied by Pd.
using Atom = std::variant<double, const char*>;

inline bool is_number(const Atom& atom) {
    return std::holds_alternative<double>(atom);
}

/// As a person would type it.
std::string to_string(const Atom& atom);

}  // namespace percussionist::pdx
