#include "vfh_astar/control/tracking_law.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

struct Gains {
  double k1;
  double k2;
  double k3;
};

Gains GainsAt(const Twist2D& reference, const TrackingParameters& parameters) {
  if (parameters.gains == "constant") {
    return {parameters.k1, parameters.k2, parameters.k3};
  }
  const double natural_frequency =
      std::sqrt(reference.w * reference.w +
                parameters.bandwidth * reference.v * reference.v);
  const double gain = 2.0 * parameters.damping * natural_frequency;
  return {std::max(gain, parameters.k1), parameters.bandwidth,
          std::max(gain, parameters.k3)};
}

/// sin(x) / x, with its series where the quotient loses its digits.
double Sinc(double x) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

}  // namespace

void TrackingParameters::Read(ParameterReader& reader) {
  reader.Choice("gains", gains, {"adaptive", "constant"});
  reader.Number("damping", damping, 0.1, 5.0);
  reader.Number("bandwidth", bandwidth, 0.0, 200.0);
  reader.Number("k1", k1, 0.0, 50.0);
  reader.Number("k2", k2, 0.0, 200.0);
  reader.Number("k3", k3, 0.0, 50.0);
}

Eigen::Vector3d TrackingError(const Pose2D& pose, const Pose2D& reference) {
  const Pose2D error = pose.Inverse() * reference;
  return {error.x, error.y, error.theta};
}

Twist2D TrackingCommand(const Eigen::Vector3d& error, const Twist2D& reference,
                        const TrackingParameters& parameters) {
  const Gains gains = GainsAt(reference, parameters);
  const double u1 = -gains.k1 * error[0];
  const double u2 =
      -gains.k2 * reference.v * Sinc(error[2]) * error[1] - gains.k3 * error[2];
  return {reference.v * std::cos(error[2]) - u1, reference.w - u2};
}

}  // namespace vfh_astar
