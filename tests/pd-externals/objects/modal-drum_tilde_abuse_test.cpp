// Anything may be sent to a drum: it answers with sound within bounds or with clear errors.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"

extern "C" void setup_modal0x2ddrum_tilde();

using namespace percussionist::pdx;

namespace {

class Chance {
  public:
    explicit Chance(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t limit) { return random_() % limit; }

    /// Often what is allowed, else anything.
    double number(const Argument& argument) {
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        const double odd[] = {0, -1, 1e30, -1e30, 1e-30, kInfinite, -kInfinite, std::nan("")};
        if (below(10) == 0) {
            return odd[below(8)];
        }
        const double low = std::max(argument.low, 1e-6), high = std::min(argument.high, 1e12);
        if (argument.name == "modes") {
            return static_cast<double>(1 + below(200));  // else it is slow, not wrong
        }
        if (argument.low < 0) {
            return argument.low + (argument.high - argument.low) * unit_(random_);
        }
        return low * std::pow(high / low, unit_(random_));
    }

    std::vector<Atom> arguments(const Message& message) {
        std::vector<Atom> atoms;
        for (const auto& argument : message.arguments) {
            if (argument.optional && below(2) == 0) {
                break;
            }
            if (argument.kind == Argument::Kind::kNumber) {
                atoms.emplace_back(number(argument));
            } else {
                atoms.emplace_back("no-such-thing");
            }
        }
        if (below(20) == 0) {
            atoms.emplace_back("more");
        }
        return atoms;
    }

    Sample signal() {
        const double odd[] = {
            0, 0, 1e30, -1e30, std::nan(""), std::numeric_limits<double>::infinity()};
        return static_cast<Sample>(below(4) == 0 ? odd[below(6)] : 0.02 * unit_(random_) - 0.01);
    }

  private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> unit_{0, 1};
};

/// PERCUSSIONIST_ABUSE: how many messages, for a longer run.
std::size_t wanted() {
    const char* const text = std::getenv("PERCUSSIONIST_ABUSE");
    return text ? std::strtoul(text, nullptr, 10) : 4000;
}

}  // namespace

TEST_CASE("random messages and signals leave a drum within bounds, errors clear") {
    if (!find_class("modal-drum~")) {
        setup_modal0x2ddrum_tilde();
    }
    const Description& table = *find_class("modal-drum~");
    constexpr std::size_t kAtOnce = 4000;
    for (std::size_t done = 0; done < wanted(); done += kAtOnce) {
        Chance chance(static_cast<unsigned>(done));
        FakeHost host;
        auto& drum = *host.create("modal-drum~", {0.3, 3000.0, 0.26, 2.0});
        host.start_dsp();
        drum.message("modes", {60.0});
        for (std::size_t i = 0; i < kAtOnce; ++i) {
            const Message& message = table.messages[chance.below(table.messages.size())];
            // Thousands of modes, and what is printed, only take time.
            if (message.selector != "band" && message.selector != "print") {
                drum.message(message.selector, chance.arguments(message));
            }
            for (const auto& error : host.errors()) {
                CAPTURE(error);
                REQUIRE(error.find("modal-drum~: ") == 0);
                REQUIRE(error.size() < 400);
            }
            drum.input(0, chance.signal());
            drum.input(1, chance.signal());
            if (i % 4 == 0) {
                host.run_tick();
            }
        }
        for (std::size_t outlet = 0; outlet < 2; ++outlet) {
            const auto& sound = drum.output(outlet);
            REQUIRE(
                std::all_of(sound.begin(), sound.end(), [](Sample x) { return std::abs(x) <= 1; }));
        }
        // It still plays.
        drum.message("reset");
        drum.message("lift");
        drum.message("membrane");
        drum.message("radius", {0.33});
        drum.message("tension", {3500.0});
        drum.message("density", {0.262});
        drum.message("decay", {1.0, 0.2});
        drum.message("pickup", {0.2});
        drum.message("mallet", {0.012, 1e8});
        drum.message("slide", {0.0, 0.0});
        drum.input(0, 0);
        drum.message("strike", {2.0, 0.1});
        host.run_tick();
        host.run_tick();
        const auto& sound = drum.output(0);
        REQUIRE(std::any_of(sound.end() - 64, sound.end(), [](Sample x) { return x != 0; }));
    }
}

TEST_CASE("as many outlets as pickups, and arrays give modes") {
    FakeHost host;
    auto& drum = *host.create("modal-drum~", {0.3, 3000.0, 0.26, 3.0});
    host.start_dsp();
    CHECK(drum.outputs() == 3);
    host.set_array("f", {200, 300, 450});
    host.set_array("t", {1, 1, 0.5});
    host.set_array("w", {5, 4, 3});
    drum.message("arrays", {"f", "t", "w"});
    for (const auto& error : host.errors()) {
        FAIL_CHECK(error);
    }
    drum.message("print");
    CHECK(host.posts().at(0) == "modal-drum~: 3 modes from 200.0 to 450 Hz");
    drum.message("arrays", {"f", "t", "x"});
    CHECK(host.errors().at(0) == "modal-drum~: arrays: no array 'x'");
    drum.message("given", {100.0, 1.0});
    CHECK(host.errors().at(0).find("again and again") != std::string::npos);
    drum.message("given", {100.0, 1.0, 2.0, 150.0, 1.0, 1.5});
    drum.message("pickup-position", {0.1, 0.0, 3.0});
    drum.message("pickup", {0.1, 0.0, 4.0});
    const auto errors = host.errors();
    REQUIRE(!errors.empty());
    CHECK(errors.back() == "modal-drum~: pickup: expected one of 3, got 4");
    drum.message("bang");
    host.advance_to(0.1);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& sound = drum.output(i);
        CHECK(std::any_of(sound.begin(), sound.end(), [](Sample x) { return x != 0; }));
    }
}
