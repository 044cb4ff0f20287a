// Any bytes from a serial line: the client finds its records and replies in them, or nothing; and
// no pose that is not sane. The first byte chooses the layout.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "core/motion/fastrak_replies.hpp"
#include "core/motion/fastrak_settings.hpp"
#include "core/motion/fastrak_stream.hpp"

using namespace percussionist::motion;

namespace {

FastrakLayout layout_from(std::uint8_t byte) {
    FastrakSettings settings;
    settings.encoding = static_cast<Encoding>(byte % 3);
    settings.attitude = static_cast<Attitude>(byte / 3 % 3);
    settings.twice = (byte & 0x40) != 0;
    return layout_for(settings);
}

void check(const FastrakReading& reading) {
    const bool sane = reading.station >= 1 && reading.station <= kFastrakStations &&
                      reading.pose.position.allFinite() &&
                      reading.pose.position.cwiseAbs().maxCoeff() <= kFastrakReach &&
                      std::abs(reading.pose.orientation.norm() - 1.0) < 1e-6;
    if (!sane) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) {
        return 0;
    }
    FastrakStream stream;
    for (int station = 1; station <= kFastrakStations; ++station) {
        stream.expect(station, layout_from(data[0]));
    }
    const std::size_t piece = 1 + data[1];
    for (std::size_t at = 2; at < size; at += piece) {
        const auto bytes = std::span(data + at, std::min(piece, size - at));
        for (const auto& arrived : stream.receive(bytes, 1.0, 1e-4)) {
            check(arrived.reading);
        }
    }
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    find_status(text);
    find_stations(text);
    find_output_list(text, 1);
    find_complaint(text);
    return 0;
}
