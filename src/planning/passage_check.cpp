#include "vfh_astar/planning/passage_check.h"

#include <algorithm>
#include <cmath>

#include "vfh_astar/grid/footprint_rows.h"

namespace vfh_astar {

PassageCheck::PassageCheck(const Footprint& footprint, const Pose2D& start,
                           const ClearanceMap& clearance)
    : footprint_(footprint),
      circumscribed_radius_(
          static_cast<float>(footprint.CircumscribedRadius())),
      to_robot_(PointTransform::Into(start)),
      clearance_(clearance) {
  const double resolution = clearance.geometry().resolution;
  for (int heading = 0; heading < kHeadings; ++heading) {
    std::vector<Covered>& covered = covered_[heading];
    const Pose2D turned(0.0, 0.0, heading * 2.0 * kPi / kHeadings);
    VisitFootprintRows(
        footprint, turned, resolution, [&covered, resolution](CellRow row) {
          for (int x = row.first; x <= row.last; ++x) {
            covered.push_back(
                {{x, row.y},
                 static_cast<float>(resolution * std::hypot(x, row.y))});
          }
          return true;
        });
    std::sort(covered.begin(), covered.end(),
              [](const Covered& a, const Covered& b) {
                return a.distance > b.distance;
              });
  }
}

bool PassageCheck::FitsAt(const Cell& cell, int heading) const {
  // Nearer than the clearance no cell is occupied; most checks are over after
  // the corners.
  constexpr float kRounding = 1e-4f;
  const float clear = static_cast<float>(clearance_.At(cell)) - kRounding;
  for (const Covered& covered : covered_[(heading + kHeadings) % kHeadings]) {
    if (covered.distance < clear) return true;
    const Cell at{cell.x + covered.offset.x, cell.y + covered.offset.y};
    if (clearance_.geometry().Contains(at) && clearance_.IsOccupied(at)) {
      return false;
    }
  }
  return true;
}

bool PassageCheck::Fits(const Cell& cell, int direction) const {
  if (clearance_.At(cell) > circumscribed_radius_) return true;
  const int heading = direction * kHeadingsPerDirection;
  // From the direction itself outwards: mostly the first one fits.
  for (const int turn : {0, 1, -1, 2, -2}) {
    if (FitsAt(cell, heading + turn)) return true;
  }
  return footprint_.Contains(to_robot_ * clearance_.geometry().ToWorld(cell));
}

}  // namespace vfh_astar
