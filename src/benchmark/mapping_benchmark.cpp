#include "benchmark/mapping_benchmark.h"

#include <cmath>
#include <ctime>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "benchmark/carmen_log.h"
#include "benchmark/relations_file.h"
#include "vfh_astar/mapping/log_odds_grid.h"
#include "vfh_astar/mapping/scan_inserter.h"
#include "vfh_astar/mapping/slam.h"

namespace vfh_astar {
namespace {

struct SlamResult {
  std::vector<Pose2D> base_poses;  ///< one per scan of the log.
  LogOddsGrid map;
  double cpu_s = 0.0;
};

double ProcessorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// m that odometry drove, turns counted in, from scan to scan.
double Driven(const CarmenLog& log, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    const Pose2D step =
        log.scans[i].odometry.Inverse() * log.scans[i + 1].odometry;
    sum += step.position().norm() + std::abs(step.theta);
  }
  return sum;
}

/// Gives the scans from `first` on, up to the one before `last`, their places
/// by odometry; what it misses the pose of `last` by is spread over the way.
void PlaceBetween(const CarmenLog& log, std::size_t first, std::size_t last,
                  std::vector<Pose2D>& poses) {
  const auto by_odometry = [&](std::size_t i) {
    return poses[first] *
           (log.scans[first].odometry.Inverse() * log.scans[i].odometry);
  };
  const Pose2D missed = by_odometry(last).Inverse() * poses[last];
  const double whole = Driven(log, first, last);
  for (std::size_t i = first + 1; i < last; ++i) {
    const double part = whole > 0.0 ? Driven(log, first, i) / whole : 0.0;
    poses[i] = by_odometry(i) *
               Pose2D(part * missed.x, part * missed.y, part * missed.theta);
  }
}

std::vector<Pose2D> PlaceAll(const CarmenLog& log, const Slam& slam,
                             const std::vector<std::size_t>& used) {
  std::vector<Pose2D> poses(log.scans.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    poses[used[i]] = slam.trajectory()[i];
    if (i > 0) PlaceBetween(log, used[i - 1], used[i], poses);
  }
  for (std::size_t i = used.back() + 1; i < poses.size(); ++i) {
    poses[i] = slam.PoseAt(log.scans[i].odometry);
  }
  return poses;
}

SlamResult RunSlam(const CarmenLog& log, const Pose2D& base_from_laser,
                   const MappingBenchmarkOptions& options) {
  SlamParameters parameters;
  parameters.filter.particles = options.particles;
  parameters.loop_closure = options.loop_closure;
  const double begin = ProcessorSeconds();
  Slam slam(parameters, options.seed);
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    const CarmenScan& scan = log.scans[i];
    if (slam.AddScan(scan.scan, base_from_laser, scan.odometry)) {
      used.push_back(i);
    }
  }
  slam.Finish();
  SlamResult result;
  result.base_poses = PlaceAll(log, slam, used);
  GridGeometry geometry;
  result.map = LogOddsGrid(geometry);
  ScanInserter inserter{ScanInserterParameters()};
  for (const std::size_t i : used) {
    if (DescribeDefect(log.scans[i].scan)) continue;
    inserter.Insert(log.scans[i].scan, result.base_poses[i] * base_from_laser,
                    result.map);
  }
  result.cpu_s = ProcessorSeconds() - begin;
  return result;
}

void WritePicture(const LogOddsGrid& map, const std::string& file) {
  const GridGeometry& geometry = map.geometry();
  constexpr std::uint8_t kUnexploredGrey = 205;
  cv::Mat picture(std::max(1, geometry.height), std::max(1, geometry.width),
                  CV_8U, cv::Scalar(kUnexploredGrey));
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const double probability = map.Probability({x, y});
      if (probability < 0.0) continue;
      picture.at<std::uint8_t>(geometry.height - 1 - y, x) =
          static_cast<std::uint8_t>(std::lround(254.0 * (1.0 - probability)));
    }
  }
  bool is_written = false;
  try {
    is_written = cv::imwrite(file, picture);
  } catch (const cv::Exception&) {
    // An unknown ending; told below like every other cause.
  }
  if (!is_written) {
    throw std::runtime_error(
        file +
        ": cannot be written; expected a writable place and a name "
        "that ends in .png");
  }
}

}  // namespace

MappingFigures RunMappingBenchmark(const MappingBenchmarkOptions& options) {
  const CarmenLog log = ReadCarmenLog(options.log);
  const Pose2D base_from_laser(log.laser_offset, 0.0, 0.0);
  std::vector<Pose2D> reference;
  std::vector<double> stamps;
  for (const CarmenScan& scan : log.scans) {
    reference.push_back(scan.reference);
    stamps.push_back(scan.scan.stamp + options.time_offset);
  }
  // Read before the work is done, so that a bad file is told at once.
  const std::vector<PoseRelation> relations =
      options.relations.empty() ? ConsecutiveRelations(reference)
                                : ReadRelations(options.relations, stamps);
  const SlamResult slam = RunSlam(log, base_from_laser, options);
  std::vector<Pose2D> laser_poses;
  for (const Pose2D& pose : slam.base_poses) {
    laser_poses.push_back(pose * base_from_laser);
  }
  MappingFigures figures;
  figures.errors = CompareRelations(laser_poses, relations);
  figures.aligned_error = AlignedError(laser_poses, reference);
  figures.relations = static_cast<int>(relations.size());
  figures.scans = static_cast<int>(log.scans.size());
  figures.log_s = log.duration;
  figures.cpu_s = slam.cpu_s;
  if (!options.map_picture.empty()) {
    WritePicture(slam.map, options.map_picture);
  }
  return figures;
}

}  // namespace vfh_astar
