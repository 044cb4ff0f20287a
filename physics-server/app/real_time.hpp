// Asks the system to run the calling thread before others.
#pragma once

namespace percussionist::app {

/// SCHED_FIFO at a low priority for this thread, where the user may have it; false, and nothing
/// changes, where not. Threads made afterwards by it are ordinary ones.
bool ask_for_real_time();

}  // namespace percussionist::app
