// What the drum costs: nanoseconds a mode a sample (counter "ns/mode/sample"), a contact, a stroke.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/modal/modal_drum.hpp"
#include "core/modal/struck_membrane.hpp"

namespace {

using namespace percussionist::modal;

constexpr double kRate = 48000;

void count_modes(benchmark::State& state, double samples) {
    const double updates = static_cast<double>(state.range(0)) * samples;
    // Inverted, a rate of 1e9 updates a second is a nanosecond each.
    state.counters["ns/mode/sample"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * updates / 1e9,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

StruckMembrane pushed(std::size_t modes) {
    // So low that all modes are within the band.
    StruckMembrane head({.tension = 100.0}, Decay{.t60_low = 1000, .t60_high = 1000}, modes, kRate);
    head.place(0, 0.1, 0.0);
    std::array<Striker, 1> striker{{{.velocity = -2.0}}};
    for (int i = 0; i < 100; ++i) {
        head.step(striker);
    }
    return head;
}

/// The head rings by itself, listened to at range(1) points.
void ring(benchmark::State& state) {
    auto head = pushed(static_cast<std::size_t>(state.range(0)));
    std::vector<ModeBank::Weights> pickups;
    for (int i = 0; i < state.range(1); ++i) {
        const auto shapes = head.shapes(0.2 - 0.05 * i, 2.0);
        pickups.push_back(ModeBank::Weights{shapes, shapes, {}});
        head.bank().read_velocity(shapes, pickups.back());
    }
    std::array<double, ModeBank::kChunk> out{};
    for (auto _ : state) {
        for (const auto& weights : pickups) {
            head.bank().ring(weights, out);
            benchmark::DoNotOptimize(out);
        }
        head.bank().advance(out.size());
    }
    count_modes(state, static_cast<double>(out.size()));
}

/// The loops alone, as every x86-64 processor can run them and as this one runs them best; all
/// modes of one bank, without a force and range(1) pickups, or in spans with a force each sample,
/// foreseen at one port and one pickup.
void loops_of(benchmark::State& state, const ModeLoops& loops) {
    const auto size = static_cast<std::size_t>(state.range(0));
    ModeBank bank(size, 1 / kRate, loops);
    Values phi(bank.padded(), 0.1);
    for (std::size_t k = 0; k < size; ++k) {
        bank.set(k, {.angular_frequency = 300 + 10.0 * static_cast<double>(k), .loss = 1e-3});
    }
    const std::array<double, ModeBank::kSpan> forces{1.0, -0.5, 2.0};
    bank.give(forces, phi);
    ModeBank::Weights weights{phi, phi, {}};
    std::array<double, ModeBank::kChunk> out{};
    for (auto _ : state) {
        for (std::size_t n = 0; state.range(1) == 0 && n < out.size(); n += ModeBank::kSpan) {
            bank.ring(phi, std::span(out).subspan(n, ModeBank::kSpan));
            bank.ring(weights, std::span(out).subspan(n, ModeBank::kSpan));
            bank.advance(ModeBank::kSpan);
            bank.give(forces, phi);
        }
        for (int i = 0; i < state.range(1); ++i) {
            bank.ring(weights, out);
        }
        bank.advance(state.range(1) > 0 ? out.size() : 0);
        benchmark::DoNotOptimize(out);
    }
    count_modes(state, static_cast<double>(out.size()));
}

void loops_best(benchmark::State& state) {
    loops_of(state, ModeLoops::best());
}
void loops_baseline(benchmark::State& state) {
    loops_of(state, ModeLoops::baseline());
}

/// A mallet lies on the head and is pressed down: contact at each sample, and a pickup.
void contact(benchmark::State& state) {
    auto head = pushed(static_cast<std::size_t>(state.range(0)));
    head.place(0, 0.1, 0.0);
    const auto shapes = head.shapes(0.2, 2.0);
    ModeBank::Weights weights{shapes, shapes, {}};
    head.bank().read_velocity(shapes, weights);
    head.listen(0, weights);
    std::array<Striker, 1> striker{{{.position = head.displacement(0), .acceleration = -1000.0}}};
    long touching = 0;
    for (auto _ : state) {
        head.step(striker);
        benchmark::DoNotOptimize(head.reading(0));
        touching += striker[0].force > 0.0;
    }
    count_modes(state, 1.0);
    state.counters["touching"] =
        static_cast<double>(touching) / static_cast<double>(state.iterations());
}

/// A second of a lossless drum, its mallet coming back again and again; range(0): log10 of K.
void lossless_second(benchmark::State& state) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    double worst = 0.0;
    for (auto _ : state) {
        StruckMembrane head({}, Decay{.t60_low = kNever, .t60_high = kNever}, 240, kRate);
        head.place(0, 0.12, 0.3);
        std::array<Striker, 1> striker{{{.velocity = -3.0, .acceleration = 0.0}}};
        striker[0].mallet.stiffness = std::pow(10.0, static_cast<double>(state.range(0)));
        striker[0].mallet.dissipation = 0.0;
        const double before = head.energy(striker);
        for (int i = 0; i < 48000; ++i) {
            head.step(striker);
            worst = std::max(worst, std::abs(head.energy(striker) / before - 1));
        }
    }
    state.counters["energy_error"] = worst;
}

/// The equation of one contact alone.
void contact_equation(benchmark::State& state) {
    const Mallet mallet;
    double d = 0.0, rate = 2.0, force = 0.0;
    for (auto _ : state) {
        force = contact_force(mallet, {d, rate / kRate, 1e-8, 1 / kRate}, force);
        rate -= force / mallet.mass / kRate;
        d += rate / kRate;
        if (d < 0.0) {
            d = 0.0;
            rate = 2.0;
        }
        benchmark::DoNotOptimize(force);
    }
}

/// The whole instrument in blocks of 64, ten strokes a second; "load" is the part of one core.
void drum(benchmark::State& state) {
    ModalDrum drum({.choice = {.count = static_cast<std::size_t>(state.range(0))}}, kRate);
    std::array<float, 64> block{};
    for (auto _ : state) {
        drum.strike(100, {});
        for (int i = 0; i < 75; ++i) {
            drum.process(std::span(block));
        }
        benchmark::DoNotOptimize(block);
    }
    state.counters["load"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * 75 * 64 / kRate,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void silent_drum(benchmark::State& state) {
    ModalDrum drum({}, kRate);
    std::array<float, 64> block{};
    for (auto _ : state) {
        drum.process(std::span(block));
        benchmark::DoNotOptimize(block);
    }
}

/// A new striking place: the shapes of all modes there.
void place(benchmark::State& state) {
    auto head = pushed(static_cast<std::size_t>(state.range(0)));
    double r = 0.0;
    for (auto _ : state) {
        head.place(0, r, 1.0);
        r = r > 0.3 ? 0.0 : r + 0.001;
    }
}

void tune(benchmark::State& state) {
    auto head = pushed(static_cast<std::size_t>(state.range(0)));
    double tension = 3000.0;
    for (auto _ : state) {
        head.tune({.tension = tension += 0.001}, {});
    }
}

void set_modes(benchmark::State& state) {
    ModalDrum drum({}, kRate);
    for (auto _ : state) {
        drum.choose({.count = static_cast<std::size_t>(state.range(0))});
    }
}

BENCHMARK(ring)->ArgsProduct({{16, 256, 1024, 4096, 8192}, {1, 2}});
BENCHMARK(loops_best)->ArgsProduct({{256, 1024}, {0, 1, 2}});
BENCHMARK(loops_baseline)->ArgsProduct({{256, 1024}, {0, 1, 2}});
BENCHMARK(contact)->Arg(16)->Arg(256)->Arg(512)->Arg(1024)->Arg(4096);
BENCHMARK(contact_equation);
BENCHMARK(lossless_second)->DenseRange(5, 11, 2)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(drum)->Arg(120)->Arg(240)->Arg(1024)->Arg(4096)->Arg(8192);
BENCHMARK(silent_drum);
BENCHMARK(place)->Arg(240)->Arg(1024)->Arg(8192);
BENCHMARK(set_modes)->Arg(240)->Arg(1024)->Arg(8192)->Unit(benchmark::kMillisecond);
BENCHMARK(tune)->Arg(240)->Arg(1024)->Arg(8192);

}  // namespace

BENCHMARK_MAIN();
