#include "io/osc_receiver.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "io/monotonic.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist::io;
using namespace percussionist::test;

namespace {

constexpr std::uint32_t kHere = 0x7F000001;

/// Waits for the other thread; a test that fails waits this long.
template <class Condition>
bool soon(Condition condition) {
    const double end = monotonic_seconds() + 10.0;
    while (!condition()) {
        if (monotonic_seconds() > end) {
            return false;
        }
        std::this_thread::yield();
    }
    return true;
}

struct Here {
    OscReceiver receiver{"127.0.0.1", 0};
    UdpSocket sender{"127.0.0.1", 0};
    Endpoint there{kHere, static_cast<std::uint16_t>(receiver.port())};
    std::vector<std::unique_ptr<Delivery>> got = {};

    void take() {
        while (auto delivery = receiver.next()) {
            got.push_back(std::move(delivery));
        }
    }
    bool wait_for(std::size_t count) {
        return soon([&] { return take(), got.size() >= count; });
    }
};

/// Packets that come to a socket.
std::vector<OscBytes> received(UdpSocket& socket, std::size_t count) {
    std::vector<OscBytes> all;
    soon([&] {
        socket.receive([&](auto bytes, const Endpoint&, double) {
            all.emplace_back(bytes.begin(), bytes.end());
        });
        return all.size() >= count;
    });
    return all;
}

}  // namespace

TEST_CASE("a burst of 3000 packets loses none, and they stay in order") {
    Here here;
    for (int i = 0; i < 3000; ++i) {
        here.sender.send(here.there, osc_message("/n", "i", {osc_int(i)}));
    }
    REQUIRE(here.wait_for(3000));
    int wrong = 0;
    for (int i = 0; i < 3000; ++i) {
        wrong += std::get<double>(here.got[i]->messages.at(0).arguments.at(0)) != i;
    }
    CHECK(wrong == 0);
    CHECK(soon([&] { return here.receiver.status().received == 3000; }));
    CHECK(here.receiver.status().dropped == 0);
}

TEST_CASE("packets carry the time they reached the machine, not that at which they were read") {
    UdpSocket socket("127.0.0.1", 0), sender("127.0.0.1", 0);
    // The kernel begins to stamp packets a little after it is asked to.
    CHECK(soon([&] {
        const double before = monotonic_seconds();
        sender.send({kHere, static_cast<std::uint16_t>(socket.port())}, OscBytes{1});
        const double after = monotonic_seconds();
        while (monotonic_seconds() < after + 0.02) {
        }
        double arrived = 0.0;
        socket.receive([&](auto, const Endpoint&, double arrival) { arrived = arrival; });
        return arrived > before - 1e-4 && arrived < after + 1e-3;
    }));
}

TEST_CASE("a port that is taken is refused with its number and the reason") {
    const OscReceiver first("127.0.0.1", 0);
    std::string reason;
    try {
        const OscReceiver second("127.0.0.1", first.port());
    } catch (const std::runtime_error& e) {
        reason = e.what();
    }
    CHECK(reason == "cannot listen on 127.0.0.1 port " + std::to_string(first.port()) +
                        ": Address already in use");
    CHECK_THROWS_WITH(OscReceiver("nowhere", 0),
                      "address nowhere: expected four numbers, as 0.0.0.0");
}

TEST_CASE("packets are sent to the server, and a subscription at once") {
    Here here;
    UdpSocket server("127.0.0.1", 0);
    const Bytes subscribe = write_osc("/subscribe", {}), play = write_osc("/play", {});
    here.receiver.set_server("127.0.0.1", server.port());
    here.receiver.send(play);
    here.receiver.send_often(subscribe);
    CHECK(received(server, 2) == std::vector<OscBytes>{play, subscribe});
}

TEST_CASE("a host that is not there yet is looked for again and again, and said so of once") {
    const auto asked = std::make_shared<std::atomic<int>>(0);  // by threads that may outlive this
    OscReceiver receiver(
        "127.0.0.1", 0,
        {.ask = [asked](const std::string&) { return ++*asked < 4 ? 0 : kHere; }, .again = 1e-3});
    UdpSocket server("127.0.0.1", 0);
    const Bytes subscribe = write_osc("/subscribe", {});
    receiver.set_server("stage.local", server.port());
    receiver.send_often(subscribe);
    CHECK(received(server, 1) == std::vector<OscBytes>{subscribe});
    CHECK(*asked == 4);
    const auto said = receiver.next();
    REQUIRE(said);
    CHECK(said->complaint == "no host stage.local");
    CHECK(!receiver.next());
}

TEST_CASE("what was sent to a host that is not there is said to be lost, and goes to no other") {
    OscReceiver receiver("127.0.0.1", 0,
                         {.ask = [](const std::string&) { return 0U; }, .again = 1e-3});
    UdpSocket server("127.0.0.1", 0);
    const Bytes stop = write_osc("/stop", {}), play = write_osc("/play", {});
    receiver.set_server("nowhere", server.port());
    for (int i = 0; i < 2; ++i) {
        receiver.send(stop);
        CHECK(soon([&] {
            const auto said = receiver.next();
            return said && said->complaint == "no host nowhere";
        }));
    }
    receiver.send(stop);
    receiver.set_server("127.0.0.1", server.port());
    receiver.send(play);
    CHECK(received(server, 1) == std::vector<OscBytes>{play});
}

TEST_CASE("what was asked to be sent is sent before the end") {
    UdpSocket server("127.0.0.1", 0);
    const Bytes farewell = write_osc("/unsubscribe", {});
    {
        OscReceiver receiver("127.0.0.1", 0);
        receiver.set_server("localhost", server.port());
        receiver.send(farewell);
    }
    CHECK(received(server, 1) == std::vector<OscBytes>{farewell});
}

TEST_CASE("a receiver that nobody empties drops and counts, and goes on") {
    Here here;
    for (std::size_t i = 0; i < OscReceiver::kMostWaiting + 100; ++i) {
        here.sender.send(here.there, osc_message("/n", "", {}));
        if (i % 500 == 0) {
            soon([&] { return here.receiver.status().received > static_cast<double>(i) - 200; });
        }
    }
    CHECK(soon([&] { return here.receiver.status().dropped == 100; }));
    here.take();
    CHECK(here.got.size() == OscReceiver::kMostWaiting);
    for (auto& delivery : here.got) {
        here.receiver.give_back(std::move(delivery));
    }
    here.got.clear();
    here.sender.send(here.there, osc_message("/n", "", {}));
    CHECK(here.wait_for(1));
}
