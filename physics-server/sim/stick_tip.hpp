// A stick's tip as a face sees it: where it is in the face's frame, how fast, how heavy, and what
// else moves it.
//
// Once a step: look(), then against() for each face that it may meet, then struck() with what these
// gave it. No allocation after construction; deterministic; one thread.
#pragma once

#include "body/inverse_dynamics.hpp"
#include "sim/drumhead.hpp"
#include "sim/ode_body.hpp"

namespace percussionist::sim {

/// What is struck, at the beginning of a step, world.
struct Face {
    Vector3 middle = Vector3::Zero();          ///< [m]
    Quaternion turn = Quaternion::Identity();  ///< its z is out of the face
    Vector3 velocity = Vector3::Zero();        ///< of its middle [m/s]
    Vector3 spin = Vector3::Zero();            ///< [rad/s]
    [[nodiscard]] Vector3 normal() const { return turn * Vector3::UnitZ(); }
};

class StickTip {
  public:
    StickTip(const body::Skeleton& skeleton, body::Hand hand);

    /// Takes the tip from where the body is now.
    void look(const OdeBody& body);
    /// Against a face; what costs time, masses, only if the tip is near `head`. `resistance` is the
    /// Controller's, h [s] the step.
    TouchingTip against(const Face& face, const Drumhead& head, const body::Placement& actual,
                        const std::vector<double>& resistance, double h);
    /// What all faces gave it in this step, world [N s].
    void struck(const Vector3& impulse) { impulse_ = impulse; }
    /// Of body and stick alone, along a unit normal [kg].
    double bare_mass(const body::Placement& actual, const Vector3& normal) {
        return mass_(actual, normal, bare_);
    }
    [[nodiscard]] const Vector3& position() const { return position_; }  ///< of its middle [m]
    [[nodiscard]] const Vector3& velocity() const { return velocity_; }  ///< [m/s]

  private:
    body::Hand hand_;
    double radius_;
    body::TipMass mass_;
    std::vector<double> bare_;  ///< no resistance: the mass of the body alone
    Vector3 position_ = Vector3::Zero(), velocity_ = Vector3::Zero(), before_ = Vector3::Zero();
    Vector3 impulse_ = Vector3::Zero();
};

}  // namespace percussionist::sim
