#include "vfh_astar/ros/ros_parameter_reader.h"

#include <gtest/gtest.h>

#include "vfh_astar/footprint.h"
#include "vfh_astar/ros/frame_names.h"

namespace vfh_astar {
namespace {

using XmlRpc::XmlRpcValue;

struct Parameters {
  double speed = 1.5;
  int count = 3;
  bool flag = false;
  std::string mode = "a";
  Footprint footprint;

  void Read(ParameterReader& reader) {
    reader.Number("speed", speed, 0.0, 10.0);
    reader.Integer("count", count, 0, 10);
    reader.Flag("flag", flag);
    reader.Choice("mode", mode, {"a", "b"});
    reader.Group("footprint", footprint);
  }
};

Parameters Read(const XmlRpcValue& values) {
  RosParameterReader reader(values, "/node");
  Parameters parameters;
  parameters.Read(reader);
  return parameters;
}

std::string Refusal(const XmlRpcValue& values) {
  try {
    Read(values);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(RosParameterReaderTest, NothingSetLeavesTheDefaults) {
  const Parameters parameters = Read(XmlRpcValue());
  EXPECT_EQ(parameters.speed, 1.5);
  EXPECT_EQ(parameters.count, 3);
  EXPECT_EQ(parameters.footprint.front, Footprint().front);
}

TEST(RosParameterReaderTest, ReadsEveryTypeAndGroups) {
  XmlRpcValue values;
  values["speed"] = 2.5;
  values["count"] = 7;
  values["flag"] = true;
  values["mode"] = "b";
  values["footprint"]["front"] = 0.5;
  const Parameters parameters = Read(values);
  EXPECT_EQ(parameters.speed, 2.5);
  EXPECT_EQ(parameters.count, 7);
  EXPECT_TRUE(parameters.flag);
  EXPECT_EQ(parameters.mode, "b");
  EXPECT_EQ(parameters.footprint.front, 0.5);
  EXPECT_EQ(parameters.footprint.rear, Footprint().rear);
}

TEST(RosParameterReaderTest, AWholeNumberIsANumber) {
  XmlRpcValue values;
  values["speed"] = 2;
  EXPECT_EQ(Read(values).speed, 2.0);
}

TEST(RosParameterReaderTest, NamesWhatItRefuses) {
  XmlRpcValue values;
  values["speed"] = "fast";
  EXPECT_EQ(Refusal(values),
            "parameter /node/speed is fast; expected a number");
  values = XmlRpcValue();
  values["count"] = 2.5;
  EXPECT_NE(Refusal(values).find("/node/count"), std::string::npos);
  values = XmlRpcValue();
  values["flag"] = 1;
  EXPECT_NE(Refusal(values).find("true or false"), std::string::npos);
  values = XmlRpcValue();
  values["mode"] = "c";
  EXPECT_NE(Refusal(values).find("one of a, b"), std::string::npos);
  values = XmlRpcValue();
  values["footprint"]["rear"] = -1.0;
  EXPECT_NE(Refusal(values).find("footprint/rear"), std::string::npos);
}

TEST(RosParameterReaderTest, KnowsWhatNobodyAskedFor) {
  XmlRpcValue values;
  values["speed"] = 2.0;
  values["sped"] = 2.0;
  values["footprint"]["front"] = 0.5;
  values["footprint"]["fornt"] = 0.5;
  values["other"]["front"] = 0.5;
  RosParameterReader reader(values, "/node");
  Parameters parameters;
  parameters.Read(reader);
  EXPECT_EQ(reader.UnknownNames(),
            (std::vector<std::string>{"footprint/fornt", "other", "sped"}));
}

TEST(FrameNamesTest, RefusesASlashInFront) {
  XmlRpcValue values;
  values["odom_frame"] = "robot/odom";
  RosParameterReader good(values, "/node");
  FrameNames frames;
  frames.Read(good);
  EXPECT_EQ(frames.odom_frame, "robot/odom");
  EXPECT_EQ(frames.map_frame, "map");
  values["odom_frame"] = "/odom";
  RosParameterReader bad(values, "/node");
  EXPECT_THROW(frames.Read(bad), ParameterError);
  values["odom_frame"] = "";
  RosParameterReader empty(values, "/node");
  EXPECT_THROW(frames.Read(empty), ParameterError);
}

}  // namespace
}  // namespace vfh_astar
