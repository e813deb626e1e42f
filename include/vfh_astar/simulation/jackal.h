#ifndef VFH_ASTAR_SIMULATION_JACKAL_H_
#define VFH_ASTAR_SIMULATION_JACKAL_H_

#include <array>
#include <memory>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/simulation/shape.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

/// A Clearpath Jackal's measures, from its description and controller.
struct JackalModel {
  double wheelbase = 0.262;                ///< m, between the axles.
  double track = 0.37559;                  ///< m, between the wheels' middles.
  double wheel_radius = 0.098;             ///< m
  double wheel_width = 0.040;              ///< m
  double chassis_mass = 16.523;            ///< kg
  double wheel_mass = 0.477;               ///< kg
  double max_v = 2.0;                      ///< m/s
  double max_acceleration = 20.0;          ///< m/s^2
  double max_w = 4.0;                      ///< rad/s
  double max_angular_acceleration = 25.0;  ///< rad/s^2
  /// By how much farther apart the wheels of a skid-steered robot seem to be.
  double wheel_separation_multiplier = 1.5;
  double motor_torque = 20.0;  ///< N m per wheel.
  /// Of the tyres on the ground: enough for them to creep and not to slide
  /// whatever v and w are commanded, as the multiplier takes for granted.
  double friction = 3.0;
  /// N s/m per wheel: the tyre's force grows with slip until friction caps it.
  double tyre_slip_stiffness = 200.0;
  Footprint footprint;

  double HalfSeparation() const {
    return 0.5 * track * wheel_separation_multiplier;
  }
};

/// The rigid-body world that robots stand in: a level floor under gravity.
/// Obstacles are not bodies; what a robot touches is handed to it.
///
/// Most of the time nothing slides or lifts off. Then bounds on forces (the
/// ground only pushes, friction and motors have limits) change nothing, but
/// finding that out costs the solver more than all the rest of a step. So a
/// step is taken without bounds where nothing but the ground is touched and the
/// step before kept within them, and repeated with them if its forces do not.
class PhysicsWorld {
 public:
  enum class Bounds { kWhereTheyMatter, kAlways };

  /// @param[in] bounds kAlways for the same motion, but for rounding, in more
  ///   time.
  explicit PhysicsWorld(Bounds bounds = Bounds::kWhereTheyMatter);
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  /// Moves all bodies on by `duration` seconds and forgets the contacts.
  void Step(double duration);

 private:
  friend class Jackal;
  struct Handles;

  void Repeat(double duration);

  Bounds bounds_;
  std::unique_ptr<Handles> handles_;
};

class RobotBodies;

/// A Jackal as five bodies: a chassis and four driven wheels. It turns by
/// skidding: the wheels of each side turn alike.
///
/// The tyres' force is viscous in the slip, the same in all directions, and
/// capped by friction. Then a turn on the spot settles where
///   w = w_wheels b^2 / (a^2 + b^2),
/// a and b half of wheelbase and track: 1.487 of the track for a Jackal, which
/// is why its controller takes 1.5.
class Jackal {
 public:
  /// @param[in] world must outlive the robot.
  Jackal(PhysicsWorld* world, const JackalModel& model, const Pose2D& pose);
  ~Jackal();
  Jackal(Jackal&&) noexcept;

  /// Stands at `pose`, at rest.
  void Place(const Pose2D& pose);

  /// One step of the wheel controller: the command, within the robot's limits,
  /// becomes the motors' speeds.
  void Control(const Twist2D& command, double duration);

  /// Puts the tyres on the ground for the step to come.
  /// @param[in] patches where the ground is not what the model says.
  void TouchGround(const std::vector<GroundPatch>& patches = {});

  /// Touches something solid in the step to come.
  void Touch(const ContactPoint& contact);

  /// Touches another robot in the step to come; the normal points from it to
  /// this one.
  void Touch(const ContactPoint& contact, Jackal* other);

  Pose2D pose() const;               ///< of base_link in the world.
  Twist2D twist() const;             ///< of the chassis in its own frame.
  Eigen::Vector2d velocity() const;  ///< m/s, in the world.

  /// rad since the start: front left, rear left, front right, rear right.
  const std::array<double, 4>& wheel_angles() const { return wheel_angles_; }
  /// rad/s
  std::array<double, 4> wheel_rates() const;

  /// The footprint where the robot is.
  Shape Outline() const;

  /// Notes how far the wheels have turned. Call after each step.
  void CountWheelTurns(double duration);

  const JackalModel& model() const { return model_; }

 private:
  PhysicsWorld* world_;
  JackalModel model_;
  std::unique_ptr<RobotBodies> bodies_;
  Twist2D command_;
  std::array<double, 4> wheel_angles_{};
};

/// The footprint at a pose.
Shape OutlineOf(const Footprint& footprint, const Pose2D& pose);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_JACKAL_H_
