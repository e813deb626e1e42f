#!/usr/bin/env python3
"""The hairpin with odometry that drifts: the map still leads to the goal."""

import navigation_test_case


class DriftingHairpinTest(navigation_test_case.NavigationTestCase):

    def test_reaches_the_goal_by_its_map(self):
        record = self.drive_scene("hairpin")
        self.assertGreater(record.least_clearance, 0.0)


if __name__ == "__main__":
    navigation_test_case.run("drifting_hairpin", DriftingHairpinTest)
