// How many answers a host gets, and all hosts together: so many at once, and so many more a second.
// A flood of questions, or one that pretends to come from somebody else, or from ever new ones,
// makes no flood of answers.
//
// The hosts heard last are remembered; time is an argument [s]. One thread at a time; no
// allocation.
#pragma once

#include <netinet/in.h>

#include <array>

namespace percussionist::osc {

class AnswerBudget {
  public:
    static constexpr double kAtOnce = 512.0;
    static constexpr double kPerSecond = 512.0;
    static constexpr std::size_t kHosts = 64;
    /// All hosts together get so many times that.
    static constexpr double kTogether = 8.0;

    /// Whether one more answer may go there; if so, it counts.
    bool allows(in_addr_t host, double now);

  private:
    struct Account {
        in_addr_t host = 0;
        double left = 0.0;
        double heard = -1e300;
        void fill(double times, double now);
    };
    std::array<Account, kHosts> accounts_;
    Account all_{0, kTogether* kAtOnce, -1e300};
};

}  // namespace percussionist::osc
