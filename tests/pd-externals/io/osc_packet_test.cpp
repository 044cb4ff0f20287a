#include "io/osc_packet.hpp"

#include <doctest/doctest.h>

#include <random>

#include "support/osc_writer.hpp"

using namespace percussionist::io;
using namespace percussionist::test;

namespace {

std::string refusal(const OscBytes& bytes) {
    try {
        read_osc(bytes);
    } catch (const MalformedOsc& e) {
        return e.what();
    }
    return "";
}

}  // namespace

TEST_CASE("every type of OSC becomes numbers and words") {
    const OscPacket packet = read_osc(rich_packet());
    CHECK(packet.tag == osc_tag(1.0));
    REQUIRE(packet.bundles.size() == 3);
    const auto& message = packet.bundles[0].messages.at(0);
    CHECK(message.address == "/all");
    const std::vector<OscValue> expected{-5.0,
                                         0.5,
                                         1e-3,
                                         1099511627776.0,
                                         3.0,
                                         std::string("word"),
                                         std::string("symbol"),
                                         std::string("x"),
                                         16909060.0,
                                         144.0,
                                         64.0,
                                         127.0,
                                         0.0,  // midi
                                         3.0,
                                         7.0,
                                         8.0,
                                         255.0,  // blob
                                         1.0,
                                         0.0,
                                         std::string("nil"),
                                         std::string("inf"),
                                         1.0,
                                         2.0};
    CHECK(message.arguments == expected);
    CHECK(packet.bundles[1].tag == osc_tag(0.5));
    CHECK(packet.bundles[1].messages.size() == 2);
    CHECK(packet.bundles[2].tag == kImmediately);
    CHECK(packet.bundles[2].messages.at(0).address == "/no-types");
}

TEST_CASE("a plain message is due at once") {
    const OscPacket packet = read_osc(osc_message("/a", "i", {osc_int(1)}));
    CHECK(packet.tag == kImmediately);
    REQUIRE(packet.bundles.size() == 1);
    CHECK(packet.bundles[0].tag == kImmediately);
}

TEST_CASE("messages of one tag stay together, in their order") {
    const auto named = [](const char* name) { return osc_message(name, "", {}); };
    const OscPacket packet = read_osc(
        osc_bundle(osc_tag(1), {named("/1"), osc_bundle(osc_tag(1), {named("/2")}), named("/3")}));
    REQUIRE(packet.bundles.size() == 1);
    CHECK(packet.bundles[0].messages.at(2).address == "/3");
}

TEST_CASE("what is no OSC is refused, and the place is named") {
    const auto cut = [](OscBytes bytes, std::size_t size) {
        bytes.resize(size);
        return bytes;
    };
    const OscBytes good = osc_message("/a", "if", {osc_int(1), osc_float(2)});
    CHECK(refusal({}) == "byte 0: expected a multiple of 4 bytes, not 0");
    CHECK(refusal({'/', 'a', 0}) == "byte 0: expected a multiple of 4 bytes, not 3");
    CHECK(refusal(osc_text("hello")) == "byte 0: expected an address that begins with /");
    CHECK(refusal({'/', 'a', 'b', 'c'}) == "byte 0: expected a text that ends");
    CHECK(refusal(cut(good, 12)) == "byte 12: expected 4 bytes of an argument");
    CHECK(refusal(osc_message("/a", "q", {})) == "byte 8: expected an argument of a known type");
    CHECK(refusal(osc_message("/a", "", {osc_int(1)})) ==
          "byte 8: expected the end of the message");
    CHECK(refusal(osc_message("/a", "]", {})) ==
          "byte 8: expected an array to begin before it ends");
    CHECK(refusal(osc_message("/a", "[", {})) == "byte 8: expected an array to end");
    CHECK(refusal(osc_message("/a", "b", {osc_int(-1)})) ==
          "byte 12: expected a blob that fits the packet");
    CHECK(refusal(osc_message("/a", "b", {osc_int(0x7FFFFFFF), osc_int(0)})) ==
          "byte 12: expected a blob that fits the packet");
    CHECK(refusal(cut(osc_bundle(1, {}), 12)) == "byte 0: expected a time tag of 8 bytes");
    OscBytes beyond = osc_bundle(1, {good});
    beyond[19] = 200;
    CHECK(refusal(beyond) == "byte 20: expected an element that fits the packet");
}

TEST_CASE("texts that are not filled up with zeros are refused, wherever they stand") {
    const OscBytes whole = osc_message("/ab", "ssb", {osc_text("c"), osc_text("d"), osc_int(0)});
    REQUIRE(refusal(whole).empty());
    int texts = 0;
    for (std::size_t i = 1; i < whole.size() - 4; ++i) {
        if (whole[i] == 0 && whole[i - 1] == 0) {  // one that only fills up
            OscBytes damaged = whole;
            damaged[i] = 'x';
            CHECK(refusal(damaged).find("zeros") != std::string::npos);
            ++texts;
        }
    }
    CHECK(texts >= 4);
}

TEST_CASE("bundles too deep are refused") {
    OscBytes packet = osc_message("/a", "", {});
    for (int i = 0; i < 8; ++i) {
        packet = osc_bundle(1, {packet});
        CHECK(refusal(packet).empty());
    }
    CHECK(refusal(osc_bundle(1, {packet})).find("bundles at most 8 deep") != std::string::npos);
}

TEST_CASE("any bytes are read or refused") {
    std::mt19937 random(1);
    const OscBytes seeds[] = {rich_packet(), contact_packet({{3, 0.3}, {2, 0.2}, {1, 0.1}}, 0.03)};
    int read = 0;
    for (int i = 0; i < 40000; ++i) {
        OscBytes bytes = seeds[i % 2];
        for (std::size_t k = random() % 6; k > 0; --k) {
            bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random() >> 7U);
        }
        if (random() % 3 == 0) {
            bytes.resize(random() % (bytes.size() + 1));
        }
        // In memory of exactly this size, so that sanitizers see a step beyond it.
        const OscBytes exact(bytes.begin(), bytes.end());
        read += refusal(exact).empty() ? 1 : 0;
    }
    CHECK(read > 1000);
    CHECK(read < 39000);
}

TEST_CASE("what is written is read again") {
    const std::vector<OscValue> arguments{7771.0, std::string("sound"), 0.5};
    const OscPacket floats = read_osc(write_osc("/a", arguments));
    CHECK(floats.bundles.at(0).messages.at(0).arguments == arguments);
    const Bytes integers = write_osc("/subscribe", {arguments.data(), 2}, true);
    OscBytes expected = osc_message("/subscribe", "is", {osc_int(7771), osc_text("sound")});
    CHECK(integers == expected);
    CHECK_THROWS_AS(write_osc("/a", std::vector<OscValue>(20000, 1.0)), std::invalid_argument);
}
