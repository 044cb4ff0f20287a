#include "io/dns_sd.hpp"

#include <doctest/doctest.h>

#include <random>

#include "support/dns_writer.hpp"

using namespace percussionist::io;
using namespace percussionist::test;

namespace {

constexpr const char* kService = "_percussionist._udp.local";

std::vector<FoundServer> found_in(const std::vector<OscBytes>& packets) {
    DnsSdAnswers answers(kService);
    for (const OscBytes& packet : packets) {
        answers.take(packet);
    }
    return answers.found();
}

}  // namespace

TEST_CASE("a question names the service, label by label, and asks for pointers") {
    const Bytes question = dns_sd_question("_a._udp.local");
    CHECK(question == Bytes{0,   0,   0,   0,   0, 1,   0,   0,   0,   0,   0, 0, 2,  '_', 'a', 4,
                            '_', 'u', 'd', 'p', 5, 'l', 'o', 'c', 'a', 'l', 0, 0, 12, 0,   1});
}

TEST_CASE("a server is found by its service and its host's address, whatever their order") {
    const FoundServer stage{"percussionist on stage", 0x0A090001, 7790};
    CHECK(found_in({dns_answer()}) == std::vector{stage});
    CHECK(found_in({dns_answer(), dns_answer()}) == std::vector{stage});
    const OscBytes service =
        dns_packet({dns_service(dns_name("percussionist on stage._percussionist._udp.local"),
                                dns_name("stage.local"), 7790)});
    const OscBytes address = dns_packet({dns_record(dns_name("STAGE.local"), 1, {10, 9, 0, 1})});
    CHECK(found_in({address, service}) == std::vector{stage});
    CHECK(found_in({service}).empty());
}

TEST_CASE("what is no server of this kind is not found, and no name can break out of a patch") {
    const OscBytes address = dns_packet({dns_record(dns_name("a.local"), 1, {10, 9, 0, 1})});
    const auto named = [&](const std::string& instance, int port) {
        return found_in(
            {address, dns_packet({dns_service(dns_name(instance), dns_name("a.local"), port)})});
    };
    CHECK(named("printer._ipp._tcp.local", 631).empty());
    CHECK(named("x._percussionist._udp.local", 0).empty());
    const auto hostile = named("a;quit,\\$1\n{b}._percussionist._udp.local", 7770);
    REQUIRE(hostile.size() == 1);
    CHECK(hostile[0].name == "aquit1b");
}

TEST_CASE("a cut answer, names that go round in circles and thousands of servers do no harm") {
    const OscBytes whole = dns_answer();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        found_in({{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}});
    }
    CHECK(found_in({dns_packet({dns_record(dns_elsewhere(12), 1, {1, 2, 3, 4})})}).empty());
    std::vector<OscBytes> crowd;
    for (int i = 0; i < 1000; ++i) {
        const std::string name = "s" + std::to_string(i);
        crowd.push_back(dns_packet(
            {dns_service(dns_name(name + "._percussionist._udp.local"), dns_name(name), 7770),
             dns_record(dns_name(name), 1, {10, 0, 0, 1})}));
    }
    CHECK(found_in(crowd).size() == 64);
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        OscBytes damaged = whole;
        for (int k = 0; k < 3; ++k) {
            damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
        }
        CHECK(found_in({damaged}).size() <= 1);
    }
}
