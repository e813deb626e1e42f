#include <ode/ode.h>

#include "robot_bodies.h"
#include "vfh_astar/simulation/jackal.h"

namespace vfh_astar {
namespace {

/// ODE wants to be initialised once in a process, and by each thread.
void InitializeOde() {
  static const bool initialized = dInitODE2(0) != 0;
  static_cast<void>(initialized);
  dAllocateODEDataForThread(dAllocateMaskAll);
}

}  // namespace

PhysicsWorld::PhysicsWorld(Bounds bounds) : bounds_(bounds) {
  InitializeOde();
  handles_ = std::make_unique<Handles>();
  dWorldSetGravity(handles_->world, 0.0, 0.0, -kGravity);
  dWorldSetERP(handles_->world, 0.2);
  dWorldSetCFM(handles_->world, 1e-6);
}

PhysicsWorld::~PhysicsWorld() {
  dJointGroupDestroy(handles_->contacts);
  dWorldDestroy(handles_->world);
}

void PhysicsWorld::Step(double duration) {
  for (RobotBodies* robot : handles_->robots) {
    const bool bounded = bounds_ == Bounds::kAlways ||
                         robot->touches_something || !robot->may_be_unbounded;
    robot->may_be_unbounded = !bounded;
    if (!bounded) robot->Save();
    robot->HoldGround(handles_->contacts, bounded);
  }
  dWorldStep(handles_->world, duration);
  dJointGroupEmpty(handles_->contacts);

  bool all_done = true;
  for (RobotBodies* robot : handles_->robots) {
    const bool was_bounded = !robot->may_be_unbounded;
    robot->may_be_unbounded = robot->IsWithinBounds();
    robot->must_repeat = !was_bounded && !robot->may_be_unbounded;
    all_done = all_done && !robot->must_repeat;
  }
  if (!all_done) Repeat(duration);
  for (RobotBodies* robot : handles_->robots) robot->ForgetContacts();
}

void PhysicsWorld::Repeat(double duration) {
  for (RobotBodies* robot : handles_->robots) {
    if (robot->must_repeat) {
      robot->Restore();
      robot->HoldGround(handles_->contacts, true);
    } else {
      robot->SetEnabled(false);
    }
  }
  dWorldStep(handles_->world, duration);
  dJointGroupEmpty(handles_->contacts);
  for (RobotBodies* robot : handles_->robots) robot->SetEnabled(true);
}

}  // namespace vfh_astar
