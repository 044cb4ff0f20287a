// One number of a FASTRAK record in each of the notations the unit has.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::motion {

enum class Notation {
    kTwoDecimals,   ///< Sxxx.xx
    kFourDecimals,  ///< Sx.xxxx
    kExtended,      ///< Sx.xxxxxESxx and a blank
    kFloat32,       ///< little-endian
    k16Bit          ///< 14 bits, low 7 first; full scale is 8192
};

std::size_t size_of(Notation notation);

/// `full_scale` counts for k16Bit alone.
void put_number(double value, Notation notation, double full_scale, Bytes& out);

/// Nothing if the bytes, size_of(notation) of them, are no finite number. Ignores bit 7 of k16Bit.
std::optional<double> get_number(std::span<const std::uint8_t> bytes, Notation notation,
                                 double full_scale);

}  // namespace percussionist::motion
