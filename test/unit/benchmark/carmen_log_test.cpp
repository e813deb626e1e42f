#include "benchmark/carmen_log.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <string>

#include "benchmark/trajectory_error.h"
#include "shared_data.h"
#include "temporary_folder.h"

namespace vfh_astar {
namespace {

std::string ErrorOf(const std::string& file) {
  try {
    ReadCarmenLog(file);
  } catch (const CarmenLogError& error) {
    return error.what();
  }
  return "";
}

void ExpectPose(const Pose2D& pose, double x, double y, double theta) {
  EXPECT_NEAR(pose.x, x, 1e-9);
  EXPECT_NEAR(pose.y, y, 1e-9);
  EXPECT_NEAR(pose.theta, theta, 1e-9);
}

const char kPlain[] =
    "# message formats defined: PARAM SYNC ODOM FLASER\n"
    "PARAM robot_frontlaser_offset 0.25 nohost 0\n"
    "ODOM 0 0 0 0 0 0 1.0 host 1.0\n"
    "FLASER 4 1 2 3 81.83 0.35 0 0 0.1 0 0 1.1 host 1.1\n"
    "ODOM 0.2 0 0 0 0 0 1.2 host 1.2\n"
    "FLASER 4 1 2 0 81.83 1.25 0 0 1.0 0 0 2.1 host 2.1\n"
    "ODOM 1.1 0 0 0 0 0 2.2 host 2.2\n";

// The odometer always says 0.5 m ahead; the corrected pose lies elsewhere.
const char kCorrected[] =
    "ODOM 0 0 0 0 0 0 1.0 host 1.0\n"
    "ODOM 0.5 0 0 0 0 0 2.0 host 2.0\n"
    "FLASER 2 1 2 0.4 0.1 0 0.4 0.1 0 2.0 host 2.0\n"
    "ODOM 0.4 0.1 0 0 0 0 0 host 0\n"
    "NEFF 15\n"
    "ODOM 0.9 0.1 0 0 0 0 3.0 host 3.0\n"
    "FLASER 2 1 2 7 8 1.5 7 8 1.5 3.0 host 3.0\n"
    "ODOM 7 8 1.5 0 0 0 0 host 0\n"
    "ODOM 7 8.5 1.5 0 0 0 4.0 host 4.0\n"
    "FLASER 2 1 2.5 7 8 0 7 8 0 4.0 host 4.0\n";

TEST(CarmenLog, ReadsAPlainLogsOdometryFromItsScans) {
  const TemporaryFolder folder;
  const CarmenLog log = ReadCarmenLog(folder.Write("a.log", kPlain));
  EXPECT_FALSE(log.is_corrected);
  EXPECT_DOUBLE_EQ(log.laser_offset, 0.25);
  ASSERT_EQ(log.scans.size(), 2u);
  ExpectPose(log.scans[0].odometry, 0.1, 0.0, 0.0);
  ExpectPose(log.scans[1].odometry, 1.0, 0.0, 0.0);
  ExpectPose(log.scans[1].reference, 1.25, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(log.duration, 1.0);
}

TEST(CarmenLog, BeamsSpanTheHalfCircleAndSomeSeeNothing) {
  const TemporaryFolder folder;
  const CarmenLog log = ReadCarmenLog(folder.Write("a.log", kPlain));
  const LaserScan& scan = log.scans[1].scan;
  EXPECT_DOUBLE_EQ(scan.angle_min, -0.5 * kPi);
  EXPECT_DOUBLE_EQ(scan.angle_increment, 0.25 * kPi);
  EXPECT_DOUBLE_EQ(scan.stamp, 2.1);
  ASSERT_EQ(scan.ranges.size(), 4u);
  EXPECT_EQ(scan.ranges[1], 2.0f);
  EXPECT_TRUE(std::isnan(scan.ranges[2]));
  EXPECT_TRUE(std::isnan(scan.ranges[3]));
}

TEST(CarmenLog, LeavesOutTheJumpsOntoCorrectedPoses) {
  const TemporaryFolder folder;
  const CarmenLog log = ReadCarmenLog(folder.Write("a.log", kCorrected));
  EXPECT_TRUE(log.is_corrected);
  ASSERT_EQ(log.scans.size(), 3u);
  ExpectPose(log.scans[0].odometry, 0.5, 0.0, 0.0);
  ExpectPose(log.scans[1].odometry, 1.0, 0.0, 0.0);
  // 0.5 m along y, seen from a robot that looks along 1.5 rad.
  ExpectPose(log.scans[2].odometry, 1.0 + 0.5 * std::sin(1.5),
             0.5 * std::cos(1.5), 0.0);
  ExpectPose(log.scans[1].reference, 7.0, 8.0, 1.5);
}

TEST(CarmenLog, AnOdometerMayRepeatAScansPose) {
  // A logger that writes the scan before the odometry of the same moment: what
  // lies between is driven, not jumped.
  const TemporaryFolder folder;
  const CarmenLog log =
      ReadCarmenLog(folder.Write("a.log",
                                 "ODOM 0 0 0 0 0 0 1.0 host 1.0\n"
                                 "FLASER 2 1 2 1 0 0 1 0 0 2.0 host 2.0\n"
                                 "ODOM 1 0 0 0 0 0 2.0 host 2.0\n"
                                 "FLASER 2 1 2 2 0 0 2 0 0 3.0 host 3.0\n"
                                 "ODOM 2 0 0 0 0 0 3.0 host 3.0\n"));
  EXPECT_FALSE(log.is_corrected);
  ExpectPose(log.scans[1].odometry, 2.0, 0.0, 0.0);
}

TEST(CarmenLog, ALastLineMayBreakOff) {
  const TemporaryFolder folder;
  const std::string cut = std::string(kPlain) + "FLASER 4 1 2 3.";
  EXPECT_EQ(ReadCarmenLog(folder.Write("a.log", cut)).scans.size(), 2u);
  const std::string file = folder.Path("b.log.gz");
  const gzFile stream = gzopen(file.c_str(), "wb");
  gzwrite(stream, cut.data(), cut.size());
  gzclose(stream);
  EXPECT_EQ(ReadCarmenLog(file).scans.size(), 2u);
}

TEST(CarmenLog, SaysWhatIsWrongAndWhere) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& line) {
    return ErrorOf(folder.Write("bad.log", std::string(kPlain) + line + "\n"));
  };
  EXPECT_NE(error("FLASER 4 1 2 3").find("bad.log:8: a range is ''"),
            std::string::npos);
  EXPECT_NE(error("FLASER 2 1 nan 0 0 0 0 0 0 1 h 1")
                .find(":8: a range is 'nan'; expected a finite number"),
            std::string::npos);
  EXPECT_NE(error("FLASER 1.5 1").find("expected a whole number from 2"),
            std::string::npos);
  EXPECT_NE(error("ODOM 1 2 x").find("theta is 'x'"), std::string::npos);
  EXPECT_NE(ErrorOf(folder.Write("none.log", "ODOM 0 0 0 0 0 0 1 h 1\n"))
                .find("0 FLASER lines; expected at least two"),
            std::string::npos);
  EXPECT_NE(ErrorOf(folder.Path("absent.log")).find("absent.log: cannot be"),
            std::string::npos);
}

TEST(CarmenLog, BrokenStampsDoNotStretchTheLog) {
  const TemporaryFolder folder;
  std::string text;
  for (const char* stamp : {"10", "12", "11.5", "0", "13", "99999", "15"}) {
    text += std::string("FLASER 2 1 2 0 0 0 0 0 0 ") + stamp + " h 0\n";
  }
  EXPECT_NEAR(ReadCarmenLog(folder.Write("a.log", text)).duration, 3.0, 1e-9);
}

TEST(CarmenLog, RawOdometryOfTheRealLogsIsAsFarOffAsItIsKnownToBe) {
  const auto drift = [](const std::string& file) {
    const CarmenLog log = ReadCarmenLog(file);
    EXPECT_TRUE(log.is_corrected);
    std::vector<Pose2D> odometry;
    std::vector<Pose2D> reference;
    for (const CarmenScan& scan : log.scans) {
      odometry.push_back(scan.odometry);
      reference.push_back(scan.reference);
    }
    return AlignedError(odometry, reference);
  };
  const std::string intel = SharedData("slam/intel-corrected.log.gz");
  VFH_ASTAR_SKIP_WITHOUT(intel);
  EXPECT_NEAR(drift(intel), 24.0, 0.5);
  EXPECT_NEAR(drift(SharedData("slam/aces-corrected.log.gz")), 5.4, 0.5);
}

}  // namespace
}  // namespace vfh_astar
