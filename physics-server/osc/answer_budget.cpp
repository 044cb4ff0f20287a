#include "osc/answer_budget.hpp"

#include <algorithm>

namespace percussionist::osc {

void AnswerBudget::Account::fill(double times, double now) {
    left = std::min(times * kAtOnce, left + times * kPerSecond * (now - heard));
    heard = now;
}

bool AnswerBudget::allows(in_addr_t host, double now) {
    auto account = std::find_if(accounts_.begin(), accounts_.end(), [host](const Account& a) {
        return a.host == host && a.heard > -1e300;
    });
    if (account == accounts_.end()) {
        account = std::min_element(accounts_.begin(), accounts_.end(),
                                   [](const auto& a, const auto& b) { return a.heard < b.heard; });
        *account = {host, kAtOnce, now};
    }
    account->fill(1.0, now);
    all_.fill(kTogether, now);
    if (account->left < 1.0 || all_.left < 1.0) return false;
    account->left -= 1.0;
    all_.left -= 1.0;
    return true;
}

}  // namespace percussionist::osc
