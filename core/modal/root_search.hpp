// The roots of a function of a round body's edge, one after another, and the lowest of all orders.
#pragma once

#include <cmath>
#include <functional>
#include <queue>
#include <vector>

namespace percussionist::modal {

/// The first x above `from` where f changes sign, whose roots are more than 0.5 apart: by steps
/// that cannot skip two, then bisection and regula falsi (Illinois) to the last digits.
template <class F>
double next_root(const F& f, double from) {
    constexpr double kStep = 0.25;
    double low = from;
    double at_low = f(low);
    double high = low + kStep;
    double at_high = f(high);
    while (std::signbit(at_high) == std::signbit(at_low)) {
        low = high;
        at_low = at_high;
        high = low + kStep;
        at_high = f(high);
    }
    int side = 0;
    for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
        const double x = low + (high - low) * (at_low / (at_low - at_high));
        const double at_x = f(x);
        if (at_x == 0.0 || x <= low || x >= high) {
            return x;
        }
        if (std::signbit(at_x) == std::signbit(at_low)) {
            low = x;
            at_low = at_x;
            at_high *= side == -1 ? 0.5 : 1.0;
            side = -1;
        } else {
            high = x;
            at_high = at_x;
            at_low *= side == 1 ? 0.5 : 1.0;
            side = 1;
        }
    }
    return 0.5 * (low + high);
}

struct Root {
    int m;  ///< order
    int n;  ///< which of that order
    double x;
    bool operator>(const Root& other) const { return x > other.x; }
};

/// Calls take(root) for the roots of all orders, lowest first, until it answers false.
/// root_after(m, x) is the next of order m above x; first(m) the first, which from order `rising`
/// on grows with m.
template <class RootAfter, class First, class Take>
void in_order(int rising, const RootAfter& root_after, const First& first, const Take& take) {
    std::priority_queue<Root, std::vector<Root>, std::greater<>> waiting;
    for (int m = 0; m <= rising; ++m) {
        waiting.push({m, 1, first(m)});
    }
    while (true) {
        const Root root = waiting.top();
        if (!take(root)) {
            return;
        }
        waiting.pop();
        waiting.push({root.m, root.n + 1, root_after(root.m, root.x)});
        if (root.n == 1 && root.m >= rising) {
            waiting.push({root.m + 1, 1, first(root.m + 1)});
        }
    }
}

}  // namespace percussionist::modal
