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

void push(const Modes& bank, double force, const double* phi) {
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            const Vector share = force * load(phi + k + i);
            set_row(at, kQ, i, row(at, kQ, i) + row(at, kToQ, i) * share);
            set_row(at, kY, i, row(at, kY, i) + row(at, kToY, i) * share);
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

void turn_chunk(const Modes& bank) {
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            const Vector q = row(at, kQ, i), y = row(at, kY, i);
            const Vector c = row(at, kChunkCos, i), s = row(at, kChunkSin, i);
            set_row(at, kQ, i, c * q + s * y);
            set_row(at, kY, i, c * y - s * q);
        }
    }
}

template <bool pushed>
PERCUSSIONIST_INLINE double swing_once(const Modes& bank, double force, const double* shares,
                                       const double* phi) {
    Vector sums[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            Vector q = row(at, kQ, i), y = row(at, kY, i);
            if (pushed) {
                const Vector share = force * load(shares + k + i);
                q += row(at, kToQ, i) * share;
                y += row(at, kToY, i) * share;
            }
            const Vector c = held(row(at, kCos, i)), s = held(row(at, kSin, i));
            const Vector turned = c * q + s * y;
            set_row(at, kQ, i, turned);
            set_row(at, kY, i, c * y - s * q);
            sums[i / kWidth] += load(phi + k + i) * turned;
        }
    }
    return sum_of(sums);
}

double swing(const Modes& bank, const double* phi) {
    return swing_once<false>(bank, 0.0, nullptr, phi);
}

double push_and_swing(const Modes& bank, double force, const double* shares, const double* phi) {
    return swing_once<true>(bank, force, shares, phi);
}

double touch(const Modes& bank, double force, const double* phi, const double* a, const double* b,
             double& reading) {
    Vector sums[kVectors] = {}, reads[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            const Vector shape = held(load(phi + k + i));
            const Vector share = force * shape;
            const Vector q = held(row(at, kQ, i) + row(at, kToQ, i) * share);
            const Vector y = held(row(at, kY, i) + row(at, kToY, i) * share);
            const Vector c = held(row(at, kCos, i)), s = held(row(at, kSin, i));
            const Vector turned_q = c * q + s * y;
            const Vector turned_y = c * y - s * q;
            set_row(at, kQ, i, turned_q);
            set_row(at, kY, i, turned_y);
            sums[i / kWidth] += shape * turned_q;
            reads[i / kWidth] += load(a + k + i) * turned_q + load(b + k + i) * turned_y;
        }
    }
    reading = sum_of(reads);
    return sum_of(sums);
}

double swing_about(const Modes& bank, const double* phi, const double* weights, double* middle,
                   double& moved) {
    Vector sums[kVectors] = {}, moves[kVectors] = {};
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
            sums[i / kWidth] += load(phi + k + i) * turned;
        }
    }
    moved = sum_of(moves);
    return sum_of(sums);
}

double sum(const Modes& bank, Slot slot, const double* a) {
    Vector sums[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            sums[i / kWidth] += load(a + k + i) * row(at, slot, i);
        }
    }
    return sum_of(sums);
}

double sum2(const Modes& bank, Slot slot, const double* a, const double* b) {
    Vector sums[kVectors] = {};
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t i = 0; i < kGroup; i += kWidth) {
            sums[i / kWidth] += load(a + k + i) * load(b + k + i) * row(at, slot, i);
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

/// Four recurrences stay in registers for all samples; each sample's sum waits in memory.
void ring(const Modes& bank, const double* weights_q, const double* weights_y, double* sums,
          std::size_t samples) {
    constexpr std::size_t kAtOnce = kGroup / 4;
    for (std::size_t k = 0; k < bank.size; k += kGroup) {
        const double* const at = record(bank, k);
        for (std::size_t p = 0; p < kParts; ++p) {
            Vector last[kAtOnce], now[kAtOnce], a[kAtOnce], b[kAtOnce];
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                const std::size_t j = 4 * i + p * kWidth;
                const Vector q = row(at, kQ, j), y = row(at, kY, j);
                const Vector c = row(at, kCos, j), s = row(at, kSin, j);
                const Vector of_q = load(weights_q + k + j), of_y = load(weights_y + k + j);
                last[i] = of_q * q + of_y * y;
                now[i] = of_q * (c * q + s * y) + of_y * (c * y - s * q);
                a[i] = c + c;
                b[i] = c * c + s * s;
            }
            double* sum = sums + p * kWidth;
            for (std::size_t n = 0; n < samples; ++n, sum += 4) {
                store(sum, load(sum) + ((now[0] + now[1]) + (now[2] + now[3])));
                for (std::size_t i = 0; i < kAtOnce; ++i) {
                    const Vector next = a[i] * now[i] - b[i] * last[i];
                    last[i] = now[i];
                    now[i] = next;
                }
            }
        }
    }
}

constexpr ModeLoops kLoops{push,       swing, push_and_swing, touch, swing_about, turn,
                           turn_chunk, sum,   sum2,           read,  ring};

}  // namespace

}  // namespace percussionist::modal
