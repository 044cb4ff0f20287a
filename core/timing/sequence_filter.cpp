#include "core/timing/sequence_filter.hpp"

#include <algorithm>

namespace percussionist::timing {

namespace {

/// How much later `tag` is than `other`; tags of 64 bits wrap, and any may come from a network.
std::int64_t later(std::int64_t tag, std::int64_t other) noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(tag) -
                                     static_cast<std::uint64_t>(other));
}

}  // namespace

bool SequenceFilter::is_new(std::int64_t number, std::int64_t tag) noexcept {
    number = std::clamp<std::int64_t>(number, 0, kLargest);
    const Event known = place(number);
    if (known.number == number && known.tag == tag) {
        ++repeated_;
        return false;
    }
    place(number) = {number, tag};
    const bool renamed = known.number == number && later(known.tag, began_) >= -margin_;
    if (furthest_.number < 0 || renamed || started_anew(number, tag)) {
        begin(number, tag);
    } else if (number > furthest_.number) {
        const bool left_over = number > furthest_.number + 1 && later(tag, began_) < -margin_;
        if (!left_over) {  // by the run before
            add_lost(number - furthest_.number - 1);
            furthest_ = {number, tag};
        }
    } else if (number > first_) {
        --lost_;  // it was only late
    } else {
        add_lost(first_ - number - 1);
        first_ = number;
    }
    return true;
}

bool SequenceFilter::started_anew(std::int64_t number, std::int64_t tag) noexcept {
    return number < furthest_.number &&
           (later(tag, furthest_.tag) > margin_ || number <= furthest_.number - kWindow);
}

void SequenceFilter::add_lost(std::int64_t count) noexcept {
    lost_ = std::min(lost_ + count, kLargest);
}

/// The first number heard need not be 0: whoever subscribes late has lost nothing.
void SequenceFilter::begin(std::int64_t number, std::int64_t tag) noexcept {
    furthest_ = {number, tag};
    began_ = tag;
    first_ = number;
}

}  // namespace percussionist::timing
