#include "sim/ode_world.hpp"

#include <stdexcept>

namespace percussionist::sim {

namespace {

/// ODE wants its global state made before the first world; it lives as long as the program.
void initialise_ode() {
    static const int made = dInitODE2(0);
    if (made == 0) throw std::runtime_error("ODE could not be initialised");
    dAllocateODEDataForThread(dAllocateMaskAll);
}

}  // namespace

OdeWorld::OdeWorld() {
    initialise_ode();
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0.0, 0.0, -9.81);
    // Joint anchors are held by ERP; the tiny CFM keeps the constraint matrix regular and is far
    // below anything that moves.
    dWorldSetERP(world_, 0.2);
    dWorldSetCFM(world_, 1e-10);
}

OdeWorld::~OdeWorld() {
    dWorldDestroy(world_);
}

}  // namespace percussionist::sim
