#!/usr/bin/env python3
"""Without odom -> base_link nothing moves, and the goal's answer says what is
missing; when it comes, the robot drives."""

import navigation_test_case
from kinematic_robot import KinematicRobot
from navigation_test_case import is_motion


class MissingTransformTest(navigation_test_case.NavigationTestCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.robot = KinematicRobot()
        cls.robot.publishes_odometry_frame = False
        cls.robot.start()

    @classmethod
    def tearDownClass(cls):
        cls.robot.stop()

    def test_is_reported_and_recovered_from(self):
        client = self.served_client()
        client.send((1.0, 0.0, 0.0))
        self.wait_simulated(client.is_done, 6.0)
        self.assertFalse(client.succeeded())
        self.assertRegex(client.text(), "(?i)transform|tf")
        self.assertRegex(client.text(), "odom|base_link")
        self.assertFalse(any(is_motion(c) for _, c in self.commands))

        self.robot.publishes_odometry_frame = True
        self.sleep_simulated(1.0)
        client.send((1.0, 0.0, 0.0))
        self.wait_simulated(client.is_done, 30.0)
        self.assertTrue(client.succeeded(), client.text())


if __name__ == "__main__":
    navigation_test_case.run("missing_transform", MissingTransformTest)
