#include "app/kit_gltf.hpp"

#include "app/figure.hpp"

namespace percussionist::app {

namespace {

using linear::Quaternion;
using linear::Vector3;

/// He who stands: the same parts, for what they look like.
body::Skeleton standing(const score::Drummer& drummer) {
    body::Anthropometry person;
    person.stature = drummer.stature;
    person.mass = drummer.mass;
    person.stick.length = drummer.stick_length;
    person.stick.held_at = drummer.stick_held;
    return body::make_skeleton(person);
}

}  // namespace

KitGltf::KitGltf(const body::Skeleton& skeleton, const score::Kit& kit)
    : skeleton_(skeleton), kit_(kit), kit_nodes_(kit_nodes(kit)) {
    scene_.nodes = figure_nodes(standing(kit.drummer));
    scene_.nodes.insert(scene_.nodes.end(), kit_nodes_.nodes.begin(), kit_nodes_.nodes.end());
    scene_.turning = scene_.nodes.size();
}

Quaternion KitGltf::turn_of(std::size_t node, const std::vector<body::ObjectState>& states) const {
    for (std::size_t o = 0; o < states.size(); ++o) {
        if (kit_nodes_.faces[o] == node) return linear::quaternion_exp(states[o].turn);
    }
    for (std::size_t p = 0; p < kit_.pedals.size(); ++p) {
        const score::Pedal& pedal = kit_.pedals[p];
        const body::ObjectState& state = states[pedal.object];
        if (kit_nodes_.plates[p] == node) {
            const double angle = pedal.down + state.pedal * (pedal.up - pedal.down);
            return body::from_euler_zyx({pedal.direction, -angle, 0.0});
        }
        if (kit_nodes_.beaters[p] == node) {
            const double lean = beater_of(pedal, kit_).lean - state.beater;
            return body::from_euler_zyx({pedal.direction, lean, 0.0});
        }
    }
    return Quaternion::Identity();
}

void KitGltf::add(double time, const body::Placement& placement,
                  const std::vector<body::ObjectState>& states) {
    scene_.times.push_back(time);
    scene_.moved.push_back(placement.joint[0].cast<float>());
    for (int i = 0; i < skeleton_.size(); ++i) {
        const int parent = skeleton_.segments[i].parent;
        const Quaternion& own = placement.orientation[i];
        const Quaternion turn = parent < 0 ? own : placement.orientation[parent].conjugate() * own;
        scene_.rotations.push_back(turn.cast<float>());
    }
    for (std::size_t node = 0; node < kit_nodes_.nodes.size(); ++node) {
        scene_.rotations.push_back(turn_of(node, states).cast<float>());
    }
    const auto first = static_cast<std::size_t>(skeleton_.size());
    for (std::size_t o = 0; o < states.size(); ++o) {
        if (kit_.objects[o].kind != score::ObjectKind::hi_hat) continue;
        const Vector3 at = kit_.objects[o].middle + states[o].lift * Vector3::UnitZ();
        scene_.shifted[first + kit_nodes_.faces[o]].push_back(at.cast<float>());
    }
}

}  // namespace percussionist::app
