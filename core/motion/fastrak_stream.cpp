#include "core/motion/fastrak_stream.hpp"

#include <algorithm>

namespace percussionist::motion {

void FastrakStream::expect(int station, std::optional<FastrakLayout> layout) {
    auto& slot = expected_.at(static_cast<std::size_t>(station - 1));
    slot.reset();
    const auto size = layout ? record_size(*layout) : std::nullopt;
    if (size) {
        slot = Expected{std::move(*layout), *size};
    }
    longest_ = 0;
    for (const auto& each : expected_) {
        longest_ = std::max(longest_, each ? each->size : 0);
    }
}

void FastrakStream::clear() {
    bytes_.clear();
    times_.clear();
}

void FastrakStream::drop(std::size_t count) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(count));
    times_.erase(times_.begin(), times_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Takes the first whole record; answers the bytes up to its end, 0 if there is none.
std::size_t FastrakStream::take_first() {
    for (std::size_t at = 0; at + 1 < bytes_.size(); ++at) {
        const int station = bytes_[at + 1] - '1';
        if (bytes_[at] != '0' || station < 0 || station >= kFastrakStations) {
            continue;
        }
        const auto& expected = expected_[static_cast<std::size_t>(station)];
        if (!expected || at + expected->size > bytes_.size()) {
            continue;
        }
        const auto reading =
            decode(std::span(bytes_).subspan(at, expected->size), expected->layout);
        if (reading) {
            arrived_.push_back({*reading, times_[at]});
            lost_ += at;
            return at + expected->size;
        }
    }
    return 0;
}

const std::vector<ArrivedReading>& FastrakStream::receive(std::span<const std::uint8_t> bytes,
                                                          double last_byte, double byte_time) {
    arrived_.clear();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    for (std::size_t left = bytes.size(); left > 0; --left) {
        times_.push_back(last_byte - static_cast<double>(left) * byte_time);
    }
    while (const std::size_t taken = take_first()) {
        drop(taken);
    }
    // No record can begin further back than this.
    const std::size_t keep = std::min(bytes_.size(), longest_ > 0 ? longest_ - 1 : 0);
    const std::size_t stale = bytes_.size() - keep;
    lost_ += stale;
    drop(stale);
    return arrived_;
}

}  // namespace percussionist::motion
