#!/usr/bin/env python3
"""A map is built while driving, saved, loaded by another navigation, which finds
the robot in it from a pose that is a little off, and drives back."""

import math
import os
import signal
import subprocess
import tempfile

import navigation_test_case
import rospy
from driver import goal_drive
from driver.observer import Observer, yaw_of
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage
from vfh_astar.msg import LocalizationState
from vfh_astar.srv import Reset, SaveMap, SetPose

_START = (1.5, 4.5, 0.0)  # of worlds/u_shape.yaml
_GOAL = (12.5, 4.5, 0.0)
_OFF = (0.3, -0.2, 0.15)  # m, m, rad


class _Navigation:
    """roslaunch of navigation.launch on the test's own master."""

    def __init__(self, start, **arguments):
        arguments.update(initial_pose_x=start[0], initial_pose_y=start[1],
                         initial_pose_a=start[2], lockstep="true")
        self._process = subprocess.Popen(
            ["roslaunch", "--wait", "vfh_astar", "navigation.launch"]
            + ["{}:={}".format(*item) for item in arguments.items()],
            start_new_session=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.send_signal(signal.SIGINT)
        self._process.wait(timeout=30)


class _Belief:
    """Where the navigation takes the robot to be."""

    def __init__(self):
        self._odometry = None
        self.state = None
        rospy.Subscriber("odometry/filtered", Odometry, self._on_odometry)
        rospy.Subscriber("localization", LocalizationState, self._on_state)

    def _on_odometry(self, message):
        self._odometry = message

    def _on_state(self, message):
        self.state = message

    def is_newer_than(self, time):
        """time: simulated s."""
        return all(
            message is not None and message.header.stamp.to_sec() > time
            for message in (self._odometry, self.state))

    def pose(self):
        frame = self.state.map_from_odom
        yaw = yaw_of(frame.rotation)
        odometry = self._odometry.pose.pose
        position = odometry.position
        return (frame.translation.x + math.cos(yaw) * position.x
                - math.sin(yaw) * position.y,
                frame.translation.y + math.sin(yaw) * position.x
                + math.cos(yaw) * position.y,
                yaw + yaw_of(odometry.orientation))


class MappingTest(navigation_test_case.NavigationTestCase):

    def setUp(self):
        self.belief = _Belief()
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.stem = os.path.join(self._folder.name, "map")

    def assert_knows_its_place(self, tolerance):
        """The robot has to stand still."""
        # Each topic comes at its own pace, some behind the clock.
        now = rospy.get_time()
        self.wait_simulated(
            lambda: self.belief.is_newer_than(now)
            and self.observer.last_pose.time > now, 20.0)
        pose, truth = self.belief.pose(), self.observer.last_pose
        self.assertLess(math.hypot(pose[0] - truth.x, pose[1] - truth.y),
                        tolerance)
        self.assertLess(abs(math.remainder(pose[2] - truth.yaw, math.tau)),
                        tolerance)

    def drive_to(self, goal):
        record = self.drive(goal, time_limit=120.0)
        self.assertTrue(record.succeeded, record.message)
        self.assertEqual(record.contacts, [])

    def test_save_reload_localise_and_drive(self):
        with _Navigation(_START):
            self.drive_to(_GOAL)
            self.assert_knows_its_place(0.1)
            answer = rospy.ServiceProxy("save_map", SaveMap)(self.stem)
            self.assertTrue(answer.success, answer.message)
        type(self).observer = Observer()  # of the next map
        self.belief.state = None
        there = self.observer_pose()
        with _Navigation((there[0] + _OFF[0], there[1] + _OFF[1],
                          there[2] + _OFF[2]), map_file=self.stem + ".yaml"):
            self.ready_client()
            self.wait_simulated(lambda: self.belief.state is not None, 20.0)
            self.sleep_simulated(1.0)
            self.assert_knows_its_place(0.1)
            self.lose_and_find()
            self.drive_to(_START)
            self.assert_knows_its_place(0.1)
            self.assertFalse(self.belief.state.lost)
            self.reset_and_wait_for_transform()

    def reset_and_wait_for_transform(self):
        """Time begins anew, and tf with it."""
        before = rospy.get_time()
        stamps = []
        rospy.Subscriber("/tf", TFMessage, lambda message: stamps.extend(
            t.header.stamp.to_sec() for t in message.transforms
            if t.header.frame_id == "map"))
        rospy.ServiceProxy("reset", Reset)(0)
        self.wait_simulated(
            lambda: any(stamp < before / 2.0 for stamp in stamps), 20.0)

    def observer_pose(self):
        self.wait_simulated(lambda: self.observer.last_pose is not None, 20.0)
        pose = self.observer.last_pose
        return pose.x, pose.y, pose.yaw

    def lose_and_find(self):
        """Somebody carries the robot away, and then says where it is."""
        moved = rospy.ServiceProxy("set_pose", SetPose)("", 3.0, 7.0, 2.0)
        self.assertTrue(moved.success, moved.message)
        self.wait_simulated(lambda: self.belief.state.lost, 10.0)
        client = self.served_client()
        client.send(_START)
        self.wait_simulated(client.is_done, 20.0)
        self.assertIn("do not fit the map", client.text())
        publisher = rospy.Publisher("initialpose", PoseWithCovarianceStamped,
                                    queue_size=1)
        message = PoseWithCovarianceStamped()
        message.header.frame_id = "map"
        message.pose.pose.position.x = 3.0 + _OFF[0]
        message.pose.pose.position.y = 7.0 + _OFF[1]
        message.pose.pose.orientation.z = math.sin((2.0 + _OFF[2]) / 2.0)
        message.pose.pose.orientation.w = math.cos((2.0 + _OFF[2]) / 2.0)
        while publisher.get_num_connections() == 0:
            self.sleep_simulated(0.1)
        publisher.publish(message)
        self.wait_simulated(lambda: not self.belief.state.lost, 10.0)
        self.sleep_simulated(2.0)  # as long as doubts would take
        self.assert_knows_its_place(0.1)
        self.assertFalse(self.belief.state.lost)


if __name__ == "__main__":
    navigation_test_case.run("mapping", MappingTest)
