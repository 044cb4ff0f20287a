#include "core/motion/fastrak_stream.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace percussionist::motion;

namespace {

const FastrakLayout kLayout{{2, 11, 2, 11, 1}, true, true};

FastrakReading reading_at(double x, int station = 1) {
    FastrakReading reading;
    reading.station = station;
    reading.pose.position = {x, 0.1, -0.2};
    return reading;
}

Bytes record(double x, int station = 1) {
    Bytes bytes;
    encode(reading_at(x, station), kLayout, bytes);
    return bytes;
}

FastrakStream stream() {
    FastrakStream fresh;
    fresh.expect(1, kLayout);
    return fresh;
}

void append(Bytes& to, const Bytes& more) {
    to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

TEST_CASE("records come out however the line cuts them up") {
    Bytes line;
    for (int i = 0; i < 20; ++i) {
        append(line, record(0.01 * i));
    }
    for (const std::size_t piece : {1u, 7u, 61u, 62u, 500u}) {
        FastrakStream s = stream();
        std::vector<double> places;
        for (std::size_t at = 0; at < line.size(); at += piece) {
            const auto bytes = std::span(line).subspan(at, std::min(piece, line.size() - at));
            for (const auto& arrived : s.receive(bytes, 0.0, 0.0)) {
                places.push_back(arrived.reading.pose.position.x());
            }
        }
        REQUIRE(places.size() == 20);
        CHECK(places[7] == doctest::Approx(0.07));
        CHECK(s.lost() == 0);
    }
}

TEST_CASE("a record's time is that of its first byte") {
    FastrakStream s = stream();
    const Bytes whole = record(0.3);
    CHECK(s.receive(std::span(whole).first(10), 1.0, 1e-3).empty());
    const auto arrived = s.receive(std::span(whole).subspan(10), 1.1, 1e-3);
    REQUIRE(arrived.size() == 1);
    CHECK(arrived[0].first_byte == doctest::Approx(0.99));
}

TEST_CASE("a record cut short costs itself alone, and so does a false beginning") {
    FastrakStream s = stream();
    Bytes line = record(0.1);
    Bytes cut = record(0.2);
    cut.resize(40);
    append(line, cut);
    append(line, record(0.3));
    append(line, {'0', '1', ' ', 'x', '0', '1'});
    append(line, record(0.4));
    const auto arrived = s.receive(line, 0.0, 0.0);
    REQUIRE(arrived.size() == 3);
    CHECK(arrived[1].reading.pose.position.x() == doctest::Approx(0.3));
    CHECK(arrived[2].reading.pose.position.x() == doctest::Approx(0.4));
    CHECK(s.lost() == 46);
}

TEST_CASE("stations that are not expected are not heard") {
    FastrakStream s = stream();
    CHECK(s.receive(record(0.1, 2), 0.0, 0.0).empty());
    s.expect(2, kLayout);
    CHECK(s.receive(record(0.1, 2), 0.0, 0.0).size() == 1);
    s.expect(2, std::nullopt);
    CHECK(s.receive(record(0.1, 2), 0.0, 0.0).empty());
}

TEST_CASE("out of random bytes comes no pose") {
    FastrakStream s = stream();
    std::mt19937 random(3);
    Bytes noise(4096);
    std::size_t poses = 0;
    for (int i = 0; i < 200; ++i) {
        for (auto& byte : noise) {
            byte = static_cast<std::uint8_t>(random());
        }
        poses += s.receive(noise, 0.0, 0.0).size();
    }
    CHECK(poses == 0);
    CHECK(s.lost() + 60 == 200 * noise.size());
}
