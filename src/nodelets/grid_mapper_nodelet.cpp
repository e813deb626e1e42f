#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/GetMap.h>
#include <nodelet/nodelet.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/transform_broadcaster.h>
#include <vfh_astar/LocalizationState.h>
#include <vfh_astar/SaveMap.h>

#include <exception>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "vfh_astar/grid/map_file.h"
#include "vfh_astar/mapping/slam_mapper.h"
#include "vfh_astar/ros/frame_names.h"
#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/map_messages.h"
#include "vfh_astar/ros/ros_parameter_reader.h"
#include "vfh_astar/ros/transformed_scans.h"
#include "vfh_astar/ros/transforms.h"

namespace vfh_astar {
namespace {

struct GridMapperNodeletParameters {
  SlamMapperParameters mapper;
  FrameNames frames;
  std::string map_file;              ///< yaml; empty: the map begins unknown.
  double map_update_interval = 5.0;  ///< s between two whole maps.
  double transform_publish_period = 0.05;  ///< s
  Pose2D initial_pose;  ///< of the robot in the map, at the first scan.

  void Read(ParameterReader& reader) {
    mapper.Read(reader);
    frames.Read(reader);
    reader.Text("map_file", map_file);
    reader.Number("map_update_interval", map_update_interval, 0.1, 3600.0);
    reader.Number("transform_publish_period", transform_publish_period, 0.005,
                  1.0);
    reader.Number("initial_pose_x", initial_pose.x, -1e4, 1e4);
    reader.Number("initial_pose_y", initial_pose.y, -1e4, 1e4);
    reader.Number("initial_pose_a", initial_pose.theta, -10.0, 10.0);
  }
};

}  // namespace

/// Scans and tf in; the map and the transform from map to odom out.
class GridMapperNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    parameters_ =
        ReadParameters<GridMapperNodeletParameters>(getPrivateNodeHandle());
    LoadMapFile();
    Advertise();
    Begin();
    // From here on callbacks come, in another thread than this one.
    Serve();
    Listen();
  }

  void LoadMapFile() {
    if (parameters_.map_file.empty()) return;
    try {
      known_map_ = LoadMap(parameters_.map_file);
    } catch (const MapFileError& error) {
      NODELET_FATAL("%s", error.what());
      throw;
    }
  }

  void Advertise() {
    ros::NodeHandle& node = getNodeHandle();
    map_publisher_ = node.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
    metadata_publisher_ =
        node.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true);
    update_publisher_ =
        node.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 100);
    localization_publisher_ =
        node.advertise<LocalizationState>("localization", 10);
    entropy_publisher_ =
        getPrivateNodeHandle().advertise<std_msgs::Float64>("entropy", 1, true);
  }

  void Serve() {
    ros::NodeHandle& node = getNodeHandle();
    services_ = {
        node.advertiseService("dynamic_map", &GridMapperNodelet::OnGetMap,
                              this),
        node.advertiseService("save_map", &GridMapperNodelet::OnSaveMap, this),
        node.advertiseService("clear_costmaps", &GridMapperNodelet::OnClear,
                              this),
        // Where clients of move_base look for it.
        node.advertiseService("move_base/clear_costmaps",
                              &GridMapperNodelet::OnClear, this)};
  }

  void Listen() {
    ros::NodeHandle& node = getNodeHandle();
    transforms_ = SharedTransforms();
    scans_ = std::make_unique<TransformedScans>(
        node, *transforms_, parameters_.frames.odom_frame,
        [this](const LaserScan& scan, const Pose2D& laser_pose,
               const ros::Time& stamp) { OnScan(scan, laser_pose, stamp); });
    pose_subscriber_ = node.subscribe<geometry_msgs::PoseWithCovarianceStamped>(
        "initialpose", 1,
        [this](const geometry_msgs::PoseWithCovarianceStampedConstPtr& p) {
          OnInitialPose(*p);
        });
    transform_timer_ =
        node.createTimer(ros::Duration(parameters_.transform_publish_period),
                         [this](const ros::TimerEvent&) {
                           // Scans bring their own.
                           if (ros::Time::now() >= transform_stamp_) {
                             PublishTransform(ros::Time::now());
                           }
                         });
    map_timer_ = node.createTimer(
        ros::Duration(parameters_.map_update_interval),
        [this](const ros::TimerEvent&) {
          if (is_map_old_ && map_publisher_.getNumSubscribers() > 0) {
            PublishMap();
          }
        });
    diagnostics_ = std::make_unique<diagnostic_updater::Updater>(
        node, getPrivateNodeHandle(), getName());
    diagnostics_->setHardwareID("none");
    diagnostics_->add("scans", this, &GridMapperNodelet::Diagnose);
    diagnostics_timer_ = node.createWallTimer(
        ros::WallDuration(1.0),
        [this](const ros::WallTimerEvent&) { diagnostics_->force_update(); });
  }

  /// The map as it is before the first scan.
  void Begin() {
    mapper_ = std::make_unique<SlamMapper>(parameters_.mapper,
                                           parameters_.initial_pose);
    if (known_map_) mapper_->SetMap(*known_map_);
    has_pose_ = false;
    stamp_ = ros::Time();
    // Time may begin anew, and the stamps with it.
    transform_stamp_ = ros::Time();
    PublishMap();
  }

  /// @param[in] odom_from_laser when the scan was taken.
  void OnScan(const LaserScan& scan, const Pose2D& odom_from_laser,
              const ros::Time& stamp) {
    if (stamp + ros::Duration(1.0) < stamp_) {
      NODELET_WARN("time went back: the map begins anew");
      Begin();
    }
    const Pose2D odom_from_base = OdomFromBase(stamp);
    const bool was_lost = mapper_->localization().is_lost;
    const int jumps = mapper_->localization().odometry_jumps;
    const MapChange change = mapper_->AddScan(
        scan, odom_from_base.Inverse() * odom_from_laser, odom_from_base);
    has_pose_ = true;
    ++used_scans_;
    Log(was_lost, jumps);
    Publish(change, stamp);
    PublishLocalization(stamp);
  }

  Pose2D OdomFromBase(const ros::Time& stamp) const {
    return ToPose2D(transforms_
                        ->lookupTransform(parameters_.frames.odom_frame,
                                          parameters_.frames.base_frame, stamp)
                        .transform);
  }

  /// Once for each event.
  void Log(bool was_lost, int jumps) {
    const Localization& state = mapper_->localization();
    if (state.is_lost && !was_lost) {
      NODELET_ERROR(
          "localisation lost: of %d hits on the map %.0f %% lie on its walls "
          "and %.0f %% behind them; give a pose with '2D Pose Estimate' unless "
          "it is found again",
          state.agreement.known, 100.0 * state.agreement.near_share(),
          100.0 * state.agreement.pierced_share());
    }
    if (!state.is_lost && was_lost) NODELET_WARN("localisation found again");
    if (state.odometry_jumps > jumps) {
      NODELET_WARN("odometry jumped; the jump is left out");
    }
  }

  void Publish(const MapChange& change, const ros::Time& stamp) {
    if (!change.inserted) return;
    stamp_ = stamp;
    is_map_old_ = true;
    if (change.resized) {
      PublishMap();
    } else if (!change.window.empty()) {
      // Shared, a message is with the other nodelets at once, and so before
      // `localization`; else topics overtake each other.
      update_publisher_.publish(
          boost::make_shared<map_msgs::OccupancyGridUpdate>(ToUpdateMessage(
              change.window, mapper_->grid_mapper().Values(change.window),
              parameters_.frames.map_frame, stamp)));
    }
  }

  /// Before anything that may wait for the map to have the scan.
  void PublishLocalization(const ros::Time& stamp) {
    PublishTransform(stamp);
    const auto message = boost::make_shared<LocalizationState>();
    const Localization& state = mapper_->localization();
    message->header.stamp = stamp;
    message->header.frame_id = parameters_.frames.map_frame;
    message->map_from_odom = ToTransformMessage(mapper_->map_from_odom());
    message->lost = state.is_lost;
    message->near_share = state.agreement.near_share();
    message->pierced_share = state.agreement.pierced_share();
    message->odometry_jumps = state.odometry_jumps;
    localization_publisher_.publish(message);
  }

  void OnInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
    geometry_msgs::PoseStamped pose;
    pose.header = message.header;
    pose.pose = message.pose.pose;
    try {
      mapper_->SetPose(
          PoseInFrame(pose, parameters_.frames.map_frame, *transforms_));
      PublishTransform(ros::Time::now());
    } catch (const std::exception& error) {
      NODELET_ERROR("the initial pose cannot be used: %s", error.what());
    }
  }

  /// @param[in] stamp of what the transform follows from.
  void PublishTransform(const ros::Time& stamp) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parameters_.frames.map_frame;
    // It holds until the next one comes, as gmapping's does.
    transform.header.stamp =
        stamp + ros::Duration(parameters_.transform_publish_period);
    // tf warns about a second transform of the same time, and one that is older
    // than the newest is of no use.
    if (!has_pose_ || transform.header.stamp <= transform_stamp_) return;
    transform_stamp_ = transform.header.stamp;
    transform.child_frame_id = parameters_.frames.odom_frame;
    transform.transform = ToTransformMessage(mapper_->map_from_odom());
    broadcaster_.sendTransform(transform);
  }

  void PublishMap() {
    const nav_msgs::OccupancyGridPtr map =
        boost::make_shared<nav_msgs::OccupancyGrid>(
            ToMapMessage(mapper_->grid_mapper().Map(),
                         parameters_.frames.map_frame, stamp_));
    map_publisher_.publish(map);
    metadata_publisher_.publish(map->info);
    if (entropy_publisher_.getNumSubscribers() > 0) {
      std_msgs::Float64 entropy;
      entropy.data = mapper_->grid_mapper().Entropy();
      entropy_publisher_.publish(entropy);
    }
    is_map_old_ = false;
  }

  bool OnGetMap(nav_msgs::GetMap::Request&,
                nav_msgs::GetMap::Response& answer) {
    answer.map = ToMapMessage(mapper_->grid_mapper().Map(),
                              parameters_.frames.map_frame, stamp_);
    return true;
  }

  bool OnSaveMap(SaveMap::Request& request, SaveMap::Response& answer) {
    try {
      vfh_astar::SaveMap(mapper_->grid_mapper().Map(), request.stem);
      answer.success = true;
      answer.message =
          "wrote " + request.stem + ".yaml and " + request.stem + ".pgm";
    } catch (const MapFileError& error) {
      answer.message = error.what();
    }
    return true;
  }

  /// What was seen is forgotten, as by move_base; what is still there comes
  /// back with the next scans.
  bool OnClear(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
    mapper_->Forget();
    PublishMap();
    return true;
  }

  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    using diagnostic_msgs::DiagnosticStatus;
    if (used_scans_ == 0) {
      status.summary(DiagnosticStatus::WARN, "no scan used yet");
    } else if (mapper_->localization().is_lost) {
      status.summary(DiagnosticStatus::ERROR, "localisation lost");
    } else {
      status.summary(DiagnosticStatus::OK, "mapping");
    }
    status.add("localisation", parameters_.mapper.localization);
    status.add("hits on the map's walls [%]",
               100.0 * mapper_->localization().agreement.near_share());
    status.add("odometry jumps left out",
               mapper_->localization().odometry_jumps);
    status.add("scans used", used_scans_);
    status.add("scans dropped, no transform", scans_->late());
    status.add("scans dropped, unusable", scans_->unusable());
    status.add("map width [cells]", mapper_->grid_mapper().geometry().width);
    status.add("map height [cells]", mapper_->grid_mapper().geometry().height);
  }

  GridMapperNodeletParameters parameters_;
  std::optional<OccupancyGrid> known_map_;
  std::unique_ptr<SlamMapper> mapper_;
  bool has_pose_ = false;      ///< from a scan.
  ros::Time transform_stamp_;  ///< of the one published last.
  ros::Time stamp_;            ///< of the newest scan in the map.
  bool is_map_old_ = false;    ///< more is known than was published whole.
  int used_scans_ = 0;

  std::shared_ptr<const tf2_ros::Buffer> transforms_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
  ros::Publisher map_publisher_;
  ros::Publisher metadata_publisher_;
  ros::Publisher update_publisher_;
  ros::Publisher localization_publisher_;
  ros::Publisher entropy_publisher_;
  std::vector<ros::ServiceServer> services_;
  ros::Timer transform_timer_;
  ros::Timer map_timer_;
  ros::WallTimer diagnostics_timer_;
  std::unique_ptr<TransformedScans> scans_;
  ros::Subscriber pose_subscriber_;
};

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::GridMapperNodelet, nodelet::Nodelet)
