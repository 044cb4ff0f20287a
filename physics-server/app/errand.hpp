// What takes longer than a step, a file read or written at someone's wish: done by another thread,
// and who asked is told how it went.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <future>
#include <stdexcept>
#include <string>
#include <utility>

#include "osc/endpoint.hpp"

namespace percussionist::app {

/// One at a time. begin() and take() in one thread, which never waits; the end of an Errand waits
/// for what goes on.
template <class Result>
class Errand {
  public:
    /// `about` is said to whoever asks while it goes on: "a score is being read".
    Errand(osc::Endpoint& endpoint, std::string about)
        : endpoint_(endpoint), about_(std::move(about)) {}

    /// `work` in another thread; take() tells the asker how it went. Throws std::runtime_error if
    /// the one before has not been taken.
    void begin(const osc::Heard& wish, std::function<Result()> work,
               std::function<std::string(const Result&)> reply) {
        if (going_.valid()) throw std::runtime_error(about_);
        sender_ = wish.sender;
        address_ = wish.address;
        reply_ = std::move(reply);
        going_ = std::async(std::launch::async, std::move(work));
    }

    /// Once it has ended, `use` of what came of it; then the asker hears /reply with `reply` of
    /// that, or /error with what was thrown. Whoever acts on the answer finds the result in use.
    template <class Use>
    void take(Use use) {
        constexpr auto kAtOnce = std::chrono::seconds(0);
        if (!going_.valid() || going_.wait_for(kAtOnce) != std::future_status::ready) return;
        try {
            Result result = going_.get();
            const std::string said = reply_(result);
            use(std::move(result));
            endpoint_.answer(sender_, "/reply", {address_, said});
        } catch (const std::exception& error) {
            fmt::print(stderr, "{}\n", error.what());
            endpoint_.answer(sender_, "/error", {address_, error.what()});
        }
    }

  private:
    osc::Endpoint& endpoint_;
    std::string about_;
    osc::Peer sender_;  ///< who asked, and what
    std::string address_;
    std::function<std::string(const Result&)> reply_;
    std::future<Result> going_;
};

}  // namespace percussionist::app
