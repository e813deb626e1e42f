#!/usr/bin/env python3
"""Several robots: each in a namespace of its own, seeing and touching the
others."""

import math
import sys
import time

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage
from vfh_astar.msg import CollisionReport

from simulator_test_case import Newest, SimulatorTestCase

_LASER_X = 0.055  # m in base_link
_MANY = 1000  # messages at 50 Hz, for what takes 4 s
_HALF_LENGTH = 0.229  # m, of the footprint


class TwoRobotsTest(SimulatorTestCase):

    def test_frames_carry_the_robots_names(self):
        for name in ("left", "right"):
            scan = Newest(name + "/front/scan", LaserScan).next()
            self.assertEqual(scan.header.frame_id, name + "/front_laser")
            odometry = Newest(name + "/odometry/filtered", Odometry).next()
            self.assertEqual(odometry.header.frame_id, name + "/odom")
            self.assertEqual(odometry.child_frame_id, name + "/base_link")
        mounts = rospy.wait_for_message("/tf_static", TFMessage, 10.0)
        self.assertEqual({t.child_frame_id for t in mounts.transforms},
                         {"left/front_laser", "right/front_laser"})

    def test_they_see_each_other(self):
        ahead = {}
        for name in ("left", "right"):
            ranges = Newest(name + "/front/scan", LaserScan).next().ranges
            ahead[name] = ranges[len(ranges) // 2]
            self.assertTrue(math.isinf(ranges[0]))
        self.assertAlmostEqual(ahead["left"], 4.0 - _HALF_LENGTH - _LASER_X,
                               delta=0.01)
        self.assertAlmostEqual(ahead["left"], ahead["right"], delta=0.01)

    def test_each_has_its_own_laser(self):
        for name, beams, rate in (("left", 1080, 40), ("right", 720, 50)):
            scans = Newest(name + "/front/scan", LaserScan)
            before = scans.next()
            self.assertEqual(len(before.ranges), beams)
            self.assertAlmostEqual(before.scan_time, 1.0 / rate, 6)
            self.pause(True)
            time.sleep(0.3)
            before = scans.count
            self.step(1000)
            time.sleep(0.3)
            self.assertEqual(scans.count - before, 2 * rate)
            self.pause(False)

    def test_who_drives_into_whom(self):
        reports = {name: Newest(name + "/collision", CollisionReport)
                   for name in ("left", "right")}
        clock = Newest("left/ground_truth/odom", Odometry)
        commands = rospy.Publisher("left/cmd_vel", Twist, queue_size=1)
        command = Twist()
        command.linear.x = 1.0
        for report in reports.values():
            report.until(lambda m: not m.collided)
        for _ in range(_MANY):
            if all(report.message.collided for report in reports.values()):
                break
            commands.publish(command)
            clock.next()
        self.assertEqual(reports["left"].message.touched, "right")
        self.assertEqual(reports["right"].message.touched, "left")
        self.assertGreater(reports["left"].message.robot_speed, 0.8)
        self.assertLess(reports["right"].message.robot_speed, 0.1)
        self.assertEqual(reports["left"].message.header.stamp,
                         reports["right"].message.header.stamp)

    def test_a_robot_is_placed_by_its_name(self):
        truth = Newest("right/ground_truth/odom", Odometry)
        self.assertTrue(self.set_pose("right", 5.0, 1.0, 0.0).success)
        truth.next(lambda m: abs(m.pose.pose.position.y - 1.0) < 1e-3)
        refused = self.set_pose("nobody", 0.0, 0.0, 0.0)
        self.assertFalse(refused.success)
        self.assertIn("nobody", refused.message)
        # The other robot stands there.
        self.assertFalse(self.set_pose("right", -1.7, 0.0, 0.0).success)


if __name__ == "__main__":
    rostest.rosrun("vfh_astar", "two_robots", TwoRobotsTest, sys.argv)
