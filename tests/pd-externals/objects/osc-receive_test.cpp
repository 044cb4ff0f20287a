#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <thread>
#include <utility>

#include "io/monotonic.hpp"
#include "io/udp_socket.hpp"
#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"
#include "support/osc_writer.hpp"

extern "C" void setup_osc0x2dreceive();

using namespace percussionist;
using namespace percussionist::pdx;
using namespace percussionist::test;

namespace {

FakeObject* create(FakeHost& host, std::vector<Atom> arguments = {0.0}) {
    if (!find_class("osc-receive")) {
        setup_osc0x2dreceive();
    }
    return host.create("osc-receive", std::move(arguments));
}

double told(FakeObject& object, const std::string& name) {
    object.sent();
    object.message("status");
    for (const auto& sent : object.sent()) {
        if (sent.outlet == 1 && sent.selector == name) {
            return std::get<double>(sent.atoms.at(0));
        }
    }
    return std::nan("");
}

io::Endpoint here(FakeObject& object) {
    return {0x7F000001, static_cast<std::uint16_t>(told(object, "port"))};
}

/// Runs until as many messages have come out on the left.
std::vector<Sent> wait_for(FakeHost& host, FakeObject& object, std::size_t count) {
    std::vector<Sent> all;
    const double end = io::monotonic_seconds() + 10.0;
    while (all.size() < count && io::monotonic_seconds() < end) {
        host.run_tick();
        for (auto& sent : object.sent()) {
            if (sent.outlet == 0) {
                all.push_back(std::move(sent));
            }
        }
        std::this_thread::yield();
    }
    return all;
}

std::vector<OscBytes> received(io::UdpSocket& socket, std::size_t count) {
    std::vector<OscBytes> all;
    const double end = io::monotonic_seconds() + 10.0;
    while (all.size() < count && io::monotonic_seconds() < end) {
        socket.receive([&](auto bytes, const io::Endpoint&, double) {
            all.emplace_back(bytes.begin(), bytes.end());
        });
        std::this_thread::yield();
    }
    return all;
}

}  // namespace

TEST_CASE("a message leaves with its address as selector and its arguments in order") {
    FakeHost host;
    auto& object = *create(host);
    const io::UdpSocket sender("127.0.0.1", 0);
    sender.send(here(object),
                osc_message("/a/b", "isd", {osc_int(1), osc_text("two"), osc_double(3.5)}));
    const auto sent = wait_for(host, object, 1);
    REQUIRE(sent.size() == 1);
    CHECK(sent[0].selector == "/a/b");
    REQUIRE(sent[0].atoms.size() == 3);
    CHECK(to_string(sent[0].atoms[0]) == "1");
    CHECK(to_string(sent[0].atoms[1]) == "two");
    CHECK(to_string(sent[0].atoms[2]) == "3.5");
}

TEST_CASE("contacts come once each, in the order of their instants") {
    FakeHost host;
    auto& object = *create(host);
    const io::UdpSocket sender("127.0.0.1", 0);
    sender.send(here(object), clock_packet(0.0, 0.03));
    std::vector<Contact> recent;
    for (int i = 0; i < 50; ++i) {
        recent.insert(recent.begin(), {i, -0.02 + 0.0004 * i});
        recent.resize(std::min<std::size_t>(recent.size(), 4));
        sender.send(here(object), contact_packet(recent, 0.03));
        sender.send(here(object), contact_packet(recent, 0.03));
    }
    const auto sent = wait_for(host, object, 51);
    REQUIRE(sent.size() == 51);
    int next = 0;
    for (const auto& message : sent) {
        if (message.selector == "/contact") {
            CHECK(to_string(message.atoms.at(0)) == std::to_string(next++));
        }
    }
    CHECK(told(object, "lost") == 0);
    CHECK(told(object, "repeated") > 50);
}

TEST_CASE("the state of things is told each second and when asked") {
    FakeHost host;
    auto& object = *create(host);
    host.advance_to(2.5);
    int lines = 0;
    for (const auto& sent : object.sent()) {
        lines += sent.selector == "lost";
        CHECK(sent.outlet == 1);
    }
    CHECK(lines == 2);
    for (const char* name : {"received", "lost", "late", "latest", "repeated", "malformed",
                             "dropped", "senders", "lookahead", "offset", "rate", "jitter"}) {
        CHECK(told(object, name) == 0);
    }
}

TEST_CASE("a malformed packet is counted and told of, and nothing else") {
    FakeHost host;
    auto& object = *create(host);
    const io::UdpSocket sender("127.0.0.1", 0);
    sender.send(here(object), OscBytes{'n', 'o'});
    sender.send(here(object), osc_message("/a", "", {}));
    CHECK(wait_for(host, object, 1).size() == 1);
    const auto errors = host.errors();
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].find("osc-receive: malformed packet from 127.0.0.1:") == 0);
    CHECK(told(object, "malformed") == 1);
}

TEST_CASE("a port that is taken is one error; the object lives and takes another later") {
    FakeHost host;
    auto& first = *create(host);
    const double taken = told(first, "port");
    auto* const second = create(host, {taken});
    REQUIRE(second);
    const std::string reason =
        "cannot listen on 0.0.0.0 port " + to_string(Atom(taken)) + ": Address already in use";
    CHECK(host.errors() == std::vector<std::string>{"osc-receive: " + reason});
    second->message("send", {"/play"});
    CHECK(host.errors() ==
          std::vector<std::string>{"osc-receive: send: it has no port: send it port N"});
    host.advance_to(0.1);
    second->message("port", {0.0});
    CHECK(host.errors().empty());
    const io::UdpSocket sender("127.0.0.1", 0);
    sender.send(here(*second), osc_message("/a", "", {}));
    CHECK(wait_for(host, *second, 1).size() == 1);
    host.destroy(&first);
    second->message("port", {taken});
    CHECK(host.errors().empty());
}

TEST_CASE("subscribing asks the server, leaving tells it, and so does going away") {
    FakeHost host;
    auto& object = *create(host);
    io::UdpSocket server("127.0.0.1", 0);
    const auto port = osc_int(here(object).port);
    const auto subscribe = [&](const char* feed) {
        return osc_message("/subscribe", "is", {port, osc_text(feed)});
    };
    const auto unsubscribe = osc_message("/unsubscribe", "i", {port});
    object.message("subscribe", {"127.0.0.1", static_cast<double>(server.port())});
    CHECK(received(server, 1) == std::vector<OscBytes>{subscribe("sound")});
    object.message("feed", {"all"});
    CHECK(received(server, 1) == std::vector<OscBytes>{subscribe("all")});
    object.message("send", {"/tempo", 120.0, "x"});
    CHECK(received(server, 1) ==
          std::vector<OscBytes>{osc_message("/tempo", "fs", {osc_float(120), osc_text("x")})});
    object.message("unsubscribe");
    CHECK(received(server, 1) == std::vector<OscBytes>{unsubscribe});
    object.message("subscribe", {"localhost", static_cast<double>(server.port())});
    CHECK(received(server, 1) == std::vector<OscBytes>{subscribe("all")});
    host.destroy(&object);
    CHECK(received(server, 1) == std::vector<OscBytes>{unsubscribe});
    CHECK(host.errors().empty());
}

TEST_CASE("subscribing to another server, or at another port, leaves the one before") {
    FakeHost host;
    auto& object = *create(host);
    io::UdpSocket first("127.0.0.1", 0), second("127.0.0.1", 0);
    const auto port = osc_int(here(object).port);
    const auto subscribe = osc_message("/subscribe", "is", {port, osc_text("sound")});
    const auto unsubscribe = osc_message("/unsubscribe", "i", {port});
    const auto to = [&](const io::UdpSocket& server) {
        object.message("subscribe", {"127.0.0.1", static_cast<double>(server.port())});
    };
    to(first);
    CHECK(received(first, 1) == std::vector<OscBytes>{subscribe});
    to(first);
    CHECK(received(first, 1) == std::vector<OscBytes>{subscribe});
    to(second);
    CHECK(received(first, 1) == std::vector<OscBytes>{unsubscribe});
    CHECK(received(second, 1) == std::vector<OscBytes>{subscribe});
    object.message("unsubscribe");
    CHECK(received(second, 1) == std::vector<OscBytes>{unsubscribe});
    to(first);
    CHECK(received(first, 1) == std::vector<OscBytes>{subscribe});
}

TEST_CASE("going away with more to send than there is room for, it still tells the server") {
    for (int i = 0; i < 5; ++i) {
        FakeHost host;
        auto& object = *create(host);
        io::UdpSocket server("127.0.0.1", 0);
        const auto farewell = osc_message("/unsubscribe", "i", {osc_int(here(object).port)});
        object.message("subscribe", {"127.0.0.1", static_cast<double>(server.port())});
        OscBytes last;
        const auto read = [&] {
            return server.receive([&](auto bytes, const io::Endpoint&, double) {
                last.assign(bytes.begin(), bytes.end());
            });
        };
        for (int sent = 0; sent < 20000 && host.errors().empty(); ++sent) {
            object.message("send", {"/play"});
            while (sent % 100 == 0 && read()) {
            }
        }
        host.destroy(&object);
        while (read()) {
        }
        CHECK(last == farewell);
    }
}

TEST_CASE("every bad message to it gets one error and changes nothing") {
    FakeHost host;
    auto& object = *create(host);
    const double port = told(object, "port");
    const std::vector<std::pair<std::string, std::vector<Atom>>> bad = {
        {"port", {}},        {"port", {-1.0}},
        {"port", {65536.0}}, {"port", {"x"}},
        {"listen", {}},      {"listen", {1.0}},
        {"latency", {-1.0}}, {"latency", {"x"}},
        {"feed", {"wine"}},  {"feed", {}},
        {"send", {}},        {"send", {"play"}},
        {"send", {1.0}},     {"subscribe", {7770.0}},
        {"status", {1.0}},   {"bang", {}},
        {"nonsense", {1.0}}, {"subscribe", {"localhost", 0.0}},
    };
    for (const auto& [selector, atoms] : bad) {
        CAPTURE(selector);
        object.message(selector, atoms);
        const auto errors = host.errors();
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].find("osc-receive: ") == 0);
        CHECK(errors[0].find(selector) != std::string::npos);
    }
    CHECK(told(object, "port") == port);
    object.message("listen", {"no.such.address"});
    CHECK(host.errors() ==
          std::vector<std::string>{
              "osc-receive: listen: address no.such.address: expected four numbers, as 0.0.0.0"});
    CHECK(told(object, "port") == port);
}

TEST_CASE("told to listen where it cannot, it says so and listens where it did") {
    FakeHost host;
    auto& object = *create(host);
    const io::UdpSocket sender("127.0.0.1", 0), taken("127.0.0.1", 0);
    const double port = told(object, "port");
    const auto refused = [&](const char* selector, const Atom& atom) {
        object.message(selector, {atom});
        const auto errors = host.errors();
        REQUIRE(errors.size() == 1);
        CHECK(told(object, "port") == port);
        sender.send(here(object), osc_message("/a", "", {}));
        CHECK(wait_for(host, object, 1).size() == 1);
        return errors[0];
    };
    const auto in_use = [](double number) {
        return " port " + to_string(Atom(number)) + ": Address already in use";
    };
    const std::string foreign =
        "osc-receive: listen: cannot listen on 203.0.113.5: Cannot assign requested address";
    const double other = taken.port();
    CHECK(refused("port", other) == "osc-receive: port: cannot listen on 0.0.0.0" + in_use(other));
    CHECK(refused("listen", "203.0.113.5") == foreign);
    object.message("port", {port});
    CHECK(refused("listen", "203.0.113.5") == foreign);
    object.message("listen", {"127.0.0.1"});
    CHECK(host.errors().empty());
    const io::UdpSocket in_the_way("127.0.0.2", static_cast<int>(port));
    CHECK(refused("listen", "0.0.0.0") ==
          "osc-receive: listen: cannot listen on 0.0.0.0" + in_use(port));
}

TEST_CASE("many objects come and go while packets arrive") {
    FakeHost host;
    const io::UdpSocket sender("127.0.0.1", 0);
    for (int i = 0; i < 20; ++i) {
        auto* const a = create(host);
        auto* const b = create(host);
        for (int k = 0; k < 50; ++k) {
            sender.send(here(*a), osc_message("/a", "i", {osc_int(k)}));
            sender.send(here(*b), clock_packet(0.01 * k, 0.03));
        }
        host.run_tick();
        host.destroy(i % 2 == 0 ? a : b);
        host.run_tick();
        host.destroy(i % 2 == 0 ? b : a);
    }
    CHECK(host.errors().empty());
}

TEST_CASE("deleted by what it sends itself, of many messages at once, it ends in peace") {
    for (const int which : {0, 3}) {
        FakeHost host;
        FakeObject* object = create(host);
        const io::UdpSocket sender("127.0.0.1", 0);
        OscBytes many = osc_bundle(1, std::vector<OscBytes>(8, osc_message("/a", "", {})));
        int heard = 0;
        FakeHost::on_sent([&](const Sent& sent) {
            if (sent.outlet == 0 && heard++ == which) {
                host.destroy(std::exchange(object, nullptr));
            }
        });
        sender.send(here(*object), many);
        for (const double end = io::monotonic_seconds() + 10.0;
             object && io::monotonic_seconds() < end;) {
            host.run_tick();
        }
        CHECK(heard == which + 1);
        CHECK(!object);
        host.run_tick();
        FakeHost::on_sent({});
        CHECK(host.errors().empty());
    }
}

TEST_CASE("deleted by its own status, it ends in peace too") {
    FakeHost host;
    FakeObject* object = create(host);
    int heard = 0;
    FakeHost::on_sent([&](const Sent&) {
        ++heard;
        host.destroy(std::exchange(object, nullptr));
    });
    object->message("status");
    CHECK(heard == 1);
    FakeHost::on_sent({});
    host.run_tick();
}
