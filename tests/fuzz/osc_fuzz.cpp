// Any bytes: a packet is taken apart and its messages are due some time, or it is counted as
// malformed. A packet may come twice, and from two senders.
#include <cmath>
#include <cstdlib>

#include "io/osc_inbox.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::io;
    OscInbox inbox([](std::unique_ptr<Delivery> delivery) {
        if (delivery->messages.empty() == delivery->complaint.empty() ||
            (delivery->due && std::isnan(*delivery->due))) {
            std::abort();
        }
    });
    for (int i = 0; i < 3; ++i) {
        inbox.take({data, size}, {1, static_cast<std::uint16_t>(i / 2)}, 1000.0 + 0.5 * i);
    }
    if (inbox.status().received != 3) {
        std::abort();
    }
    return 0;
}
