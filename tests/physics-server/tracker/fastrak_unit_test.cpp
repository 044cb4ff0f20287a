#include "tracker/fastrak_unit.hpp"

#include <doctest/doctest.h>

#include <string>

#include "core/motion/fastrak_replies.hpp"
#include "core/motion/fastrak_stream.hpp"

using namespace percussionist;
using namespace percussionist::tracker;
using motion::FastrakLayout;
using motion::Pose;
using motion::Vector3;

namespace {

/// A unit and the one who talks to it, a tick of a tenth of a millisecond at a time.
class Bench {
  public:
    explicit Bench(FastrakUnitSettings settings = {})
        : unit(settings, [](int station, double time) {
              return Pose{{0.1 * station, 0.01 * time, 0.2}, motion::Quaternion::Identity()};
          }) {}

    /// What comes within so long [s].
    std::string say(const std::string& text, double seconds = 0.05) {
        unit.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now);
        motion::Bytes out;
        for (const double end = now + seconds; now < end; now += 1e-4) {
            unit.advance(now, out);
        }
        return {out.begin(), out.end()};
    }

    FastrakUnit unit;
    double now = 100.0;
};

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

}  // namespace

TEST_CASE("switched on it is silent, in ASCII and inches, and says so") {
    Bench bench;
    CHECK(bench.say("").empty());
    const std::string status = bench.say("S");
    CHECK(status.size() == 55);
    const auto read = motion::find_status(status);
    REQUIRE(read);
    CHECK_FALSE(read->binary);
    CHECK_FALSE(read->centimetres);
    CHECK_FALSE(read->continuous);
    CHECK(motion::find_status(bench.say("UfCcS"))->binary);
    CHECK(bench.say("uFP").substr(0, 10) == "01    3.94");
}

TEST_CASE("stations share 120 records a second in their order") {
    for (const int receivers : {1, 2, 3, 4}) {
        Bench bench({.receivers = receivers});
        const std::string text = "\r\n" + bench.say("C", 2.0);
        const double each = 240.0 / receivers;
        for (int station = 1; station <= receivers; ++station) {
            const auto records = count(text, "\r\n0" + std::to_string(station) + " ");
            CHECK(std::abs(static_cast<double>(records) - each) <= 1.0);
        }
    }
}

TEST_CASE("a record comes 3.75 ms after its instant and takes the wire's time") {
    Bench bench;
    bench.say("O1,2,11,0\rUfC");
    motion::FastrakStream stream;
    stream.expect(1, FastrakLayout{{2, 11, 0}, true, true});
    double earliest = 1.0;
    for (int i = 0; i < 2000; ++i, bench.now += 1e-4) {
        motion::Bytes out;
        bench.unit.advance(bench.now, out);
        for (const auto& arrived : stream.receive(out, bench.now, 0.0)) {
            // The motion's y is a clock.
            earliest = std::min(earliest, bench.now - arrived.reading.pose.position.y() / 0.01);
        }
    }
    CHECK(earliest == doctest::Approx(3.75e-3 + 32 * 10 / 115200.0).epsilon(0.03));
}

TEST_CASE("a line too slow drops solutions, not bytes") {
    Bench bench({.baud = 9600});
    const std::string text = bench.say("C", 2.0);
    CHECK(text.size() < 1940);
    CHECK(count(text, "\r\n") >= 38);
    CHECK(bench.unit.dropped() > 150);
}

TEST_CASE("settings read back as they were set") {
    Bench bench({.receivers = 2});
    CHECK(bench.say("l1\r") == "21l1100\r\n");
    CHECK(bench.say("l2,0\rl1\r") == "21l1000\r\n");
    CHECK(bench.say("O1\r") == "21O 2 4 1\r\n");
    CHECK(bench.say("O1,2,11,0\rO1\r") == "21O 2 11 0\r\n");
    CHECK(bench.say("H1,0,0,1\rH1\r") == "21H   0.00   0.00   1.00\r\n");
    CHECK(bench.say("N1,1,,2\rN1\r") == "21N   1.00   0.00   2.00\r\n");
    CHECK(bench.say("x0.2,0.2,0.8,0.8\rx\r") == "2 x  0.200  0.200  0.800  0.800\r\n");
    CHECK(bench.say("r1\r").size() == 3 + 24 + 2);
    CHECK(bench.say("A1\r").size() == 3 + 63 + 2);
}

TEST_CASE("what it does not understand it complains of, and goes on") {
    Bench bench;
    const auto complaint = [&](const std::string& command) {
        return motion::find_complaint(bench.say(command)).value_or("none");
    };
    CHECK(complaint("O1,99\r") == "O1,99: out of range");
    CHECK(complaint("O9,2\r") == "O9,2: out of range");
    CHECK(complaint("Hx\r") == "Hx: expected a number");
    CHECK(complaint("H\r") == "H: something is missing");
    CHECK(complaint("!") == "!: unknown command");
    CHECK(complaint("o77,n,8,0\r") == "o77,n,8,0: expected a number");
    CHECK(complaint(std::string(400, 'O')).find("out of range") != std::string::npos);
    CHECK(motion::find_status(bench.say("\rS")));
    Bench newer({.has_16bit = false});
    CHECK(motion::find_complaint(newer.say("O1,18,20,1\r")));
}

TEST_CASE("alignment, tip, hemisphere and boresight move what it shows as the manual says") {
    Bench bench;
    bench.say("Uf");
    const FastrakLayout layout{{2, 4, 1}, true, true};
    const auto pose = [&](const std::string& commands) {
        const std::string record = bench.say(commands + "P");
        const auto reading =
            decode({reinterpret_cast<const std::uint8_t*>(record.data()), record.size()}, layout);
        REQUIRE(reading);
        return reading->pose;
    };
    const double y = pose("").position.y();
    CHECK(pose("").position.x() == doctest::Approx(0.1));
    CHECK(pose("N1,2,0,0\r").position.x() == doctest::Approx(0.12));
    CHECK(pose("N1,0,0,0\rH1,-1,0,0\r").position.x() == doctest::Approx(-0.1));
    // An origin at the receiver's height, x along the old y: y is then along the old -x.
    const Pose aligned = pose("H1,1,0,0\rA1,0,0,20,0,1,20,-1,0,20\r");
    CHECK(aligned.position.x() == doctest::Approx(y).epsilon(0.01));
    CHECK(aligned.position.y() == doctest::Approx(-0.1));
    CHECK(aligned.position.z() == doctest::Approx(0.0));
    CHECK(pose("G1,0,0,0\rB1\r").orientation.angularDistance(motion::Quaternion::Identity()) <
          1e-6);
    CHECK(pose("b1\r").orientation.angularDistance(motion::Quaternion::Identity()) > 1.0);
    CHECK(pose("R1\r").position.x() == doctest::Approx(0.1));
}

TEST_CASE("a foreign driver that knows nothing but the manual is served") {
    Bench bench({.receivers = 4});
    bench.say("C", 0.3);
    bench.say("c");
    CHECK(bench.say("S").size() == 55);
    bench.say("O1,2,11,0\rO2,2,11,0\rO3,2,11,0\rO4,2,11,0\r");
    CHECK(bench.say("x0.2,0.2,0.8,0.8\rv0.2,0.2,0.8,0.8\rf").empty());
    const std::string stream = bench.say("C", 1.0);
    const std::size_t records = stream.size() / 32;
    CHECK(records >= 118);
    const FastrakLayout inches{{2, 11, 0}, true, false};
    for (std::size_t i = 0; i < records; ++i) {
        const auto reading =
            decode({reinterpret_cast<const std::uint8_t*>(&stream[32 * i]), 32}, inches);
        REQUIRE(reading);
        CHECK(reading->pose.position.x() == doctest::Approx(0.1 * reading->station));
    }
    CHECK(bench.say("\x19", 1.0).empty());
}
