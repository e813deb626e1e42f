"""Listens to a running stack and keeps what it sees in a DriveRecord."""

import math
import threading

import numpy as np
import rospy
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from rosgraph.names import ns_join
from std_msgs.msg import Float64

from driver.drive_record import GridMap, PoseSample, StateSample

# Nothing of a drive may be lost while a large map is read: some seconds on a busy
# machine.
_LONG_QUEUE = 2000


def yaw_of(orientation):
    """rad, of a geometry_msgs/Quaternion that turns about z."""
    return 2.0 * math.atan2(orientation.z, orientation.w)


class Observer:
    """Fills the record that is set; only the map and the newest pose are kept
    without one. All topics are relative, as the stack's are."""

    def __init__(self, plan_topic="plan", map_pose=(0.0, 0.0, 0.0),
                 namespace=""):
        """map_pose: the frame of the stack's map and plans in the world; m, rad.
        namespace: the robot's, where there are several; relative.
        """
        self._map_pose = map_pose
        self._namespace = namespace
        self._lock = threading.Lock()
        self._record = None
        self._map = None
        self._contacts = []  # since the simulation began
        self.last_pose = None
        self.last_speed = 0.0  # m/s, ground truth
        self.last_state = None
        self._subscribe("map", OccupancyGrid, self._on_map, 5)
        self._subscribe("map_updates", OccupancyGridUpdate,
                        self._on_map_update, 100)
        self._subscribe("ground_truth/odom", Odometry, self._on_ground_truth,
                        _LONG_QUEUE)
        self._subscribe("clearance", Float64, self._on_clearance, _LONG_QUEUE)
        self._subscribe(plan_topic, Path, self._on_plan, 20)
        self._subscribe("trajectory_path", Path, self._on_trajectory, 20)
        self._subscribe_own_messages()

    def _subscribe_own_messages(self):
        # Generated in the workspace, which has to be sourced before.
        from vfh_astar.msg import CollisionReport, NavigationState
        self._subscribe("collision", CollisionReport, self._on_collision, 10)
        self._subscribe("navigation_state", NavigationState, self._on_state,
                        _LONG_QUEUE)

    def topic(self, name):
        """The name with the robot's namespace before it."""
        return ns_join(self._namespace, name)

    def in_map(self, pose):
        """The stack's map's x, y (m), yaw (rad) of a pose in the world."""
        x, y, yaw = self._map_pose
        dx, dy = pose[0] - x, pose[1] - y
        cosine, sine = math.cos(yaw), math.sin(yaw)
        return (cosine * dx + sine * dy, cosine * dy - sine * dx, pose[2] - yaw)

    def _subscribe(self, topic, message_type, callback, queue_size):
        rospy.Subscriber(self.topic(topic), message_type, callback,
                         queue_size=queue_size)

    def begin(self, record):
        with self._lock:
            self._record = record

    def finish(self):
        """The record gets the map and the contacts, and nothing more after."""
        with self._lock:
            if self._record is not None:
                self._record.map = self._map
                self._record.contacts = list(self._contacts)
            self._record = None

    def _on_map(self, message):
        info = message.info
        cells = np.array(message.data, dtype=np.int8)
        with self._lock:
            self._map = GridMap(
                info.resolution,
                (info.origin.position.x, info.origin.position.y),
                cells.reshape(info.height, info.width), self._map_pose)

    def _on_map_update(self, update):
        values = np.array(update.data, dtype=np.int8)
        with self._lock:
            if self._map is None:
                return
            window = self._map.cells[update.y:update.y + update.height,
                                     update.x:update.x + update.width]
            # A window of the geometry before a resize does not fit any more.
            if window.shape == (update.height, update.width):
                window[:] = values.reshape(window.shape)

    def has_map(self):
        with self._lock:
            return self._map is not None

    def _on_ground_truth(self, odometry):
        pose, twist = odometry.pose.pose, odometry.twist.twist
        sample = PoseSample(odometry.header.stamp.to_sec(), pose.position.x,
                            pose.position.y, yaw_of(pose.orientation),
                            twist.linear.x, twist.angular.z)
        with self._lock:
            self.last_pose = sample
            self.last_speed = twist.linear.x
            if self._record is not None:
                self._record.poses.append(sample)

    def _on_clearance(self, message):
        with self._lock:
            if self._record is not None:
                self._record.least_clearance = min(
                    self._record.least_clearance, message.data)

    def _on_collision(self, report):
        with self._lock:
            if report.collided:
                self._contacts.append(report.touched)

    def _on_state(self, message):
        sample = StateSample(
            message.header.stamp.to_sec(), message.state, message.reason,
            (message.error_x, message.error_y, message.error_theta),
            message.clearance, message.speed, message.distance_to_goal)
        with self._lock:
            self.last_state = sample
            if self._record is not None:
                self._record.states.append(sample)

    def _points(self, path):
        """N x 2, in the world."""
        points = np.array([(p.pose.position.x, p.pose.position.y)
                           for p in path.poses])
        x, y, yaw = self._map_pose
        cosine, sine = math.cos(yaw), math.sin(yaw)
        return points @ np.array([(cosine, sine), (-sine, cosine)]) + (x, y)

    def _on_plan(self, path):
        if path.poses:
            with self._lock:
                if self._record is not None:
                    self._record.plans.append(self._points(path))
                    self._record.plan_times.append(rospy.get_time())

    def _on_trajectory(self, path):
        if path.poses:
            with self._lock:
                if self._record is not None:
                    self._record.trajectories.append(self._points(path))
                    self._record.trajectory_times.append(rospy.get_time())
