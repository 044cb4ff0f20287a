// OSC packets byte by byte, good ones and bad ones, and those of docs/osc-protocol.md.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace percussionist::test {

using OscBytes = std::vector<std::uint8_t>;

inline void append(OscBytes& to, const OscBytes& more) {
    to.insert(to.end(), more.begin(), more.end());
}

inline OscBytes big_endian(std::uint64_t value, int bytes) {
    OscBytes all;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) {
        all.push_back(static_cast<std::uint8_t>(value >> shift));
    }
    return all;
}

/// With its zero, filled up to whole words.
inline OscBytes osc_text(const std::string& text) {
    OscBytes bytes(text.begin(), text.end());
    bytes.resize((bytes.size() / 4 + 1) * 4);
    return bytes;
}

inline OscBytes osc_int(std::int64_t value) {
    return big_endian(static_cast<std::uint64_t>(value), 4);
}
inline OscBytes osc_float(double value) {
    return big_endian(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}
inline OscBytes osc_double(double value) {
    return big_endian(std::bit_cast<std::uint64_t>(value), 8);
}

inline OscBytes osc_message(const std::string& address, const std::string& types,
                            const std::vector<OscBytes>& arguments) {
    OscBytes bytes = osc_text(address);
    append(bytes, osc_text("," + types));
    for (const auto& argument : arguments) {
        append(bytes, argument);
    }
    return bytes;
}

inline OscBytes osc_bundle(std::uint64_t tag, const std::vector<OscBytes>& elements) {
    OscBytes bytes = osc_text("#bundle");
    append(bytes, big_endian(tag, 8));
    for (const auto& element : elements) {
        append(bytes, big_endian(element.size(), 4));
        append(bytes, element);
    }
    return bytes;
}

/// A sender's time as a tag; 2026 or so at 0.
inline std::uint64_t osc_tag(double seconds) {
    constexpr double kUnits = 4294967296.0;
    constexpr std::uint64_t kBegin = std::uint64_t{3977000000} << 32U;
    return kBegin + static_cast<std::uint64_t>(static_cast<std::int64_t>(seconds * kUnits));
}

struct Contact {
    int number = 0;
    double instant = 0.0;  ///< by the sender's clock [s]
};

inline OscBytes contact_message(const Contact& contact) {
    std::vector<OscBytes> arguments{osc_int(contact.number), osc_int(contact.number % 2),
                                    osc_int(0), osc_int(contact.number),
                                    osc_double(contact.instant)};
    for (int i = 0; i < 13; ++i) {
        arguments.push_back(osc_float(0.1 * i));
    }
    arguments.push_back(osc_int(0));
    return osc_message("/contact", "iiiidfffffffffffffi", arguments);
}

/// The newest event, and those before it along with it.
inline OscBytes contact_packet(const std::vector<Contact>& newest_first, double lookahead) {
    const Contact& newest = newest_first.front();
    std::vector<OscBytes> elements{contact_message(newest)};
    for (std::size_t i = 1; i < newest_first.size(); ++i) {
        elements.push_back(osc_bundle(osc_tag(newest_first[i].instant + lookahead),
                                      {contact_message(newest_first[i])}));
    }
    return osc_bundle(osc_tag(newest.instant + lookahead), elements);
}

inline OscBytes clock_packet(double now, double lookahead) {
    return osc_bundle(osc_tag(now + lookahead),
                      {osc_message("/clock", "f", {osc_float(lookahead)})});
}

/// One of everything.
inline OscBytes rich_packet() {
    OscBytes blob = osc_int(3);
    append(blob, {7, 8, 255, 0});
    const OscBytes message =
        osc_message("/all", "ifdhtsScrmbTFNI[ii]",
                    {osc_int(-5), osc_float(0.5), osc_double(1e-3), big_endian(1ULL << 40U, 8),
                     big_endian(3ULL << 32U, 8), osc_text("word"), osc_text("symbol"), osc_int('x'),
                     osc_int(0x01020304), osc_int(0x90407F00), blob, osc_int(1), osc_int(2)});
    return osc_bundle(osc_tag(1.0),
                      {message, osc_bundle(osc_tag(0.5), {message, osc_message("/b", "", {})}),
                       osc_bundle(1, {osc_text("/no-types")})});
}

}  // namespace percussionist::test
