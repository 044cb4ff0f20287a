// The loops for any processor, and the choice.
#define PERCUSSIONIST_WIDTH 2
#include "core/modal/mode_loops_body.hpp"

namespace percussionist::modal {

#if defined(__x86_64__)
/// In mode_loops_avx2.cpp.
const ModeLoops& avx2_mode_loops();
#endif

const ModeLoops& ModeLoops::baseline() {
    return kLoops;
}

const ModeLoops& ModeLoops::best() {
#if defined(__x86_64__)
    static const ModeLoops& chosen = __builtin_cpu_supports("avx2") ? avx2_mode_loops() : kLoops;
    return chosen;
#else
    return kLoops;
#endif
}

}  // namespace percussionist::modal
