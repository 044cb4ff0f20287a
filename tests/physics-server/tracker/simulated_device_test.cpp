// A foreign driver, which knows the manual and a serial port and nothing of ours, on the simulated
// device. Time is an argument: the device is moved along as the driver waits.
#include "tracker/simulated_device.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "core/motion/bodhran_player.hpp"
#include "tracker/recorded_motion.hpp"

using namespace percussionist;
using namespace percussionist::tracker;

namespace {

class Driver {
  public:
    explicit Driver(SimulatedDeviceSettings settings)
        : device_(
              [&settings] {
                  settings.link = (std::filesystem::temp_directory_path() /
                                   ("foreign-driver-" + std::to_string(getpid())))
                                      .string();
                  return settings;
              }(),
              [this](int station, double time) { return player_.receiver(station, time); },
              [this](const std::string& name) { name_ = name; }) {
        open_port(B115200);
    }
    ~Driver() { close(port_); }

    void open_port(speed_t rate) {
        close(port_);
        port_ = open(name_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
        REQUIRE(port_ >= 0);
        termios line{};
        tcgetattr(port_, &line);
        cfmakeraw(&line);
        cfsetspeed(&line, rate);
        tcsetattr(port_, TCSANOW, &line);
    }

    /// Writes and reads what comes within so long [s].
    std::string say(const std::string& text, double seconds) {
        if (!text.empty()) {
            CHECK(write(port_, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
        }
        std::string heard;
        for (const double end = now_ + seconds; now_ < end; now_ += 1e-3) {
            device_.run(now_);
            char bytes[512];
            const ssize_t count = read(port_, bytes, sizeof bytes);
            heard.append(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        }
        return heard;
    }
    void order(const std::string& line) { device_.order(line, now_); }

  private:
    motion::BodhranPlayer player_;
    std::string name_;
    SimulatedDevice device_;
    int port_ = -1;
    double now_ = 0.0;
};

SimulatedDeviceSettings four_receivers() {
    SimulatedDeviceSettings settings;
    settings.unit.receivers = 4;
    return settings;
}

float number(const std::string& stream, std::size_t at) {
    float value = 0.0F;
    std::memcpy(&value, &stream[at], sizeof value);
    return value;
}

}  // namespace

TEST_CASE("a foreign driver gets its status, its settings and an unbroken stream in inches") {
    static_assert(std::endian::native == std::endian::little);
    Driver driver(four_receivers());
    driver.say("c", 0.1);
    const std::string status = driver.say("S", 0.1);
    REQUIRE(status.size() == 55);
    CHECK(status.substr(0, 3) == "21S");
    CHECK(status.substr(53) == "\r\n");
    for (const char* command : {"O1,2,11,0\r", "O2,2,11,0\r", "O3,2,11,0\r", "O4,2,11,0\r",
                                "x0.2,0.2,0.8,0.8\r", "v0.2,0.2,0.8,0.8\r", "f"}) {
        CHECK(driver.say(command, 0.02).empty());
    }
    const std::string stream = driver.say("C", 2.0);
    const std::size_t records = stream.size() / 32;
    CHECK(records >= 237);
    for (std::size_t i = 0; i < records; ++i) {
        const std::size_t at = 32 * i;
        REQUIRE(stream[at] == '0');
        REQUIRE(stream[at + 1] == static_cast<char>('1' + (stream[1] - '1' + i) % 4));
        REQUIRE(stream[at + 31] == ' ');
        double norm = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            norm += std::pow(number(stream, at + 15 + 4 * k), 2);
        }
        CHECK(norm == doctest::Approx(1.0).epsilon(1e-5));
        if (stream[at + 1] == '2') {  // the chest, 0.30 m in front
            CHECK(number(stream, at + 3) == doctest::Approx(0.30 / 0.0254).epsilon(0.1));
        }
    }
    CHECK(driver.say("c", 0.1).size() < 100);
    CHECK(driver.say("", 0.1).empty());
}

TEST_CASE("silence is silent, then it goes on; unplugged the port hangs up and comes back") {
    Driver driver(four_receivers());
    CHECK(driver.say("C", 0.2).size() > 500);
    driver.order("silence 0.3");
    CHECK(driver.say("", 0.29).empty());
    CHECK(driver.say("", 0.2).size() > 500);
    driver.order("unplug 0.1");
    CHECK(driver.say("", 0.05).empty());
    driver.say("", 0.1);
    driver.open_port(B115200);
    CHECK(driver.say("S", 0.1).size() == 55);  // it has lost power: no longer continuous
}

TEST_CASE("at another rate there is garbage only") {
    SimulatedDeviceSettings settings = four_receivers();
    settings.unit.baud = 38400;
    settings.strict_baud = true;
    Driver driver(settings);
    CHECK(driver.say("S", 0.2).empty());
    driver.open_port(B38400);
    CHECK(driver.say("S", 0.2).size() == 55);
    driver.say("C", 0.1);
    driver.open_port(B9600);
    CHECK(driver.say("", 0.3).find("01 ") == std::string::npos);
}

TEST_CASE("orders that are none say what is understood") {
    Driver driver(four_receivers());
    for (const char* bad : {"garbage", "garbage 200", "sing 3", "unplug x", "baud 7", "cut -1"}) {
        CHECK_THROWS_AS(driver.order(bad), std::runtime_error);
    }
    driver.order("garbage 5");
    driver.order("");
    driver.order("error j");
}

TEST_CASE("a recording moves the receivers as it was, and begins again") {
    std::istringstream file(
        "time [s],station,x [m],y [m],z [m],qw,qx,qy,qz\n"
        "10,1,0.1,0,0,1,0,0,0\n10.5,1,0.3,0,0,1,0,0,0\n11,2,0.5,0,0,1,0,0,0\n");
    const Recording recording = read_recording(file, "test.csv");
    CHECK(recording.receivers == 2);
    CHECK(recording.duration == 1.0);
    CHECK(recording.motion(1, 0.25).position.x() == doctest::Approx(0.2));
    CHECK(recording.motion(1, 3.25).position.x() == doctest::Approx(0.2));
    CHECK(recording.motion(2, 0.0).position.x() == doctest::Approx(0.5));
}

TEST_CASE("a bad recording is refused with its line") {
    for (const auto& [text, part] : {std::pair{"", "line 1"},
                                     {"1,1,0,0,0,1,0,0,0\nx\n", "line 2"},
                                     {"1,1,0,0,0,1,0,0,0\n1,1,0,0,0,1,0,0,0\n", "later time"}}) {
        std::istringstream file(text);
        try {
            read_recording(file, "test.csv");
            FAIL("accepted");
        } catch (const std::runtime_error& e) {
            CHECK(std::string(e.what()).find("test.csv") == 0);
            CHECK(std::string(e.what()).find(part) != std::string::npos);
        }
    }
    CHECK_THROWS_AS(read_recording("/nowhere.csv"), std::runtime_error);
}
