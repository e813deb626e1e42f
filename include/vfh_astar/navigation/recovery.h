#ifndef VFH_ASTAR_NAVIGATION_RECOVERY_H_
#define VFH_ASTAR_NAVIGATION_RECOVERY_H_

#include <deque>
#include <optional>
#include <string>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/observation.h"

namespace vfh_astar {

/// Short manoeuvres that free a robot which can neither drive on nor plan: in
/// turn, backing up along the way it came and turning towards the most open
/// direction. Each ends by itself, when the way is not free, or after its time
/// limit.
class Recovery {
 public:
  /// @param[in] parameters, footprint kept by reference: changes count at once.
  Recovery(const RecoveryParameters& parameters, const Footprint& footprint);

  /// Notes where the robot has been. Call in every cycle that is no recovery.
  void Record(const Pose2D& pose);

  /// Attempts count anew, as for a new goal.
  void ResetAttempts() { attempts_ = 0; }

  /// True while fewer than max_attempts have been made without leaving the
  /// place of the last one.
  bool HasAttemptLeft(const Pose2D& pose) const;

  /// Begins the next manoeuvre.
  void Start(const Observation& observation);

  /// @return the command, or nothing when the manoeuvre has ended.
  std::optional<Twist2D> Update(const Observation& observation);

  /// What the present manoeuvre is, for people.
  std::string Description() const;

 private:
  enum class Manoeuvre { kBackUp, kTurn };

  bool HasLeft(const Pose2D& pose) const;
  std::optional<Twist2D> BackUp(const Observation& observation);
  std::optional<Twist2D> Turn(const Observation& observation) const;

  const RecoveryParameters& parameters_;
  const Footprint& footprint_;
  std::deque<Pose2D> trail_;  ///< oldest first.
  int attempts_ = 0;
  Manoeuvre manoeuvre_ = Manoeuvre::kBackUp;
  double start_time_ = 0.0;
  Pose2D start_;
  double turn_target_ = 0.0;  ///< rad, map frame.
};

/// The direction (rad, robot frame) in which the nearest obstacle within a
/// footprint's breadth is farthest; the one nearest to straight ahead among
/// equals.
double MostOpenDirection(const std::vector<Eigen::Vector2d>& obstacles,
                         const Footprint& footprint);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_RECOVERY_H_
