#include "vfh_astar/ros/reconfiguration.h"

#include <gtest/gtest.h>

#include "vfh_astar/ros/ros_parameter_reader.h"

namespace vfh_astar {
namespace {

template <typename Parameters, typename Config>
Parameters Applied(const Config& config) {
  Parameters parameters;
  Apply(config, parameters);
  return parameters;
}

template <typename Config>
XmlRpc::XmlRpcValue ToParameters(const Config& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  XmlRpc::XmlRpcValue values;
  for (const auto& entry : message.doubles) values[entry.name] = entry.value;
  return values;
}

template <typename Parameters, typename Config>
void ExpectReadable(const Config& config) {
  RosParameterReader reader(ToParameters(config), "/node");
  Parameters parameters;
  EXPECT_NO_THROW(parameters.Read(reader));
  EXPECT_TRUE(reader.UnknownNames().empty());
}

// What dynamic_reconfigure lets through has to be what the parameters allow,
// and its defaults have to be theirs.
template <typename Parameters, typename Config>
void ExpectSameDefaultsAndRanges() {
  const Config& config = Config::__getDefault__();
  EXPECT_EQ(ToParameters(config).toXml(),
            ToParameters(ToConfig(Parameters())).toXml());
  ExpectReadable<Parameters>(Config::__getMin__());
  ExpectReadable<Parameters>(Config::__getMax__());
}

TEST(ReconfigurationTest, TheCfgFilesAgreeWithTheParameters) {
  ExpectSameDefaultsAndRanges<RobotLimits, LimitsConfig>();
  ExpectSameDefaultsAndRanges<GoalParameters, GoalConfig>();
  ExpectSameDefaultsAndRanges<SafetyLimiterParameters, SafetyConfig>();
}

TEST(ReconfigurationTest, ValuesSurviveTheWayThereAndBack) {
  RobotLimits limits;
  limits.max_v = 0.7;
  limits.max_v_reverse = 0.1;
  limits.max_w = 1.1;
  limits.max_acceleration = 0.9;
  limits.max_deceleration = 1.3;
  limits.max_lateral_acceleration = 0.4;
  const auto back = Applied<RobotLimits>(ToConfig(limits));
  EXPECT_EQ(back.max_v, 0.7);
  EXPECT_EQ(back.max_v_reverse, 0.1);
  EXPECT_EQ(back.max_w, 1.1);
  EXPECT_EQ(back.max_acceleration, 0.9);
  EXPECT_EQ(back.max_deceleration, 1.3);
  EXPECT_EQ(back.max_lateral_acceleration, 0.4);

  GoalParameters goal;
  goal.tolerance = 0.0;
  goal.xy_goal_tolerance = 0.2;
  goal.yaw_goal_tolerance = 0.3;
  const auto same_goal = Applied<GoalParameters>(ToConfig(goal));
  EXPECT_EQ(same_goal.tolerance, 0.0);
  EXPECT_EQ(same_goal.xy_goal_tolerance, 0.2);
  EXPECT_EQ(same_goal.yaw_goal_tolerance, 0.3);

  SafetyLimiterParameters safety;
  safety.margin = 0.125;
  EXPECT_EQ(Applied<SafetyLimiterParameters>(ToConfig(safety)).margin, 0.125);
}

}  // namespace
}  // namespace vfh_astar
