#include "io/playout.hpp"

#include <algorithm>

namespace percussionist::io {

namespace {

constexpr double kSameTime = 1e-9;  // [s]
constexpr double kLate = 1e-5;      // half a sample: what is later was not heard in time [s]
constexpr double kAtOnce = -std::numeric_limits<double>::infinity();

bool after(const std::unique_ptr<Delivery>& a, const std::unique_ptr<Delivery>& b) {
    const double due_a = a->due.value_or(kAtOnce), due_b = b->due.value_or(kAtOnce);
    return due_a != due_b ? due_a > due_b : a->serial > b->serial;
}

}  // namespace

Playout::Playout(std::size_t room) : room_(room) {
    waiting_.reserve(room);
}

void Playout::add(std::unique_ptr<Delivery> delivery) noexcept {
    waiting_.push_back(std::move(delivery));
    std::push_heap(waiting_.begin(), waiting_.end(), after);
}

double Playout::next() const noexcept {
    if (waiting_.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const auto& due = waiting_.front()->due;
    return due ? line_.to_x(*due + latency_) : kAtOnce;
}

std::unique_ptr<Delivery> Playout::take(double logical) noexcept {
    const double due = next();
    if (due > logical + kSameTime) {
        return nullptr;
    }
    std::pop_heap(waiting_.begin(), waiting_.end(), after);
    auto delivery = std::move(waiting_.back());
    waiting_.pop_back();
    if (due < logical - kLate && delivery->due) {
        ++late_;
        latest_ = std::max(latest_, logical - due);
        if (delivery->stale) {
            delivery->messages.clear();
        }
    }
    return delivery;
}

}  // namespace percussionist::io
