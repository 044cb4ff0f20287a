// ODE's world and what is in it, owned: destroyed with the object that made it.
//
// One world a simulation, one thread a world. ODE itself is initialised on first use.
#pragma once

#include <ode/ode.h>

#include "core/linear/rotation.hpp"

namespace percussionist::sim {

using linear::Matrix3;
using linear::Quaternion;
using linear::Vector3;

class OdeWorld {
  public:
    OdeWorld();
    ~OdeWorld();
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    [[nodiscard]] dWorldID id() const { return world_; }
    void step(double h) { dWorldStep(world_, h); }

  private:
    dWorldID world_;
};

inline Vector3 vector(const dReal* v) {
    return {v[0], v[1], v[2]};
}
inline Quaternion quaternion(const dReal* q) {
    return {q[0], q[1], q[2], q[3]};
}
inline Quaternion orientation(dBodyID body) {
    return body == nullptr ? Quaternion::Identity() : quaternion(dBodyGetQuaternion(body));
}
inline Vector3 angular_velocity(dBodyID body) {
    return body == nullptr ? Vector3::Zero() : vector(dBodyGetAngularVel(body));
}

}  // namespace percussionist::sim
