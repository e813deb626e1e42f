#include "benchmark/navigation_stack.h"

namespace vfh_astar {

StackParameters LoadStackParameters(const std::string& file) {
  StackParameters parameters;
  parameters.mapper = LoadParameters<SlamMapperParameters>(file, "grid_mapper");
  parameters.planner =
      LoadParameters<PathPlannerParameters>(file, "path_planner");
  parameters.fitter =
      LoadParameters<TrajectoryFitterParameters>(file, "trajectory_fitter");
  parameters.navigator = LoadParameters<NavigatorParameters>(file, "navigator");
  return parameters;
}

NavigationStack::NavigationStack(const StackParameters& parameters,
                                 const Pose2D& start, StageTimes* times)
    : times_(times),
      mapper_(parameters.mapper, start),
      planner_(parameters.planner),
      fitter_(parameters.fitter),
      navigator_(parameters.navigator),
      clearance_(parameters.navigator.occupied_threshold,
                 parameters.fitter.ClearanceReach()) {
  const OccupancyGrid map = mapper_.grid_mapper().Map();
  planner_.SetMap(map);
  clearance_.SetMap(map);
}

void NavigationStack::InsertScan(const Sensing& sensing) {
  const Pose2D odom_from_base =
      Integrate(sensing.odom_from_base, sensing.twist,
                sensing.scan.stamp - sensing.odometry_stamp);
  {
    const StageTimer timer(times_, Stage::kLocalize);
    mapper_.Locate(sensing.scan, sensing.base_from_laser, odom_from_base);
  }
  StageTimer timer(times_, Stage::kMapInsert);
  const MapChange change = mapper_.Enter();
  if (!change.inserted) {
    timer.Discard();
    return;
  }
  timer.Stop();
  TakeIn(change);
}

void NavigationStack::TakeIn(const MapChange& change) {
  if (change.resized) {
    const OccupancyGrid map = mapper_.grid_mapper().Map();
    const StageTimer timer(times_, Stage::kInflationUpdate);
    planner_.SetMap(map);
    clearance_.SetMap(map);
  } else if (!change.window.empty()) {
    const std::vector<std::int8_t> values =
        mapper_.grid_mapper().Values(change.window);
    const StageTimer timer(times_, Stage::kInflationUpdate);
    planner_.UpdateMap({{change.window, values}});
    clearance_.Update(change.window, values);
  }
}

void NavigationStack::Answer(const MotionRequest& request) {
  StageTimer planning(times_, Stage::kPlan);
  PlanResult plan = planner_.Plan(
      {request.start.pose, request.goal, request.tolerance, path_});
  planning.Stop();
  if (plan.outcome != Outcome::kSuccess) {
    navigator_.PlanFailed(request.id, plan.outcome, plan.message);
    return;
  }
  path_ = plan.path;
  StageTimer fitting(times_, Stage::kFit);
  FitResult fit =
      fitter_.Fit({std::move(plan.path), request.start, plan.goal}, clearance_);
  fitting.Stop();
  if (fit.outcome != Outcome::kSuccess) {
    navigator_.PlanFailed(request.id, fit.outcome, fit.message);
    return;
  }
  trajectory_ = fit.trajectory;
  navigator_.SetTrajectory(request.id, std::move(fit.trajectory));
}

void NavigationStack::AnswerWithCourse(const MotionRequest& request) {
  if (!trajectory_.empty()) {
    navigator_.PlanFailed(request.id, Outcome::kNoTrajectory,
                          "the course was left");
    return;
  }
  trajectory_ = *course_;
  navigator_.SetTrajectory(request.id, *course_);
}

NavigatorOutput NavigationStack::Update(const Sensing& sensing) {
  InsertScan(sensing);
  NavigatorInput input;
  input.time = sensing.scan.stamp;
  input.map_from_odom = mapper_.map_from_odom();
  input.is_lost = mapper_.localization().is_lost;
  input.odometry_stamp = sensing.odometry_stamp;
  input.odom_from_base = sensing.odom_from_base;
  input.twist = sensing.twist;
  input.scan = &sensing.scan;
  input.base_from_laser = sensing.base_from_laser;
  input.map = &clearance_;
  StageTimer control(times_, Stage::kControlTick);
  NavigatorOutput output = navigator_.Update(input);
  control.Stop();
  if (output.request && course_) {
    AnswerWithCourse(*output.request);
  } else if (output.request) {
    Answer(*output.request);
  }
  return output;
}

}  // namespace vfh_astar
