// The loops over modes of mode_bank.hpp: plain numbers in and out.
//
// A bank is one block of memory: for each group of kGroup modes a record of kSlots rows of kGroup
// numbers, so that what belongs together lies together, and no two streams fall on one set of the
// cache. Weights (phi and the like) are plain arrays of as many modes, whole groups.
//
// On x86-64 they are compiled twice, for the least such processor and for AVX2; best() takes the
// better one the processor has. Both give the same bits: each of four lanes sums every fourth mode,
// whether in vectors of two or of four.
#pragma once

#include <cstddef>

namespace percussionist::modal {

/// The rows of a record: state, turn in a sample, what f phi adds in a sample, and the turns in a
/// span and in a chunk of samples.
enum Slot : std::size_t {
    kQ,
    kY,
    kCos,
    kSin,
    kToQ,
    kToY,
    kSpanCos,
    kSpanSin,
    kChunkCos,
    kChunkSin,
    kSlots
};

/// A bank as the loops see it: its block, and how many modes move.
struct Modes {
    static constexpr std::size_t kGroup = 16;
    static constexpr std::size_t kRecord = kSlots * kGroup;

    double* block;
    std::size_t size;  ///< a multiple of kGroup
};

struct ModeLoops {
    /// What forces, shared out by phi, have added when `samples` have passed, each sample with its
    /// own force; and what one has, in a simpler way.
    void (*give)(const Modes& bank, const double* forces, std::size_t samples, const double* phi);
    void (*give_once)(const Modes& bank, double force, const double* phi);
    /// One turn that fills middle = weights (q before + q after); answers
    /// sum middle (q after - q before).
    double (*swing_about)(const Modes& bank, const double* weights, double* middle);
    /// `samples` turns, or one by a whole span or chunk: by the row kSpanCos or kChunkCos and the
    /// one after it.
    void (*turn)(const Modes& bank, std::size_t samples);
    void (*turn_by)(const Modes& bank, Slot cos);
    /// sum a q.
    double (*sum)(const Modes& bank, const double* a);
    /// sum a q + b y.
    double (*read)(const Modes& bank, const double* a, const double* b);
    /// sums[4 n .. 4 n + 3] += the lanes of the reading sum a q + b y after n + 1 turns; b may be
    /// null for none.
    void (*ring)(const Modes& bank, const double* a, const double* b, double* sums,
                 std::size_t samples);
    /// The same after n turns, of the motion that 1 N, shared out by phi, makes in one sample; and
    /// that motion's own reading.
    void (*respond)(const Modes& bank, const double* phi, const double* a, const double* b,
                    double* sums, std::size_t samples);
    double (*respond_once)(const Modes& bank, const double* phi, const double* a, const double* b);

    static const ModeLoops& best();
    static const ModeLoops& baseline();
};

}  // namespace percussionist::modal
