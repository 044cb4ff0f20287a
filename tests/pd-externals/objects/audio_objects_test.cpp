// What holds for every object with signals, at any sample rate, in any block, whenever signals are
// switched on and off or an object is deleted.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "pdx/fake_host.hpp"
#include "pdx/object.hpp"

extern "C" void setup_modal0x2ddrum_tilde();
extern "C" void setup_drum0x2dlisten_tilde();
extern "C" void fastrak_tilde_setup();

using namespace percussionist::pdx;

namespace {

struct Kind {
    const char* name;
    void (*set_up)();
    std::vector<Atom> creation;
    bool hears_signals;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"modal-drum~", &setup_modal0x2ddrum_tilde, {0.3}, false},
        {"drum-listen~", &setup_drum0x2dlisten_tilde, {}, true},
        {"fastrak~", &fastrak_tilde_setup, {}, false},
    };
    return all;
}

FakeObject* make(FakeHost& host, const Kind& kind) {
    if (!find_class(kind.name)) kind.set_up();
    return host.create(kind.name, kind.creation);
}

void excite(FakeObject& object, const Kind& kind, int i) {
    if (kind.name == std::string("modal-drum~")) object.message("strike", {3.0, 0.1, 0.0});
    if (kind.hears_signals) object.input(0, i % 2 == 0 ? 0.7F : 0.0F);
}

/// Numbers, none so small that a processor takes its time over it, within bounds.
void check_signals(const FakeObject& object) {
    for (std::size_t outlet = 0; outlet < object.outputs(); ++outlet) {
        const auto& samples = object.output(outlet);
        const auto good = [](Sample s) {
            return std::isfinite(s) && std::abs(s) < 1e3F && std::fpclassify(s) != FP_SUBNORMAL;
        };
        CHECK(std::all_of(samples.begin(), samples.end(), good));
    }
}

}  // namespace

TEST_CASE("audio objects: any sample rate, any block, up- and down-sampled") {
    for (const Kind& kind : kinds()) {
        for (const double rate : {8000.0, 44100.0, 48000.0, 192000.0}) {
            for (const std::size_t block : {1, 16, 64, 1024, 4096}) {
                for (const std::size_t over : {1, 4}) {
                    if (rate * static_cast<double>(over) > 192000.0) continue;
                    CAPTURE(kind.name);
                    CAPTURE(rate);
                    CAPTURE(block);
                    CAPTURE(over);
                    FakeHost host(rate);
                    FakeObject* const object = make(host, kind);
                    REQUIRE(object);
                    host.start_dsp(block, over);
                    for (int i = 0; i < 4; ++i) {
                        excite(*object, kind, i);
                        host.advance_to(host.now() + 0.02);
                    }
                    check_signals(*object);
                    CHECK(host.errors().empty());
                }
            }
        }
    }
}

TEST_CASE("audio objects: signals are switched on and off, blocks change, objects come and go") {
    for (const Kind& kind : kinds()) {
        CAPTURE(kind.name);
        FakeHost host;
        FakeObject* first = make(host, kind);
        REQUIRE(first);
        for (int i = 0; i < 40; ++i) {
            CAPTURE(i);
            host.start_dsp(std::size_t{1} << (i % 13), i % 3 == 0 ? 2 : 1);
            FakeObject* const second = make(host, kind);
            REQUIRE(second);
            excite(*first, kind, i);
            if (i % 2 == 0) {  // the second is among the signals at once; else it stays silent
                host.start_dsp(64);
                excite(*second, kind, i);
            }
            host.advance_to(host.now() + 0.01);
            check_signals(*first);
            host.destroy(i % 5 == 0 ? std::exchange(first, second) : second);
            host.advance_to(host.now() + 0.005);
        }
        CHECK(host.errors().empty());
    }
}

TEST_CASE("audio objects: a drum that has rung out is silent, and no number of it is subnormal") {
    FakeHost host;
    const Kind& drum = kinds().front();
    FakeObject* const object = make(host, drum);
    REQUIRE(object);
    host.start_dsp(64);
    excite(*object, drum, 0);
    host.advance_to(30.0);
    check_signals(*object);
    CHECK(std::abs(object->output(0).back()) < 1e-9F);
}
