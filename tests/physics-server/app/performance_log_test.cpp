#include "app/performance_log.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace percussionist;

namespace {

app::LoggedContact contact(int sequence, int stroke, double asked, double instant) {
    app::LoggedContact c;
    c.sequence = sequence;
    c.stroke = stroke;
    c.asked_time = asked;
    c.event.instant = instant;
    return c;
}

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("percussionist-" + name);
}

}  // namespace

TEST_CASE("performance log: a constant delay is no error, a late contact is") {
    app::PerformanceLog log;
    log.add(contact(0, 0, 1.0, 1.010));
    log.add(contact(1, 1, 2.0, 2.010));
    log.add(contact(2, 2, 3.0, 3.013));
    const app::TimingSummary s = log.summary(3);
    CHECK(s.offset == doctest::Approx(0.010));
    CHECK(s.worst_error == doctest::Approx(0.003));
    CHECK(s.median_error == doctest::Approx(0.0));
}

TEST_CASE("performance log: missed strokes and uncalled contacts are told apart") {
    app::PerformanceLog log;
    log.add(contact(0, 0, 1.0, 1.0));
    log.add(contact(1, 0, 1.0, 1.03));
    log.add(contact(2, -1, 0.0, 5.0));
    const app::TimingSummary s = log.summary(2);
    CHECK(s.contacts == 1);
    CHECK(s.missed == 1);
    CHECK(s.uncalled == 2);
}

TEST_CASE("performance log: the times asked for are read back as written") {
    app::PerformanceLog log;
    log.add(contact(0, 1, 2.5, 2.51));
    log.add(contact(1, 0, 1.25, 1.26));
    log.add(contact(2, -1, 0.0, 5.0));
    const auto path = scratch("log.csv");
    log.write_csv(path);
    const std::vector<double> times = app::read_asked_times(path);
    std::filesystem::remove(path);
    REQUIRE(times.size() == 2);
    CHECK(times[0] == 1.25);
    CHECK(times[1] == 2.5);
}

TEST_CASE("performance log: a file of another kind is refused by line") {
    const auto path = scratch("other.csv");
    std::ofstream(path) << "a,b\n1,2\n";
    try {
        app::read_asked_times(path);
        FAIL("accepted");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find("line 2") != std::string::npos);
    }
    std::filesystem::remove(path);
    CHECK_THROWS_AS(app::read_asked_times(scratch("nowhere.csv")), std::runtime_error);
}
