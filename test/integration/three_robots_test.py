#!/usr/bin/env python3
"""Three robots, each with a navigation of its own, exchange places."""

import os

import navigation_test_case
from driver import goal_drive, scene
from driver.observer import Observer


class ThreeRobotsTest(navigation_test_case.NavigationTestCase):

    def test_they_exchange_places_without_contact(self):
        robots = scene.robots_with_goals(
            os.path.join(scene.ROOT, "worlds", "three_robots.yaml"), 3)
        observers = [Observer(namespace=robot.name) for robot in robots]
        records = goal_drive.drive_all(
            self.stack,
            [goal_drive.DriveTask(observer, robot.start, robot.goal)
             for observer, robot in zip(observers, robots)],
            60.0, lambda elapsed: None)
        for robot, record in zip(robots, records):
            with self.subTest(robot.name):
                self.assertTrue(record.succeeded, record.message)
                self.assertEqual(record.contacts, [])
                # Who stood at the goal may still be in the map when it is chosen.
                self.assertLess(record.distance_left(), 0.4)
                # Each has a map of its own, in the world's coordinates.
                self.assertIsNotNone(record.map)
                self.assertLess(record.tracking_errors()[0], 0.1)


if __name__ == "__main__":
    navigation_test_case.run("three_robots", ThreeRobotsTest)
