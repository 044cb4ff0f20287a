// Any line: a route is read, or one std::invalid_argument comes; written, it is one line of a file
// that is read back as the same route; what it sends of an event is OSC.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "osc/route.hpp"
#include "osc/wire.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::osc;
    Route route;
    try {
        route = parse_route({reinterpret_cast<const char*>(data), size});
    } catch (const std::invalid_argument&) {
        return 0;
    }
    const std::string line = to_string(route);
    if (line.find_first_of("#\n\r") != std::string::npos || to_string(parse_route(line)) != line) {
        std::abort();
    }
    Event event;
    event.kind = route.event;
    event.body = route.event == EventKind::pose ? "left_stick" : "";
    event.values.assign(fields(route.event).size(), 0.5);
    matches(route, event);
    const Packet packet = encode_routed(route.address, arguments(route, event), 1.7e9);
    const auto heard = [&](const std::string& path, std::span<const Argument>) {
        if (path != route.address) std::abort();
    };
    if (!decode(packet, heard)) std::abort();
    return 0;
}
