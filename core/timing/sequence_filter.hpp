// Tells events that were heard already from new ones, and counts those that never came.
//
// A sender numbers its events from 0 and sends each of them several times, with its one time tag:
// number and tag together are an event's name. The number alone is not, for a sender that starts
// anew begins again at 0. It has started anew if a number that is not ahead comes with a tag
// much later than that of the number furthest ahead, or with a tag other than the number had, or if
// it lies further back than anything is sent again.
//
// Pure and without allocation; one thread at a time.
#pragma once

#include <array>
#include <cstdint>

namespace percussionist::timing {

class SequenceFilter {
  public:
    /// Whether this event was not heard before. `tag` in any one unit, of which there are
    /// `units_a_second`; tags
    /// wrap round after 2^64, numbers count as at most 2^60.
    bool is_new(std::int64_t number, std::int64_t tag) noexcept;

    explicit SequenceFilter(double units_a_second)
        : margin_(static_cast<std::int64_t>(kMargin * units_a_second)) {}

    /// Events that have not come though later ones have.
    std::int64_t lost() const noexcept { return lost_; }
    std::int64_t repeated() const noexcept { return repeated_; }

  private:
    static constexpr std::int64_t kWindow = 1024;  ///< numbers back that are remembered
    static constexpr std::int64_t kLargest = std::int64_t{1} << 60;
    static constexpr double kMargin = 0.1;  ///< tags of one run are in order up to this [s]

    struct Event {
        std::int64_t number = -1;
        std::int64_t tag = 0;
    };
    Event& place(std::int64_t number) noexcept {
        return heard_[static_cast<std::size_t>(number & (kWindow - 1))];
    }
    bool started_anew(std::int64_t number, std::int64_t tag) noexcept;
    void add_lost(std::int64_t count) noexcept;
    void begin(std::int64_t number, std::int64_t tag) noexcept;

    std::array<Event, kWindow> heard_{};
    std::int64_t margin_;
    Event furthest_;
    std::int64_t began_ = 0;  // tag of the first event of this run
    std::int64_t first_ = 0;  // number of it
    std::int64_t lost_ = 0, repeated_ = 0;
};

}  // namespace percussionist::timing
