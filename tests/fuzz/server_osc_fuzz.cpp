// Any bytes to the server: each message of a packet is a command or is refused in so many words,
// and a refusal fits one packet.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "osc/address_table.hpp"
#include "osc/wire.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::osc;
    constexpr std::size_t kLongestAnswer = 1400;
    const auto heard = [&](const std::string& path, std::span<const Argument> arguments) {
        const auto said = understand(path, arguments);
        const auto* refusal = std::get_if<Refusal>(&said);
        if (refusal == nullptr) return;
        if (refusal->reason.empty()) std::abort();
        const std::string texts[] = {refusal->address, refusal->reason};
        if (encode_text("/error", texts).size() > kLongestAnswer) std::abort();
    };
    decode({reinterpret_cast<const char*>(data), size}, heard);
    return 0;
}
