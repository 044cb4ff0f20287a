#include "tracker/line_faults.hpp"

namespace percussionist::tracker {

namespace {

constexpr std::size_t kLongestBurst = 15;
constexpr double kMeanBurst = 8.0;

}  // namespace

bool LineFaults::burst(motion::Bytes& record) {
    const std::size_t length = 1 + below(kLongestBurst);
    const std::size_t at = below(record.size());
    const bool in_between = chance() < 0.5;
    bool harmed = in_between && at > 0;
    for (std::size_t i = 0; i < length; ++i) {
        const auto byte = static_cast<std::uint8_t>(below(256));
        const auto place = record.begin() + static_cast<std::ptrdiff_t>(at + i);
        if (in_between) {
            record.insert(place, byte);
        } else if (at + i < record.size()) {
            harmed = harmed || *place != byte;
            *place = byte;
        }
    }
    return harmed;
}

bool LineFaults::damage(motion::Bytes& record) {
    bool harmed = false;
    if (settings_.cut > 0.0 && chance() < settings_.cut && record.size() > 1) {
        record.resize(1 + below(record.size() - 1));
        harmed = true;
    }
    const double bursts = settings_.garbage * static_cast<double>(record.size()) / kMeanBurst;
    if (settings_.garbage > 0.0 && chance() < bursts) {
        harmed = burst(record) || harmed;
    }
    return harmed;
}

}  // namespace percussionist::tracker
