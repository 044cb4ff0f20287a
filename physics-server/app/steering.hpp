// How the percussionist plays, with what, and where: commands turned into calls of the player and
// the simulation, and what holds now, to be told.
//
// Simulating thread, between two steps.
#pragma once

#include <string>
#include <vector>

#include "app/performance.hpp"
#include "body/gesture.hpp"
#include "osc/command.hpp"
#include "osc/outgoing.hpp"

namespace percussionist::app {

class Steering {
  public:
    /// `gestures` are those that /nuance knows.
    Steering(Performance& performance, std::vector<body::Gesture> gestures);

    /// False if the command is about something else. Throws std::invalid_argument saying what was
    /// expected, and then nothing has changed.
    bool obey(const osc::Command& command);

    /// True once after something has changed.
    bool take_changed();
    [[nodiscard]] osc::StateMessage state(double wall) const;

  private:
    void set(const osc::Tempo& wish);
    void set(const osc::Rubato& wish);
    void set(const osc::SetGrip& wish);
    void set(const osc::SetNuance& wish);
    void set(const osc::SetHeight& wish);
    void set(const osc::SetPlace& wish);
    void set(const osc::SetLeading& wish);
    void set(const osc::SetHeadHeight& wish);
    void set(const osc::SetMembrane& wish);
    void set(const osc::SetMallet& wish);
    void set(const osc::SetTracking& wish);
    void set(const osc::SetInverse& wish);
    void set(const osc::SetLaw& wish);
    void set(const osc::SetGain& wish);

    Performance& performance_;
    std::vector<body::Gesture> gestures_;
    bool french_ = false, tips_ = true;
    std::string inverse_ = "dls";
    bool changed_ = false;
};

}  // namespace percussionist::app
