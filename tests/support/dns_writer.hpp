// Answers of multicast DNS, byte by byte, as a responder sends them for one service.
#pragma once

#include <string>

#include "support/osc_writer.hpp"

namespace percussionist::test {

inline OscBytes dns_name(const std::string& dotted) {
    OscBytes bytes;
    for (std::size_t begin = 0; begin < dotted.size();) {
        const std::size_t end = std::min(dotted.find('.', begin), dotted.size());
        bytes.push_back(static_cast<std::uint8_t>(end - begin));
        bytes.insert(bytes.end(), dotted.begin() + static_cast<std::ptrdiff_t>(begin),
                     dotted.begin() + static_cast<std::ptrdiff_t>(end));
        begin = end + 1;
    }
    bytes.push_back(0);
    return bytes;
}

/// A name that goes on at an earlier byte of the packet.
inline OscBytes dns_elsewhere(std::size_t at) {
    return big_endian(0xC000U | at, 2);
}

inline OscBytes dns_record(const OscBytes& name, int type, const OscBytes& content) {
    OscBytes bytes = name;
    append(bytes, big_endian(static_cast<std::uint64_t>(type), 2));
    append(bytes, big_endian(0x8001, 2));
    append(bytes, big_endian(120, 4));
    append(bytes, big_endian(content.size(), 2));
    append(bytes, content);
    return bytes;
}

inline OscBytes dns_packet(const std::vector<OscBytes>& records) {
    OscBytes bytes{0, 0, 0x84, 0, 0, 0};
    append(bytes, big_endian(records.size(), 2));
    append(bytes, {0, 0, 0, 0});
    for (const OscBytes& record : records) {
        append(bytes, record);
    }
    return bytes;
}

inline OscBytes dns_service(const OscBytes& instance, const OscBytes& host, int port) {
    OscBytes content{0, 0, 0, 0};
    append(content, big_endian(static_cast<std::uint64_t>(port), 2));
    append(content, host);
    return dns_record(instance, 33, content);
}

/// Service and address of "percussionist on stage" at 10.9.0.1:7790, the service's name once in
/// full and then by its place.
inline OscBytes dns_answer() {
    constexpr std::size_t kHeader = 12, kLabel = 23;
    const OscBytes service = dns_name("_percussionist._udp.local");
    OscBytes instance{22};
    append(instance, OscBytes{'p', 'e', 'r', 'c', 'u', 's', 's', 'i', 'o', 'n', 'i',
                              's', 't', ' ', 'o', 'n', ' ', 's', 't', 'a', 'g', 'e'});
    append(instance, service);
    return dns_packet({dns_service(instance, dns_name("Stage.local"), 7790),
                       dns_record(dns_name("stage.local"), 1, {10, 9, 0, 1}),
                       dns_record(dns_elsewhere(kHeader + kLabel), 12, dns_elsewhere(kHeader))});
}

}  // namespace percussionist::test
