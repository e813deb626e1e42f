"""What the tests of the running nodelets share."""

import math
import os
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "scripts"))

import rospy  # noqa: E402
import rostest  # noqa: E402
from geometry_msgs.msg import Twist  # noqa: E402

from driver import goal_drive, poses, scene, world_file  # noqa: E402
from driver.observer import Observer  # noqa: E402


class _RostestStack:
    """rostest has launched the stack and keeps its log."""

    def check_alive(self):
        if rospy.is_shutdown():
            raise goal_drive.LaunchError("rostest has ended the launch")

    def log_tail(self):
        return "(in rostest's output)"


class NavigationTestCase(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        rospy.init_node("navigation_test")
        cls.stack = _RostestStack()
        cls.observer = Observer()
        cls.commands = []  # (simulated s, Twist)
        rospy.Subscriber("cmd_vel", Twist, lambda command: cls.commands.append(
            (rospy.get_time(), command)))

    def goal_of_world(self, name):
        """The goal that worlds/<name>.yaml suggests; fails unless the robot
        stands at the start that it has."""
        start, goal = world_file.read_start_and_goal(
            os.path.join(scene.ROOT, "worlds", name + ".yaml"))
        self.ready_client()
        pose = self.observer.last_pose
        self.assertLess(math.hypot(pose.x - start[0], pose.y - start[1]), 0.05)
        return poses.with_yaw(goal, start)

    def drive(self, goal, time_limit):
        """Drives from where the robot is; see goal_drive.drive."""
        self.wait_for_navigator()
        return goal_drive.drive(self.stack, self.observer, (0.0, 0.0, 0.0),
                                goal, time_limit, lambda elapsed: None)

    def wait_for_navigator(self):
        """Waits until it has answered a scan. A clock that is not held before
        then can run through its patience with what has not come yet."""
        self.ready_client()
        began = rospy.get_time()
        end = time.monotonic() + 60.0
        while (self.observer.last_state is None
               or self.observer.last_state.time <= began):
            self.assertLess(time.monotonic(), end,
                            "the navigator answers no scan")
            time.sleep(0.01)

    def drive_scene(self, name):
        """The record of a drive to the goal that worlds/<name>.yaml suggests;
        fails unless it is reached without contact."""
        record = self.drive(self.goal_of_world(name), time_limit=120.0)
        self.assertTrue(record.succeeded, record.message)
        self.assertEqual(record.contacts, [])
        self.assertLess(record.distance_left(), 0.2)
        return record

    def ready_client(self):
        client = goal_drive.GoalClient(self.stack, self.observer)
        client.wait_until_ready()
        return client

    def served_client(self):
        client = goal_drive.GoalClient(self.stack, self.observer)
        client.wait_until_served()
        return client

    def wait_simulated(self, condition, simulated_limit, wall_limit=60.0):
        """Returns the simulated seconds until condition() held; fails after
        either limit."""
        began = rospy.get_time()
        wall_end = time.monotonic() + wall_limit
        while not condition():
            elapsed = rospy.get_time() - began
            self.assertLess(elapsed, simulated_limit,
                            "simulated time is up")
            self.assertLess(time.monotonic(), wall_end, "wall time is up")
            time.sleep(0.002)
        return rospy.get_time() - began

    def sleep_simulated(self, seconds):
        end = rospy.get_time() + seconds
        self.wait_simulated(lambda: rospy.get_time() >= end, seconds + 1.0)


def is_motion(command):
    return math.hypot(command.linear.x, command.linear.y) > 0.0 or \
        command.angular.z != 0.0


def run(name, test_case):
    rostest.rosrun("vfh_astar", name, test_case, sys.argv)
