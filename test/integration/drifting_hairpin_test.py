#!/usr/bin/env python3
"""The hairpin with odometry that drifts: the map still leads to the goal."""

import navigation_test_case


class DriftingHairpinTest(navigation_test_case.NavigationTestCase):

    def test_reaches_the_goal_by_its_map(self):
        record = self.drive(self.goal_of_world("hairpin"), time_limit=120.0)
        self.assertTrue(record.succeeded, record.message)
        self.assertEqual(record.contacts, [])
        self.assertLess(record.distance_left(), 0.2)
        self.assertGreater(record.least_clearance, 0.0)


if __name__ == "__main__":
    navigation_test_case.run("drifting_hairpin", DriftingHairpinTest)
