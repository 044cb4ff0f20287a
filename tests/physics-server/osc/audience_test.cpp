#include "osc/audience.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#include "osc/udp_socket.hpp"

using namespace percussionist::osc;

namespace {

sockaddr_in at_port(int port) {
    return UdpSocket::resolve("127.0.0.1", std::to_string(port));
}

std::size_t heard_by(const Audience& audience, Feed feed) {
    Audience::Addresses to;
    return audience.listeners(feed, to);
}

}  // namespace

TEST_CASE("audience: each hears its feed, once, however often it renews") {
    Audience audience;
    audience.subscribe(at_port(1), Feed::sound, 0.0);
    audience.subscribe(at_port(2), Feed::pose, 0.0);
    audience.subscribe(at_port(3), Feed::all, 0.0);
    audience.subscribe(at_port(1), Feed::sound, 1.0);
    CHECK(heard_by(audience, Feed::sound) == 2);
    CHECK(heard_by(audience, Feed::pose) == 2);
    CHECK(heard_by(audience, Feed::all) == 3);
}

TEST_CASE("audience: who renewed and fell silent is dropped, who never did stays") {
    Audience audience;
    audience.subscribe(at_port(1), Feed::sound, 0.0);
    audience.subscribe(at_port(2), Feed::sound, 0.0);
    audience.subscribe(at_port(2), Feed::sound, 3.0);
    CHECK(audience.drop_silent(3.0 + 0.9 * Audience::kLease).empty());
    const auto dropped = audience.drop_silent(3.0 + 1.1 * Audience::kLease);
    REQUIRE(dropped.size() == 1);
    CHECK(dropped[0].port == "2");
    CHECK(audience.subscribers() == 1);
}

TEST_CASE("audience: no more than it has room for") {
    Audience audience;
    for (std::size_t i = 0; i < Audience::kMostSubscribers; ++i) {
        audience.subscribe(at_port(1000 + static_cast<int>(i)), Feed::all, 0.0);
    }
    CHECK_THROWS_AS(audience.subscribe(at_port(1), Feed::all, 0.0), std::runtime_error);
    CHECK_NOTHROW(audience.subscribe(at_port(1000), Feed::pose, 1.0));
    const Route route = parse_route("status to h:1 /s");
    for (std::size_t i = 0; i < Audience::kMostRoutes; ++i) audience.add_route(route, at_port(1));
    CHECK_THROWS_AS(audience.add_route(route, at_port(1)), std::runtime_error);
}

TEST_CASE("audience: a route keeps its number until it is removed") {
    Audience audience;
    const int first = audience.add_route(parse_route("status to h:1 /a"), at_port(1));
    const int second = audience.add_route(parse_route("status to h:1 /b"), at_port(1));
    CHECK(audience.remove_route(first));
    CHECK_FALSE(audience.remove_route(first));
    CHECK(audience.change_route(second, parse_route("status to h:1 /c"), at_port(2)));
    const auto all = audience.routes();
    REQUIRE(all.size() == 1);
    CHECK(all[0].first == second);
    CHECK(all[0].second == "status to h:1 /c");
    int sent = 0;
    audience.route(event_of(StatusMessage{}), [&](const Route& r, const sockaddr_in& to) {
        CHECK(r.address == "/c");
        CHECK(same(to, at_port(2)));
        ++sent;
    });
    CHECK(sent == 1);
}
