#!/usr/bin/env python3
"""The simulator node: its topics, its services and how it keeps time."""

import math
import subprocess
import sys
import time

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Imu, JointState, LaserScan
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage
from vfh_astar.msg import CollisionReport

from simulator_test_case import Newest, SimulatorTestCase

_STEP = 0.002  # s of physics
_REAL_TIME_FACTOR = 5.0  # as in simulator.test
_POST_FACE = 3.0 - 0.2  # m, x of the post's near side in the world
_START_X = -2.0
_LASER_X = 0.055  # m in base_link
_FRONT = 0.229  # m, from base_link to the footprint's front


def _twist(v, w=0.0):
    twist = Twist()
    twist.linear.x = v
    twist.angular.z = w
    return twist


def _ahead(scan):
    return scan.ranges[len(scan.ranges) // 2]


class SimulatorTest(SimulatorTestCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.clock = Newest("/clock", Clock)
        cls.scan = Newest("front/scan", LaserScan)
        cls.truth = Newest("ground_truth/odom", Odometry)
        cls.collision = Newest("collision", CollisionReport)
        cls.commands = rospy.Publisher("cmd_vel", Twist, queue_size=1)

    def now(self):
        return self.clock.message.clock.to_sec()

    def drive(self, command, seconds):
        """Commands at 50 Hz for so many simulated seconds."""
        for _ in range(int(50 * seconds)):
            self.commands.publish(command)
            self.truth.next()

    # Topics.

    def test_scan(self):
        scan = self.scan.next()
        self.assertEqual(scan.header.frame_id, "front_laser")
        self.assertEqual(len(scan.ranges), 1080)
        self.assertAlmostEqual(
            scan.angle_min + 1079 * scan.angle_increment, scan.angle_max, 4)
        self.assertAlmostEqual(scan.scan_time, 1.0 / 40.0, 6)
        self.assertAlmostEqual(_ahead(scan), _POST_FACE - _START_X - _LASER_X,
                               delta=0.005)

    def test_frames(self):
        mounts = rospy.wait_for_message("/tf_static", TFMessage, 10.0)
        self.assertIn(("base_link", "front_laser", _LASER_X), [
            (t.header.frame_id, t.child_frame_id, t.transform.translation.x)
            for t in mounts.transforms])
        tf = Newest("/tf", TFMessage).next()
        self.assertEqual(tf.transforms[0].header.frame_id, "odom")
        self.assertEqual(tf.transforms[0].child_frame_id, "base_link")
        for topic in ("odometry/filtered", "jackal_velocity_controller/odom"):
            odometry = Newest(topic, Odometry).next()
            self.assertEqual(odometry.header.frame_id, "odom")
            self.assertEqual(odometry.child_frame_id, "base_link")
        self.assertEqual(self.truth.next().header.frame_id, "world")

    def test_motion_is_seen_by_every_sensor(self):
        topics = [Newest("odometry/filtered", Odometry),
                  Newest("jackal_velocity_controller/odom", Odometry)]
        imu = Newest("imu/data", Imu)
        joints = Newest("joint_states", JointState)
        self.drive(_twist(0.5, 1.0), 1.5)
        for topic in topics + [self.truth]:
            twist = topic.message.twist.twist
            self.assertAlmostEqual(twist.linear.x, 0.5, delta=0.05)
        self.assertAlmostEqual(imu.message.angular_velocity.z, 1.0, delta=0.1)
        self.assertGreater(imu.message.linear_acceleration.z, 9.7)
        turns = dict(zip(joints.message.name, joints.message.position))
        self.assertGreater(turns["front_right_wheel"],
                           turns["front_left_wheel"])
        # The robot's own controller lets go when commands stay away.
        self.truth.next(lambda m: abs(m.twist.twist.linear.x) < 1e-3)

    def test_commands_that_are_not_finite_are_refused(self):
        self.drive(_twist(math.nan, 1.0), 0.5)
        self.drive(_twist(math.inf), 0.5)
        pose = self.truth.next().pose.pose
        self.assertAlmostEqual(pose.position.x, _START_X, 5)
        self.assertAlmostEqual(pose.orientation.z, 0.0, 5)

    def test_clearance_and_collision_with_the_post(self):
        self.collision.until(lambda m: not m.collided)
        clearance = Newest("clearance", Float64)
        self.set_pose("", 2.0, 0.0, 0.0)
        clearance.next(lambda m: abs(m.data - (_POST_FACE - 2.0 - _FRONT))
                       < 1e-3)
        self.drive(_twist(0.4), 3.0)
        report = self.collision.until(lambda m: m.collided)
        self.assertEqual(report.touched, "post")
        self.assertAlmostEqual(report.robot_speed, 0.4, delta=0.05)
        self.assertLess(clearance.message.data, 0.01)
        self.reset(0)
        self.collision.until(lambda m: not m.collided)

    # Services.

    def test_set_pose_refuses_what_is_occupied(self):
        refused = self.set_pose("", 3.0, 0.0, 0.0)
        self.assertFalse(refused.success)
        self.assertIn("touch", refused.message)
        self.assertFalse(self.set_pose("", math.nan, 0.0, 0.0).success)
        self.assertAlmostEqual(self.truth.next().pose.pose.position.x,
                               _START_X, 5)
        odometry = Newest("odometry/filtered", Odometry)
        before = odometry.next().pose.pose.position
        self.assertTrue(self.set_pose("", 0.0, 1.0, 1.0).success)
        self.truth.next(lambda m: abs(m.pose.pose.position.y - 1.0) < 1e-6)
        after = odometry.next().pose.pose.position
        self.assertAlmostEqual(before.x, after.x, 3)
        self.assertAlmostEqual(before.y, after.y, 3)

    def test_spawn_and_delete(self):
        box = dict(name="box", x=1.0, y=0.0, yaw=0.0, radius=0.0, length=0.4,
                   width=0.4)
        self.assertTrue(self.spawn(**box).success)
        to_box = 1.0 - 0.2 - _START_X - _LASER_X
        self.scan.next(lambda m: abs(_ahead(m) - to_box) < 0.005)
        for change in (dict(), dict(name="", x=2.0), dict(name="b", radius=1.0),
                       dict(name="b", length=0.0), dict(name="b", width=-1.0),
                       dict(name="b", y=math.inf), dict(name="b", x=_START_X)):
            refused = self.spawn(**dict(box, **change))
            self.assertFalse(refused.success, change)
            self.assertTrue(refused.message)
        self.assertTrue(self.delete("box").success)
        self.assertTrue(self.delete("post").success)
        self.assertFalse(self.delete("box").success)
        to_wall = 6.0 - 0.1 - _START_X - _LASER_X
        self.scan.next(lambda m: abs(_ahead(m) - to_wall) < 0.005)

    def test_pause_and_step(self):
        self.truth.next()
        self.pause(True)
        paused_at = self.step(0).time.to_sec()
        time.sleep(0.3)
        self.assertAlmostEqual(self.now(), paused_at, 6)
        for steps in (1, 7, 500):
            before = self.step(0).time.to_sec()
            after = self.step(steps).time.to_sec()
            self.assertAlmostEqual(after - before, steps * _STEP, 6)
        self.clock.until(lambda m: abs(m.clock.to_sec() - after) < 1e-6)
        # A robot can be put somewhere while nothing moves.
        self.assertTrue(self.set_pose("", 0.0, 1.0, 0.0).success)
        self.pause(False)
        self.truth.next(lambda m: m.pose.pose.position.y > 0.9)

    def test_reset_begins_anew(self):
        self.drive(_twist(1.0), 1.0)
        self.delete("post")
        before = self.now()
        self.reset(0)
        self.clock.next(lambda m: m.clock.to_sec() < before)
        pose = self.truth.next().pose.pose.position
        self.assertAlmostEqual(pose.x, _START_X, 5)
        self.assertLess(_ahead(self.scan.next()), 5.0)

    # Time.

    def test_the_clock_ticks_finely(self):
        ticks = []
        subscriber = rospy.Subscriber(
            "/clock", Clock, lambda m: ticks.append(m.clock.to_sec()))
        self.truth.next()
        while len(ticks) < 300:
            self.truth.next()
        subscriber.unregister()
        gaps = [b - a for a, b in zip(ticks, ticks[1:])]
        self.assertGreater(min(gaps), 0.0)
        # rospy keeps only the newest of the ticks that come at once.
        wide = [gap for gap in gaps if gap > 0.01 + 1e-6]
        self.assertLess(len(wide), 0.1 * len(gaps))

    def test_pace(self):
        self.truth.next()
        wall, simulated = time.monotonic(), self.now()
        time.sleep(2.0)
        elapsed = self.now() - simulated
        factor = elapsed / (time.monotonic() - wall)
        self.assertLess(factor, 1.1 * _REAL_TIME_FACTOR)
        self.assertGreater(factor, 1.0)

    # The world file.

    def test_a_start_or_world_that_cannot_be_used_ends_it(self):
        node = roslib.packages.find_node("vfh_astar", "simulator_node")[0]
        world = "_world:=" + rospy.get_param("simulator/world")
        for arguments, sentence in (
                (["_world:=/nowhere.yaml"], "/nowhere.yaml: cannot be read"),
                ([world, "_x:=3.0"], "cannot start at (3 m"),
                ([world, "_laser:=none"], "laser 'none' is unknown"),
                ([world, "_seed:=-1"], "parameter seed is -1"),
                ([], "parameter world is missing")):
            run = subprocess.run(
                [node, "__name:=other_simulator"] + arguments, timeout=30,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(run.returncode, 1, arguments)
            self.assertIn(sentence, run.stdout.decode())
            if arguments:
                rospy.delete_param("other_simulator")


if __name__ == "__main__":
    rostest.rosrun("vfh_astar", "simulator_node", SimulatorTest, sys.argv)
