#include "pdx/object.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "pdx/fake_host.hpp"

using namespace percussionist::pdx;

namespace {

/// An object that does a little of everything.
class Sampler : public Object {
  public:
    Sampler(Box& box, const Arguments& creation)
        : Object(box), clock_(*this, [this] { tick(); }), gain_(creation.number(0)) {
        if (gain_ == 13.0) {
            throw std::runtime_error("13 brings bad luck");
        }
    }
    ~Sampler() override { ++destroyed; }

    void gain(const Arguments& a) { gain_ = a.number(0); }
    void later(const Arguments& a) { clock_.delay(a.number(0)); }
    void echo(const Arguments& a) { send(1, "echo", a.atoms()); }
    void fail(const Arguments&) { throw std::runtime_error("as asked"); }
    void mark(const Arguments&) { mark_ = now(); }

    void prepare(double sample_rate, std::size_t) override { rate_ = sample_rate; }
    void process(const Block& block) noexcept override {
        const long offset = std::lround((mark_ - block.start) * block.sample_rate);
        for (std::size_t i = 0; i < block.size; ++i) {
            block.outputs[0][i] = static_cast<Sample>(gain_) * block.inputs[0][i] +
                                  static_cast<Sample>(static_cast<long>(i) == offset);
        }
    }

    static inline int destroyed = 0;

  private:
    void tick() {
        send(1, now());
        if (gain_ == 99.0) {
            throw std::runtime_error("in the clock");
        }
    }
    Clock clock_;
    double gain_;
    double rate_ = 0.0;
    double mark_ = -1.0;
};

void make_sampler_known() {
    if (find_class("sampler~")) {
        return;
    }
    add_class(
        describe<Sampler>("sampler~", "a test")
            .creation({number("gain").from(0).by_default(1)})
            .message("gain", {number("gain").from(0)}, "gain", &Sampler::gain)
            .message("later", {number("delay", "s").above(0)}, "sends the time", &Sampler::later)
            .message("echo", {anything("arguments")}, "sends them", &Sampler::echo)
            .message("place", {number("r", "m").from(0).to(1), word("name").or_none()}, "",
                     &Sampler::gain)
            .message("fail", {}, "fails", &Sampler::fail)
            .message("bang", {}, "a click", &Sampler::mark)
            .signal_inlet("in")
            .signal_outlet("out")
            .outlet("times and echoes"));
}

std::string one_error(FakeHost& host) {
    const auto errors = host.errors();
    REQUIRE(errors.size() == 1);
    return errors[0];
}

}  // namespace

TEST_CASE("what does not fit the table is refused in one sentence that names it") {
    make_sampler_known();
    FakeHost host;
    auto& object = *host.create("sampler~");
    const double inf = std::numeric_limits<double>::infinity();
    const auto error = [&](const char* selector, std::vector<Atom> atoms) {
        object.message(selector, std::move(atoms));
        return one_error(host);
    };
    CHECK(error("gain", {-3.0}) == "sampler~: gain: expected a number of 0 or more, got -3");
    CHECK(error("later", {0.0}) == "sampler~: later: delay: expected a number above 0 [s], got 0");
    CHECK(error("gain", {"x"}) == "sampler~: gain: expected a number of 0 or more, got x");
    CHECK(error("gain", {}) == "sampler~: gain: expected a number of 0 or more, got nothing");
    CHECK(error("gain", {std::nan("")}) ==
          "sampler~: gain: expected a number of 0 or more, got nan");
    CHECK(error("gain", {inf}) == "sampler~: gain: expected a number of 0 or more, got inf");
    CHECK(error("gain", {1.0, 2.0}) == "sampler~: gain: expected at most 1 argument, got 2");
    CHECK(error("place", {2.0}) == "sampler~: place: r: expected a number from 0 to 1 [m], got 2");
    CHECK(error("place", {1.0, 2.0}) == "sampler~: place: name: expected a word, got 2");
    CHECK(error("fail", {}) == "sampler~: fail: as asked");
    CHECK(error("dsp", {}) ==
          "sampler~: no message 'dsp'; it hears: gain, later, echo, place, fail, bang");
}

TEST_CASE("an object that cannot be made says why and leaves nothing behind") {
    make_sampler_known();
    FakeHost host;
    CHECK(host.create("sampler~", {-1.0}) == nullptr);
    CHECK(one_error(host) == "sampler~: gain: expected a number of 0 or more, got -1");
    CHECK(host.create("sampler~", {13.0}) == nullptr);
    CHECK(one_error(host) == "sampler~: 13 brings bad luck");
    const int before = Sampler::destroyed;
    host.destroy(host.create("some/folder/sampler~"));
    CHECK(Sampler::destroyed == before + 1);
}

TEST_CASE("messages leave by the outlet they are sent to, words and numbers alike") {
    make_sampler_known();
    FakeHost host;
    auto& object = *host.create("sampler~");
    object.message("echo", {1.5, "two", 3.0});
    const auto sent = object.sent();
    REQUIRE(sent.size() == 1);
    CHECK(sent[0].outlet == 1);
    CHECK(sent[0].selector == "echo");
    REQUIRE(sent[0].atoms.size() == 3);
    CHECK(to_string(sent[0].atoms[0]) == "1.5");
    CHECK(to_string(sent[0].atoms[1]) == "two");
}

TEST_CASE("a clock calls at its logical time, also inside a tick, and its errors stay inside") {
    make_sampler_known();
    FakeHost host;
    auto& object = *host.create("sampler~", {99.0});
    object.message("later", {0.0123456});
    host.advance_to(1.0);
    const auto sent = object.sent();
    REQUIRE(sent.size() == 1);
    CHECK(sent[0].time == doctest::Approx(0.0123456).epsilon(1e-6));
    CHECK(one_error(host) == "sampler~: in the clock");
}

TEST_CASE("signals pass, and a block knows when it starts, whatever its size and rate") {
    make_sampler_known();
    for (const std::size_t over : {1u, 4u}) {
        for (const std::size_t size : {1u, 16u, 64u, 1024u}) {
            FakeHost host;
            auto& object = *host.create("sampler~", {0.5});
            host.start_dsp(size, over);
            object.input(0, 1.0F);
            const std::size_t place = 3777;  // no multiple of anything
            host.advance_to(static_cast<double>(place) / 48000);
            object.message("bang");
            host.advance_to(0.5);
            const auto& out = object.output(0);
            REQUIRE(out.size() > place * over);
            CAPTURE(size);
            CAPTURE(over);
            CHECK(out[place * over] == 1.5F);
            CHECK(std::count(out.begin(), out.end(), 1.5F) == 1);
            CHECK(std::count(out.begin(), out.end(), 0.5F) == static_cast<long>(out.size()) - 1);
        }
    }
}

TEST_CASE("the reference is the table, with units") {
    make_sampler_known();
    const std::string text = find_class("sampler~")->reference();
    CHECK(text.find("later DELAY [s]: sends the time") != std::string::npos);
    CHECK(text.find("place R [m] (NAME)") != std::string::npos);
    CHECK(text.find("signal outlet: out") != std::string::npos);
}
