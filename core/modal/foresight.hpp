// What the next samples will bring: for a span of samples the readings of a bank of modes as they
// are if nothing acts, and what the forces that do act add to them, one sample after the other.
//
// Where a force enters (an input) and where the bank is read (an output) are numbers. A reading is
// linear in all forces before it,
//     reading[n] = free[n] + sum over inputs, m <= n of force[m] answer[n - m],
// answer being what 1 N during one sample makes (ModeBank::answer()). So within the span no mode is
// looked at; at its end the bank is moved on once, and given all forces at once.
//
// The constructor allocates. All else is noexcept and may be called in the audio thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/modal/mode_bank.hpp"

namespace percussionist::modal {

class Foresight {
  public:
    static constexpr std::size_t kSpan = ModeBank::kSpan;
    using Course = std::array<double, kSpan>;

    Foresight(std::size_t inputs, std::size_t outputs)
        : outputs_(outputs),
          answers_(inputs * outputs),
          known_(inputs * outputs, 0),
          courses_(outputs),
          forces_(inputs) {
        watched_.reserve(outputs);
    }

    /// What 1 N at an input makes at an output; to be filled in unless known.
    Course& answer(std::size_t input, std::size_t output) noexcept {
        return answers_[input * outputs_ + output];
    }
    char& known(std::size_t input, std::size_t output) noexcept {
        return known_[input * outputs_ + output];
    }
    void forget() noexcept { std::fill(known_.begin(), known_.end(), char(0)); }
    void forget_input(std::size_t input) noexcept {
        std::fill_n(known_.begin() + static_cast<long>(input * outputs_), outputs_, char(0));
    }
    void forget_output(std::size_t output) noexcept {
        for (std::size_t i = output; i < known_.size(); i += outputs_) {
            known_[i] = 0;
        }
    }

    /// A span of `length` samples begins.
    void begin(std::size_t length) noexcept {
        length_ = length;
        passed_ = 0;
        watched_.clear();
    }
    /// An output to be foreseen; its course if nothing acts is to be filled in.
    Course& watch(std::size_t output) noexcept {
        watched_.push_back(output);
        return courses_[output];
    }
    std::span<const std::size_t> watched() const noexcept { return watched_; }
    bool watches(std::size_t output) const noexcept {
        return std::find(watched_.begin(), watched_.end(), output) != watched_.end();
    }

    /// A force during the present sample; answers to it are known at all outputs watched.
    void push(std::size_t input, double force) noexcept {
        Force& pushed = forces_[input];
        if (!pushed.there) {
            pushed = {.there = true, .newtons = {}};
        }
        pushed.newtons[passed_] += force;
        for (const std::size_t output : watched_) {
            const Course& answer = answers_[input * outputs_ + output];
            Course& course = courses_[output];
            for (std::size_t n = passed_; n < length_; ++n) {
                course[n] += force * answer[n - passed_];
            }
        }
    }
    void pass() noexcept { ++passed_; }

    bool over() const noexcept { return passed_ == length_; }
    std::size_t passed() const noexcept { return passed_; }
    /// As it will be after the present sample, and as it was after the last.
    double coming(std::size_t output) const noexcept { return courses_[output][passed_]; }
    double last(std::size_t output) const noexcept { return courses_[output][passed_ - 1]; }

    /// The span is over now. For each input with forces: give(input, forces).
    template <class Give>
    void end(Give give) noexcept {
        for (std::size_t i = 0; i < forces_.size(); ++i) {
            if (forces_[i].there) {
                give(i, std::span<const double>(forces_[i].newtons).first(passed_));
                forces_[i].there = false;
            }
        }
        length_ = passed_ = 0;
    }

  private:
    struct Force {
        bool there = false;
        Course newtons;
    };

    std::size_t outputs_;
    std::vector<Course> answers_;
    std::vector<char> known_;
    std::vector<Course> courses_;
    std::vector<Force> forces_;
    std::vector<std::size_t> watched_;
    std::size_t length_ = 0, passed_ = 0;
};

}  // namespace percussionist::modal
