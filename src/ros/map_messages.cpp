#include "vfh_astar/ros/map_messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

constexpr std::size_t kMostAhead = 100;  ///< updates that wait for their map.

void CheckValues(const std::vector<std::int8_t>& values) {
  const auto wrong = std::find_if(
      values.begin(), values.end(),
      [](std::int8_t value) { return value < kUnknown || value > 100; });
  if (wrong != values.end()) {
    throw MessageError("data[" + std::to_string(wrong - values.begin()) +
                       "] is " + std::to_string(*wrong) +
                       "; expected -1 to 100");
  }
}

GridGeometry ToGeometry(const nav_msgs::MapMetaData& info) {
  constexpr std::uint32_t kMaxSide = 100000;
  constexpr float kMinResolution = 0.001f;
  if (!(info.resolution >= kMinResolution) || !std::isfinite(info.resolution)) {
    throw MessageError("info.resolution is " + std::to_string(info.resolution) +
                       "; expected 0.001 m per cell or more");
  }
  if (info.width == 0 || info.width > kMaxSide || info.height == 0 ||
      info.height > kMaxSide) {
    throw MessageError("info has " + std::to_string(info.width) + " x " +
                       std::to_string(info.height) + " cells; expected 1 to " +
                       std::to_string(kMaxSide) + " a side");
  }
  const Pose2D origin = ToPose2D(info.origin);
  if (!origin.IsFinite() || std::abs(origin.theta) > 1e-3) {
    throw MessageError("info.origin is (" + std::to_string(origin.x) + ", " +
                       std::to_string(origin.y) + ", " +
                       std::to_string(origin.theta) +
                       "); expected a finite pose without yaw");
  }
  GridGeometry geometry;
  // The message has it in single precision; 0.05 shall stay 0.05.
  geometry.resolution = std::round(info.resolution * 1e6) / 1e6;
  geometry.origin = origin.position();
  geometry.width = static_cast<int>(info.width);
  geometry.height = static_cast<int>(info.height);
  return geometry;
}

void CheckSize(std::size_t size, std::size_t expected) {
  if (size != expected) {
    throw MessageError(
        "data has " + std::to_string(size) +
        " cells; expected width * height = " + std::to_string(expected));
  }
}

std::vector<std::int8_t> Values(const OccupancyGrid& map,
                                const cv::Rect& window) {
  std::vector<std::int8_t> values;
  values.reserve(window.area());
  for (int y = window.y; y < window.br().y; ++y) {
    const auto row = map.cells().begin() + map.geometry().Index({window.x, y});
    values.insert(values.end(), row, row + window.width);
  }
  return values;
}

// The least window outside of which two maps of one geometry are equal.
cv::Rect Difference(const OccupancyGrid& a, const OccupancyGrid& b) {
  const int width = a.geometry().width;
  int left = width;
  int right = -1;
  int top = -1;
  int bottom = a.geometry().height;
  for (int y = 0; y < a.geometry().height; ++y) {
    const auto first = a.cells().begin() + a.geometry().Index({0, y});
    const auto last = first + width;
    const auto other = b.cells().begin() + b.geometry().Index({0, y});
    const auto from = std::mismatch(first, last, other);
    if (from.first == last) continue;
    const auto to = std::mismatch(std::make_reverse_iterator(last),
                                  std::make_reverse_iterator(first),
                                  std::make_reverse_iterator(other + width));
    left = std::min(left, static_cast<int>(from.first - first));
    right = std::max(right, static_cast<int>(to.first.base() - first) - 1);
    bottom = std::min(bottom, y);
    top = y;
  }
  if (right < 0) return {};
  return {left, bottom, right - left + 1, top - bottom + 1};
}

}  // namespace

OccupancyGrid ToOccupancyGrid(const nav_msgs::OccupancyGrid& message) {
  const GridGeometry geometry = ToGeometry(message.info);
  CheckSize(message.data.size(), geometry.size());
  CheckValues(message.data);
  OccupancyGrid map(geometry, kUnknown);
  map.cells() = message.data;
  return map;
}

nav_msgs::MapMetaData ToMetaDataMessage(const GridGeometry& geometry) {
  nav_msgs::MapMetaData info;
  info.resolution = static_cast<float>(geometry.resolution);
  info.width = geometry.width;
  info.height = geometry.height;
  info.origin = ToPoseMessage({geometry.origin, 0.0});
  return info;
}

nav_msgs::OccupancyGrid ToMapMessage(const OccupancyGrid& map,
                                     const std::string& frame_id,
                                     const ros::Time& stamp) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = frame_id;
  message.header.stamp = stamp;
  message.info = ToMetaDataMessage(map.geometry());
  message.info.map_load_time = stamp;
  message.data = map.cells();
  return message;
}

map_msgs::OccupancyGridUpdate ToUpdateMessage(
    const cv::Rect& window, const std::vector<std::int8_t>& values,
    const std::string& frame_id, const ros::Time& stamp) {
  map_msgs::OccupancyGridUpdate message;
  message.header.frame_id = frame_id;
  message.header.stamp = stamp;
  message.x = window.x;
  message.y = window.y;
  message.width = window.width;
  message.height = window.height;
  message.data = values;
  return message;
}

MapReceiver::MapReceiver(std::string map_frame, TakeMap take_map,
                         TakeWindow take_window)
    : map_frame_(std::move(map_frame)),
      take_map_(std::move(take_map)),
      take_window_(std::move(take_window)) {}

void MapReceiver::Receive(const nav_msgs::OccupancyGrid& message) {
  CheckFrame(message.header.frame_id, map_frame_);
  OccupancyGrid map = ToOccupancyGrid(message);
  stamp_ = message.header.stamp;
  if (!map_ || map.geometry() != map_->geometry()) {
    map_ = std::move(map);
    take_map_(*map_);
    Replay();
    return;
  }
  ahead_.clear();
  const cv::Rect window = Difference(map, *map_);
  if (window.empty()) return;
  map_ = std::move(map);
  take_window_(window, Values(*map_, window));
}

void MapReceiver::Receive(const map_msgs::OccupancyGridUpdate& message) {
  CheckFrame(message.header.frame_id, map_frame_);
  CheckSize(message.data.size(),
            static_cast<std::size_t>(message.width) * message.height);
  CheckValues(message.data);
  const bool fits_any = message.x >= 0 && message.y >= 0;
  if (!fits_any || message.data.empty()) return;
  if (map_ && message.header.stamp <= stamp_) return;
  const bool fits = Fits(message);
  if (!fits || !ahead_.empty()) Keep(message);
  if (fits) Apply(message);
}

bool MapReceiver::Fits(const map_msgs::OccupancyGridUpdate& update) const {
  if (!map_) return false;
  const std::int64_t right = static_cast<std::int64_t>(update.x) + update.width;
  const std::int64_t top = static_cast<std::int64_t>(update.y) + update.height;
  return right <= map_->geometry().width && top <= map_->geometry().height;
}

void MapReceiver::Keep(const map_msgs::OccupancyGridUpdate& update) {
  ahead_.push_back(update);
  // The oldest are the likeliest to be in the map that comes.
  if (ahead_.size() > kMostAhead) ahead_.pop_front();
}

void MapReceiver::Apply(const map_msgs::OccupancyGridUpdate& update) {
  auto value = update.data.begin();
  const int top = update.y + static_cast<int>(update.height);
  for (int y = update.y; y < top; ++y) {
    std::copy(value, value + update.width,
              map_->cells().begin() + map_->geometry().Index({update.x, y}));
    value += update.width;
  }
  take_window_({update.x, update.y, static_cast<int>(update.width),
                static_cast<int>(update.height)},
               update.data);
}

void MapReceiver::Replay() {
  // What does not fit this map either is ahead of the next one.
  for (const auto& update : std::exchange(ahead_, {})) Receive(update);
}

}  // namespace vfh_astar
