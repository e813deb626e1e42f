#include "vfh_astar/navigation/observation.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace vfh_astar {
namespace {

std::string AgeMessage(const char* what, double age, double limit) {
  char text[96];
  std::snprintf(text, sizeof(text), "%s is %.2f s old; expected %.2f s or less",
                what, age, limit);
  return text;
}

std::string WithDefect(std::string message, const std::string& defect) {
  return defect.empty() ? message : message + "; " + defect;
}

std::optional<Fault> FindFault(const NavigatorInput& input,
                               const NavigatorParameters& parameters) {
  if (input.scan == nullptr) {
    return Fault{
        Outcome::kNoScan,
        WithDefect("no usable scan has been received", input.scan_defect)};
  }
  if (!input.odometry_stamp) {
    return Fault{Outcome::kNoOdometry, "no odometry has been received"};
  }
  if (!input.map_from_odom) {
    return Fault{Outcome::kTransformError,
                 "there is no transform from map to odom"};
  }
  const double transform_timeout = parameters.watchdog.transform_timeout;
  if (input.map_from_odom_stamp &&
      input.time - *input.map_from_odom_stamp > transform_timeout) {
    return Fault{
        Outcome::kTransformError,
        AgeMessage("the transform from map to odom",
                   input.time - *input.map_from_odom_stamp, transform_timeout)};
  }
  if (input.is_lost) {
    return Fault{Outcome::kLocalizationLost,
                 "the scans do not fit the map where the robot should be"};
  }
  const double scan_age = input.time - input.scan->stamp;
  const double scan_timeout = parameters.safety.scan_timeout;
  if (scan_age > scan_timeout) {
    return Fault{
        Outcome::kNoScan,
        WithDefect(AgeMessage("the latest usable scan", scan_age, scan_timeout),
                   input.scan_defect)};
  }
  const double odometry_age = input.time - *input.odometry_stamp;
  const double odometry_timeout = parameters.watchdog.odometry_timeout;
  if (odometry_age < -odometry_timeout) {
    return Fault{
        Outcome::kNoOdometry,
        AgeMessage("the latest odometry", odometry_age, odometry_timeout) +
            "; its stamp lies in the future"};
  }
  if (odometry_age > odometry_timeout) {
    return Fault{
        Outcome::kNoOdometry,
        AgeMessage("the latest odometry", odometry_age, odometry_timeout)};
  }
  return std::nullopt;
}

Pose2D OdomFromBase(const NavigatorInput& input, double time) {
  return Integrate(input.odom_from_base, input.twist,
                   time - *input.odometry_stamp);
}

}  // namespace

void TrackObstacles(const NavigatorInput& input, ObstacleTracker& tracker) {
  if (input.scan == nullptr || !input.odometry_stamp) return;
  tracker.AddScan(*input.scan, OdomFromBase(input, input.scan->stamp) *
                                   input.base_from_laser);
}

Observation Observe(const NavigatorInput& input,
                    const NavigatorParameters& parameters,
                    const ObstacleTracker* tracker) {
  Observation observation;
  observation.time = input.time;
  observation.map = input.map;
  observation.twist = input.twist;
  observation.fault = FindFault(input, parameters);
  if (!input.odometry_stamp || !input.map_from_odom) return observation;

  const Pose2D odom_from_now = OdomFromBase(input, input.time);
  observation.pose = *input.map_from_odom * odom_from_now;
  if (observation.fault) return observation;
  const Pose2D now_from_laser = odom_from_now.Inverse() *
                                OdomFromBase(input, input.scan->stamp) *
                                input.base_from_laser;
  const double range_max = input.scan->range_max;
  if (tracker == nullptr) {
    observation.obstacles = HitPoints(*input.scan, now_from_laser, range_max);
    return observation;
  }
  observation.obstacles =
      HitPoints(tracker->Without(*input.scan), now_from_laser, range_max);
  if (tracker->HitsMovers()) {
    observation.mover_hits =
        HitPoints(tracker->Only(*input.scan), now_from_laser, range_max);
  }
  const double age = input.time - input.scan->stamp;
  for (MovingObstacle mover : tracker->Moving()) {
    mover.position = mover.At(age);
    observation.movers.push_back(Transform(odom_from_now.Inverse(), mover));
  }
  return observation;
}

double FootprintClearance(const Footprint& footprint,
                          const std::vector<Eigen::Vector2d>& obstacles) {
  double clearance = std::numeric_limits<double>::infinity();
  const double radius = footprint.CircumscribedRadius();
  double matters = clearance;  // m^2 from the robot's centre.
  for (const Eigen::Vector2d& point : obstacles) {
    if (point.squaredNorm() > matters) continue;
    const double distance = footprint.SignedDistance(point);
    if (distance >= clearance) continue;
    clearance = distance;
    matters = (clearance + radius) * (clearance + radius);
  }
  return clearance;
}

}  // namespace vfh_astar
