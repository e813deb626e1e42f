#include "vfh_astar/mapping/pose_graph.h"

#include <ceres/ceres.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace vfh_astar {
namespace {

Eigen::Vector3d Residual(const PoseConstraint& constraint, const Pose2D& from,
                         const Pose2D& to) {
  const double c = std::cos(from.theta);
  const double s = std::sin(from.theta);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  return {c * dx + s * dy - constraint.motion.x,
          -s * dx + c * dy - constraint.motion.y,
          NormalizeAngle(to.theta - from.theta - constraint.motion.theta)};
}

/// A square root of a matrix that may be singular.
Eigen::Matrix3d Root(const Eigen::Matrix3d& information) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
  const Eigen::Vector3d roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return roots.asDiagonal() * solver.eigenvectors().transpose();
}

class ConstraintCost : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit ConstraintCost(const PoseConstraint& constraint)
      : constraint_(constraint), root_(Root(constraint.information)) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Pose2D from(parameters[0][0], parameters[0][1], parameters[0][2]);
    const Pose2D to(parameters[1][0], parameters[1][1], parameters[1][2]);
    Eigen::Map<Eigen::Vector3d>{residuals} =
        root_ * Residual(constraint_, from, to);
    if (jacobians == nullptr) return true;
    const double c = std::cos(from.theta);
    const double s = std::sin(from.theta);
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    using Jacobian = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
    Eigen::Matrix3d by_to;
    by_to << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
    if (jacobians[0] != nullptr) {
      Eigen::Matrix3d by_from = -by_to;
      by_from(0, 2) = -s * dx + c * dy;
      by_from(1, 2) = -c * dx - s * dy;
      Jacobian{jacobians[0]} = root_ * by_from;
    }
    if (jacobians[1] != nullptr) Jacobian{jacobians[1]} = root_ * by_to;
    return true;
  }

 private:
  PoseConstraint constraint_;
  Eigen::Matrix3d root_;
};

ceres::Solver::Options SolverOptions(const PoseGraphParameters& parameters) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = parameters.max_iterations;
  options.function_tolerance = 1e-5;
  // One thread, so that the same sums come out in the same order.
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

Eigen::Matrix3d InFrameOf(const Pose2D& from,
                          const Eigen::Matrix3d& map_information) {
  const double c = std::cos(from.theta);
  const double s = std::sin(from.theta);
  Eigen::Matrix3d turn;
  turn << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return turn.transpose() * map_information * turn;
}

std::vector<Pose2D> OptimizePoses(
    const std::vector<Pose2D>& poses,
    const std::vector<PoseConstraint>& constraints,
    const PoseGraphParameters& parameters) {
  if (constraints.empty()) return poses;
  std::vector<Eigen::Vector3d> values;
  values.reserve(poses.size());
  for (const Pose2D& pose : poses) {
    values.emplace_back(pose.x, pose.y, pose.theta);
  }
  ceres::Problem problem;
  for (Eigen::Vector3d& value : values) {
    problem.AddParameterBlock(value.data(), 3);
  }
  problem.SetParameterBlockConstant(values.front().data());
  for (const PoseConstraint& constraint : constraints) {
    problem.AddResidualBlock(
        new ConstraintCost(constraint),
        constraint.is_doubtful ? new ceres::CauchyLoss(parameters.doubt_width)
                               : nullptr,
        values[constraint.from].data(), values[constraint.to].data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(parameters), &problem, &summary);
  std::vector<Pose2D> result;
  result.reserve(values.size());
  for (const Eigen::Vector3d& value : values) {
    result.emplace_back(value.x(), value.y(), NormalizeAngle(value.z()));
  }
  return result;
}

}  // namespace vfh_astar
