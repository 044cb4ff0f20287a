#include "osc/address_table.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace percussionist::osc;

namespace {

std::string refusal(const std::string& path, const std::vector<Argument>& arguments) {
    const auto said = understand(path, arguments);
    const Refusal* r = std::get_if<Refusal>(&said);
    return r == nullptr ? "" : r->reason;
}

}  // namespace

TEST_CASE("address table: what it lists is understood with the arguments it names") {
    for (const Address& address : address_table()) {
        std::vector<Argument> arguments;
        for (const Parameter& p : address.parameters) {
            if (!p.required) break;
            if (p.text) {
                std::string word = *p.choices != '\0' ? p.choices : "built-in";
                arguments.emplace_back(word.substr(0, word.find(' ')));
            } else {
                arguments.emplace_back(p.least);
            }
        }
        CAPTURE(address.path);
        CHECK(refusal(address.path, arguments) == "");
    }
}

TEST_CASE("address table: wrong type, range or number of arguments is refused by name") {
    CHECK(refusal("/tempo", {}).find("FACTOR") != std::string::npos);
    CHECK(refusal("/tempo", {std::string("fast")}).find("FACTOR") != std::string::npos);
    CHECK(refusal("/tempo", {0.0}).find("0.1") != std::string::npos);
    CHECK(refusal("/tempo", {std::nan("")}).find("FACTOR") != std::string::npos);
    CHECK(refusal("/play", {1.0}) != "");
    CHECK(refusal("/subscribe", {7771.0, std::string("everything")}).find("FEED") !=
          std::string::npos);
    CHECK(refusal("/grip", {std::string("loose")}).find("german or french") != std::string::npos);
    CHECK(refusal("/nuance", {std::string("accent"), std::string("foot")}).find("HAND") !=
          std::string::npos);
    CHECK(refusal("/dance", {}).find("/describe") != std::string::npos);
}

TEST_CASE("address table: a refusal is short, however long what it refuses") {
    const std::string long_text(60000, 'x');
    CHECK(refusal("/tempo", {long_text}).size() < 300);
    CHECK(refusal("/subscribe", {1.0, long_text}).size() < 300);
    const auto said = understand('/' + long_text, {});
    CHECK(std::get<Refusal>(said).address.size() < 300);
}

TEST_CASE("address table: a bound is within the range, also when it came as a float") {
    for (const Address& address : address_table()) {
        std::vector<Argument> least, most;
        for (const Parameter& p : address.parameters) {
            if (p.text) break;
            least.emplace_back(static_cast<double>(static_cast<float>(p.least)));
            most.emplace_back(static_cast<double>(static_cast<float>(p.most)));
        }
        if (least.size() != address.parameters.size()) continue;
        CAPTURE(address.path);
        CHECK(refusal(address.path, least) == "");
        CHECK(refusal(address.path, most) == "");
    }
}

TEST_CASE("address table: a name or a text is of bounded length") {
    const auto of = [](std::size_t letters) {
        return std::vector<Argument>{std::string(letters, 'x')};
    };
    CHECK(refusal("/nuance", of(80)) == "");
    CHECK(refusal("/score", of(255)) == "");
    for (const auto& [path, letters] : {std::pair("/nuance", "80"), std::pair("/score", "255")}) {
        const std::string said = refusal(path, of(60000));
        CHECK(said.find(std::string("at most ") + letters + " letters") != std::string::npos);
        CHECK(said.size() < 200);
    }
}

TEST_CASE("address table: an asker that names no host is sent to where it came from") {
    const auto said = understand("/subscribe", std::vector<Argument>{7771.0});
    const auto* wish = std::get_if<Subscribe>(&std::get<Command>(said));
    REQUIRE(wish != nullptr);
    CHECK(wish->peer == Peer{"", "7771"});
    CHECK(wish->feed == Feed::sound);
}

TEST_CASE("address table: the page on the protocol says what the table says") {
    std::ifstream in(PROJECT_FOLDER "/docs/osc-protocol.md");
    std::stringstream page;
    page << in.rdbuf();
    for (const Address& address : address_table()) {
        CAPTURE(usage(address));
        CHECK(page.str().find(usage(address)) != std::string::npos);
        CHECK(page.str().find(address.description) != std::string::npos);
    }
}
