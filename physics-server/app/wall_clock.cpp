#include "app/wall_clock.hpp"

#include <chrono>
#include <thread>

namespace percussionist::app {

namespace {

using Seconds = std::chrono::duration<double>;

double monotonic() {
    return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

SystemClock::SystemClock()
    : offset_(Seconds(std::chrono::system_clock::now().time_since_epoch()).count() - monotonic()) {}

double SystemClock::now() const {
    return monotonic() + offset_;
}

void SystemClock::sleep_until(double time) {
    const double wait = time - now();
    if (wait > 0.0) std::this_thread::sleep_for(Seconds(wait));
}

}  // namespace percussionist::app
