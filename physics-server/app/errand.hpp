// What takes longer than a step, a file read or written at someone's wish: done by another thread,
// and who asked is told how it went.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <future>
#include <optional>
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

    /// `work` in another thread; then the asker hears /reply with `reply` of its result, or /error
    /// with what it threw. Throws std::runtime_error if the one before has not been taken.
    void begin(const osc::Heard& wish, std::function<Result()> work,
               std::function<std::string(const Result&)> reply) {
        if (going_.valid()) throw std::runtime_error(about_);
        going_ = std::async(std::launch::async, [this, sender = wish.sender, address = wish.address,
                                                 work = std::move(work), reply = std::move(reply)] {
            try {
                Result result = work();
                endpoint_.answer(sender, "/reply", {address, reply(result)});
                return std::optional<Result>(std::move(result));
            } catch (const std::exception& error) {
                fmt::print(stderr, "{}\n", error.what());
                endpoint_.answer(sender, "/error", {address, error.what()});
                return std::optional<Result>();
            }
        });
    }

    /// What came of it, once it has ended well.
    std::optional<Result> take() {
        constexpr auto kAtOnce = std::chrono::seconds(0);
        if (!going_.valid() || going_.wait_for(kAtOnce) != std::future_status::ready) {
            return std::nullopt;
        }
        return going_.get();
    }

  private:
    osc::Endpoint& endpoint_;
    std::string about_;
    std::future<std::optional<Result>> going_;
};

}  // namespace percussionist::app
