// A patch that misuses every object in every way its table and Pd know.
#pragma once

#include <string>

namespace percussionist::objects {

/// Subpatches of several block sizes and rates with each object; plays abuse.txt beside it.
std::string abuse_patch();

/// For abuse.txt: each object hears every selector with arguments that fit, that do not, none and a
/// thousand, while signals run, stop and start; is made with wrong arguments, and `copies` times,
/// and deleted. Then Pd quits.
std::string abuse_story(int copies);

}  // namespace percussionist::objects
