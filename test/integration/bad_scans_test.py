#!/usr/bin/env python3
"""Scans that no laser should send harm nothing: the nodelets go on, and the
robot drives again as soon as the scans are good again."""

import math

import navigation_test_case
from kinematic_robot import KinematicRobot


def no_beams(scan):
    scan.ranges = []


def zero_increment(scan):
    scan.angle_increment = 0.0


def nan_increment(scan):
    scan.angle_increment = math.nan


def all_nan(scan):
    scan.ranges = [math.nan] * len(scan.ranges)


def all_infinite(scan):
    scan.ranges = [math.inf] * len(scan.ranges)


def all_too_close(scan):
    scan.ranges = [-math.inf] * len(scan.ranges)


def mixed(scan):
    odd = (math.nan, math.inf, -math.inf, 0.0, -1.0, 1e9)
    scan.ranges = [odd[i % 12] if i % 12 < len(odd) else scan.ranges[i]
                   for i in range(len(scan.ranges))]


def turned_limits(scan):
    scan.range_min, scan.range_max = scan.range_max, scan.range_min


def unknown_frame(scan):
    scan.header.frame_id = "no_such_frame"


_BAD = (no_beams, zero_increment, nan_increment, all_nan, all_infinite,
        all_too_close, mixed, turned_limits, unknown_frame)


class BadScansTest(navigation_test_case.NavigationTestCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.robot = KinematicRobot()
        cls.robot.start()

    @classmethod
    def tearDownClass(cls):
        cls.robot.stop()

    def test_survives_them_at_rest(self):
        client = self.ready_client()
        for bad in _BAD:
            with self.subTest(bad.__name__):
                self.robot.alter_scan = bad
                self.sleep_simulated(0.5)
        self.robot.alter_scan = None
        self.sleep_simulated(0.5)
        self.assert_drives(client, 1.0)

    def test_stops_without_scans_and_goes_on_with_them(self):
        client = self.ready_client()
        client.send((-2.0, 0.0, 0.0))
        self.wait_simulated(
            lambda: self.observer.last_state is not None
            and self.observer.last_state.speed > 0.3, 20.0)
        self.robot.alter_scan = no_beams
        # Older than 0.25 s they are no ground to move on; then the robot brakes.
        self.wait_simulated(lambda: self.observer.last_state.speed < 0.01, 1.5)
        self.robot.alter_scan = None
        self.wait_simulated(client.is_done, 30.0)
        self.assertTrue(client.succeeded(), client.text())

    def assert_drives(self, client, x):
        client.send((x, 0.0, 0.0))
        self.wait_simulated(client.is_done, 30.0)
        self.assertTrue(client.succeeded(), client.text())
        self.assertLess(math.hypot(self.robot.x - x, self.robot.y), 0.2)


if __name__ == "__main__":
    navigation_test_case.run("bad_scans", BadScansTest)
