// What a kit looks like: the shapes of its things, in units of their sizes for the viewer, and in
// metres for files of motion. Nothing is simulated with them.
#pragma once

#include <vector>

#include "core/score/kit.hpp"
#include "files/gltf_file.hpp"

namespace percussionist::app {

/// Each kind of object as kit-KIND (face, body, metal), its radius and depth 1, its face's middle
/// in the origin, the face upwards; kit-rod (upwards, 1 long), kit-pedal (forward, 1 long), and in
/// metres kit-tripod, kit-beater, kit-seat (1 high).
std::vector<files::SceneNode> kit_shapes();

/// A scene's nodes that stand for a kit, and what of them moves.
struct KitNodes {
    std::vector<files::SceneNode> nodes;
    std::vector<std::size_t> faces;    ///< by object: it swings and lifts about its middle
    std::vector<std::size_t> plates;   ///< by pedal: it turns about its heel
    std::vector<std::size_t> beaters;  ///< by pedal: it turns about its pivot; none: plates' own
};
KitNodes kit_nodes(const score::Kit& kit);

/// A pedal's beater: where it turns, how long it is, how far it leans forward when it strikes.
struct Beater {
    linear::Vector3 pivot = linear::Vector3::Zero();  ///< world [m]
    double length = 0.0;                              ///< [m]; 0: the pedal has none
    double lean = 0.0;                                ///< [rad]
};
Beater beater_of(const score::Pedal& pedal, const score::Kit& kit);

}  // namespace percussionist::app
