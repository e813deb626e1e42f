#include "vfh_astar/trajectory/pose_check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vfh_astar {
namespace {

// m between probes of the outline at most.
constexpr double kProbeSpacing = 0.12;
// m that a corner moves between two checked poses of a turn.
constexpr double kTurnStep = 0.01;
// m from the start within which no more margin is asked for.
constexpr double kFirstMetres = 0.3;
// m that a start inside the margin may lose: a rectangle beside a wall cannot
// turn away from it otherwise.
constexpr double kStartSlack = 0.01;

std::vector<Eigen::Vector2d> Outline(const Footprint& footprint) {
  std::vector<Eigen::Vector2d> outline;
  const std::array<Eigen::Vector2d, 4> corners = footprint.Corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % 4] - corners[i];
    const int parts =
        std::max(1, static_cast<int>(std::ceil(side.norm() / kProbeSpacing)));
    for (int k = 0; k < parts; ++k) {
      outline.push_back(corners[i] + side * k / parts);
    }
  }
  return outline;
}

// The largest margin up to `margin` at which the footprint is free at `pose`;
// the least one leaves next to nothing of the footprint.
double MarginKept(const Footprint& footprint, const ClearanceMap& clearance,
                  double margin, const Pose2D& pose) {
  if (clearance.IsFree(footprint, pose, margin)) return margin;
  double low = -footprint.InscribedRadius();
  double high = margin;
  constexpr double kTolerance = 1e-3;
  while (high - low > kTolerance) {
    const double middle = 0.5 * (low + high);
    (clearance.IsFree(footprint, pose, middle) ? low : high) = middle;
  }
  return low - kStartSlack;
}

}  // namespace

PoseCheck::PoseCheck(const Footprint& footprint, const ClearanceMap& clearance,
                     double margin, const Pose2D& start)
    : footprint_(footprint),
      clearance_(clearance),
      // IsFree looks at cell centres, and a cell reaches half a cell farther.
      margin_(margin + 0.5 * clearance.geometry().resolution),
      start_(start.position()),
      start_margin_(MarginKept(footprint, clearance, margin_, start)),
      outline_(Outline(footprint)) {}

double PoseCheck::MarginAt(const Eigen::Vector2d& point) const {
  if (start_margin_ >= margin_) return margin_;
  // Nothing more at first: a robot beside a wall gains room slowly.
  const double left = std::clamp(((point - start_).norm() - kFirstMetres) /
                                     (kLeavingDistance - kFirstMetres),
                                 0.0, 1.0);
  return start_margin_ + left * left * (margin_ - start_margin_);
}

bool PoseCheck::IsFree(const Pose2D& pose) const {
  const GridGeometry& geometry = clearance_.geometry();
  // Beyond the map nothing is known, and nothing can be planned from there; a
  // start there already is not made worse.
  if (!geometry.Contains(geometry.ToCell(pose.position())) &&
      geometry.Contains(geometry.ToCell(start_))) {
    return false;
  }
  return clearance_.IsFree(footprint_, pose, MarginAt(pose.position()));
}

bool PoseCheck::IsTurnFree(const Pose2D& pose, double angle) const {
  const double step = kTurnStep / footprint_.CircumscribedRadius();
  const int steps =
      std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
  for (int i = 0; i <= steps; ++i) {
    if (!IsFree({pose.x, pose.y, pose.theta + angle * i / steps})) return false;
  }
  return true;
}

double PoseCheck::RoomAt(const Eigen::Vector2d& point) const {
  // Interpolated between cell centres: in steps of a cell it would make the
  // speed step, too.
  const GridGeometry& geometry = clearance_.geometry();
  const Eigen::Vector2d at = (point - geometry.origin) / geometry.resolution -
                             Eigen::Vector2d(0.5, 0.5);
  const int x = static_cast<int>(std::floor(at.x()));
  const int y = static_cast<int>(std::floor(at.y()));
  const auto clear = [&](int dx, int dy) {
    const Cell cell{x + dx, y + dy};
    return geometry.Contains(cell) ? clearance_.At(cell)
                                   : clearance_.max_distance();
  };
  const double right = at.x() - x;
  const double up = at.y() - y;
  const double low = (1.0 - right) * clear(0, 0) + right * clear(1, 0);
  const double high = (1.0 - right) * clear(0, 1) + right * clear(1, 1);
  return std::max(0.0,
                  (1.0 - up) * low + up * high - 0.5 * geometry.resolution);
}

double PoseCheck::Room(const Pose2D& pose) const {
  double room = clearance_.max_distance();
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  for (const Eigen::Vector2d& p : outline_) {
    room = std::min(room, RoomAt({pose.x + c * p.x() - s * p.y(),
                                  pose.y + s * p.x() + c * p.y()}));
  }
  return room;
}

}  // namespace vfh_astar
