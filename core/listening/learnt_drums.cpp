#include "core/listening/drum_model.hpp"

namespace percussionist::listening {

namespace {

constexpr char kLearnt[] =
#include "core/listening/learnt_drums.inc"
    ;

/// The compiler joins the quoted lines into one; a line begins wherever one did.
constexpr std::string_view kText(kLearnt, sizeof kLearnt - 1);

}  // namespace

DrumModel learnt_drums() {
    return model_from_text(kText);
}

}  // namespace percussionist::listening
