#include "io/osc_inbox.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>

#include "support/osc_writer.hpp"

using namespace percussionist::io;
using namespace percussionist::test;

namespace {

constexpr double kLookahead = 0.03;
constexpr double kSample = 1.0 / 48000;
constexpr Endpoint kServer{0x7F000001, 7770};

struct Got {
    std::optional<double> due;
    OscMessage message;
    double number() const { return std::get<double>(message.arguments.at(0)); }
};

/// An inbox, and what came out of it.
struct Box {
    std::vector<Got> got;
    std::vector<std::string> complaints;
    OscInbox inbox{[this](std::unique_ptr<Delivery> delivery) {
        for (auto& message : delivery->messages) {
            got.push_back({delivery->due, message});
        }
        if (!delivery->complaint.empty()) {
            complaints.push_back(delivery->complaint);
        }
    }};
    std::vector<Got> contacts() const {
        std::vector<Got> all;
        std::copy_if(got.begin(), got.end(), std::back_inserter(all),
                     [](const Got& g) { return g.message.address == "/contact"; });
        return all;
    }
};

/// A server with a clock of its own, and a network that is slow, loses, doubles and reorders.
struct Link {
    double drift = 50e-6;
    double lateness = 0.0;
    double loss = 0.0;
    double doubled = 0.0;
    double clocks = 100.0;  // a second, as the server sends them
    unsigned seed = 1;

    struct Packet {
        double arrival;
        OscBytes bytes;
        bool operator<(const Packet& other) const { return arrival > other.arrival; }
    };
    std::priority_queue<Packet> on_the_way = {};
    std::mt19937_64 random{};

    double sender(double local) const { return (local - 5e4) * (1.0 + drift); }
    bool chance(double p) { return std::uniform_real_distribution<double>(0.0, 1.0)(random) < p; }
    void send(double local, const OscBytes& bytes) {
        std::uniform_real_distribution<double> late(0.0, lateness + 1e-12);
        for (int copies = chance(doubled) ? 2 : 1; copies > 0; --copies) {
            const double arrival = local + 0.001 + late(random);
            if (!chance(loss)) {
                on_the_way.push({arrival, bytes});
            }
        }
    }
    /// Strokes for some seconds, each sent 10 ms after its instant and four times again; the
    /// instants by the local clock.
    std::vector<double> play(Box& box, double from, double to) {
        random.seed(seed);
        for (double t = from; t < to; t += 1.0 / clocks) {
            send(t, clock_packet(sender(t), kLookahead));
        }
        std::vector<double> instants;
        std::vector<Contact> recent;
        std::uniform_real_distribution<double> apart(0.005, 0.2);
        for (double t = from + 0.2; t < to - 0.1; t += apart(random)) {
            recent.insert(recent.begin(), {static_cast<int>(instants.size()), sender(t)});
            recent.resize(std::min<std::size_t>(recent.size(), 8));
            instants.push_back(t);
            for (int again = 0; again < 5; ++again) {
                send(t + 0.01 + 0.00375 * again, contact_packet(recent, kLookahead));
            }
        }
        for (; !on_the_way.empty(); on_the_way.pop()) {
            box.inbox.take(on_the_way.top().bytes, kServer, on_the_way.top().arrival);
        }
        return instants;
    }
};

double deviation(const std::vector<double>& values) {
    double sum = 0.0, squares = 0.0;
    for (const double v : values) {
        sum += v;
        squares += v * v;
    }
    const auto n = static_cast<double>(values.size());
    return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)));
}

}  // namespace

TEST_CASE("contacts are due at their instant plus the lookahead, whatever the sender's clock") {
    for (const double drift : {-100e-6, 0.0, 50e-6}) {
        Box box;
        Link link{.drift = drift, .lateness = 50e-6};
        const auto instants = link.play(box, 5e4, 5e4 + 20.0);
        const auto contacts = box.contacts();
        REQUIRE(contacts.size() == instants.size());
        std::vector<double> errors;
        for (std::size_t i = 0; i < instants.size(); ++i) {
            CHECK(contacts[i].number() == static_cast<double>(i));
            errors.push_back(*contacts[i].due - instants[i] - kLookahead - 0.001);
            CHECK(std::abs(errors.back()) < 1e-4);
        }
        CHECK(deviation(errors) < kSample);
        const auto status = box.inbox.status();
        CHECK(status.rate == doctest::Approx(drift).epsilon(0.1).scale(1e-5));
        CHECK(status.lookahead == doctest::Approx(kLookahead));
        CHECK(status.jitter < 1e-4);
        CHECK(status.lost == 0);
    }
}

TEST_CASE("under 10 ms of jitter contacts stay within 3 samples, once the clock is known") {
    Box box;
    Link link{.lateness = 0.01};
    const auto instants = link.play(box, 5e4, 5e4 + 60.0);
    std::vector<double> errors;
    for (const auto& contact : box.contacts()) {
        const double instant = instants.at(static_cast<std::size_t>(contact.number()));
        if (instant > 5e4 + 20.0) {
            errors.push_back(*contact.due - instant);
        }
    }
    CHECK(errors.size() > 300);
    CHECK(deviation(errors) < 3.0 * kSample);
}

TEST_CASE("a fifth of the packets lost, some doubled, all out of order: each contact comes once") {
    for (unsigned seed = 0; seed < 10; ++seed) {
        Box box;
        Link link{.lateness = 0.01, .loss = 0.2, .doubled = 0.1, .seed = seed};
        const auto instants = link.play(box, 5e4, 5e4 + 20.0);
        std::vector<double> numbers;
        for (const auto& contact : box.contacts()) {
            numbers.push_back(contact.number());
        }
        std::sort(numbers.begin(), numbers.end());
        REQUIRE(numbers.size() == instants.size());
        CHECK(std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
        CHECK(box.inbox.status().lost == 0);
        CHECK(box.inbox.status().repeated > 1000);
    }
}

TEST_CASE("a server started anew is heard from its first contact on") {
    Box box;
    Link link{.loss = 0.2};
    const auto first = link.play(box, 5e4, 5e4 + 5.0);
    link.seed = 2;
    const auto second = link.play(box, 5e4 + 6.0, 5e4 + 20.0);
    CHECK(box.contacts().size() == first.size() + second.size());
    CHECK(box.inbox.status().lost == 0);
}

TEST_CASE("a clock that was set is found again within half a second") {
    for (const double step : {-3600.0, -0.2, 0.2, 3600.0}) {
        CAPTURE(step);
        Box box;
        for (double t = 5e4; t < 5e4 + 10.0; t += 0.05) {
            const double now = t - 5e4 + (t > 5e4 + 5.0 ? step : 0.0);
            box.inbox.take(clock_packet(now, kLookahead), kServer, t);
            if (t < 5e4 + 5.0 || t > 5e4 + 5.5) {
                CHECK(*box.got.back().due == doctest::Approx(t + kLookahead).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("a sender without /clock, always as far ahead, is heard evenly") {
    Box box;
    for (int i = 0; i < 100; ++i) {
        const double t = 5e4 + 0.1 * i;
        const OscBytes note = osc_message("/note", "i", {osc_int(i)});
        box.inbox.take(osc_bundle(osc_tag(0.1 * i + 0.2), {note}), kServer,
                       t + (i % 3 == 0 ? 0.0 : 0.004));
    }
    REQUIRE(box.got.size() == 100);
    for (int i = 10; i < 100; ++i) {
        CHECK(*box.got[i].due == doctest::Approx(5e4 + 0.1 * i).epsilon(1e-10));
    }
}

TEST_CASE(
    "what is announced again and again for one instant is heard once, and another time anew") {
    Box box;
    const auto said = [&](const char* address, double at) {
        return osc_bundle(osc_tag(at), {osc_message(address, "f", {osc_float(1.0)})});
    };
    box.inbox.take(clock_packet(100.0, kLookahead), kServer, 1.0);
    for (int i = 0; i < 5; ++i) {
        box.inbox.take(said("/started", 100.5), kServer, 1.001 + 0.01 * i);
        box.inbox.take(said("/finished", 100.5), kServer, 1.002 + 0.01 * i);
        box.inbox.take(said("/started", 100.7), kServer, 1.003 + 0.01 * i);
        box.inbox.take(said("/other", 100.5), kServer, 1.004 + 0.01 * i);
    }
    const auto count = [&](const char* address) {
        return std::count_if(box.got.begin(), box.got.end(),
                             [&](const Got& g) { return g.message.address == address; });
    };
    CHECK(count("/started") == 2);
    CHECK(count("/finished") == 1);
    CHECK(count("/other") == 5);
}

TEST_CASE("plain messages and tag 1 are due at once, and alike ones are none the less two") {
    Box box;
    const OscBytes contact = contact_message({5, 0.0});
    for (int i = 0; i < 2; ++i) {
        box.inbox.take(contact, kServer, 1.0);
        box.inbox.take(osc_bundle(kImmediately, {contact}), kServer, 1.0);
    }
    REQUIRE(box.got.size() == 4);
    for (const auto& got : box.got) {
        CHECK(!got.due);
    }
}

TEST_CASE("what was over before the sender was heard of is not played late") {
    Box box;
    box.inbox.take(clock_packet(10.0, kLookahead), kServer, 100.0);
    box.inbox.take(contact_packet({{9, 10.09}, {8, 9.9}, {7, 8.0}}, kLookahead), kServer, 100.1);
    const auto contacts = box.contacts();
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].number() == 9);
    CHECK(box.inbox.status().lost == 0);
}

TEST_CASE("each sender has its own clock and its own numbers") {
    Box box;
    for (int i = 0; i < 100; ++i) {
        const double t = 100.0 + 0.05 * i;
        for (std::uint16_t port = 1; port <= 10; ++port) {
            const double now = 1000.0 * port + 0.05 * i;
            box.inbox.take(clock_packet(now, kLookahead), {1, port}, t);
            box.inbox.take(contact_packet({{i, now}}, kLookahead), {1, port}, t);
            CHECK(*box.got.back().due == doctest::Approx(t + kLookahead).epsilon(1e-9));
        }
    }
    CHECK(box.contacts().size() == 1000);
    CHECK(box.inbox.status().senders == 10);
}

TEST_CASE("a crowd of strangers does not make a server unknown") {
    Box box;
    for (int i = 0; i < 2000; ++i) {
        const double t = 100.0 + 0.05 * i;
        box.inbox.take(clock_packet(0.05 * i, kLookahead), kServer, t);
        box.inbox.take(contact_packet({{i / 2, 0.05 * (i / 2)}}, kLookahead), kServer, t);
        for (std::uint16_t k = 0; k < 30; ++k) {
            box.inbox.take(osc_message("/x", "", {}), {7, static_cast<std::uint16_t>(30 * i + k)},
                           t);
        }
    }
    CHECK(box.contacts().size() == 1000);
    CHECK(box.inbox.status().senders == 16);
}

TEST_CASE("ever new words are let in up to a bound, and what was known before goes on") {
    Box box;
    box.inbox.take(osc_message("/known", "s", {osc_text("word")}), kServer, 0.0);
    for (int i = 0; i < 400; ++i) {
        const std::string word = std::to_string(i) + std::string(60000, 'x');
        box.inbox.take(osc_message("/flood", "s", {osc_text(word)}), kServer, 1e-3 * i);
    }
    const std::size_t let_in = box.got.size();
    CHECK(let_in * 60000 < WordBudget::kMostBytes + 60000);
    CHECK(let_in > 100);
    CHECK(box.complaints.size() == 1);
    CHECK(box.complaints[0].find("new words") != std::string::npos);
    box.inbox.take(osc_message("/known", "s", {osc_text("word")}), kServer, 2.0);
    CHECK(box.got.size() == let_in + 1);
}

TEST_CASE("what is due later than the longest lookahead is refused, and what follows is heard") {
    Box box;
    const auto said = [&](double at) {
        return osc_bundle(osc_tag(at), {osc_message("/other", "f", {osc_float(1.0)})});
    };
    box.inbox.take(clock_packet(100.0, kLookahead), kServer, 5e4);
    box.got.clear();
    for (int i = 0; i < 100; ++i) {
        box.inbox.take(said(200.0 + i), kServer, 5e4 + 1e-3 * i);
    }
    CHECK(box.got.empty());
    CHECK(box.inbox.status().malformed == 100);
    REQUIRE(box.complaints.size() == 1);
    CHECK(box.complaints[0].find("ahead") != std::string::npos);
    box.inbox.take(said(109.0), kServer, 5e4 + 0.2);
    CHECK(box.got.size() == 1);
}

TEST_CASE("malformed packets are counted; one a second is told of") {
    Box box;
    for (int i = 0; i < 100; ++i) {
        box.inbox.take(OscBytes{'n', 'o'}, kServer, 10.0 + 0.02 * i);
    }
    CHECK(box.inbox.status().malformed == 100);
    REQUIRE(box.complaints.size() == 2);
    CHECK(box.complaints[0] ==
          "malformed packet from 127.0.0.1:7770: byte 0: expected a multiple of 4 bytes, not 2");
    CHECK(box.got.empty());
}

TEST_CASE(
    "strokes of a time in which a sender was silent are stale, those in time or late are not") {
    std::vector<bool> stale;
    OscInbox inbox([&](std::unique_ptr<Delivery> delivery) { stale.push_back(delivery->stale); });
    for (int i = 0; i < 100; ++i) {
        inbox.take(clock_packet(0.01 * i, kLookahead), kServer, 5e4 + 0.01 * i);
    }
    stale.clear();
    inbox.take(contact_packet({{0, 0.8}}, kLookahead), kServer, 5e4 + 1.0);
    CHECK(stale == std::vector<bool>{false});
    stale.clear();
    const double back = 11.0;  // with what rode along
    inbox.take(contact_packet({{9, back - 0.01}, {8, back - 0.2}, {7, 8.0}}, kLookahead), kServer,
               5e4 + back);
    inbox.take(osc_bundle(osc_tag(8.0), {osc_message("/other", "", {})}), kServer, 5e4 + back);
    CHECK(std::count(stale.begin(), stale.end(), true) == 2);
    stale.clear();
    inbox.take(contact_packet({{10, back - 0.01}}, kLookahead), kServer, 5e4 + back + 0.3);
    CHECK(stale == std::vector<bool>{false});
}
