#ifndef VFH_ASTAR_SIMULATION_ROBOT_BODIES_H_
#define VFH_ASTAR_SIMULATION_ROBOT_BODIES_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "vfh_astar/simulation/jackal.h"

namespace vfh_astar {

constexpr double kGravity = 9.81;  ///< m/s^2

/// Where a tyre stands in the step to come, and how it may hold on.
struct TyreContact {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< m
  double depth = 0.0;                               ///< m, into the ground.
  /// Unit vectors in the ground's plane, along the wheel and across.
  std::array<Eigen::Vector3d, 2> directions;
  std::array<double, 2> most_force{};  ///< N in either direction.
  double slip_stiffness = 0.0;         ///< N s/m
};

/// A robot's part in the rigid-body world.
class RobotBodies {
 public:
  RobotBodies(dWorldID world, const JackalModel& model);
  ~RobotBodies();
  RobotBodies(const RobotBodies&) = delete;
  RobotBodies& operator=(const RobotBodies&) = delete;

  /// Joins the tyres to the ground for one step. Without bounds they would also
  /// pull and hold more than they can; then see IsWithinBounds.
  void HoldGround(dJointGroupID group, bool bounded);

  /// Whether the last step asked of tyres and motors no more than they can
  /// give, so that it would be the same with and without bounds.
  bool IsWithinBounds() const;

  /// Touches nothing any more, not even the ground.
  void ForgetContacts();

  void Save();
  void Restore();
  void SetEnabled(bool enabled);

  dBodyID chassis;
  std::array<dBodyID, 4> wheels;
  std::array<dJointID, 4> axles;
  std::array<std::optional<TyreContact>, 4> tyres;  ///< by wheel.
  bool touches_something = false;  ///< besides the ground, in the step to come.
  bool may_be_unbounded = true;    ///< by what the step before was like.
  bool must_repeat = false;        ///< the step, with bounds.

 private:
  struct State {
    std::array<dReal, 3> position, velocity, turn_rate;
    std::array<dReal, 4> turn;
  };
  /// The up to three joints of a tyre with the ground.
  struct Hold {
    std::array<dJointFeedback, 3> feedback;
    int joints = 0;
  };

  void HoldByContact(std::size_t wheel, dJointGroupID group);
  void HoldByBars(std::size_t wheel, dJointGroupID group);
  template <typename Visit>
  void ForEachBody(const Visit& visit);

  dWorldID world_;
  double motor_torque_;
  bool motors_bounded_ = true;
  std::array<Hold, 4> holds_;
  std::array<dJointFeedback, 4> axle_feedback_;
  std::array<State, 5> saved_;
};

/// What PhysicsWorld is made of.
struct PhysicsWorld::Handles {
  dWorldID world = dWorldCreate();
  dJointGroupID contacts = dJointGroupCreate(0);
  std::vector<RobotBodies*> robots;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_ROBOT_BODIES_H_
