#include "vfh_astar/simulation/jackal.h"

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "robot_bodies.h"

namespace vfh_astar {
namespace {

constexpr double kChassisHeight = 0.0325;  ///< m of its middle above the axles.

/// N with which a touched obstacle holds the chassis back along its face. A
/// constant: ODE's solver complains of friction that depends on the pressure
/// when the pressure is nothing.
constexpr double kBumperFriction = 50.0;

/// m/s of slip below which a tyre's force has no direction to speak of.
constexpr double kNoSlip = 1e-6;

/// The share of a tyre's greatest force that one direction may have. Never
/// nothing: ODE's solver fails on a contact without any friction.
double ShareOfSlip(double component, double speed) {
  constexpr double kLeastShare = 0.02;
  if (speed < kNoSlip) return 1.0;
  return std::max(kLeastShare, std::abs(component) / speed);
}

/// What a tyre has to hold on to.
struct Grip {
  double friction;
  double slip_stiffness;  // N s/m
};

Grip FindGrip(const std::vector<GroundPatch>& patches,
              const Eigen::Vector2d& place, const JackalModel& model) {
  for (const GroundPatch& patch : patches) {
    for (const Shape& shape : patch.shapes) {
      if (Contains(shape, place)) {
        return {patch.friction, patch.tyre_slip_stiffness};
      }
    }
  }
  return {model.friction, model.tyre_slip_stiffness};
}

}  // namespace

Jackal::Jackal(PhysicsWorld* world, const JackalModel& model,
               const Pose2D& pose)
    : world_(world),
      model_(model),
      bodies_(std::make_unique<RobotBodies>(world->handles_->world, model)) {
  world_->handles_->robots.push_back(bodies_.get());
  Place(pose);
}

Jackal::~Jackal() {
  if (bodies_ == nullptr) return;
  std::vector<RobotBodies*>& robots = world_->handles_->robots;
  robots.erase(std::find(robots.begin(), robots.end(), bodies_.get()));
}

Jackal::Jackal(Jackal&&) noexcept = default;

void Jackal::Place(const Pose2D& pose) {
  dQuaternion turn = {std::cos(0.5 * pose.theta), 0.0, 0.0,
                      std::sin(0.5 * pose.theta)};
  const auto put = [&turn](dBodyID body, const Eigen::Vector2d& at, double z) {
    dBodySetPosition(body, at.x(), at.y(), z);
    dBodySetQuaternion(body, turn);
    dBodySetLinearVel(body, 0.0, 0.0, 0.0);
    dBodySetAngularVel(body, 0.0, 0.0, 0.0);
  };
  put(bodies_->chassis, pose.position(), model_.wheel_radius + kChassisHeight);
  const Eigen::Vector2d left =
      Pose2D(0.0, 0.0, pose.theta) * Eigen::Vector2d(0.0, 1.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d axle((i % 2 == 0 ? 0.5 : -0.5) * model_.wheelbase,
                               (i < 2 ? 0.5 : -0.5) * model_.track);
    const Eigen::Vector2d at = pose * axle;
    put(bodies_->wheels[i], at, model_.wheel_radius);
    const dJointID joint = bodies_->axles[i];
    dJointAttach(joint, bodies_->chassis, bodies_->wheels[i]);
    dJointSetHingeAnchor(joint, at.x(), at.y(), model_.wheel_radius);
    dJointSetHingeAxis(joint, -left.x(), -left.y(), 0.0);
    dJointSetHingeParam(joint, dParamVel, 0.0);
  }
  command_ = Twist2D();
}

void Jackal::Control(const Twist2D& command, double duration) {
  const auto approach = [](double from, double to, double step) {
    return std::clamp(to, from - step, from + step);
  };
  command_.v =
      approach(command_.v, std::clamp(command.v, -model_.max_v, model_.max_v),
               model_.max_acceleration * duration);
  command_.w =
      approach(command_.w, std::clamp(command.w, -model_.max_w, model_.max_w),
               model_.max_angular_acceleration * duration);
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = i < 2 ? -1.0 : 1.0;
    const double speed =
        command_.v + side * command_.w * model_.HalfSeparation();
    dJointSetHingeParam(bodies_->axles[i], dParamVel,
                        speed / model_.wheel_radius);
  }
}

void Jackal::TouchGround(const std::vector<GroundPatch>& patches) {
  const dReal* rotation = dBodyGetRotation(bodies_->chassis);
  // The axles' direction, in the plane and in full.
  const double ax = rotation[1], ay = rotation[5], az = rotation[9];
  const double in_plane = std::hypot(ax, ay);
  const double load =
      0.25 * (model_.chassis_mass + 4.0 * model_.wheel_mass) * kGravity;
  const Eigen::Vector3d along(ay / in_plane, -ax / in_plane, 0.0);
  const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
  const double scale = model_.wheel_radius / in_plane;
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    bodies_->tyres[wheel].reset();
    // The lowest point of the wheel's rim: from its middle, straight down as
    // far as the wheel's plane allows.
    const dReal* middle = dBodyGetPosition(bodies_->wheels[wheel]);
    TyreContact tyre;
    tyre.point = {middle[0] + scale * az * ax, middle[1] + scale * az * ay,
                  middle[2] - scale * (1.0 - az * az)};
    tyre.depth = -tyre.point.z();
    if (tyre.depth < 0.0) continue;
    tyre.directions = {along, across};

    dVector3 slip;
    dBodyGetPointVel(bodies_->wheels[wheel], tyre.point.x(), tyre.point.y(),
                     tyre.point.z(), slip);
    const double slip_along = slip[0] * along.x() + slip[1] * along.y();
    const double slip_across = slip[0] * across.x() + slip[1] * across.y();
    const double speed = std::hypot(slip_along, slip_across);
    // ODE caps the two directions one by one; sharing the cap by the slip's
    // direction makes of the box the circle that friction is.
    const Grip grip = FindGrip(patches, tyre.point.head<2>(), model_);
    const double cap = grip.friction * load;
    tyre.most_force = {cap * ShareOfSlip(slip_along, speed),
                       cap * ShareOfSlip(slip_across, speed)};
    tyre.slip_stiffness = grip.slip_stiffness;
    bodies_->tyres[wheel] = tyre;
  }
}

void Jackal::Touch(const ContactPoint& touched) { Touch(touched, nullptr); }

void Jackal::Touch(const ContactPoint& touched, Jackal* other) {
  dContact contact;
  std::memset(&contact, 0, sizeof(contact));
  contact.geom.pos[0] = touched.point.x();
  contact.geom.pos[1] = touched.point.y();
  contact.geom.pos[2] = model_.wheel_radius + kChassisHeight;
  contact.geom.normal[0] = touched.normal.x();
  contact.geom.normal[1] = touched.normal.y();
  contact.geom.depth = touched.depth;
  contact.surface.mode = dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = kBumperFriction;
  contact.surface.soft_erp = 0.2;
  contact.surface.soft_cfm = 1e-5;
  dJointAttach(dJointCreateContact(world_->handles_->world,
                                   world_->handles_->contacts, &contact),
               bodies_->chassis,
               other == nullptr ? nullptr : other->bodies_->chassis);
  bodies_->touches_something = true;
  if (other != nullptr) other->bodies_->touches_something = true;
}

Pose2D Jackal::pose() const {
  const dReal* position = dBodyGetPosition(bodies_->chassis);
  const dReal* rotation = dBodyGetRotation(bodies_->chassis);
  return {position[0], position[1], std::atan2(rotation[4], rotation[0])};
}

Eigen::Vector2d Jackal::velocity() const {
  const dReal* velocity = dBodyGetLinearVel(bodies_->chassis);
  return {velocity[0], velocity[1]};
}

Twist2D Jackal::twist() const {
  return {velocity().dot(pose().heading()),
          dBodyGetAngularVel(bodies_->chassis)[2]};
}

std::array<double, 4> Jackal::wheel_rates() const {
  std::array<double, 4> rates;
  for (std::size_t i = 0; i < 4; ++i) {
    rates[i] = dJointGetHingeAngleRate(bodies_->axles[i]);
  }
  return rates;
}

void Jackal::CountWheelTurns(double duration) {
  const std::array<double, 4> rates = wheel_rates();
  for (std::size_t i = 0; i < 4; ++i) wheel_angles_[i] += rates[i] * duration;
}

Shape Jackal::Outline() const { return OutlineOf(model_.footprint, pose()); }

Shape OutlineOf(const Footprint& footprint, const Pose2D& pose) {
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& corner : footprint.Corners()) {
    corners.push_back(pose * corner);
  }
  return MakeConvexPolygon(std::move(corners));
}

}  // namespace vfh_astar
