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

/// The rows of a record: state, turn in a sample and in a chunk, and what f phi adds in a sample.
enum Slot : std::size_t { kQ, kY, kCos, kSin, kToQ, kToY, kChunkCos, kChunkSin, kSlots };

/// A bank as the loops see it: its block, and how many modes move.
struct Modes {
    static constexpr std::size_t kGroup = 16;
    static constexpr std::size_t kRecord = kSlots * kGroup;

    double* block;
    std::size_t size;  ///< a multiple of kGroup
};

struct ModeLoops {
    /// q += to_q force phi, y += to_y force phi.
    void (*push)(const Modes& bank, double force, const double* phi);
    /// One turn; answers sum phi q.
    double (*swing)(const Modes& bank, const double* phi);
    /// push(force, shares), then swing(phi), in one pass.
    double (*push_and_swing)(const Modes& bank, double force, const double* shares,
                             const double* phi);
    /// push(force, phi), swing(phi), and reading = sum a q + b y then, in one pass: all that is
    /// done in a sample in which one mallet touches.
    double (*touch)(const Modes& bank, double force, const double* phi, const double* a,
                    const double* b, double& reading);
    /// swing() that fills middle = weights (q before + q after), and sets
    /// moved = sum middle (q after - q before).
    double (*swing_about)(const Modes& bank, const double* phi, const double* weights,
                          double* middle, double& moved);
    /// `samples` turns, or one by a whole chunk.
    void (*turn)(const Modes& bank, std::size_t samples);
    void (*turn_chunk)(const Modes& bank);
    /// sum a x; sum a b x; x being a row of the bank.
    double (*sum)(const Modes& bank, Slot row, const double* a);
    double (*sum2)(const Modes& bank, Slot row, const double* a, const double* b);
    /// sum a q + b y.
    double (*read)(const Modes& bank, const double* a, const double* b);
    /// sums[4 n .. 4 n + 3] += the lanes of the reading after n + 1 turns.
    void (*ring)(const Modes& bank, const double* a, const double* b, double* sums,
                 std::size_t samples);

    static const ModeLoops& best();
    static const ModeLoops& baseline();
};

}  // namespace percussionist::modal
