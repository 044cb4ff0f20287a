#include "core/motion/fastrak_record.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <random>
#include <string_view>

#include "core/linear/euler.hpp"
#include "core/motion/fastrak_number.hpp"

using namespace percussionist::motion;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The example that the manual's formats are worked out for: 11, -2, 5.5 in; 10, 5, -3 degrees.
FastrakReading example() {
    FastrakReading reading;
    reading.pose.position = 0.0254 * Vector3(11, -2, 5.5);
    reading.pose.orientation =
        percussionist::linear::to_quaternion({10 * kDegree, 5 * kDegree, -3 * kDegree});
    return reading;
}

Bytes encoded(const FastrakReading& reading, const FastrakLayout& layout) {
    Bytes bytes;
    encode(reading, layout, bytes);
    return bytes;
}

Bytes operator""_bytes(const char* text, std::size_t size) {
    return Bytes(text, text + size);
}

FastrakReading random_reading(std::mt19937& random) {
    std::uniform_real_distribution<> number(-1.0, 1.0);
    FastrakReading reading;
    reading.station = 1 + static_cast<int>(random() % 4);
    for (int i = 0; i < 3; ++i) {
        reading.pose.position[i] = number(random);
    }
    reading.pose.orientation =
        Quaternion(number(random), number(random), number(random), number(random)).normalized();
    return reading;
}

double turn_between(const FastrakReading& a, const FastrakReading& b) {
    return a.pose.orientation.angularDistance(b.pose.orientation);
}

}  // namespace

TEST_CASE("a record is what the manual's worked examples are, byte for byte") {
    const FastrakReading reading = example();
    CHECK(encoded(reading, {.items = {2, 4, 1}, .binary = false, .centimetres = false}) ==
          "01   11.00  -2.00   5.50  10.00   5.00  -3.00\r\n"_bytes);
    CHECK(encoded(reading, {.items = {2, 11, 0}, .binary = true, .centimetres = false}) ==
          Bytes{0x30, 0x31, 0x20, 0x00, 0x00, 0x30, 0x41, 0x00, 0x00, 0x00, 0xc0,
                0x00, 0x00, 0xb0, 0x40, 0x9b, 0xab, 0x7e, 0x3f, 0x0f, 0x8e, 0xf4,
                0xbc, 0x90, 0x96, 0x28, 0x3d, 0xf1, 0x97, 0xb4, 0x3d, 0x20});
    CHECK(encoded(reading, {.items = {18, 20}, .binary = true, .centimetres = true}) ==
          Bytes{0x30, 0x31, 0x20, 0xfb, 0x05, 0x75, 0x7e, 0x7d, 0x02, 0x55, 0x3f, 0x0b, 0x7e, 0x51,
                0x02, 0x52, 0x05});
}

TEST_CASE("sixteen-bit numbers are the manual's pairs") {
    const auto pair = [](double value, double full) {
        Bytes bytes;
        put_number(value, Notation::k16Bit, full, bytes);
        return bytes;
    };
    CHECK(pair(10, 300) == Bytes{0x11, 0x02});
    CHECK(pair(-25, 300) == Bytes{0x55, 0x7a});
    CHECK(pair(-300, 300) == Bytes{0x00, 0x40});
    CHECK(pair(300, 300) == Bytes{0x7f, 0x3f});
    CHECK(pair(45, 180) == Bytes{0x00, 0x10});
    CHECK(pair(-90, 180) == Bytes{0x00, 0x60});
}

TEST_CASE("what is encoded decodes to the same pose, in every format and unit") {
    std::mt19937 random(1);
    struct Form {
        FastrakLayout layout;
        double position, angle;  // what its notation leaves out [m], [rad]
    };
    std::vector<Form> forms;
    for (const bool cm : {false, true}) {
        const double text = (cm ? 0.01 : 0.0254) * 0.0051;
        forms.push_back({{{2, 4, 1}, false, cm}, text, 3e-4});
        forms.push_back({{{2, 11, 2, 11, 1}, false, cm}, text, 3e-4});
        forms.push_back({{{2, 5, 6, 7, 50}, false, cm}, text, 3e-4});
        forms.push_back({{{52, 61, 51}, false, cm}, 1e-6, 3e-5});
        forms.push_back({{{52, 54}, false, cm}, 1e-6, 3e-5});
        forms.push_back({{{2, 11}, true, cm}, 1e-6, 1e-6});
        forms.push_back({{{2, 4, 16}, true, cm}, 1e-6, 1e-6});
        forms.push_back({{{2, 5, 6, 7, 1}, true, cm, true}, 1e-6, 1e-6});
        forms.push_back({{{18, 20, 18, 20, 1}, true, cm}, 2e-4, 4e-4});
        forms.push_back({{{18, 19}, true, cm}, 2e-4, 5e-4});
    }
    for (const Form& form : forms) {
        for (int i = 0; i < 100; ++i) {
            const FastrakReading truth = random_reading(random);
            const Bytes bytes = encoded(truth, form.layout);
            CHECK(bytes.size() == record_size(form.layout));
            const auto read = decode(bytes, form.layout);
            REQUIRE(read);
            CHECK(read->station == truth.station);
            CHECK((read->pose.position - truth.pose.position).norm() < 2 * form.position);
            CHECK(turn_between(*read, truth) < form.angle);
        }
    }
}

TEST_CASE("a record with any one byte changed gives no other pose where numbers come twice") {
    const FastrakReading truth = example();
    for (const FastrakLayout& layout : {FastrakLayout{{2, 11, 2, 11, 1}, true, true},
                                        FastrakLayout{{18, 20, 18, 20, 1}, true, true},
                                        FastrakLayout{{2, 4, 2, 4, 1}, false, true}}) {
        const Bytes whole = encoded(truth, layout);
        for (std::size_t at = 3; at < whole.size(); ++at) {
            for (int value = 0; value < 256; ++value) {
                Bytes damaged = whole;
                damaged[at] = static_cast<std::uint8_t>(value);
                CHECK((decode(damaged, layout).has_value() == (damaged == whole)));
            }
        }
    }
}

TEST_CASE("no record: other lengths, other headers, impossible numbers") {
    const FastrakLayout layout{{2, 11}, true, true};
    const Bytes good = encoded(example(), layout);
    REQUIRE(decode(good, layout));
    CHECK_FALSE(decode(std::span(good).first(good.size() - 1), layout));
    for (const auto& [at, byte] : {std::pair{0, '2'}, {1, '0'}, {1, '5'}, {2, '!'}}) {
        Bytes bad = good;
        bad[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(byte);
        CHECK_FALSE(decode(bad, layout));
    }
    FastrakReading far = example();
    far.pose.position.x() = 6.0;
    CHECK_FALSE(decode(encoded(far, layout), layout));
    far.pose.position.x() = std::nan("");
    CHECK_FALSE(decode(encoded(far, layout), layout));
    FastrakReading stretched = example();
    stretched.pose.orientation.w() *= 1.1;
    CHECK_FALSE(decode(encoded(stretched, layout), layout));
    CHECK_FALSE(record_size({.items = {2, 99}}));
    CHECK_FALSE(record_size({.items = std::vector<int>(33, 0)}));
    CHECK_FALSE(record_size({.items = std::vector<int>(12, 52)}));
}
