// A server in a thread of its own, by a clock of its own, for tests.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/wall_clock.hpp"
#include "support/osc_listener.hpp"

namespace percussionist::test {

/// Goes as fast as it is asked to: sleeping is jumping ahead, once the threads that hear and tell
/// have had the processor; what they are given to send is bounded.
class HurriedClock : public app::WallClock {
  public:
    double now() const override { return now_; }
    void sleep_until(double time) override {
        now_ = std::max(now_.load(), time);
        std::this_thread::sleep_for(std::chrono::microseconds(20));
    }
    void jump(double seconds) { now_ = now_ + seconds; }

  private:
    std::atomic<double> now_{1.7e9};
};

template <class Server, class Options>
class Running {
  public:
    explicit Running(Options options = {})
        : server_(with_free_port(std::move(options)), clock_),
          thread_([this] { server_.run(stop_); }) {}
    ~Running() { end(); }
    void end() {
        stop_ = true;
        if (thread_.joinable()) thread_.join();
    }
    int port() const { return server_.port(); }
    HurriedClock& clock() { return clock_; }
    const Server& server() const { return server_; }  ///< once it has ended

  private:
    static Options with_free_port(Options options) {
        options.endpoint.port = 0;
        return options;
    }
    HurriedClock clock_;
    Server server_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace percussionist::test
