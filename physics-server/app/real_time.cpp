#include "app/real_time.hpp"

#include <sched.h>

namespace percussionist::app {

bool ask_for_real_time() {
    sched_param parameters{};
    parameters.sched_priority = 10;
    return sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) == 0;
}

}  // namespace percussionist::app
