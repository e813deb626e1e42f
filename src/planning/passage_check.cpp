#include "vfh_astar/planning/passage_check.h"

namespace vfh_astar {

PassageCheck::PassageCheck(const Footprint& footprint, const Pose2D& start,
                           const ClearanceMap& clearance)
    : footprint_(footprint),
      circumscribed_radius_(footprint.CircumscribedRadius()),
      start_(start),
      clearance_(clearance) {
  for (int heading = 0; heading < kHeadings; ++heading) {
    const Pose2D turned(0.0, 0.0, heading * 2.0 * kPi / kHeadings);
    VisitFootprintRows(footprint, turned, clearance.geometry().resolution,
                       [this, heading](const CellRow& row) {
                         rows_[heading].push_back(row);
                         return true;
                       });
  }
}

bool PassageCheck::FitsAt(const Cell& cell, int heading) const {
  for (const CellRow& row : rows_[(heading + kHeadings) % kHeadings]) {
    if (!clearance_.IsRowFree(
            {row.y + cell.y, row.first + cell.x, row.last + cell.x})) {
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
  return footprint_.Contains(start_.Inverse() *
                             clearance_.geometry().ToWorld(cell));
}

}  // namespace vfh_astar
