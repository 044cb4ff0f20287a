#include "core/listening/evidence.hpp"

#include "core/listening/stroke_features.hpp"

namespace percussionist::listening {

Evidence evidence_of(const Heard& heard) {
    Evidence evidence;
    evidence.features.resize(static_cast<Eigen::Index>(kFeatures),
                             static_cast<Eigen::Index>(heard.attacks.size()));
    for (std::size_t i = 0; i < heard.attacks.size(); ++i) {
        const Attack& attack = heard.attacks[i];
        const double frame = static_cast<double>(attack.frame) + static_cast<double>(attack.within);
        evidence.times.push_back(time_of(frame, heard.hop, heard.rate));
        evidence.strengths.push_back(attack.strength);
        stroke_features(heard.frames, attack.frame, heard.hearing,
                        {evidence.features.col(static_cast<Eigen::Index>(i)).data(), kFeatures});
    }
    return evidence;
}

}  // namespace percussionist::listening
