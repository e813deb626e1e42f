#include "benchmark/carmen_log.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "benchmark/text_lines.h"

namespace vfh_astar {
namespace {

constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();
constexpr int kMostBeams = 100000;
constexpr double kLongestPause = 600.0;  // s between two scans

/// A line that is not as it should be.
class BadLine : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes the blank-separated fields of a line one after the other.
class Fields {
 public:
  explicit Fields(const std::string& line) : at_(line.c_str()) {}

  std::string Word() {
    while (*at_ == ' ' || *at_ == '\t') ++at_;
    const char* const begin = at_;
    while (*at_ != '\0' && *at_ != ' ' && *at_ != '\t') ++at_;
    return {begin, at_};
  }

  double Number(const char* name) {
    const std::string word = Word();
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (!word.empty() && *end == '\0' && std::isfinite(value)) return value;
    throw BadLine(std::string(name) + " is '" + word.substr(0, 40) +
                  "'; expected a finite number");
  }

  Pose2D Pose(const char* x, const char* y, const char* theta) {
    // In this order, which that of arguments is not.
    Pose2D pose;
    pose.x = Number(x);
    pose.y = Number(y);
    pose.theta = Number(theta);
    return pose;
  }

 private:
  const char* at_;
};

struct OdometryLine {
  Pose2D pose;
  double stamp = 0.0;
};

struct ScanLine {
  CarmenScan scan;
  Pose2D odometry;            ///< the second pose triple.
  std::size_t next_odometry;  ///< index of the first ODOM line behind.
};

struct Lines {
  std::vector<OdometryLine> odometry;
  std::vector<ScanLine> scans;
  double laser_offset = 0.0;
};

OdometryLine ParseOdometry(Fields& fields) {
  OdometryLine line;
  line.pose = fields.Pose("x", "y", "theta");
  for (const char* name : {"tv", "rv", "accel"}) fields.Number(name);
  line.stamp = fields.Number("ipc_time");
  return line;
}

ScanLine ParseScan(Fields& fields) {
  const double count = fields.Number("the number of ranges");
  if (count < 2 || count > kMostBeams || count != std::floor(count)) {
    throw BadLine("the number of ranges is " + std::to_string(count) +
                  "; expected a whole number from 2 to " +
                  std::to_string(kMostBeams));
  }
  ScanLine line;
  LaserScan& scan = line.scan.scan;
  const int beams = static_cast<int>(count);
  scan.angle_min = -0.5 * kPi;
  scan.angle_increment = kPi / (beams % 2 == 0 ? beams : beams - 1);
  scan.ranges.reserve(beams);
  for (int i = 0; i < beams; ++i) {
    scan.ranges.push_back(static_cast<float>(fields.Number("a range")));
  }
  line.scan.reference = fields.Pose("x", "y", "theta");
  line.odometry = fields.Pose("odom_x", "odom_y", "odom_theta");
  scan.stamp = fields.Number("ipc_time");
  return line;
}

void ParseLine(const std::string& text, Lines& lines) {
  Fields fields(text);
  const std::string key = fields.Word();
  if (key == "ODOM") {
    lines.odometry.push_back(ParseOdometry(fields));
  } else if (key == "FLASER") {
    ScanLine scan = ParseScan(fields);
    scan.next_odometry = lines.odometry.size();
    lines.scans.push_back(std::move(scan));
  } else if (key == "PARAM" && fields.Word() == "robot_frontlaser_offset") {
    lines.laser_offset = fields.Number("robot_frontlaser_offset");
  }
}

Lines ParseLines(const std::string& file, const TextLines& text) {
  Lines lines;
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    try {
      ParseLine(text.lines[i], lines);
    } catch (const BadLine& error) {
      const bool breaks_off = i + 1 == text.lines.size() && !text.is_complete;
      if (breaks_off) break;
      throw CarmenLogError(file + ":" + std::to_string(i + 1) + ": " +
                           error.what());
    }
  }
  if (lines.scans.size() < 2) {
    throw CarmenLogError(file + ": " + std::to_string(lines.scans.size()) +
                         " FLASER lines; expected at least two");
  }
  return lines;
}

bool IsSame(const Pose2D& a, const Pose2D& b) {
  return a.x == b.x && a.y == b.y && a.theta == b.theta;
}

/// Whether the ODOM line behind a scan is no odometer's; nothing when the lines
/// around the scan cannot tell.
std::optional<bool> IsJump(const Lines& lines, const ScanLine& scan) {
  const std::size_t next = scan.next_odometry;
  if (next == 0 || next >= lines.odometry.size()) return std::nullopt;
  const OdometryLine& before = lines.odometry[next - 1];
  const OdometryLine& behind = lines.odometry[next];
  if (IsSame(before.pose, scan.odometry)) return std::nullopt;
  return IsSame(behind.pose, scan.odometry) && behind.stamp <= before.stamp;
}

bool IsCorrected(const Lines& lines) {
  int jumps = 0;
  int steps = 0;
  for (const ScanLine& scan : lines.scans) {
    const std::optional<bool> is_jump = IsJump(lines, scan);
    if (is_jump) ++(*is_jump ? jumps : steps);
  }
  return jumps > steps;
}

/// The odometry of a corrected log: what the ODOM lines between two scans add.
void ChainOdometry(Lines& lines) {
  Pose2D chain;
  std::size_t next = 0;
  bool is_first_behind_scan = true;
  for (ScanLine& scan : lines.scans) {
    for (; next < scan.next_odometry; ++next) {
      if (!is_first_behind_scan) {
        chain = chain * (lines.odometry[next - 1].pose.Inverse() *
                         lines.odometry[next].pose);
      }
      is_first_behind_scan = false;
    }
    scan.scan.odometry = chain;
    is_first_behind_scan = true;
  }
}

void MarkNoReturns(Lines& lines) {
  float longest = 0.0f;
  for (const ScanLine& line : lines.scans) {
    const std::vector<float>& ranges = line.scan.scan.ranges;
    longest =
        std::max(longest, *std::max_element(ranges.begin(), ranges.end()));
  }
  for (ScanLine& line : lines.scans) {
    LaserScan& scan = line.scan.scan;
    scan.range_max = longest;
    for (float& range : scan.ranges) {
      if (range <= 0.0f || range >= longest) range = kNoReturn;
    }
  }
}

double Duration(const std::vector<CarmenScan>& scans) {
  double sum = 0.0;
  double latest = scans.front().scan.stamp;
  for (const CarmenScan& scan : scans) {
    const double step = scan.scan.stamp - latest;
    if (step > 0.0 && step < kLongestPause) sum += step;
    if (step > 0.0 || step < -kLongestPause) latest = scan.scan.stamp;
  }
  return sum;
}

}  // namespace

CarmenLog ReadCarmenLog(const std::string& file) {
  TextLines text;
  try {
    text = ReadTextLines(file);
  } catch (const std::runtime_error& error) {
    throw CarmenLogError(error.what());
  }
  Lines lines = ParseLines(file, text);
  CarmenLog log;
  log.is_corrected = IsCorrected(lines);
  log.laser_offset = lines.laser_offset;
  if (log.is_corrected) {
    ChainOdometry(lines);
  } else {
    for (ScanLine& line : lines.scans) line.scan.odometry = line.odometry;
  }
  MarkNoReturns(lines);
  for (ScanLine& line : lines.scans) log.scans.push_back(std::move(line.scan));
  log.duration = Duration(log.scans);
  return log;
}

}  // namespace vfh_astar
