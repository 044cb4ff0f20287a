#include "core/listening/transcription.hpp"

#include <algorithm>
#include <cmath>

#include "core/listening/context.hpp"
#include "core/listening/judgement.hpp"
#include "core/listening/stroke_strength.hpp"

namespace percussionist::listening {

namespace {

constexpr double kShareOfHearing = 0.9;    ///< of the time it takes
constexpr double kEcho = 0.04;             ///< one drum is not struck twice within [s]
constexpr double kTogether = 0.03;         ///< two strokes within are one moment [s]
constexpr std::size_t kEnough = 8;         ///< strokes to judge a time keeper by
constexpr double kAloneAtLeast = 0.05;     ///< of them with neither kick, snare nor tom
constexpr double kSure = 0.85;             ///< confidence
constexpr double kSurest = 0.92;           ///< confidence asked for where next to nothing is a drum
constexpr double kGoodPart = 0.75;         ///< of all confidences is below what is called sure
constexpr double kUsualConfidence = 0.78;  ///< of what is none, taken for a drum
constexpr double kCountsFor = 2.0;         ///< a higher confidence, against a share of attacks
constexpr double kUsualVelocity = 0.75;
constexpr double kLoudPart = 0.8;  ///< of a drum's strokes are softer than a loud one

bool same_drum(DrumClass a, DrumClass b) {
    const auto hat = [](DrumClass d) {
        return d == DrumClass::open_hat ? DrumClass::closed_hat : d;
    };
    return hat(a) == hat(b);
}

/// Of two strokes of one drum too close for hands, the surer one.
void leave_out_echoes(std::vector<DrumStroke>& strokes) {
    std::vector<DrumStroke> kept;
    for (const DrumStroke& stroke : strokes) {
        const auto earlier = std::find_if(kept.rbegin(), kept.rend(), [&](const DrumStroke& k) {
            return same_drum(k.drum, stroke.drum) && stroke.time - k.time < kEcho;
        });
        if (earlier == kept.rend()) {
            kept.push_back(stroke);
        } else if (stroke.confidence > earlier->confidence) {
            *earlier = stroke;
        }
    }
    std::stable_sort(kept.begin(), kept.end(),
                     [](const DrumStroke& a, const DrumStroke& b) { return a.time < b.time; });
    strokes = std::move(kept);
}

double quantile(std::vector<double> values, double part) {
    if (values.empty()) return 0.0;
    const auto nth =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

/// From logarithms of power to velocities, each drum against its own loud strokes.
void powers_to_velocities(std::vector<DrumStroke>& strokes) {
    for (std::size_t c = 0; c < kDrumClasses; ++c) {
        std::vector<double> powers;
        for (const DrumStroke& s : strokes) {
            if (index(s.drum) == c) powers.push_back(s.velocity);
        }
        const double loud = quantile(powers, kLoudPart);
        for (DrumStroke& s : strokes) {
            if (index(s.drum) == c)
                s.velocity = velocity_of(static_cast<float>(s.velocity), static_cast<float>(loud));
        }
    }
}

/// Where somebody drums, many of the attacks are drums, or a good part of them surely so. The less
/// that holds, the more likely are the few a voice's hisses and a guitar's picks that happen to
/// sound like one, and the surer each has to be.
void doubt_the_few(std::size_t attacks, std::vector<DrumStroke>& strokes) {
    double moments = 0.0;
    double last = -1.0;
    std::vector<double> confidences;
    for (const DrumStroke& stroke : strokes) {
        if (stroke.time > last + kTogether) ++moments;
        last = stroke.time;
        confidences.push_back(stroke.confidence);
    }
    const double share = moments / static_cast<double>(std::max<std::size_t>(attacks, 1));
    const double sure = std::max(0.0, quantile(confidences, kGoodPart) - kUsualConfidence);
    const double asked = kSurest - share - kCountsFor * sure;
    std::erase_if(strokes, [&](const DrumStroke& s) { return s.confidence < asked; });
}

/// Who keeps time on a hat or a ride strikes it between the other drums too. One that is only ever
/// heard with them is most likely their own brightness: only where it is sure does it stay.
void doubt_time_keepers(DrumClass keeper, std::vector<DrumStroke>& strokes) {
    const auto is_skin = [](DrumClass d) {
        return d == DrumClass::kick || d == DrumClass::snare || d == DrumClass::tom;
    };
    const auto alone = [&](const DrumStroke& stroke) {
        return std::none_of(strokes.begin(), strokes.end(), [&](const DrumStroke& other) {
            return is_skin(other.drum) && std::abs(other.time - stroke.time) < kTogether;
        });
    };
    std::size_t all = 0, by_themselves = 0;
    for (const DrumStroke& stroke : strokes) {
        if (!same_drum(stroke.drum, keeper)) continue;
        ++all;
        by_themselves += alone(stroke) ? 1 : 0;
    }
    if (all < kEnough ||
        static_cast<double>(by_themselves) >= kAloneAtLeast * static_cast<double>(all)) {
        return;
    }
    std::erase_if(strokes, [&](const DrumStroke& s) {
        return same_drum(s.drum, keeper) && s.confidence < kSure;
    });
}

/// Where a louder drum of the same moment fills the bands of a softer one, that one's power cannot
/// be told: it is taken for usual.
void cover_what_is_drowned(std::vector<DrumStroke>& strokes) {
    const auto drowns = [](DrumClass d) { return d == DrumClass::snare || d == DrumClass::crash; };
    const auto drowned = [](DrumClass d) {
        return d == DrumClass::closed_hat || d == DrumClass::open_hat || d == DrumClass::ride;
    };
    for (DrumStroke& soft : strokes) {
        if (!drowned(soft.drum)) continue;
        for (const DrumStroke& loud : strokes) {
            if (drowns(loud.drum) && std::abs(loud.time - soft.time) < kTogether) {
                soft.velocity = std::min(soft.velocity, kUsualVelocity);
            }
        }
    }
}

}  // namespace

Transcription transcribe(std::span<const double> signal, double rate, const DrumModel& model,
                         const std::function<void(double)>& progress) {
    return transcribe(playback_of(signal), rate, model, progress);
}

Transcription transcribe(const Playback& playback, double rate, const DrumModel& model,
                         const std::function<void(double)>& progress) {
    const auto hearing = [&](double done) {
        if (progress) progress(kShareOfHearing * done);
    };
    Transcription made{.heard = hear(playback, rate, hearing), .strokes = {}};
    const Evidence evidence = evidence_of(made.heard);
    DrumModel judge = model;
    const Judgement first = judge_all(judge.first, evidence.features);
    const Judgement second = judge_all(judge.second, context_of(evidence, first));
    for (std::size_t i = 0; i < evidence.times.size(); ++i) {
        Odds odds{};
        for (std::size_t c = 0; c < kDrumClasses; ++c) {
            odds[c] = second.odds(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(i)) -
                      model.second_threshold[c];
        }
        const std::size_t frame = made.heard.attacks[i].frame;
        for (const Verdict& verdict : verdicts(odds)) {
            made.strokes.push_back({.time = evidence.times[i],
                                    .drum = verdict.drum,
                                    .velocity = added_power(made.heard.frames, frame, verdict.drum),
                                    .confidence = verdict.confidence,
                                    .pitch = verdict.drum == DrumClass::tom
                                                 ? pitch_of(made.heard.frames, frame)
                                                 : 0.0});
        }
    }
    leave_out_echoes(made.strokes);
    doubt_the_few(evidence.times.size(), made.strokes);
    doubt_time_keepers(DrumClass::closed_hat, made.strokes);
    doubt_time_keepers(DrumClass::ride, made.strokes);
    powers_to_velocities(made.strokes);
    cover_what_is_drowned(made.strokes);
    if (progress) progress(1.0);
    return made;
}

}  // namespace percussionist::listening
