// Any bytes to the simulated FASTRAK: it obeys or complains, and afterwards still tells its status.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/motion/fastrak_replies.hpp"
#include "tracker/fastrak_unit.hpp"

using namespace percussionist;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    tracker::FastrakUnit unit({.receivers = 4, .restart = 0.1}, [](int station, double time) {
        return motion::Pose{{0.1 * station, 0.01 * time, 0.2}, motion::Quaternion::Identity()};
    });
    motion::Bytes out;
    double now = 1.0;
    for (std::size_t at = 0; at < size; at += 16) {
        unit.receive({data + at, std::min<std::size_t>(16, size - at)}, now);
        unit.advance(now += 0.01, out);
        if (out.size() > (1U << 16)) out.clear();
    }
    // Whatever half a command or pause there was: a line end, all off, and time for it; more time
    // for restarts, for 3 s in which it saves and hears nothing, for slow lines.
    const std::string_view ask =
        "\r\x11"
        "co1152\rS";
    out.clear();
    for (const double patience : {0.1, 0.4, 2.7, 0.4, 20.0}) {
        unit.receive({reinterpret_cast<const std::uint8_t*>(ask.data()), ask.size()}, now);
        unit.advance(now += patience, out);
        if (motion::find_status({reinterpret_cast<const char*>(out.data()), out.size()})) {
            return 0;
        }
    }
    std::abort();
}
