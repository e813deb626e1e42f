#include "vfh_astar/ros/motion_messages.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

// s between two poses of a trajectory that is displayed.
constexpr double kDisplayStep = 0.05;

geometry_msgs::PoseStamped Stamped(const Pose2D& pose,
                                   const std_msgs::Header& header) {
  geometry_msgs::PoseStamped message;
  message.header = header;
  message.pose = ToPoseMessage(pose);
  return message;
}

void FromQuintic(const Quintic& coefficients,
                 boost::array<double, 6>& message) {
  std::copy(coefficients.data(), coefficients.data() + 6, message.begin());
}

Quintic ToQuintic(const boost::array<double, 6>& message) {
  return Eigen::Map<const Quintic>(message.data());
}

std::uint8_t ToKindMessage(TrajectoryPiece::Kind kind) {
  switch (kind) {
    case TrajectoryPiece::Kind::kForward:
      return QuinticPiece::FORWARD;
    case TrajectoryPiece::Kind::kReverse:
      return QuinticPiece::REVERSE;
    case TrajectoryPiece::Kind::kTurn:
      break;
  }
  return QuinticPiece::TURN;
}

TrajectoryPiece::Kind ToKind(std::uint8_t kind) {
  switch (kind) {
    case QuinticPiece::FORWARD:
      return TrajectoryPiece::Kind::kForward;
    case QuinticPiece::REVERSE:
      return TrajectoryPiece::Kind::kReverse;
    case QuinticPiece::TURN:
      return TrajectoryPiece::Kind::kTurn;
    default:
      throw MessageError("kind is " + std::to_string(kind) +
                         "; expected FORWARD, REVERSE or TURN");
  }
}

TrajectoryPiece ToPiece(const QuinticPiece& message) {
  TrajectoryPiece piece;
  piece.kind = ToKind(message.kind);
  piece.duration = message.duration;
  piece.x = ToQuintic(message.x);
  piece.y = ToQuintic(message.y);
  piece.heading = ToQuintic(message.heading);
  if (!(piece.duration > 0.0) || !std::isfinite(piece.duration)) {
    throw MessageError("duration is " + std::to_string(piece.duration) +
                       "; expected more than 0 s");
  }
  if (!piece.x.allFinite() || !piece.y.allFinite() ||
      !piece.heading.allFinite()) {
    throw MessageError("a coefficient is not finite");
  }
  return piece;
}

}  // namespace

MotionQuery ToQueryMessage(const MotionRequest& request,
                           const ros::Time& identity,
                           const std::string& frame_id) {
  MotionQuery query;
  query.header.stamp = identity;
  query.header.frame_id = frame_id;
  query.id = static_cast<std::uint32_t>(request.id.number);
  query.goal_id = request.id.goal_id;
  query.start_time.fromSec(request.start_time);
  query.start = ToPoseMessage(request.start.pose);
  query.start_twist = ToTwistMessage(request.start.twist);
  query.start_acceleration = request.start.acceleration;
  query.goal = ToPoseMessage(request.goal);
  query.tolerance = request.tolerance;
  return query;
}

PlanRequest ToPlanRequest(const MotionQuery& query,
                          const std::string& frame_id) {
  CheckFrame(query.header.frame_id, frame_id);
  PlanRequest request;
  request.start = ToPose2D(query.start);
  request.goal = ToPose2D(query.goal);
  request.tolerance = query.tolerance;
  return request;
}

FitRequest ToFitRequest(const nav_msgs::Path& path, const MotionQuery* query) {
  if (path.poses.empty()) {
    throw MessageError("the path has no poses; expected one or more");
  }
  FitRequest request;
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const Pose2D pose = ToPose2D(path.poses[i].pose);
    if (!pose.IsFinite()) {
      throw MessageError("poses[" + std::to_string(i) + "] is not finite");
    }
    request.path.push_back(pose.position());
  }
  request.goal = ToPose2D(path.poses.back().pose);
  if (query) {
    request.start.pose = ToPose2D(query->start);
    request.start.twist = ToTwist2D(query->start_twist);
    request.start.acceleration = query->start_acceleration;
  } else {
    request.start.pose = ToPose2D(path.poses.front().pose);
  }
  return request;
}

nav_msgs::Path ToPathMessage(const std::vector<Eigen::Vector2d>& points,
                             const Pose2D& goal, const std::string& frame_id,
                             const ros::Time& stamp) {
  assert(!points.empty());
  nav_msgs::Path path;
  path.header.frame_id = frame_id;
  path.header.stamp = stamp;
  path.poses.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector2d along = points[i + 1] - points[i];
    const double heading = std::atan2(along.y(), along.x());
    path.poses.push_back(Stamped({points[i], heading}, path.header));
  }
  path.poses.push_back(Stamped({points.back(), goal.theta}, path.header));
  return path;
}

nav_msgs::Path ToPathMessage(const Trajectory& trajectory,
                             const std::string& frame_id,
                             const ros::Time& start) {
  nav_msgs::Path path;
  path.header.frame_id = frame_id;
  path.header.stamp = start;
  const double duration = trajectory.duration();
  const int steps =
      std::max(1, static_cast<int>(std::ceil(duration / kDisplayStep)));
  for (int i = 0; i <= steps; ++i) {
    const double t = duration * i / steps;
    std_msgs::Header header = path.header;
    header.stamp += ros::Duration(t);
    path.poses.push_back(Stamped(trajectory.Sample(t).pose, header));
  }
  return path;
}

QuinticTrajectory ToTrajectoryMessage(const Trajectory& trajectory,
                                      const std::string& frame_id,
                                      const ros::Time& start) {
  QuinticTrajectory message;
  message.header.frame_id = frame_id;
  message.header.stamp = start;
  for (const TrajectoryPiece& piece : trajectory.pieces()) {
    QuinticPiece& part = message.pieces.emplace_back();
    part.kind = ToKindMessage(piece.kind);
    part.duration = piece.duration;
    FromQuintic(piece.x, part.x);
    FromQuintic(piece.y, part.y);
    FromQuintic(piece.heading, part.heading);
  }
  return message;
}

Trajectory ToTrajectory(const QuinticTrajectory& message) {
  if (message.pieces.empty()) {
    throw MessageError("the trajectory has no pieces; expected one or more");
  }
  std::vector<TrajectoryPiece> pieces;
  for (std::size_t i = 0; i < message.pieces.size(); ++i) {
    try {
      pieces.push_back(ToPiece(message.pieces[i]));
    } catch (const MessageError& error) {
      throw MessageError("pieces[" + std::to_string(i) + "]: " + error.what());
    }
  }
  return Trajectory(std::move(pieces));
}

MotionFailure ToFailureMessage(const MotionQuery& query,
                               const std::string& stage, Outcome outcome,
                               const std::string& message) {
  MotionFailure failure;
  failure.header = query.header;
  failure.request_id = query.id;
  failure.goal_id = query.goal_id;
  failure.stage = stage;
  failure.outcome = static_cast<std::int32_t>(outcome);
  failure.message = message;
  return failure;
}

MotionAnswer ToAnswer(const MotionFailure& failure) {
  MotionAnswer answer;
  answer.id = {static_cast<int>(failure.request_id), failure.goal_id};
  answer.message = failure.message;
  switch (failure.outcome) {
    case MotionFailure::CANCELLED:
    case MotionFailure::INVALID_GOAL:
    case MotionFailure::NO_PATH:
    case MotionFailure::GOAL_OUTSIDE_MAP:
    case MotionFailure::GOAL_BLOCKED:
    case MotionFailure::START_OUTSIDE_MAP:
    case MotionFailure::START_BLOCKED:
    case MotionFailure::NO_MAP:
    case MotionFailure::NO_TRAJECTORY:
      answer.outcome = static_cast<Outcome>(failure.outcome);
      break;
    default:
      answer.outcome = Outcome::kFailure;
  }
  return answer;
}

}  // namespace vfh_astar
