// Any bytes as an answer of multicast DNS: what is found has a name's length, a host and a port.
#include <cstdlib>

#include "io/dns_sd.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::io;
    DnsSdAnswers answers("_percussionist._udp.local");
    answers.take({data, size});
    answers.take({data, size / 2});
    for (const FoundServer& server : answers.found()) {
        if (server.address == 0 || server.port == 0 || server.name.size() > 255) {
            std::abort();
        }
    }
    return answers.found().size() <= 64 ? 0 : (std::abort(), 0);
}
