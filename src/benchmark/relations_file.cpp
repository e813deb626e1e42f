#include "benchmark/relations_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "benchmark/text_lines.h"

namespace vfh_astar {
namespace {

constexpr double kTolerance = 0.1;  // s

/// The poses by their times; stamps may be out of order.
class PosesByTime {
 public:
  explicit PosesByTime(const std::vector<double>& stamps) {
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      poses_.push_back({stamps[i], i});
    }
    std::sort(poses_.begin(), poses_.end());
  }

  std::optional<std::size_t> Nearest(double time) const {
    const auto behind = std::lower_bound(
        poses_.begin(), poses_.end(), std::pair<double, std::size_t>(time, 0));
    std::optional<std::size_t> nearest;
    double least = kTolerance;
    const auto consider = [&](const std::pair<double, std::size_t>& pose) {
      const double distance = std::abs(pose.first - time);
      if (distance > least) return;
      least = distance;
      nearest = pose.second;
    };
    if (behind != poses_.begin()) consider(*(behind - 1));
    if (behind != poses_.end()) consider(*behind);
    return nearest;
  }

 private:
  std::vector<std::pair<double, std::size_t>> poses_;
};

/// The eight numbers of a line, or nothing.
std::optional<std::array<double, 8>> ParseNumbers(const std::string& line) {
  std::istringstream fields(line);
  std::array<double, 8> numbers;
  for (double& number : numbers) {
    if (!(fields >> number) || !std::isfinite(number)) return std::nullopt;
  }
  std::string rest;
  if (fields >> rest) return std::nullopt;
  return numbers;
}

}  // namespace

std::vector<PoseRelation> ReadRelations(const std::string& file,
                                        const std::vector<double>& stamps) {
  TextLines text;
  try {
    text = ReadTextLines(file);
  } catch (const std::runtime_error& error) {
    throw RelationsError(error.what());
  }
  const PosesByTime poses(stamps);
  std::vector<PoseRelation> relations;
  int read = 0;
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    const std::string& line = text.lines[i];
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#') continue;
    const auto numbers = ParseNumbers(line);
    if (!numbers) {
      if (i + 1 == text.lines.size() && !text.is_complete) break;
      throw RelationsError(file + ":" + std::to_string(i + 1) + ": '" +
                           line.substr(0, 80) +
                           "'; expected t1 t2 x y z roll pitch yaw");
    }
    ++read;
    const auto [t1, t2, x, y, z, roll, pitch, yaw] = *numbers;
    const auto from = poses.Nearest(t1);
    const auto to = poses.Nearest(t2);
    if (from && to) {
      relations.push_back({*from, *to, {x, y, NormalizeAngle(yaw)}});
    }
  }
  if (relations.empty()) {
    throw RelationsError(file + ": none of its " + std::to_string(read) +
                         " relations is between times of the log's scans; "
                         "expected one at least (see --time-offset)");
  }
  return relations;
}

}  // namespace vfh_astar
