#include "vfh_astar/ros/transforms.h"

#include <gtest/gtest.h>

#include <string>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

class PoseInFrameTest : public testing::Test {
 protected:
  PoseInFrameTest() {
    transforms_.setUsingDedicatedThread(true);
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.header.stamp = ros::Time(5);
    transform.child_frame_id = "odom";
    transform.transform = ToTransformMessage({1.0, 2.0, 0.5 * kPi});
    transforms_.setTransform(transform, "test");
    pose_.header.frame_id = "odom";
    pose_.pose = ToPoseMessage({3.0, 0.0, 0.25});
  }

  std::string Refusal() const {
    try {
      PoseInFrame(pose_, "map", transforms_);
    } catch (const MessageError& error) {
      return error.what();
    }
    return "";
  }

  tf2_ros::Buffer transforms_;
  geometry_msgs::PoseStamped pose_;
};

TEST_F(PoseInFrameTest, TakesAPoseAlong) {
  const Pose2D pose = PoseInFrame(pose_, "map", transforms_);
  EXPECT_NEAR(pose.x, 1.0, 1e-12);
  EXPECT_NEAR(pose.y, 5.0, 1e-12);
  EXPECT_NEAR(pose.theta, 0.5 * kPi + 0.25, 1e-12);
}

TEST_F(PoseInFrameTest, NeedsNoTransformWithinAFrame) {
  pose_.header.frame_id = "/map";
  EXPECT_EQ(PoseInFrame(pose_, "map", tf2_ros::Buffer()).x, 3.0);
}

TEST_F(PoseInFrameTest, NamesBothFramesWhenThereIsNoTransform) {
  pose_.header.frame_id = "nowhere";
  const std::string refusal = Refusal();
  EXPECT_NE(refusal.find("nowhere"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("map"), std::string::npos) << refusal;
}

TEST_F(PoseInFrameTest, RefusesAPoseWithoutFrame) {
  pose_.header.frame_id.clear();
  EXPECT_NE(Refusal().find("frame_id"), std::string::npos);
}

TEST_F(PoseInFrameTest, RefusesAPoseThatIsNone) {
  pose_.pose.orientation = geometry_msgs::Quaternion();
  EXPECT_NE(Refusal().find("quaternion"), std::string::npos);
}

}  // namespace
}  // namespace vfh_astar
