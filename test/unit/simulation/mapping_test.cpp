// SLAM and localisation with what the simulated robot senses.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "simulation/mapped_drive.h"
#include "simulation/wall_distance.h"
#include "temporary_folder.h"
#include "vfh_astar/grid/map_file.h"

namespace vfh_astar {
namespace {

constexpr int kOccupied = 65;       // percent
constexpr double kTolerance = 0.1;  // m

World Office() { return LoadWorld(VFH_ASTAR_SOURCE_DIR "/worlds/office.yaml"); }

SlamMapperParameters OfficeParameters() {
  SlamMapperParameters parameters;
  parameters.grid.xmin = -2.0;
  parameters.grid.ymin = -2.0;
  parameters.grid.xmax = 48.0;
  parameters.grid.ymax = 30.0;
  parameters.slam.filter.particles = 5;
  return parameters;
}

/// Once around the corridor from the office's start, and a little on.
std::vector<Eigen::Vector2d> OfficeLoop() {
  return {{6, 22}, {40, 22}, {40, 6}, {6, 6}, {6, 11}};
}

/// @param[in] map_from_world where the world lies in the map.
MappedDrive DriveOffice(const std::string& noise, std::uint32_t seed,
                        const Pose2D& map_from_world = Pose2D()) {
  const World world = Office();
  return {world, FewBeams(noise, seed), OfficeParameters(),
          map_from_world * world.robots.front().pose};
}

/// Counts for each tenth of a metre how often something was hit in it, from
/// near enough to tell, by true poses.
class SeenPlaces {
 public:
  void Add(const Simulation& simulation) {
    constexpr double kNear = 8.0;  // m
    for (const Eigen::Vector2d& hit :
         HitPoints(simulation.scan(0),
                   simulation.TruePose(0) * simulation.laser(0).mount, kNear)) {
      Place& place =
          places_[{std::lround(10.0 * hit.x()), std::lround(10.0 * hit.y())}];
      if (place.count++ == 0) place.first = hit;
    }
  }

  std::vector<Eigen::Vector2d> Often() const {
    constexpr int kOften = 20;
    std::vector<Eigen::Vector2d> places;
    for (const auto& [key, place] : places_) {
      if (place.count >= kOften) places.push_back(place.first);
    }
    return places;
  }

 private:
  struct Place {
    int count = 0;
    Eigen::Vector2d first;  ///< m, a hit in it.
  };

  std::map<std::pair<long, long>, Place> places_;
};

/// The share of occupied cells farther than the tolerance from any surface.
/// @param[in] world_from_map where the map lies in the world.
double ShareOfWrongCells(const OccupancyGrid& map, const World& world,
                         int fewest_occupied,
                         const Pose2D& world_from_map = Pose2D()) {
  int occupied = 0;
  int wrong = 0;
  for (int y = 0; y < map.geometry().height; ++y) {
    for (int x = 0; x < map.geometry().width; ++x) {
      if (map[{x, y}] < kOccupied) continue;
      ++occupied;
      const Eigen::Vector2d place =
          world_from_map * map.geometry().ToWorld({x, y});
      wrong += WallDistance(world, place) > kTolerance ? 1 : 0;
    }
  }
  EXPECT_GT(occupied, fewest_occupied);
  return static_cast<double>(wrong) / occupied;
}

bool HasOccupiedWithin(const OccupancyGrid& map, const Eigen::Vector2d& place,
                       double distance) {
  const Cell centre = map.geometry().ToCell(place);
  const int reach =
      static_cast<int>(std::ceil(distance / map.geometry().resolution));
  for (int y = centre.y - reach; y <= centre.y + reach; ++y) {
    for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
      if (!map.geometry().Contains({x, y}) || map[{x, y}] < kOccupied) continue;
      if ((map.geometry().ToWorld({x, y}) - place).norm() <= distance) {
        return true;
      }
    }
  }
  return false;
}

/// The share of places seen often at which the map has nothing.
double ShareOfMissing(const OccupancyGrid& map, const SeenPlaces& seen,
                      const World& world) {
  int places = 0;
  int missing = 0;
  for (const Eigen::Vector2d& place : seen.Often()) {
    // Where the laser's noise put it is not where the wall is.
    if (WallDistance(world, place) > 0.05) continue;
    ++places;
    missing += HasOccupiedWithin(map, place, kTolerance) ? 0 : 1;
  }
  EXPECT_GT(places, 1000);
  return static_cast<double>(missing) / places;
}

TEST(MappingInSimulation, WallsLieWhereTheyAreAfterALoopOf100Metres) {
  const World world = Office();
  for (const std::uint32_t seed : {1, 2, 3}) {
    MappedDrive drive = DriveOffice("experiment", seed);
    SeenPlaces seen;
    drive.on_scan = [&] { seen.Add(drive.simulation); };
    drive.Follow(OfficeLoop(), 1.4);
    ASSERT_FALSE(drive.simulation.collision(0));
    const OccupancyGrid map = drive.mapper.grid_mapper().Map();
    EXPECT_LT(ShareOfWrongCells(map, world, 5000), 0.01) << seed;
    // Some were seen for a moment only, through doors.
    EXPECT_LT(ShareOfMissing(map, seen, world), 0.03) << seed;
    EXPECT_LT(drive.Error(), kTolerance) << seed;
    EXPECT_FALSE(drive.was_lost) << seed;
  }
}

// Walls that lie along the rows of cells hold a pose; here they do not.
TEST(MappingInSimulation, AMapThatIsTurnedIsRightOnceTheLoopIsClosed) {
  const World world = Office();
  const Pose2D map_from_world(0.013, 0.013, 0.8);
  for (const std::uint32_t seed : {1, 2, 3}) {
    MappedDrive drive = DriveOffice("experiment", seed, map_from_world);
    drive.Follow({{6, 22}, {40, 22}, {40, 6}, {6, 6}, {6, 15}}, 1.4);
    ASSERT_FALSE(drive.simulation.collision(0));
    EXPECT_LT(ShareOfWrongCells(drive.mapper.grid_mapper().Map(), world, 5000,
                                map_from_world.Inverse()),
              0.02)
        << seed;
    const Eigen::Vector2d end =
        (map_from_world.Inverse() * drive.believed).position();
    EXPECT_LT((end - drive.simulation.TruePose(0).position()).norm(),
              kTolerance)
        << seed;
  }
}

TEST(MappingInSimulation, AStandingRobotKeepsItsPose) {
  MappedDrive drive = DriveOffice("experiment", 4);
  drive.Follow({{6, 14}}, 1.0);
  drive.Wait(60.0);
  EXPECT_LT(drive.Error(), 0.05);
  EXPECT_NEAR(drive.believed.theta, drive.simulation.TruePose(0).theta, 0.01);
  EXPECT_LT(ShareOfWrongCells(drive.mapper.grid_mapper().Map(), Office(), 500),
            0.01);
}

/// The office's map as a robot with good odometry makes and saves it.
const OccupancyGrid& SavedOffice() {
  static const OccupancyGrid map = [] {
    const TemporaryFolder folder;
    MappedDrive drive = DriveOffice("clean", 1);
    drive.Follow(OfficeLoop(), 1.4);
    SaveMap(drive.mapper.grid_mapper().Map(), folder.Path("office"));
    return LoadMap(folder.Path("office.yaml"));
  }();
  return map;
}

TEST(MappingInSimulation, AStartThatIsOffIsMendedInASavedMap) {
  const Pose2D start = Office().robots.front().pose;
  for (const Pose2D& off : {Pose2D(0.4, 0.0, 0.2), Pose2D(-0.2, 0.35, -0.2)}) {
    MappedDrive drive = DriveOffice("experiment", 5);
    drive.mapper.SetMap(SavedOffice());
    drive.mapper.SetPose(start * off);
    drive.Wait(0.2);
    EXPECT_LT(drive.Error(), 0.1);
    drive.Follow({{6, 22}, {40, 22}, {40, 17}}, 1.4);
    EXPECT_LT(drive.max_error, 0.15);
    EXPECT_FALSE(drive.was_lost);
  }
}

TEST(MappingInSimulation, AKidnappedRobotKnowsSoonAndCanBeHelped) {
  for (const bool has_map : {false, true}) {
    MappedDrive drive = DriveOffice("experiment", 6);
    if (has_map) drive.mapper.SetMap(SavedOffice());
    drive.Follow({{6, 22}, {12, 22}}, 1.4);
    ASSERT_FALSE(drive.was_lost);
    const std::vector<std::int8_t> before =
        drive.mapper.grid_mapper().Map().cells();
    ASSERT_TRUE(drive.simulation.SetPose(0, {6.0, 9.5, 1.8}));
    drive.Wait(2.0);
    EXPECT_TRUE(drive.mapper.localization().is_lost) << has_map;
    EXPECT_TRUE(drive.mapper.grid_mapper().Map().cells() == before) << has_map;
    drive.mapper.SetPose(drive.simulation.TruePose(0) * Pose2D(0.3, 0.2, 0.15));
    EXPECT_FALSE(drive.mapper.localization().is_lost);
    drive.was_lost = false;
    drive.Wait(0.2);
    drive.max_error = 0.0;
    drive.Follow({{6, 14}, {6, 9}}, 1.0);
    EXPECT_LT(drive.max_error, 0.15) << has_map;
    EXPECT_FALSE(drive.was_lost) << has_map;
  }
}

TEST(MappingInSimulation, ABoxInTheWayIsNoReasonToBeLost) {
  MappedDrive drive = DriveOffice("experiment", 7);
  drive.mapper.SetMap(SavedOffice());
  drive.Follow({{6, 14}}, 1.0);
  const Pose2D pose = drive.simulation.TruePose(0);
  const Pose2D at(pose.position() + 1.2 * pose.heading(), pose.theta);
  ASSERT_TRUE(drive.simulation.Spawn({"box", {MakeBox(at, {1.2, 1.8})}}));
  drive.Wait(5.0);
  EXPECT_FALSE(drive.was_lost);
  EXPECT_TRUE(HasOccupiedWithin(drive.mapper.grid_mapper().Map(),
                                pose.position() + 0.6 * pose.heading(), 0.1));
  ASSERT_TRUE(drive.simulation.Delete("box"));
  drive.Wait(5.0);
  EXPECT_FALSE(drive.was_lost);
  EXPECT_FALSE(HasOccupiedWithin(drive.mapper.grid_mapper().Map(),
                                 pose.position() + 0.6 * pose.heading(), 0.1));
  EXPECT_LT(drive.max_error, 0.1);
}

TEST(MappingInSimulation, ACrowdIsNoReasonToBeLost) {
  World world = Office();
  for (int i = 0; i < 14; ++i) {
    Mover person;
    person.name = "person_" + std::to_string(i);
    person.shape = MakeDisc({0.0, 0.0}, 0.25);
    const double x = 5.6 + 0.8 * (i % 2);
    const double low = 10.5 + 0.4 * i;
    person.keyframes = {{0.0, {x, low}},
                        {4.0 + 0.3 * i, {x, low + 3.0}},
                        {8.0 + 0.6 * i, {x, low}}};
    person.period = 8.0 + 0.6 * i;
    world.movers.push_back(person);
  }
  for (const bool has_map : {false, true}) {
    MappedDrive drive(world, FewBeams("experiment", 8), OfficeParameters(),
                      world.robots.front().pose);
    if (has_map) drive.mapper.SetMap(SavedOffice());
    drive.Wait(25.0);
    EXPECT_FALSE(drive.was_lost) << has_map;
    EXPECT_LT(drive.max_error, 0.1) << has_map;
  }
}

/// Two rooms of 6 by 6 m, a doorway of 2 m between them at x = 3.
World TwoRooms() {
  World world;
  world.obstacles = {
      {"outside", MakeWall({{-3, -3}, {9, -3}, {9, 3}, {-3, 3}}, 0.2, true)},
      {"between_1", MakeWall({{3, -3}, {3, -1}}, 0.2, false)},
      {"between_2", MakeWall({{3, 1}, {3, 3}}, 0.2, false)},
      {"cupboard", {MakeBox({7.5, -1.0, 0.0}, {0.6, 1.2})}}};
  world.robots.push_back({"jackal", {0.0, 0.0, 0.0}});
  return world;
}

TEST(MappingInSimulation, ADoorThatOpensIsNoReasonToBeLost) {
  for (const double distance : {0.8, 2.0}) {
    MappedDrive drive(TwoRooms(), FewBeams("experiment", 9), {}, {});
    ASSERT_TRUE(drive.simulation.Spawn(
        {"door", {MakeBox({3.0, 0.0, 0.0}, {0.1, 2.0})}}));
    drive.Wait(1.0);
    drive.Follow({{3.6 - distance, 0.0}}, 1.0);
    drive.Wait(1.0);
    ASSERT_TRUE(drive.simulation.Delete("door"));
    drive.Wait(3.0);
    EXPECT_FALSE(drive.was_lost) << distance;
    EXPECT_FALSE(
        HasOccupiedWithin(drive.mapper.grid_mapper().Map(), {3.0, 0.0}, 0.3));
    drive.Follow({{6.0, 0.0}}, 1.0);
    EXPECT_FALSE(drive.was_lost) << distance;
    EXPECT_LT(drive.max_error, 0.1) << distance;
  }
}

TEST(MappingInSimulation, AMoverLeavesNoTrail) {
  World world = TwoRooms();
  Mover mover;
  mover.name = "walker";
  mover.shape = MakeDisc({0.0, 0.0}, 0.25);
  mover.keyframes = {{0.0, {2.0, -2.4}},
                     {1.0, {2.0, -2.4}},
                     {6.0, {2.0, 2.4}},
                     {8.0, {0.8, 2.4}},
                     {12.0, {0.8, -2.4}}};
  world.movers.push_back(mover);
  MappedDrive drive(world, FewBeams("experiment", 10), {}, {-1.5, 0.0, 0.0});
  ASSERT_TRUE(drive.simulation.SetPose(0, {-1.5, 0.0, 0.0}));

  std::map<std::pair<int, int>, double> covered;  // s, when a cell was last.
  int hits = 0;                                   // on the mover
  int checked = 0;
  drive.on_scan = [&] {
    const double now = drive.simulation.time();
    const OccupancyGrid map = drive.mapper.grid_mapper().Map();
    const Eigen::Vector2d at = mover.PositionAt(now);
    for (const Eigen::Vector2d& hit : HitPoints(
             drive.simulation.scan(0),
             drive.simulation.TruePose(0) * drive.simulation.laser(0).mount,
             20.0)) {
      hits += (hit - at).norm() < 0.3 ? 1 : 0;
    }
    for (double dy = -0.25; dy <= 0.25; dy += 0.025) {
      for (double dx = -0.25; dx <= 0.25; dx += 0.025) {
        if (std::hypot(dx, dy) > 0.25) continue;
        const Cell cell = map.geometry().ToCell(at + Eigen::Vector2d(dx, dy));
        covered[{cell.x, cell.y}] = now;
      }
    }
    for (const auto& [key, time] : covered) {
      const Cell cell{key.first, key.second};
      const Eigen::Vector2d place = map.geometry().ToWorld(cell);
      // Not what the mover itself hides.
      const Pose2D laser =
          drive.simulation.TruePose(0) * drive.simulation.laser(0).mount;
      const Eigen::Vector2d way = place - laser.position();
      const double along = std::clamp(
          (at - laser.position()).dot(way) / way.squaredNorm(), 0.0, 1.0);
      const bool is_hidden =
          (laser.position() + along * way - at).norm() < 0.35;
      if (is_hidden) covered[key] = now;
      if (now - time < 1.0 || is_hidden) continue;
      ++checked;
      EXPECT_LT(static_cast<int>(map[cell]), 50)
          << "cell at " << place.transpose() << ", time " << now;
    }
  };
  drive.Wait(4.0);
  drive.Follow({{-0.2, 0.3}}, 0.5);
  drive.Wait(6.0);
  EXPECT_GT(hits, 1000);
  EXPECT_GT(checked, 10000);
  EXPECT_FALSE(drive.was_lost);
}

}  // namespace
}  // namespace vfh_astar
