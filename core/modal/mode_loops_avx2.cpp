// The loops for processors with AVX2; compiled for them.
#if defined(__x86_64__)

#define PERCUSSIONIST_WIDTH 4
#include "core/modal/mode_loops_body.hpp"

namespace percussionist::modal {

const ModeLoops& avx2_mode_loops();

const ModeLoops& avx2_mode_loops() {
    return kLoops;
}

}  // namespace percussionist::modal

#endif
