// A patch that misuses every object in every way its table and Pd know.
#pragma once

#include <string>

namespace percussionist::objects {

/// The text of a patch that quits Pd at its end: in subpatches of several block sizes and rates
/// each object hears every selector with arguments that fit, that do not, none and a thousand,
/// while signals run, stop and start; is made with wrong arguments, and `copies` times, and
/// deleted.
std::string abuse_patch(int copies);

}  // namespace percussionist::objects
