// An orderly end on SIGINT and SIGTERM.
#pragma once

#include <atomic>

namespace percussionist::app {

/// From now on either signal sets what this returns.
const std::atomic<bool>& stop_on_signals();

}  // namespace percussionist::app
