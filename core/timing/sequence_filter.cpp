#include "core/timing/sequence_filter.hpp"

#include <algorithm>

namespace percussionist::timing {

bool SequenceFilter::is_new(std::int64_t number, std::int64_t tag) noexcept {
    number = std::max<std::int64_t>(number, 0);
    const Event known = place(number);
    if (known.number == number && known.tag == tag) {
        ++repeated_;
        return false;
    }
    place(number) = {number, tag};
    const bool renamed = known.number == number && known.tag >= began_ - margin_;
    if (furthest_.number < 0 || renamed || started_anew(number, tag)) {
        begin(number, tag);
    } else if (number > furthest_.number) {
        const bool left_over = number > furthest_.number + 1 && tag < began_ - margin_;
        if (!left_over) {  // by the run before
            lost_ += number - furthest_.number - 1;
            furthest_ = {number, tag};
        }
    } else if (number > first_) {
        --lost_;  // it was only late
    } else {
        lost_ += first_ - number - 1;
        first_ = number;
    }
    return true;
}

bool SequenceFilter::started_anew(std::int64_t number, std::int64_t tag) noexcept {
    return number < furthest_.number &&
           (tag > furthest_.tag + margin_ || number <= furthest_.number - kWindow);
}

/// The first number heard need not be 0: whoever subscribes late has lost nothing.
void SequenceFilter::begin(std::int64_t number, std::int64_t tag) noexcept {
    furthest_ = {number, tag};
    began_ = tag;
    first_ = number;
}

}  // namespace percussionist::timing
