#include "core/listening/practice/learning.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/listening/context.hpp"
#include "core/listening/judgement.hpp"
#include "core/listening/network_training.hpp"
#include "core/listening/stroke_features.hpp"

namespace percussionist::listening::practice {

namespace {

using Eigen::Index;
using Eigen::MatrixXf;

constexpr double kSameMoment = 0.03;  ///< between an attack and the stroke it is [s]
constexpr float kAtLeast = -0.4F;     ///< odds of toms and cymbals
constexpr std::size_t kHeldOut = 10;  ///< every so many lessons one decides thresholds

/// 1 for each class struck at each attack; a hat of any kind counts as a closed one too, and a
/// crash as a ride.
MatrixXf targets(const Lesson& lesson) {
    const auto& times = lesson.evidence.times;
    MatrixXf struck =
        MatrixXf::Zero(static_cast<Index>(kDrumClasses), static_cast<Index>(times.size()));
    for (const HeardStroke& stroke : lesson.strokes) {
        auto it = std::lower_bound(times.begin(), times.end(), stroke.time - kSameMoment);
        for (; it != times.end() && *it < stroke.time + kSameMoment; ++it) {
            const Index column = it - times.begin();
            struck(static_cast<Index>(index(stroke.drum)), column) = 1.0F;
            if (stroke.drum == DrumClass::open_hat) {
                struck(static_cast<Index>(index(DrumClass::closed_hat)), column) = 1.0F;
            }
            if (stroke.drum == DrumClass::crash) {
                struck(static_cast<Index>(index(DrumClass::ride)), column) = 1.0F;
            }
        }
    }
    return struck;
}

/// Columns of several lessons side by side.
class Collection {
  public:
    void add(const MatrixXf& inputs, const MatrixXf& wanted) {
        inputs_.push_back(&inputs);
        targets_.push_back(&wanted);
        count_ += inputs.cols();
    }
    [[nodiscard]] Examples examples(Index rows) const {
        Examples all{MatrixXf(rows, count_), MatrixXf(static_cast<Index>(kDrumClasses), count_)};
        Index at = 0;
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            all.inputs.middleCols(at, inputs_[i]->cols()) = inputs_[i]->topRows(rows);
            all.targets.middleCols(at, inputs_[i]->cols()) = *targets_[i];
            at += inputs_[i]->cols();
        }
        return all;
    }

  private:
    std::vector<const MatrixXf*> inputs_, targets_;
    Index count_ = 0;
};

/// The odds at which precision and recall, between them, are best; for toms and cymbals not far
/// below even ones, and for what is no drum of a kit not at all below, since there one too many is
/// worse than one missed.
Odds best_thresholds(const MatrixXf& odds, const MatrixXf& struck) {
    Odds best{};
    for (std::size_t c = 0; c < kDrumClasses; ++c) {
        const auto said_odds = odds.row(static_cast<Index>(c)).array();
        const auto truth = struck.row(static_cast<Index>(c)).array();
        float most = -1.0F;
        for (int step = -25; step <= 25; ++step) {
            const float threshold = 0.1F * static_cast<float>(step);
            const Eigen::Array<float, 1, Eigen::Dynamic> said =
                (said_odds >= threshold).cast<float>();
            const float f = (said * truth).sum() / (said.sum() + truth.sum() + 1.0F);
            if (f > most) {
                most = f;
                best[c] = threshold;
            }
        }
        // Chance moves the best of such a curve about, and made-up pieces make too sure. For odds
        // that hold what they say it is where the chance is half the best F (Lipton and others
        // 2014, "Optimal thresholding of classifiers to maximize F1 measure"): half way to there.
        const float held = std::clamp(most, 0.05F, 0.95F);  // half of F: right / (said + struck)
        best[c] = 0.5F * (best[c] + std::log(held / (1.0F - held)));
        if (c == index(DrumClass::other)) best[c] = std::max(best[c], 0.0F);
        if (c == index(DrumClass::tom) || c == index(DrumClass::ride))
            best[c] = std::max(best[c], kAtLeast);
    }
    return best;
}

class Learner {
  public:
    Learner(const std::vector<Lesson>& lessons, const LearningOptions& options,
            const std::function<void(double, const char*)>& progress)
        : lessons_(lessons), options_(options), progress_(progress), dice_(options.seed) {
        for (const Lesson& lesson : lessons) struck_.push_back(targets(lesson));
        contexts_.resize(lessons.size());
    }

    DrumModel learn() {
        DrumModel model;
        const auto learnt = [](std::size_t i) { return i % kHeldOut != 0; };
        model.live = first_network(static_cast<Index>(kLiveFeatures), learnt, 0.0, "live");
        model.live_threshold = thresholds_of(model.live, false);
        model.first = first_network(static_cast<Index>(kFeatures), learnt, 0.25, "first");
        for (const std::size_t half : {0, 1}) {
            const auto of_half = [&](std::size_t i) { return learnt(i) && i % 2 == half; };
            Network other =
                first_network(static_cast<Index>(kFeatures), of_half,
                              0.5 + 0.2 * static_cast<double>(half), "first, by halves");
            find_contexts(other, [&](std::size_t i) { return learnt(i) && i % 2 != half; });
        }
        find_contexts(model.first, [&](std::size_t i) { return !learnt(i); });
        model.second = second_network(learnt);
        model.second_threshold = thresholds_of(model.second, true);
        return model;
    }

  private:
    void tell(double done, const char* what) const {
        if (progress_) progress_(done, what);
    }

    template <class Chosen>
    Network first_network(Index rows, Chosen chosen, double done, const char* what) {
        Collection collection;
        for (std::size_t i = 0; i < lessons_.size(); ++i) {
            if (chosen(i)) collection.add(lessons_[i].evidence.features, struck_[i]);
        }
        // Much is taken away: what is learnt on made-up drums has to hold for real ones.
        const TrainingOptions training{.hidden = {64, 32},
                                       .epochs = options_.epochs,
                                       .dropped = 0.3F,
                                       .dropped_inputs = 0.15F,
                                       .noise = 0.3F};
        return train(collection.examples(rows), training, dice_,
                     [&](double part, double) { tell(done + 0.2 * part, what); });
    }

    template <class Chosen>
    void find_contexts(Network& first, Chosen chosen) {
        for (std::size_t i = 0; i < lessons_.size(); ++i) {
            if (!chosen(i)) continue;
            const Evidence& evidence = lessons_[i].evidence;
            contexts_[i] = context_of(evidence, judge_all(first, evidence.features));
        }
    }

    template <class Chosen>
    Network second_network(Chosen chosen) {
        Collection collection;
        for (std::size_t i = 0; i < lessons_.size(); ++i) {
            if (chosen(i)) collection.add(contexts_[i], struck_[i]);
        }
        const TrainingOptions training{
            .hidden = {48, 24}, .epochs = options_.epochs, .dropped = 0.15F};
        return train(collection.examples(static_cast<Index>(kContext)), training, dice_,
                     [&](double part, double) { tell(0.9 + 0.1 * part, "second"); });
    }

    Odds thresholds_of(Network& network, bool second) {
        Collection collection;
        for (std::size_t i = 0; i < lessons_.size(); i += kHeldOut) {
            collection.add(second ? contexts_[i] : lessons_[i].evidence.features, struck_[i]);
        }
        const Examples held = collection.examples(static_cast<Index>(network.inputs()));
        return best_thresholds(judge_all(network, held.inputs).odds, held.targets);
    }

    const std::vector<Lesson>& lessons_;
    const LearningOptions& options_;
    const std::function<void(double, const char*)>& progress_;
    Dice dice_;
    std::vector<MatrixXf> struck_, contexts_;
};

}  // namespace

Lesson lesson(const PieceOfMusic& piece) {
    return {evidence_of(hear(playback_of(piece.signal), piece.rate)), piece.strokes};
}

DrumModel learn(const std::vector<Lesson>& lessons, const LearningOptions& options,
                const std::function<void(double, const char*)>& progress) {
    if (lessons.size() < 2 * kHeldOut) {
        throw std::invalid_argument("learning: expected at least 20 practice pieces");
    }
    return Learner(lessons, options, progress).learn();
}

}  // namespace percussionist::listening::practice
