"""A robot of a few lines in an empty square room, for tests that have to send
what no simulator sends: broken scans, missing transforms.

It has the clock too, at the wall's pace, obeys cmd_vel at once and never slips.
"""

import math
import threading
import time

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan

_STEP = 0.01  # s
_STEPS_PER_SCAN = 4
_STEPS_PER_ODOMETRY = 2
_COMMAND_TIMEOUT = 0.25  # s, the Jackal's
_BEAMS = 360
_ROOM = 10.0  # m, side of the room; the robot starts in its middle
_FRONT_LASER_X = 0.055  # m in base_link


def _transform(stamp, parent, child, x, y, yaw):
    transform = TransformStamped()
    transform.header.stamp = stamp
    transform.header.frame_id = parent
    transform.child_frame_id = child
    transform.transform.translation.x = x
    transform.transform.translation.y = y
    transform.transform.rotation.z = math.sin(yaw / 2.0)
    transform.transform.rotation.w = math.cos(yaw / 2.0)
    return transform


def _distance_to_wall(x, y, angle):
    """m along a ray from inside the room."""
    half = _ROOM / 2.0
    cosine, sine = math.cos(angle), math.sin(angle)
    along_x = ((math.copysign(half, cosine) - x) / cosine
               if abs(cosine) > 1e-9 else math.inf)
    along_y = ((math.copysign(half, sine) - y) / sine
               if abs(sine) > 1e-9 else math.inf)
    return min(along_x, along_y)


class KinematicRobot:
    """Runs from start() to stop(). alter_scan, when set, is called with every
    scan before it is published; publishes_odometry_frame says whether tf has
    odom -> base_link."""

    def __init__(self):
        self.alter_scan = None
        self.publishes_odometry_frame = True
        self.x = self.y = self.yaw = 0.0
        self._command = Twist()
        self._command_time = -math.inf
        self._time = 1.0
        self._running = False
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self._scans = rospy.Publisher("front/scan", LaserScan, queue_size=10)
        self._odometry = rospy.Publisher("odometry/filtered", Odometry,
                                         queue_size=10)
        self._transforms = tf2_ros.TransformBroadcaster()
        self._static_transforms = tf2_ros.StaticTransformBroadcaster()
        rospy.Subscriber("cmd_vel", Twist, self._on_command)

    def start(self):
        self._static_transforms.sendTransform(_transform(
            rospy.Time(0), "base_link", "front_laser", _FRONT_LASER_X, 0.0, 0.0))
        self._running = True
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def stop(self):
        self._running = False
        self._thread.join()

    def _on_command(self, command):
        self._command = command
        self._command_time = self._time

    def _run(self):
        step = 0
        next_step = time.monotonic()
        while self._running and not rospy.is_shutdown():
            self._move()
            stamp = rospy.Time.from_sec(self._time)
            self._clock.publish(Clock(stamp))
            if step % _STEPS_PER_ODOMETRY == 0:
                self._publish_odometry(stamp)
            if step % _STEPS_PER_SCAN == 0:
                self._publish_scan(stamp)
            step += 1
            next_step += _STEP
            time.sleep(max(0.0, next_step - time.monotonic()))

    def _velocity(self):
        if self._time - self._command_time > _COMMAND_TIMEOUT:
            return 0.0, 0.0
        return self._command.linear.x, self._command.angular.z

    def _move(self):
        v, w = self._velocity()
        self._time += _STEP
        self.x += v * math.cos(self.yaw + 0.5 * w * _STEP) * _STEP
        self.y += v * math.sin(self.yaw + 0.5 * w * _STEP) * _STEP
        self.yaw += w * _STEP

    def _publish_odometry(self, stamp):
        pose = _transform(stamp, "odom", "base_link", self.x, self.y, self.yaw)
        odometry = Odometry()
        odometry.header = pose.header
        odometry.child_frame_id = pose.child_frame_id
        odometry.pose.pose.position.x = self.x
        odometry.pose.pose.position.y = self.y
        odometry.pose.pose.orientation = pose.transform.rotation
        v, w = self._velocity()
        odometry.twist.twist.linear.x = v
        odometry.twist.twist.angular.z = w
        if self.publishes_odometry_frame:
            self._transforms.sendTransform(pose)
        self._odometry.publish(odometry)

    def _publish_scan(self, stamp):
        scan = LaserScan()
        scan.header.stamp = stamp
        scan.header.frame_id = "front_laser"
        scan.angle_min = -0.75 * math.pi
        scan.angle_max = 0.75 * math.pi
        scan.angle_increment = 1.5 * math.pi / (_BEAMS - 1)
        scan.range_min = 0.1
        scan.range_max = 30.0
        x = self.x + _FRONT_LASER_X * math.cos(self.yaw)
        y = self.y + _FRONT_LASER_X * math.sin(self.yaw)
        scan.ranges = [
            _distance_to_wall(
                x, y, self.yaw + scan.angle_min + i * scan.angle_increment)
            for i in range(_BEAMS)]
        if self.alter_scan is not None:
            self.alter_scan(scan)
        self._scans.publish(scan)
