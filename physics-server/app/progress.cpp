#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace percussionist::app {

Progress::Progress(std::string what) : what_(std::move(what)), shown_(isatty(STDERR_FILENO) != 0) {}

void Progress::tell(double done, const std::string& detail) {
    const int percent = static_cast<int>(100.0 * done);
    if (!shown_ || percent == told_) return;
    told_ = percent;
    fmt::print(stderr, "\r\x1b[K{} {:3} % {}", what_, percent, detail);
    std::fflush(stderr);
}

void Progress::done() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace percussionist::app
