// What may stand in a FASTRAK record: the items of its output list, by their codes.
#pragma once

#include "core/motion/fastrak_number.hpp"

namespace percussionist::motion {

enum class What {
    kBlank,
    kLineEnd,
    kPosition,
    kRelative,
    kEuler,
    kX,
    kY,
    kZ,
    kQuaternion,
    kButton
};

struct Item {
    int code;
    What what;
    bool extended;
    bool is_16bit;
};

/// Null if the unit does not know the code.
const Item* find_item(int code);

/// How many numbers; blanks, line ends and the button have none.
std::size_t numbers_in(What what);
Notation notation_of(const Item& item, bool binary);
std::size_t size_of(const Item& item, bool binary);

/// One of the unit's units in SI, and what 8191 sixteen-bit steps and one more are of it.
struct Scale {
    double unit;
    double full;
};

Scale scale_of(What what, bool centimetres);

}  // namespace percussionist::motion
