#!/usr/bin/env python3
"""The hairpin between two dead ends is driven without contact."""

import navigation_test_case


class HairpinTest(navigation_test_case.NavigationTestCase):

    def test_reaches_the_goal_without_contact(self):
        record = self.drive_scene("hairpin")
        # No straight line: the walls stand in the way of one.
        straight = record.poses[0]
        self.assertGreater(record.path_length(), 1.2 * abs(
            complex(record.goal[0] - straight.x, record.goal[1] - straight.y)))
        self.assertGreater(record.least_clearance, 0.0)


if __name__ == "__main__":
    navigation_test_case.run("hairpin", HairpinTest)
