#include "vfh_astar/ros/map_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

OccupancyGrid MakeMap(int width, int height, std::int8_t value) {
  GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.origin = Eigen::Vector2d(-1.0, 2.0);
  geometry.width = width;
  geometry.height = height;
  return OccupancyGrid(geometry, value);
}

nav_msgs::OccupancyGrid MapAt(const OccupancyGrid& map, double stamp) {
  return ToMapMessage(map, "map", ros::Time(stamp));
}

TEST(MapMessagesTest, MapsSurviveTheWayThereAndBack) {
  OccupancyGrid map = MakeMap(3, 2, 0);
  map.cells() = {0, 1, 50, 99, 100, kUnknown};
  const nav_msgs::OccupancyGrid message = MapAt(map, 7.5);
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(7.5));
  EXPECT_EQ(message.info.width, 3u);
  EXPECT_EQ(message.info.origin.position.y, 2.0);
  EXPECT_EQ(message.data[5], -1);
  const OccupancyGrid back = ToOccupancyGrid(message);
  // The message's float has to become the same double again.
  EXPECT_EQ(back.geometry(), map.geometry());
  EXPECT_EQ(back.cells(), map.cells());
}

TEST(MapMessagesTest, RefusesWhatIsNoMap) {
  const nav_msgs::OccupancyGrid good = MapAt(MakeMap(3, 2, 0), 1.0);
  EXPECT_NO_THROW(ToOccupancyGrid(good));
  nav_msgs::OccupancyGrid bad = good;
  bad.data.pop_back();
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.data[3] = 101;
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.data[3] = -2;
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.info.resolution = 0.0f;
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.info.resolution = std::nanf("");
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.info.width = 0;
  bad.data.clear();
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.info.width = 4000000000u;
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.info.origin.orientation.z = 1.0;
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
  bad = good;
  bad.info.origin.position.x = HUGE_VAL;
  EXPECT_THROW(ToOccupancyGrid(bad), MessageError);
}

// Keeps what a MapReceiver passes on.
class MapReceiverTest : public testing::Test {
 protected:
  void Update(const cv::Rect& window, std::int8_t value, double stamp) {
    receiver_.Receive(
        ToUpdateMessage(window, std::vector<std::int8_t>(window.area(), value),
                        "map", ros::Time(stamp)));
  }

  int maps_ = 0;
  std::vector<cv::Rect> windows_;
  OccupancyGrid copy_;
  MapReceiver receiver_{
      "map",
      [this](const OccupancyGrid& map) {
        ++maps_;
        copy_ = map;
      },
      [this](const cv::Rect& window, const std::vector<std::int8_t>& values) {
        windows_.push_back(window);
        auto value = values.begin();
        for (int y = window.y; y < window.br().y; ++y) {
          for (int x = window.x; x < window.br().x; ++x) {
            copy_[{x, y}] = *value++;
          }
        }
        EXPECT_EQ(value, values.end());
      }};
};

TEST_F(MapReceiverTest, AppliesUpdatesInOrder) {
  receiver_.Receive(MapAt(MakeMap(4, 3, 0), 1.0));
  Update({1, 1, 2, 2}, 100, 2.0);
  Update({3, 0, 1, 1}, 50, 3.0);
  EXPECT_EQ(maps_, 1);
  const std::vector<std::int8_t> expected = {0, 0,   0,   50,  //
                                             0, 100, 100, 0,   //
                                             0, 100, 100, 0};
  EXPECT_EQ(copy_.cells(), expected);
}

TEST_F(MapReceiverTest, NothingComesBeforeTheFirstMap) {
  Update({0, 0, 1, 1}, 100, 2.0);
  EXPECT_EQ(maps_, 0);
  EXPECT_TRUE(windows_.empty());
}

TEST_F(MapReceiverTest, DropsAnUpdateThatTheMapContains) {
  receiver_.Receive(MapAt(MakeMap(4, 3, 0), 2.0));
  Update({0, 0, 2, 2}, 100, 1.0);
  Update({0, 0, 2, 2}, 100, 2.0);
  EXPECT_TRUE(windows_.empty());
  Update({0, 0, 2, 2}, 100, 2.1);
  EXPECT_EQ(windows_.size(), 1u);
}

TEST_F(MapReceiverTest, KeepsAnUpdateForItsMapYetToCome) {
  receiver_.Receive(MapAt(MakeMap(4, 3, 0), 1.0));
  Update({3, 2, 2, 1}, 90, 2.0);
  Update({0, 2, 1, 2}, 80, 3.0);
  EXPECT_TRUE(windows_.empty());
  // It fits the map that is known and the one to come.
  Update({0, 0, 1, 1}, 70, 4.0);
  EXPECT_EQ(windows_.size(), 1u);
  // The first is in it already.
  receiver_.Receive(MapAt(MakeMap(5, 4, 0), 2.0));
  EXPECT_EQ(maps_, 2);
  const std::vector<std::int8_t> expected = {70, 0, 0, 0, 0,  //
                                             0,  0, 0, 0, 0,  //
                                             80, 0, 0, 0, 0,  //
                                             80, 0, 0, 0, 0};
  EXPECT_EQ(copy_.cells(), expected);
}

TEST_F(MapReceiverTest, KeepsUpdatesForTheFirstMap) {
  Update({0, 0, 1, 1}, 50, 1.0);
  Update({1, 0, 1, 1}, 60, 2.0);
  receiver_.Receive(MapAt(MakeMap(2, 1, 0), 1.0));
  EXPECT_EQ(copy_.cells(), (std::vector<std::int8_t>{0, 60}));
}

TEST_F(MapReceiverTest, KeepsWhatIsAheadOfTheNextMapToo) {
  receiver_.Receive(MapAt(MakeMap(1, 1, 0), 1.0));
  Update({2, 0, 1, 1}, 50, 3.0);
  Update({0, 0, 1, 1}, 60, 4.0);
  receiver_.Receive(MapAt(MakeMap(2, 1, 0), 2.0));
  EXPECT_EQ(copy_.cells(), (std::vector<std::int8_t>{60, 0}));
  receiver_.Receive(MapAt(MakeMap(3, 1, 0), 2.5));
  EXPECT_EQ(copy_.cells(), (std::vector<std::int8_t>{60, 0, 50}));
}

TEST_F(MapReceiverTest, AMapOfTheSameGeometryDropsWhatIsAhead) {
  receiver_.Receive(MapAt(MakeMap(1, 1, 0), 1.0));
  Update({1, 0, 1, 1}, 50, 3.0);
  receiver_.Receive(MapAt(MakeMap(1, 1, 0), 1.5));
  receiver_.Receive(MapAt(MakeMap(2, 1, 0), 2.0));
  EXPECT_EQ(copy_.cells(), (std::vector<std::int8_t>{0, 0}));
}

TEST_F(MapReceiverTest, AnUpdateLeftOrBelowOfAllMapsIsNotKept) {
  receiver_.Receive(MapAt(MakeMap(2, 1, 0), 1.0));
  Update({-1, 0, 2, 1}, 50, 2.0);
  Update({0, -1, 1, 2}, 50, 2.0);
  // Were one kept, this would be too, and come a second time.
  Update({0, 0, 1, 1}, 60, 3.0);
  receiver_.Receive(MapAt(MakeMap(3, 1, 0), 2.0));
  EXPECT_EQ(copy_.cells(), (std::vector<std::int8_t>{0, 0, 0}));
}

TEST_F(MapReceiverTest, KeepsNoMoreThanAHundredOfTheNewest) {
  receiver_.Receive(MapAt(MakeMap(1, 1, 0), 1.0));
  for (int i = 0; i < 101; ++i) Update({1 + i, 0, 1, 1}, 50, 2.0 + i);
  receiver_.Receive(MapAt(MakeMap(102, 1, 0), 1.5));
  std::vector<std::int8_t> expected(102, 50);
  expected[0] = expected[1] = 0;
  EXPECT_EQ(copy_.cells(), expected);
}

TEST_F(MapReceiverTest, UsesNothingOfAnotherFrame) {
  nav_msgs::OccupancyGrid map = MapAt(MakeMap(4, 3, 0), 1.0);
  map.header.frame_id = "odom";
  EXPECT_THROW(receiver_.Receive(map), MessageError);
  EXPECT_EQ(maps_, 0);
  map.header.frame_id = "map";
  receiver_.Receive(map);
  auto update = ToUpdateMessage({0, 0, 1, 1}, {50}, "odom", ros::Time(2.0));
  EXPECT_THROW(receiver_.Receive(update), MessageError);
  EXPECT_TRUE(windows_.empty());
  update.header.frame_id = "/map";
  receiver_.Receive(update);
  EXPECT_EQ(windows_.size(), 1u);
}

TEST_F(MapReceiverTest, AMapThatSaysNothingNewIsNoNews) {
  receiver_.Receive(MapAt(MakeMap(4, 3, 0), 1.0));
  receiver_.Receive(MapAt(MakeMap(4, 3, 0), 2.0));
  EXPECT_EQ(maps_, 1);
  EXPECT_TRUE(windows_.empty());
}

TEST_F(MapReceiverTest, AMapMakesUpForLostUpdates) {
  OccupancyGrid map = MakeMap(4, 3, 0);
  receiver_.Receive(MapAt(map, 1.0));
  map[{1, 2}] = 100;
  map[{2, 1}] = 50;
  receiver_.Receive(MapAt(map, 2.0));
  EXPECT_EQ(maps_, 1);
  ASSERT_EQ(windows_.size(), 1u);
  EXPECT_EQ(windows_[0], cv::Rect(1, 1, 2, 2));
  EXPECT_EQ(copy_.cells(), map.cells());
}

TEST_F(MapReceiverTest, ABrokenMessageChangesNothing) {
  receiver_.Receive(MapAt(MakeMap(4, 3, 0), 1.0));
  map_msgs::OccupancyGridUpdate update =
      ToUpdateMessage({0, 0, 2, 2}, {0, 0, 0}, "map", ros::Time(2.0));
  EXPECT_THROW(receiver_.Receive(update), MessageError);
  update.data = {0, 0, 0, 120};
  EXPECT_THROW(receiver_.Receive(update), MessageError);
  EXPECT_TRUE(windows_.empty());
  Update({0, 0, 1, 1}, 100, 2.0);
  EXPECT_EQ(windows_.size(), 1u);
}

// Whatever is lost, doubled or late on the way, after a whole map the receiver
// has what the publisher has.
TEST_F(MapReceiverTest, EndsUpWithThePublishersMap) {
  std::mt19937 random(5);
  const auto pick = [&random](int count) {
    return static_cast<int>(random() % count);
  };
  OccupancyGrid map = MakeMap(20, 15, kUnknown);
  receiver_.Receive(MapAt(map, 0.5));
  map_msgs::OccupancyGridUpdate late;
  for (int step = 1; step < 2000; ++step) {
    const cv::Point corner(pick(20), pick(15));
    const cv::Rect window(
        corner, cv::Size(1 + pick(20 - corner.x), 1 + pick(15 - corner.y)));
    const auto value = static_cast<std::int8_t>(pick(101));
    for (int y = window.y; y < window.br().y; ++y) {
      for (int x = window.x; x < window.br().x; ++x) map[{x, y}] = value;
    }
    const auto update =
        ToUpdateMessage(window, std::vector<std::int8_t>(window.area(), value),
                        "map", ros::Time(step));
    const bool is_lost = pick(10) == 0;
    if (!is_lost) receiver_.Receive(update);
    if (pick(10) == 0) late = update;
    if (is_lost || pick(20) == 0) {
      receiver_.Receive(MapAt(map, step));
      if (late.width > 0) receiver_.Receive(late);
    }
    ASSERT_EQ(copy_.cells(), map.cells()) << step;
  }
  EXPECT_EQ(maps_, 1);
}

// A map that grows to the right and up while its whole messages lag behind the
// updates: once the last has come, the receiver has what the publisher has.
TEST_F(MapReceiverTest, CatchesUpWithAMapThatGrows) {
  std::mt19937 random(7);
  const auto pick = [&random](int count) {
    return static_cast<int>(random() % count);
  };
  OccupancyGrid map = MakeMap(3, 3, kUnknown);
  receiver_.Receive(MapAt(map, 0.5));
  for (int round = 0; round < 60; ++round) {
    OccupancyGrid grown = MakeMap(map.geometry().width + pick(3),
                                  map.geometry().height + 1, kUnknown);
    for (int y = 0; y < map.geometry().height; ++y) {
      for (int x = 0; x < map.geometry().width; ++x) {
        grown[{x, y}] = map[{x, y}];
      }
    }
    map = grown;
    const double start = 1.0 + 100.0 * round;
    const nav_msgs::OccupancyGrid late = MapAt(map, start);
    const int count = pick(30);
    const int overtaking = count == 0 ? 0 : pick(count + 1);
    for (int i = 0; i < count; ++i) {
      if (i == overtaking) receiver_.Receive(late);
      const cv::Point corner(pick(map.geometry().width),
                             pick(map.geometry().height));
      // The first one shows that the map has grown.
      const cv::Point cell =
          i == 0 ? cv::Point(0, map.geometry().height - 1) : corner;
      const auto value = static_cast<std::int8_t>(pick(101));
      map[{cell.x, cell.y}] = value;
      Update({cell, cv::Size(1, 1)}, value, start + 1.0 + i);
    }
    if (overtaking >= count) receiver_.Receive(late);
    ASSERT_EQ(copy_.geometry(), map.geometry()) << round;
    ASSERT_EQ(copy_.cells(), map.cells()) << round;
  }
}

}  // namespace
}  // namespace vfh_astar
