// The loops themselves, for vectors of PERCUSSIONIST_WIDTH doubles: included by the one file that
// is compiled for each. No header of the standard library: what it has inline must not be compiled
// for a processor that is not there.
#include "core/modal/mode_loops.hpp"

namespace percussionist::modal {

namespace {

constexpr std::size_t kWidth = PERCUSSIONIST_WIDTH;
constexpr std::size_t kParts = 4 / kWidth;  // vectors to four lanes

using Vector __attribute__((vector_size(8 * kWidth), aligned(8), may_alias)) = double;

#define PERCUSSIONIST_INLINE inline __attribute__((always_inline))

PERCUSSIONIST_INLINE Vector load(const double* values) {
    return *reinterpret_cast<const Vector*>(values);
}

PERCUSSIONIST_INLINE void store(double* values, Vector v) {
    *reinterpret_cast<Vector*>(values) = v;
}

/// Loaded once: the compiler would rather read memory each time a value is used, but these loops
/// are as fast as memory is read.
PERCUSSIONIST_INLINE Vector held(Vector v) {
#if defined(__x86_64__)
    asm("" : "+x"(v));
#endif
    return v;
}

constexpr std::size_t kGroup = Modes::kGroup;
constexpr std::size_t kVectors = kGroup / kWidth;  // of a row

/// Sums of a row's vectors, each on its own: one chain of additions would wait for itself.
PERCUSSIONIST_INLINE double sum_of(const Vector* sums) {
    double lanes[4];
    for (std::size_t p = 0; p < kParts; ++p) {
        store(lanes + p * kWidth,
              (sums[p] + sums[kParts + p]) + (sums[2 * kParts + p] + sums[3 * kParts + p]));
    }
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

PERCUSSIONIST_INLINE double* record(const Modes& bank, std::size_t k) {
    return bank.block + k / kGroup * Modes::kRecord;
}

/// A mode's vector in a row of its record.
PERCUSSIONIST_INLINE Vector row(const double* record, Slot slot, std::size_t i) {
    return load(record + slot * kGroup + i);
}

PERCUSSIONIST_INLINE void set_row(double* record, Slot slot, std::size_t i, Vector v) {
    store(record + slot * kGroup + i, v);
}

void give_once(const Modes& bank, double force, const double* phi) {
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            const Vector share = force * load(phi + k + i);
            set_row(at, kQ, i, row(at, kQ, i) + row(at, kToQ, i) * share);
            set_row(at, kY, i, row(at, kY, i) + row(at, kToY, i) * share);
        }
    }
}

/// Goertzel's recurrence: x[n] = f[n] + 2 r cos x[n-1] - r^2 x[n-2], of which the sum of the
/// forces, each turned as often as samples have passed since, is x[n] - (turn back) x[n-1].
void give(const Modes& bank, const double* forces, std::size_t samples, const double* phi) {
    constexpr std::size_t kAtOnce = 4;
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t j = 0; j < kGroup; j += kAtOnce * kWidth) {
            Vector now[kAtOnce] = {}, last[kAtOnce] = {}, a[kAtOnce], b[kAtOnce];
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                const Vector c = row(at, kCos, j + i * kWidth), s = row(at, kSin, j + i * kWidth);
                a[i] = c + c;
                b[i] = c * c + s * s;
            }
            for (std::size_t n = 0; n < samples; ++n) {
                for (std::size_t i = 0; i < kAtOnce; ++i) {
                    const Vector next = (forces[n] - b[i] * last[i]) + a[i] * now[i];
                    last[i] = now[i];
                    now[i] = next;
                }
            }
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                const std::size_t m = j + i * kWidth;
                const Vector shape = load(phi + k + m);
                const Vector real = shape * (now[i] - row(at, kCos, m) * last[i]);
                const Vector imaginary = shape * (row(at, kSin, m) * last[i]);
                const Vector to_q = row(at, kToQ, m), to_y = row(at, kToY, m);
                set_row(at, kQ, m, row(at, kQ, m) + (to_q * real + to_y * imaginary));
                set_row(at, kY, m, row(at, kY, m) + (to_y * real - to_q * imaginary));
            }
        }
    }
}

void turn(const Modes& bank, std::size_t samples) {
    constexpr std::size_t kAtOnce = 4;
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t j = 0; j < kGroup; j += kAtOnce * kWidth) {
            Vector q[kAtOnce], y[kAtOnce];
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                q[i] = row(at, kQ, j + i * kWidth);
                y[i] = row(at, kY, j + i * kWidth);
            }
            for (std::size_t n = 0; n < samples; ++n) {
                for (std::size_t i = 0; i < kAtOnce; ++i) {
                    const Vector c = row(at, kCos, j + i * kWidth);
                    const Vector s = row(at, kSin, j + i * kWidth);
                    const Vector turned = c * q[i] + s * y[i];
                    y[i] = c * y[i] - s * q[i];
                    q[i] = turned;
                }
            }
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                set_row(at, kQ, j + i * kWidth, q[i]);
                set_row(at, kY, j + i * kWidth, y[i]);
            }
        }
    }
}

void turn_by(const Modes& bank, Slot cos) {
    const auto sin = static_cast<Slot>(cos + 1);
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            const Vector q = row(at, kQ, i), y = row(at, kY, i);
            const Vector c = row(at, cos, i), s = row(at, sin, i);
            set_row(at, kQ, i, c * q + s * y);
            set_row(at, kY, i, c * y - s * q);
        }
    }
}

double swing_about(const Modes& bank, const double* weights, double* middle) {
    Vector moves[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            const Vector q = held(row(at, kQ, i)), y = held(row(at, kY, i));
            const Vector c = held(row(at, kCos, i)), s = held(row(at, kSin, i));
            const Vector turned = c * q + s * y;
            const Vector about = load(weights + k + i) * (q + turned);
            set_row(at, kQ, i, turned);
            set_row(at, kY, i, c * y - s * q);
            store(middle + k + i, about);
            moves[i / kWidth] += about * (turned - q);
        }
    }
    return sum_of(moves);
}

double sum(const Modes& bank, const double* a) {
    Vector sums[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            sums[i / kWidth] += load(a + k + i) * row(at, kQ, i);
        }
    }
    return sum_of(sums);
}

double read(const Modes& bank, const double* a, const double* b) {
    Vector of_q[kVectors] = {}, of_y[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            of_q[i / kWidth] += load(a + k + i) * row(at, kQ, i);
            of_y[i / kWidth] += load(b + k + i) * row(at, kY, i);
        }
    }
    for (std::size_t p = 0; p < kVectors; ++p) {
        of_q[p] += of_y[p];
    }
    return sum_of(of_q);
}

/// Four recurrences stay in registers for all samples; each sample's sum waits in memory. They
/// begin with the motion there is, or with what 1 N shared out by phi makes of rest.
template <bool answering, bool two>
PERCUSSIONIST_INLINE void recur(const Modes& bank, const double* phi, const double* weights_q,
                                const double* weights_y, double* sums, std::size_t samples) {
    constexpr std::size_t kAtOnce = kGroup / 4;
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t p = 0; p < kParts; ++p) {
            Vector last[kAtOnce], now[kAtOnce], a[kAtOnce], b[kAtOnce];
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                const std::size_t j = 4 * i + p * kWidth;
                Vector q = row(at, answering ? kToQ : kQ, j), y = row(at, answering ? kToY : kY, j);
                if (answering) {
                    const Vector shape = load(phi + k + j);
                    q *= shape;
                    y *= shape;
                }
                const Vector c = row(at, kCos, j), s = row(at, kSin, j);
                const Vector of_q = load(weights_q + k + j);
                last[i] = of_q * q;
                now[i] = of_q * (c * q + s * y);
                if (two) {
                    const Vector of_y = load(weights_y + k + j);
                    last[i] += of_y * y;
                    now[i] += of_y * (c * y - s * q);
                }
                a[i] = c + c;
                b[i] = c * c + s * s;
            }
            double* sum = sums + p * kWidth;
            for (std::size_t n = 0; n < samples; ++n, sum += 4) {
                const Vector* const out = answering ? last : now;
                store(sum, load(sum) + ((out[0] + out[1]) + (out[2] + out[3])));
                for (std::size_t i = 0; i < kAtOnce; ++i) {
                    const Vector next = a[i] * now[i] - b[i] * last[i];
                    last[i] = now[i];
                    now[i] = next;
                }
            }
        }
    }
}

void ring(const Modes& bank, const double* weights_q, const double* weights_y, double* sums,
          std::size_t samples) {
    if (weights_y) {
        recur<false, true>(bank, nullptr, weights_q, weights_y, sums, samples);
    } else {
        recur<false, false>(bank, nullptr, weights_q, nullptr, sums, samples);
    }
}

void respond(const Modes& bank, const double* phi, const double* weights_q, const double* weights_y,
             double* sums, std::size_t samples) {
    if (weights_y) {
        recur<true, true>(bank, phi, weights_q, weights_y, sums, samples);
    } else {
        recur<true, false>(bank, phi, weights_q, nullptr, sums, samples);
    }
}

double respond_once(const Modes& bank, const double* phi, const double* weights_q,
                    const double* weights_y) {
    Vector sums[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            Vector reading = load(weights_q + k + i) * row(at, kToQ, i);
            if (weights_y) {
                reading += load(weights_y + k + i) * row(at, kToY, i);
            }
            sums[i / kWidth] += load(phi + k + i) * reading;
        }
    }
    return sum_of(sums);
}

constexpr ModeLoops kLoops{give, give_once, swing_about, turn,    turn_by,
                           sum,  read,      ring,        respond, respond_once};

}  // namespace

}  // namespace percussionist::modal
