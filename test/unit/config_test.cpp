#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <set>
#include <string>

#include "vfh_astar/mapping/slam_mapper.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/planning/path_planner.h"
#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {
namespace {

class ConfigTest : public testing::TestWithParam<const char*> {
 protected:
  std::string file() const {
    return std::string(VFH_ASTAR_SOURCE_DIR) + "/config/" + GetParam();
  }

  // The names of all values below a node, as ParameterReader has them.
  static void CollectNames(const YAML::Node& node, const std::string& prefix,
                           std::set<std::string>& names) {
    if (!node.IsMap()) {
      names.insert(prefix);
      return;
    }
    for (const auto& entry : node) {
      const std::string name = entry.first.as<std::string>();
      CollectNames(entry.second, prefix.empty() ? name : prefix + "/" + name,
                   names);
    }
  }

  // Reads a section and expects it to name every parameter there is, and no
  // other one.
  template <typename Parameters>
  Parameters ReadWhole(const std::string& section) {
    YamlParameterReader reader(file(), section);
    Parameters parameters;
    parameters.Read(reader);
    std::set<std::string> names;
    CollectNames(YAML::LoadFile(file())[section], "", names);
    EXPECT_EQ(names, reader.names()) << section;
    return parameters;
  }
};

TEST_P(ConfigTest, NamesEveryParameter) {
  ReadWhole<SlamMapperParameters>("grid_mapper");
  const auto planner = ReadWhole<PathPlannerParameters>("path_planner");
  const auto fitter =
      ReadWhole<TrajectoryFitterParameters>("trajectory_fitter");
  const auto navigator = ReadWhole<NavigatorParameters>("navigator");
  // What the stages share is one and the same.
  EXPECT_EQ(planner.occupied_threshold, fitter.occupied_threshold);
  EXPECT_EQ(planner.occupied_threshold, navigator.occupied_threshold);
  EXPECT_EQ(planner.footprint.front, navigator.footprint.front);
  EXPECT_EQ(fitter.footprint.rear, navigator.footprint.rear);
  // What is planned is what may be commanded, or less.
  EXPECT_LE(fitter.limits.max_v, navigator.limits.max_v);
  EXPECT_LE(fitter.limits.max_w, navigator.limits.max_w);
}

TEST_P(ConfigTest, StaysWithinTheJackalsOwnLimits) {
  const auto navigator =
      LoadParameters<NavigatorParameters>(file(), "navigator");
  EXPECT_LE(navigator.limits.max_v, 2.0);
  EXPECT_LE(navigator.limits.max_w, 4.0);
  EXPECT_LE(navigator.limits.max_acceleration, 20.0);
  EXPECT_LE(navigator.limits.max_angular_acceleration, 25.0);
}

INSTANTIATE_TEST_SUITE_P(Files, ConfigTest,
                         testing::Values("jackal.yaml", "paper.yaml"));

TEST(ConfigFileTest, PaperDiffersWhereThePaperDoes) {
  const std::string folder = std::string(VFH_ASTAR_SOURCE_DIR) + "/config/";
  const auto fitter = LoadParameters<TrajectoryFitterParameters>(
      folder + "paper.yaml", "trajectory_fitter");
  const auto navigator =
      LoadParameters<NavigatorParameters>(folder + "paper.yaml", "navigator");
  EXPECT_EQ(fitter.fit, "quintic");
  EXPECT_EQ(navigator.tracking.gains, "constant");
  EXPECT_EQ(navigator.vfh.speed, 0.2);
  EXPECT_GE(navigator.vfh.slow_angle, kPi);
  EXPECT_EQ(navigator.avoidance.rule, "distance");
  EXPECT_EQ(navigator.replan.lag, 0.0);
}

}  // namespace
}  // namespace vfh_astar
