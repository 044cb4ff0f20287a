// udp_relay IN_PORT OUT_ADDRESS OUT_PORT DELAY_MS JITTER_MS LOSS_PERCENT DOUBLED_PERCENT [SEED]:
// passes packets on as a bad network would, until it is ended.
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "net/relay.hpp"

int main(int count, char** arguments) try {
    using namespace percussionist;
    if (count < 8) {
        std::cerr << "udp_relay IN_PORT OUT_ADDRESS OUT_PORT DELAY_MS JITTER_MS LOSS_PERCENT "
                     "DOUBLED_PERCENT [SEED]\n";
        return 2;
    }
    io::Endpoint to{0, static_cast<std::uint16_t>(std::atoi(arguments[3]))};
    if (!io::read_address(arguments[2], to.address)) {
        std::cerr << arguments[2] << ": expected four numbers, as 127.0.0.1\n";
        return 2;
    }
    const test::Relay relay(std::atoi(arguments[1]), to,
                            {.delay = 1e-3 * std::atof(arguments[4]),
                             .jitter = 1e-3 * std::atof(arguments[5]),
                             .loss = 1e-2 * std::atof(arguments[6]),
                             .doubled = 1e-2 * std::atof(arguments[7]),
                             .seed = count > 8 ? std::strtoull(arguments[8], nullptr, 10) : 1});
    std::cout << "relaying from port " << relay.port() << std::endl;
    pause();
    return 0;
} catch (const std::exception& e) {
    std::cerr << "udp_relay: " << e.what() << '\n';
    return 1;
}
