#include "osc/answer_budget.hpp"

#include <doctest/doctest.h>

using percussionist::osc::AnswerBudget;

namespace {

int answers(AnswerBudget& budget, in_addr_t host, int asked, double now) {
    int count = 0;
    for (int i = 0; i < asked; ++i) count += budget.allows(host, now) ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("answer budget: so many at once, so many a second, whoever else asks") {
    AnswerBudget budget;
    CHECK(answers(budget, 1, 10000, 5.0) == static_cast<int>(AnswerBudget::kAtOnce));
    CHECK(answers(budget, 2, 10, 5.0) == 10);
    CHECK(answers(budget, 1, 10000, 5.5) == static_cast<int>(0.5 * AnswerBudget::kPerSecond));
    CHECK(answers(budget, 1, 10000, 1e6) == static_cast<int>(AnswerBudget::kAtOnce));
}

TEST_CASE("answer budget: whoever floods is remembered though thousands of others come") {
    AnswerBudget budget;
    answers(budget, 1, 10000, 0.0);
    int allowed = 0;
    for (in_addr_t host = 2; host < 5000; ++host) {
        budget.allows(host, 0.0);
        allowed += budget.allows(1, 1e-9 * host) ? 1 : 0;
    }
    CHECK(allowed == 0);
}

TEST_CASE("answer budget: ever new hosts get no more than a few, however many they are") {
    constexpr double kAll = AnswerBudget::kTogether * AnswerBudget::kAtOnce;
    AnswerBudget budget;
    int allowed = 0;
    for (int round = 0; round < 100; ++round) {
        for (in_addr_t host = 1; host <= AnswerBudget::kHosts + 1; ++host) {
            allowed += answers(budget, host, 100, 7.0);
        }
    }
    CHECK(allowed == static_cast<int>(kAll));
    allowed = 0;
    for (in_addr_t host = 1000; host < 2000; ++host) allowed += answers(budget, host, 100, 7.5);
    CHECK(allowed == static_cast<int>(kAll / 2));
}
