// A drummer at a kit as what is told of him: values of body/ and core/ become messages.
//
// Pure functions; times [s] are the caller's.
#pragma once

#include <optional>
#include <vector>

#include "app/performance_log.hpp"
#include "body/live_drummer.hpp"
#include "osc/command.hpp"
#include "osc/outgoing.hpp"

namespace percussionist::app {

/// What the thing that is struck feels is what the body's touch says, else that of an elastic tip
/// on a wall (Hertz), with the event's striker at the speed of the note: force = K a^1.5, a = (5 m
/// v^2 / 4 K)^0.4, 2.94 a / v long.
osc::ContactMessage contact_message(const body::KitContact& contact, const score::Kit& kit);
/// The same for the log, as it is told and as it was asked for; its hand is the limb's side.
LoggedContact logged_contact(const osc::ContactMessage& told, const body::KitContact& contact);

osc::ObjectsMessage objects_message(double time, const body::LiveKit& drummer);
osc::KitMessage kit_message(double time, const score::Kit& kit);

/// The pose that is shown and its joints, if one is.
std::vector<osc::StateMessage::Item> pose_items(const body::LiveDrummer& drummer);
/// None for "off". Throws std::invalid_argument naming what there is not.
std::optional<body::ShownPose> shown_pose(const osc::ShowPose& wish, const score::Kit& kit);

}  // namespace percussionist::app
