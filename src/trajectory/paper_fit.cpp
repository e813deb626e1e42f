#include "vfh_astar/trajectory/paper_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kViaSpacing = 0.1;  // m
constexpr int kMinVias = 6;          // as many as a quintic has coefficients.
// The ends are where the robot is and where it has to stop: they count for far
// more than any via point, so that the fit meets them to a millimetre.
constexpr double kEndWeight = 1000.0;

}  // namespace

Trajectory FitSingleQuintic(const Polyline& path,
                            const Eigen::Vector2d& velocity,
                            double time_per_metre) {
  const double length = Length(path);
  assert(length > 0.0 && time_per_metre > 0.0);
  const double duration = time_per_metre * length;
  const int vias = std::max(
      kMinVias, 1 + static_cast<int>(std::lround(length / kViaSpacing)));
  const Polyline points = Resample(path, vias);
  const double step = duration / (vias - 1);

  Eigen::MatrixXd powers(2 * vias, 6);
  Eigen::MatrixXd targets(2 * vias, 2);
  for (int k = 0; k < vias; ++k) {
    const bool is_end = k == 0 || k == vias - 1;
    const double weight = is_end ? kEndWeight : 1.0;
    Eigen::Vector2d speed = Eigen::Vector2d::Zero();
    if (k == 0) speed = velocity;
    if (!is_end) speed = (points[k + 1] - points[k - 1]) / (2.0 * step);

    const double tau = static_cast<double>(k) / (vias - 1);
    double power = 1.0;
    double previous = 0.0;
    for (int i = 0; i < 6; ++i) {
      powers(k, i) = weight * power;
      powers(vias + k, i) = weight * i * previous / duration;
      previous = power;
      power *= tau;
    }
    targets.row(k) = weight * points[k];
    targets.row(vias + k) = weight * speed;
  }
  const Eigen::MatrixXd coefficients =
      powers.colPivHouseholderQr().solve(targets);

  TrajectoryPiece piece;
  piece.duration = duration;
  piece.x = coefficients.col(0);
  piece.y = coefficients.col(1);
  return Trajectory({piece});
}

}  // namespace vfh_astar
