#include "osc/endpoint.hpp"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <memory>

#include "support/osc_listener.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist;
using test::OscListener;

namespace {

constexpr int kPatience = 60000;  // [ms]

/// An endpoint by a clock that stands still unless it is told.
struct Standing {
    std::atomic<double> wall{1.7e9};
    osc::Endpoint endpoint;

    explicit Standing(osc::EndpointOptions options = {})
        : endpoint(on_free_port(std::move(options)), [this] { return wall.load(); }) {}
    static osc::EndpointOptions on_free_port(osc::EndpointOptions options) {
        options.port = 0;
        return options;
    }
};

/// The same message so many times, in one packet.
osc::Packet many(int times, const test::OscBytes& message) {
    const auto bytes =
        test::osc_bundle(1, std::vector<test::OscBytes>(static_cast<std::size_t>(times), message));
    return {bytes.begin(), bytes.end()};
}

osc::Packet subscription(const char* address, int port, const std::string& host) {
    std::vector<osc::Argument> arguments{static_cast<double>(port)};
    if (address == std::string("/subscribe")) arguments.emplace_back(std::string("sound"));
    arguments.emplace_back(host);
    return osc::encode_message(address, arguments);
}

}  // namespace

TEST_CASE("endpoint: a flood of questions makes no flood of answers, and others are answered") {
    Standing server;
    OscListener asker(server.endpoint.port());
    for (int i = 0; i < 20; ++i) asker.send(many(100, test::osc_message("/describe", "", {})));
    osc::UdpSocket other("127.0.0.2", 0);  // another host, as far as the server can tell
    other.send(osc::encode_text("/ping", {}),
               osc::UdpSocket::address(*osc::UdpSocket::numeric("127.0.0.1"),
                                       std::to_string(server.endpoint.port())));
    std::array<char, 256> answer{};
    CHECK(other.receive(answer, kPatience));
    CHECK(asker.hears("/description"));
    CHECK(asker.count("/description") <= static_cast<int>(osc::AnswerBudget::kAtOnce));
    CHECK(asker.count("/pong") == 0);
    server.wall = server.wall + 1.0;
    asker.send("/ping");
    CHECK(asker.hears("/pong"));
}

TEST_CASE("endpoint: an /error is never answered, so two servers cannot complain for ever") {
    Standing server;
    OscListener other_server(server.endpoint.port());
    for (int i = 0; i < 10; ++i) other_server.send("/error", {"/clock", "no such address"});
    other_server.send("/ping");
    REQUIRE(other_server.hears("/pong"));
    CHECK(other_server.count("/error") == 0);
}

TEST_CASE("endpoint: a server told of itself goes on serving") {
    Standing server;
    OscListener asker(server.endpoint.port());
    asker.send(subscription("/subscribe", server.endpoint.port(), "127.0.0.1"));
    for (int i = 1; i <= 20; ++i) {
        server.wall = server.wall + 0.02;
        asker.send("/ping");
        REQUIRE(asker.hears("/pong", i));
    }
    CHECK(server.endpoint.subscribers() == 1);
}

TEST_CASE("endpoint: no name is looked up at a stranger's wish, one given with --allow is known") {
    osc::EndpointOptions options;
    options.allow = {"localhost"};
    Standing server(options);
    OscListener asker(server.endpoint.port());
    asker.send(subscription("/subscribe", 9000, "drums.example"));
    asker.send("/route/add", {"contact to drums.example:9000 /hit"});
    REQUIRE(asker.hears("/error", 2));
    for (const int i : {1, 3}) {
        CHECK(asker.texts("/error").at(i).find("in numbers") != std::string::npos);
    }
    asker.send("/route/add", {"contact to localhost:9000 /hit"});
    CHECK(asker.hears("/route"));
}

TEST_CASE("endpoint: nobody can unsubscribe a third party") {
    osc::EndpointOptions options;
    options.allow = {"192.0.2.7"};
    Standing server(options);
    OscListener asker(server.endpoint.port());
    asker.send(subscription("/subscribe", 9000, "192.0.2.7"));
    asker.send("/ping");
    REQUIRE(asker.hears("/pong"));
    REQUIRE(server.endpoint.subscribers() == 1);
    asker.send(subscription("/unsubscribe", 9000, "192.0.2.8"));
    CHECK(asker.hears("/error"));
    asker.send(subscription("/unsubscribe", 9000, "192.0.2.7"));
    asker.send("/ping");
    REQUIRE(asker.hears("/pong", 2));
    CHECK(server.endpoint.subscribers() == 0);
}

TEST_CASE("endpoint: commands wait in bounded memory and are taken a few at a time, in order") {
    Standing server;
    OscListener asker(server.endpoint.port());
    asker.send(many(1000, test::osc_message("/tempo", "f", {test::osc_float(2.0)})));
    asker.send("/ping");
    REQUIRE(asker.hears("/pong"));
    std::size_t all = 0;
    for (auto some = server.endpoint.take_commands(); !some.empty();
         some = server.endpoint.take_commands()) {
        CHECK(some.size() <= 2);
        all += some.size();
    }
    CHECK(all == 256);
}

TEST_CASE("endpoint: what is told faster than it can be sent is left out, poses first") {
    Standing server;
    osc::PoseMessage pose;
    pose.bodies.assign(20, {"right_upper_arm", {}, {}});
    OscListener listener(server.endpoint.port());
    listener.send(subscription("/subscribe", listener.port(), "127.0.0.1"));
    listener.send("/ping");
    REQUIRE(listener.hears("/pong"));
    for (int i = 0; i < 20000; ++i) server.endpoint.tell(pose);
    server.endpoint.tell(osc::FinishedMessage{});
    CHECK(listener.hears("/finished"));
}

TEST_CASE("endpoint: one that is gone is dropped, though the next one's packet takes its error") {
    for (int round = 0; round < 5; ++round) {
        Standing server;
        OscListener witness(server.endpoint.port());
        {
            OscListener leaves(server.endpoint.port());
            leaves.send(subscription("/subscribe", leaves.port(), "127.0.0.1"));
            leaves.send("/ping");
            REQUIRE(leaves.hears("/pong"));
        }
        witness.send(subscription("/subscribe", witness.port(), "127.0.0.1"));
        witness.send("/ping");
        REQUIRE(witness.hears("/pong"));
        REQUIRE(server.endpoint.subscribers() == 2);
        server.endpoint.tell(osc::StatusMessage{});
        CHECK(witness.hears("/dropped"));
        CHECK(server.endpoint.subscribers() == 1);
    }
}

TEST_CASE("endpoint: what is told last is sent as often as all else, though the server ends") {
    auto server = std::make_unique<Standing>();
    OscListener listener(server->endpoint.port());
    listener.send(subscription("/subscribe", listener.port(), "127.0.0.1"));
    listener.send("/ping");
    REQUIRE(listener.hears("/pong"));
    server->endpoint.tell(osc::FinishedMessage{});
    server.reset();
    CHECK(listener.hears("/finished", 5));
}

TEST_CASE("endpoint: who has fallen silent is dropped by time, though no packet comes") {
    Standing server;
    OscListener listener(server.endpoint.port());
    for (int i = 0; i < 2; ++i) {
        listener.send(subscription("/subscribe", listener.port(), "127.0.0.1"));
    }
    listener.send("/ping");
    REQUIRE(listener.hears("/pong"));
    REQUIRE(server.endpoint.subscribers() == 1);
    OscListener witness(server.endpoint.port());
    witness.send(subscription("/subscribe", witness.port(), "127.0.0.1"));
    witness.send("/ping");
    REQUIRE(witness.hears("/pong"));
    server.wall = server.wall + osc::Audience::kLease + 1.0;
    CHECK(witness.hears("/dropped"));
    CHECK(server.endpoint.subscribers() == 1);
}
