#include "robot_bodies.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vfh_astar {
namespace {

constexpr double kGroundErp = 0.2;
constexpr double kGroundCfm = 1e-5;

/// A step that comes this close to a bound is done with bounds.
constexpr double kShareOfBound = 1.0 - 1e-9;

void CopyTo(dReal* to, const Eigen::Vector3d& from) {
  std::copy(from.data(), from.data() + 3, to);
}

}  // namespace

RobotBodies::RobotBodies(dWorldID world, const JackalModel& model)
    : chassis(dBodyCreate(world)),
      world_(world),
      motor_torque_(model.motor_torque) {
  dMass mass;
  // Moments of inertia of Clearpath's description.
  dMassSetParameters(&mass, model.chassis_mass, 0.0, 0.0, 0.0, 0.3136, 0.3922,
                     0.4485, 0.0, 0.0, 0.0);
  dBodySetMass(chassis, &mass);
  for (std::size_t i = 0; i < 4; ++i) {
    wheels[i] = dBodyCreate(world);
    constexpr int kAlongY = 2;
    dMassSetCylinderTotal(&mass, model.wheel_mass, kAlongY, model.wheel_radius,
                          model.wheel_width);
    dBodySetMass(wheels[i], &mass);
    axles[i] = dJointCreateHinge(world, nullptr);
    dJointSetHingeParam(axles[i], dParamFMax, motor_torque_);
    dJointSetFeedback(axles[i], &axle_feedback_[i]);
  }
}

RobotBodies::~RobotBodies() {
  for (const dJointID axle : axles) dJointDestroy(axle);
  for (const dBodyID wheel : wheels) dBodyDestroy(wheel);
  dBodyDestroy(chassis);
}

void RobotBodies::HoldGround(dJointGroupID group, bool bounded) {
  if (bounded != motors_bounded_) {
    motors_bounded_ = bounded;
    for (const dJointID axle : axles) {
      dJointSetHingeParam(axle, dParamFMax,
                          bounded ? motor_torque_ : dInfinity);
    }
  }
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    holds_[wheel].joints = 0;
    if (!tyres[wheel]) continue;
    if (bounded) {
      HoldByContact(wheel, group);
    } else {
      HoldByBars(wheel, group);
    }
  }
}

void RobotBodies::HoldByContact(std::size_t wheel, dJointGroupID group) {
  const TyreContact& tyre = *tyres[wheel];
  dContact contact;
  std::memset(&contact, 0, sizeof(contact));
  CopyTo(contact.geom.pos, tyre.point);
  contact.geom.normal[2] = 1.0;
  contact.geom.depth = tyre.depth;
  CopyTo(contact.fdir1, tyre.directions[0]);
  contact.surface.mode = dContactMu2 | dContactFDir1 | dContactSlip1 |
                         dContactSlip2 | dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = tyre.most_force[0];
  contact.surface.mu2 = tyre.most_force[1];
  contact.surface.slip1 = 1.0 / tyre.slip_stiffness;
  contact.surface.slip2 = 1.0 / tyre.slip_stiffness;
  contact.surface.soft_erp = kGroundErp;
  contact.surface.soft_cfm = kGroundCfm;
  const dJointID joint = dJointCreateContact(world_, group, &contact);
  dJointAttach(joint, wheels[wheel], nullptr);
  Hold& hold = holds_[wheel];
  dJointSetFeedback(joint, &hold.feedback[hold.joints++]);
}

void RobotBodies::HoldByBars(std::size_t wheel, dJointGroupID group) {
  const TyreContact& tyre = *tyres[wheel];
  Hold& hold = holds_[wheel];
  // ODE has no contact without bounds. A bar that ends in the ground 1 m away
  // acts along one direction just as a contact does.
  const auto add = [&](const Eigen::Vector3d& direction, double erp,
                       double cfm) {
    const dJointID bar = dJointCreateDBall(world_, group);
    dJointAttach(bar, wheels[wheel], nullptr);
    const Eigen::Vector3d end = tyre.point - direction;
    dJointSetDBallAnchor1(bar, tyre.point.x(), tyre.point.y(), tyre.point.z());
    dJointSetDBallAnchor2(bar, end.x(), end.y(), end.z());
    dJointSetDBallParam(bar, dParamERP, erp);
    dJointSetDBallParam(bar, dParamCFM, cfm);
    dJointSetFeedback(bar, &hold.feedback[hold.joints++]);
    return bar;
  };
  dJointSetDBallDistance(add(Eigen::Vector3d::UnitZ(), kGroundErp, kGroundCfm),
                         1.0 + tyre.depth);
  for (const Eigen::Vector3d& direction : tyre.directions) {
    add(direction, 0.0, 1.0 / tyre.slip_stiffness);
  }
}

bool RobotBodies::IsWithinBounds() const {
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    // The axle's bearing turns nothing about the axle; what does is the motor.
    const dReal* torque = axle_feedback_[wheel].t2;
    dVector3 axis;
    dJointGetHingeAxis(axles[wheel], axis);
    if (std::abs(dCalcVectorDot3(torque, axis)) >
        kShareOfBound * motor_torque_) {
      return false;
    }
    const Hold& hold = holds_[wheel];
    if (hold.joints == 0) continue;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (int i = 0; i < hold.joints; ++i) {
      force += Eigen::Map<const Eigen::Vector3d>(hold.feedback[i].f1);
    }
    if (force.z() <= 0.0) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      if (std::abs(force.dot(tyres[wheel]->directions[i])) >
          kShareOfBound * tyres[wheel]->most_force[i]) {
        return false;
      }
    }
  }
  return true;
}

void RobotBodies::ForgetContacts() {
  touches_something = false;
  for (std::optional<TyreContact>& tyre : tyres) tyre.reset();
}

template <typename Visit>
void RobotBodies::ForEachBody(const Visit& visit) {
  visit(chassis, &saved_[4]);
  for (std::size_t i = 0; i < 4; ++i) visit(wheels[i], &saved_[i]);
}

void RobotBodies::Save() {
  ForEachBody([](dBodyID body, State* state) {
    std::copy_n(dBodyGetPosition(body), 3, state->position.begin());
    std::copy_n(dBodyGetQuaternion(body), 4, state->turn.begin());
    std::copy_n(dBodyGetLinearVel(body), 3, state->velocity.begin());
    std::copy_n(dBodyGetAngularVel(body), 3, state->turn_rate.begin());
  });
}

void RobotBodies::Restore() {
  ForEachBody([](dBodyID body, State* state) {
    const auto& [position, velocity, turn_rate, turn] = *state;
    dBodySetPosition(body, position[0], position[1], position[2]);
    dBodySetQuaternion(body, turn.data());
    dBodySetLinearVel(body, velocity[0], velocity[1], velocity[2]);
    dBodySetAngularVel(body, turn_rate[0], turn_rate[1], turn_rate[2]);
  });
}

void RobotBodies::SetEnabled(bool enabled) {
  ForEachBody([enabled](dBodyID body, State*) {
    if (enabled) {
      dBodyEnable(body);
    } else {
      dBodyDisable(body);
    }
  });
}

}  // namespace vfh_astar
