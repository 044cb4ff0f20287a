#include "osc/route.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

using namespace percussionist::osc;

namespace {

ContactMessage contact(int hand, float speed) {
    ContactMessage c;
    c.hand = hand;
    c.velocity = {0.0F, 0.0F, -speed};
    c.place = {0.3F, 0.4F};
    return c;
}

std::string refusal(const std::string& line) {
    try {
        parse_route(line);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("route: what is written parses to the same") {
    for (const char* line :
         {"contact to 10.0.0.1:9000 /hit", "contact to a.b:1 /x velocity*0.5+1 r when hand 1 1",
          "pose to localhost:9001 /stick body x y z when body right_stick",
          "strike to 127.0.0.1:65535 /s ahead-0.25", "status to h:2 /s time load"}) {
        CHECK(to_string(parse_route(line)) == line);
    }
}

TEST_CASE("route: values are the event's, scaled and shifted") {
    const Route route = parse_route("contact to h:1 /x velocity*2+1 r/0.5 hand");
    const auto values = arguments(route, event_of(contact(1, 3.0F)));
    REQUIRE(values.size() == 3);
    CHECK(std::get<double>(values[0]) == doctest::Approx(7.0));
    CHECK(std::get<double>(values[1]) == doctest::Approx(1.0));
    CHECK(std::get<double>(values[2]) == 1.0);
}

TEST_CASE("route: without values all fields go, in the order of the table") {
    const auto values = arguments(parse_route("contact to h:1 /x"), event_of(contact(0, 1.0F)));
    CHECK(values.size() == fields(EventKind::contact).size());
}

TEST_CASE("route: only events that fulfil every condition go") {
    const Route route = parse_route("contact to h:1 /x when hand 1 1 when velocity 2 10");
    CHECK(matches(route, event_of(contact(1, 3.0F))));
    CHECK_FALSE(matches(route, event_of(contact(0, 3.0F))));
    CHECK_FALSE(matches(route, event_of(contact(1, 1.0F))));
    CHECK_FALSE(matches(route, event_of(StatusMessage{})));
    const Route stick = parse_route("pose to h:1 /x when body right_stick");
    CHECK(matches(stick, event_of(BodyPose{"right_stick", {}, {}}, 0.0)));
    CHECK_FALSE(matches(stick, event_of(BodyPose{"left_stick", {}, {}}, 0.0)));
}

TEST_CASE("route: a line that is wrong is refused by the word") {
    CHECK(refusal("dance to h:1 /x").find("dance") != std::string::npos);
    CHECK(refusal("contact at h:1 /x").find("'to'") != std::string::npos);
    CHECK(refusal("contact to nowhere /x").find("HOST:PORT") != std::string::npos);
    CHECK(refusal("contact to h:70000 /x").find("65535") != std::string::npos);
    CHECK(refusal("contact to h:1 hit").find("hit") != std::string::npos);
    CHECK(refusal("contact to h:1 /x colour").find("colour") != std::string::npos);
    CHECK(refusal("contact to h:1 /x r/0").find("factor") != std::string::npos);
    CHECK(refusal("contact to h:1 /x r when hand one 1").find("one") != std::string::npos);
    CHECK(refusal("").find("nothing") != std::string::npos);
}

TEST_CASE("route: a line that a file could not hold, or an answer, is refused") {
    CHECK(refusal("contact to h:1 /x#y r").find("no #") != std::string::npos);
    CHECK(refusal(std::string("contact to h:1 /x\0y", 19)) != "");
    CHECK(refusal("contact to h:1 /" + std::string(1000, 'x')).find("1000") != std::string::npos);
    std::string grows = "contact to h:1 /x";
    for (int i = 0; i < 60; ++i) grows += " r/0.0660123+0.1";
    CHECK(grows.size() < 1000);
    CHECK(refusal(grows).find("shorter") != std::string::npos);
    CHECK(refusal(std::string(900, 'x')).size() < 200);
}

TEST_CASE("route: any bytes are a route or refused") {
    std::mt19937 random(1);
    const std::string good = "contact to 10.0.0.1:9000 /hit velocity*0.5+1 r when hand 1 1";
    for (int i = 0; i < 20000; ++i) {
        std::string line = good;
        for (int k = 0; k < 3; ++k) line[random() % line.size()] = static_cast<char>(random());
        const std::string said = refusal(line);
        if (said.empty()) CHECK(refusal(to_string(parse_route(line))).empty());
    }
}

TEST_CASE("route: the page on the protocol names every field") {
    std::ifstream in(PROJECT_FOLDER "/docs/osc-protocol.md");
    std::stringstream page;
    page << in.rdbuf();
    for (const EventKind kind :
         {EventKind::contact, EventKind::strike, EventKind::pose, EventKind::status}) {
        const std::string row_start = std::string("| `") + name(kind) + "`";
        const std::size_t at = page.str().find(row_start, page.str().find("## Routes"));
        REQUIRE(at != std::string::npos);
        const std::string row = page.str().substr(at, page.str().find('\n', at) - at);
        for (const Field& f : fields(kind)) CHECK(row.find(f.name) != std::string::npos);
    }
}
