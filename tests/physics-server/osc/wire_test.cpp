#include "osc/wire.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace percussionist::osc;

namespace {

struct Message {
    std::string path;
    std::vector<Argument> arguments;
};

std::vector<Message> messages(const Packet& packet) {
    std::vector<Message> all;
    CHECK(decode(packet, [&](const std::string& path, std::span<const Argument> arguments) {
        all.push_back({path, {arguments.begin(), arguments.end()}});
    }));
    return all;
}

ContactMessage contact(int sequence) {
    ContactMessage c;
    c.sequence = sequence;
    c.wall = 1.7e9 + sequence;
    c.place = {0.3F, -0.4F};
    c.force = {0.0F, 0.0F, -20.0F};
    return c;
}

/// The time tag of the bundle that begins at a byte, seconds since 1970.
double time_tag(const Packet& packet, std::size_t at) {
    std::uint64_t tag = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        tag = tag << 8U | static_cast<unsigned char>(packet[at + 8 + i]);
    }
    return static_cast<double>(tag >> 32U) - 2208988800.0 +
           static_cast<double>(tag & 0xFFFFFFFFU) / 4294967296.0;
}

}  // namespace

TEST_CASE("wire: a contact comes first, those before it ride along") {
    const std::vector<ContactMessage> earlier{contact(6), contact(5)};
    const auto all = messages(encode(contact(7), earlier, 0.03));
    REQUIRE(all.size() == 3);
    for (int i = 0; i < 3; ++i) {
        CHECK(all[i].path == "/contact");
        REQUIRE(all[i].arguments.size() == 19);
        CHECK(std::get<double>(all[i].arguments[0]) == 7 - i);
    }
    CHECK(std::get<double>(all[0].arguments[7]) == doctest::Approx(0.5));  // r of (0.3, -0.4)
    CHECK(std::get<double>(all[0].arguments[8]) == doctest::Approx(std::atan2(-0.4, 0.3)));
}

TEST_CASE("wire: the time tag is the instant plus the lookahead, to a microsecond") {
    const Packet packet = encode(contact(7), {}, 0.03);
    CHECK(std::abs(time_tag(packet, 0) - (1.7e9 + 7 + 0.03)) < 1e-6);
}

TEST_CASE("wire: with all that ride along a contact fits one Ethernet frame") {
    const std::vector<ContactMessage> earlier(7, contact(1));
    CHECK(encode(contact(8), earlier, 0.03).size() <= 1472);
}

TEST_CASE("wire: all bodies' poses fit one datagram") {
    PoseMessage pose;
    for (int i = 0; i < 20; ++i) pose.bodies.push_back({"right_upper_arm", {}, {}});
    const Packet packet = encode(pose, 0.03);
    CHECK(messages(packet).size() == 20);
    CHECK(packet.size() < 65507);
}

TEST_CASE("wire: whatever bytes come, decoding ends and reads no further than they are") {
    std::mt19937 random(1);
    const Packet good = encode(contact(7), std::vector<ContactMessage>{contact(6)}, 0.03);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        Packet bytes = good;
        for (int k = 0; k < 4; ++k) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        bytes.resize(random() % (bytes.size() + 1));
        bytes.shrink_to_fit();
        if (!decode(bytes, [](const std::string&, std::span<const Argument>) {})) ++refused;
    }
    CHECK(refused > 10000);
}

TEST_CASE("wire: bundles within bundles end somewhere") {
    Packet packet = encode_text("/play", {});
    for (int depth = 0; depth < 100; ++depth) {
        Packet around{'#', 'b', 'u', 'n', 'd', 'l', 'e', 0, 0, 0, 0, 0, 0, 0, 0, 1};
        const auto size = static_cast<std::uint32_t>(packet.size());
        for (int shift = 24; shift >= 0; shift -= 8) {
            around.push_back(static_cast<char>(size >> shift));
        }
        around.insert(around.end(), packet.begin(), packet.end());
        packet = around;
    }
    CHECK_FALSE(decode(packet, [](const std::string&, std::span<const Argument>) {}));
}
