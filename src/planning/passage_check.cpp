#include "vfh_astar/planning/passage_check.h"

namespace vfh_astar {
namespace {

constexpr double kDirectionAngle = 2.0 * kPi / kDirections;

}  // namespace

PassageCheck::PassageCheck(const Footprint& footprint, const Pose2D& start,
                           const ClearanceMap& clearance)
    : footprint_(footprint), start_(start), clearance_(clearance) {}

bool PassageCheck::Fits(const Cell& cell, int direction) const {
  if (clearance_.At(cell) > footprint_.CircumscribedRadius()) return true;
  const Eigen::Vector2d centre = clearance_.geometry().ToWorld(cell);
  // From the direction itself outwards: mostly the first one fits.
  for (const double part : {0.0, 0.25, -0.25, 0.5, -0.5}) {
    const Pose2D pose(centre, (direction + part) * kDirectionAngle);
    if (clearance_.IsFree(footprint_, pose, 0.0)) return true;
  }
  return footprint_.Contains(start_.Inverse() * centre);
}

}  // namespace vfh_astar
