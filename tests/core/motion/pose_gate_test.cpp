#include "core/motion/pose_gate.hpp"

#include <doctest/doctest.h>

using namespace percussionist::motion;
using percussionist::linear::Quaternion;
using Verdict = PoseGate::Verdict;

namespace {

TimedPose pose(double time, double x) {
    return {time, {{x, 0.0, 0.0}, Quaternion::Identity()}};
}

}  // namespace

TEST_CASE("repeats and times that do not rise are dropped, slow movement is not") {
    PoseGate gate;
    CHECK(gate.judge(pose(0.00, 0.1)) == Verdict::kFresh);
    CHECK(gate.judge(pose(0.01, 0.1)) == Verdict::kRepeat);
    CHECK(gate.judge(pose(0.02, 0.1 + 1e-9)) == Verdict::kGood);
    CHECK(gate.judge(pose(0.02, 0.2)) == Verdict::kRepeat);
    CHECK(gate.repeats() == 2);
}

TEST_CASE("a jump that comes back never was; one that stays is a new path") {
    PoseGate gate;
    gate.judge(pose(0.00, 0.0));
    CHECK(gate.judge(pose(0.01, 2.0)) == Verdict::kJump);
    CHECK(gate.judge(pose(0.02, 0.05)) == Verdict::kGood);
    CHECK(gate.judge(pose(0.03, 2.0)) == Verdict::kJump);
    CHECK(gate.judge(pose(0.04, 2.02)) == Verdict::kFresh);
    CHECK(gate.judge(pose(0.05, 2.05)) == Verdict::kGood);
    CHECK(gate.jumps() == 2);
}

TEST_CASE("after a pause anything may have happened") {
    PoseGate gate;
    gate.judge(pose(0.0, 0.0));
    CHECK(gate.judge(pose(1.0, 3.0)) == Verdict::kFresh);
}
