#ifndef VFH_ASTAR_ROS_MAP_MESSAGES_H_
#define VFH_ASTAR_ROS_MAP_MESSAGES_H_

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/time.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// @throws MessageError for a map without cells or resolution, one that is
///   turned, and one whose data has another size than its width and height say
///   or values that are not -1 to 100.
OccupancyGrid ToOccupancyGrid(const nav_msgs::OccupancyGrid& message);

nav_msgs::MapMetaData ToMetaDataMessage(const GridGeometry& geometry);

/// @param[in] stamp of the newest scan in the map; see MapReceiver.
nav_msgs::OccupancyGrid ToMapMessage(const OccupancyGrid& map,
                                     const std::string& frame_id,
                                     const ros::Time& stamp);

/// @param[in] values of the window, row by row.
map_msgs::OccupancyGridUpdate ToUpdateMessage(
    const cv::Rect& window, const std::vector<std::int8_t>& values,
    const std::string& frame_id, const ros::Time& stamp);

/// Keeps a map up to date from `map` and `map_updates`, and passes on what
/// changes.
///
/// The two topics come in any order. Both carry the stamp of the newest scan in
/// them, so an update that is not newer than the map is contained in it and
/// dropped; and as the publisher sends no update with a new geometry before the
/// map that has it, an update that does not fit belongs to a map that is yet to
/// come. It and those after it are kept, and those that the map does not
/// contain are applied to it when it comes. A whole map that repeats what is
/// known already passes as the window that differs, if any does.
class MapReceiver {
 public:
  using TakeMap = std::function<void(const OccupancyGrid&)>;
  using TakeWindow =
      std::function<void(const cv::Rect&, const std::vector<std::int8_t>&)>;

  /// @param[in] map_frame that the messages have to be in.
  /// @param[in] take_map called with a map of a new geometry.
  /// @param[in] take_window called with a window of the last map given to
  ///   take_map and its values row by row.
  MapReceiver(std::string map_frame, TakeMap take_map, TakeWindow take_window);

  /// @throws MessageError for a map that cannot be used or is in another frame;
  ///   the old one stays.
  void Receive(const nav_msgs::OccupancyGrid& message);

  /// @throws MessageError for an update whose data does not fill its window and
  ///   for one in another frame.
  void Receive(const map_msgs::OccupancyGridUpdate& message);

 private:
  bool Fits(const map_msgs::OccupancyGridUpdate& update) const;
  void Keep(const map_msgs::OccupancyGridUpdate& update);
  void Apply(const map_msgs::OccupancyGridUpdate& update);
  void Replay();

  std::string map_frame_;
  TakeMap take_map_;
  TakeWindow take_window_;
  std::optional<OccupancyGrid> map_;
  ros::Time stamp_;  ///< of the newest whole map.
  /// The first update that did not fit and all after it, oldest first.
  std::deque<map_msgs::OccupancyGridUpdate> ahead_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_MAP_MESSAGES_H_
