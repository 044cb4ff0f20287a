#include "app/stop_signals.hpp"

#include <csignal>

namespace percussionist::app {

namespace {

std::atomic<bool> g_stop{false};

void ask_to_stop(int) {
    g_stop = true;
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    return g_stop;
}

}  // namespace percussionist::app
