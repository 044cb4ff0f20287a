#include "app/tracking.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace percussionist::app {

namespace {

using body::Hand;
using body::kHands;
using body::Vector3;

/// Samples kept a second.
constexpr double kSampleRate = 250.0;
/// A still clip (one frame) is held for so long [s].
constexpr double kShortest = 1.0;

/// From the upper arm's direction to the forearm's, of the rotation of the elbow.
double flexion(const body::Quaternion& elbow) {
    // At rest the upper arm points down, the forearm ahead.
    const double cosine = -(elbow * Vector3::UnitX()).z();
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

class Tracker {
  public:
    Tracker(const LoadedClip& clip, const TrackControl& control, const TrackOptions& options)
        : simulation_(simulation_options(clip, options)),
          options_(options),
          posture_(simulation_.skeleton()),
          placement_(simulation_.skeleton()) {
        run_.control = control;
        for (int i = 0; i < clip.skeleton.size(); ++i) {
            simulation_.set_limits(i, clip.skeleton.segments[i].limits);
        }
        simulation_.controller().set_law(control.law);
        simulation_.controller().set_gains(options.frequency, options.damping);
        simulation_.controller().set_paper_gains(options.paper_frequency, 1.0);
        simulation_.set_tracking(control.tracking);
        simulation_.set_inverse(control.inverse);
        simulation_.begin_with(clip.clip, options.start);
        for (const Hand hand : kHands) {
            const std::string side = body::Skeleton::side(hand);
            int* joints = joints_[static_cast<int>(hand)];
            for (const char* name : {"upper_arm", "forearm", "hand", "stick"}) {
                *joints++ = simulation_.skeleton().index(side + name);
            }
        }
    }

    TrackRun run() {
        const double left = simulation_.following()->clip().duration() - options_.start;
        const double duration = std::min(std::max(left, kShortest), options_.seconds);
        double next_sample = 0.0;
        std::vector<sim::ContactEvent> none;
        while (simulation_.time() < duration) {
            const auto before = std::chrono::steady_clock::now();
            simulation_.step(none);
            run_.computing +=
                std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
            run_.lasted = simulation_.time();
            if (!simulation_.sane()) {
                run_.stable = false;
                break;
            }
            measure(simulation_.time() >= next_sample);
            if (simulation_.time() >= next_sample) next_sample += 1.0 / kSampleRate;
        }
        return std::move(run_);
    }

  private:
    static sim::SimulationOptions simulation_options(const LoadedClip& clip,
                                                     const TrackOptions& options) {
        sim::SimulationOptions o;
        o.rate = options.rate;
        o.person = clip.person;
        o.head_there = false;
        o.mass_error = options.mass_error;
        return o;
    }

    void measure(bool keep) {
        const body::ClipFollower& clip = *simulation_.following();
        const double t = simulation_.time() + options_.start;
        clip.posture(t, posture_, placement_);
        const body::Placement& actual = simulation_.placement();
        const body::Posture& asked = simulation_.posture_asked();
        const auto relative = [&](int i) {
            const int parent = simulation_.skeleton().segments[i].parent;
            return body::Quaternion(actual.orientation[parent].conjugate() * actual.orientation[i]);
        };
        for (int i = 1; i < simulation_.skeleton().size(); ++i) {
            const body::Quaternion q = relative(i);
            run_.joint.take(q.angularDistance(asked.joints[i]));
            run_.joint_captured.take(q.angularDistance(posture_.joints[i]));
        }
        TrackSample sample;
        sample.time = simulation_.time();
        for (const Hand hand : kHands) {
            const int h = static_cast<int>(hand);
            TrackSample::Arm& arm = sample.arms[h];
            arm.tip_captured = clip.tip(t, hand, placement_);
            arm.tip = actual.tip(simulation_.skeleton(), hand);
            run_.tip.take((arm.tip - arm.tip_captured).norm());
            run_.asked_tip.take((simulation_.tip_asked(hand) - arm.tip_captured).norm());
            const int elbow = joints_[h][1];
            arm.elbow_captured = flexion(posture_.joints[elbow]);
            arm.elbow_asked = flexion(asked.joints[elbow]);
            arm.elbow = flexion(relative(elbow));
            run_.elbow_asked.take(std::abs(arm.elbow_asked - arm.elbow_captured));
            run_.elbow.take(std::abs(arm.elbow - arm.elbow_captured));
            for (int j = 0; j < 4; ++j) {
                arm.torque[j] = simulation_.controller().torque(joints_[h][j]).norm();
                run_.worst_torque = std::max(run_.worst_torque, arm.torque[j]);
            }
        }
        if (keep) run_.samples.push_back(sample);
    }

    sim::Simulation simulation_;
    TrackOptions options_;
    TrackRun run_;
    body::Posture posture_;
    body::Placement placement_;
    int joints_[2][4] = {};  ///< segments of shoulder, elbow, wrist, grip, by Hand
};

}  // namespace

double ErrorSize::rms() const {
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

std::vector<TrackControl> all_track_controls() {
    std::vector<TrackControl> all;
    for (const sim::Law law : {sim::Law::paper, sim::Law::implicit}) {
        using body::Inverse;
        using body::Tracking;
        all.push_back({"joints", law, Tracking::joints, Inverse::damped_least_squares});
        all.push_back({"dls", law, Tracking::tips, Inverse::damped_least_squares});
        all.push_back({"transpose", law, Tracking::tips, Inverse::transpose});
        all.push_back({"learnt", law, Tracking::tips, Inverse::learnt});
    }
    return all;
}

std::string law_name(sim::Law law) {
    return law == sim::Law::paper ? "paper" : "implicit";
}

TrackRun track(const LoadedClip& clip, const TrackControl& control, const TrackOptions& options) {
    return Tracker(clip, control, options).run();
}

}  // namespace percussionist::app
