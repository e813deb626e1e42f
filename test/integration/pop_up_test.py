#!/usr/bin/env python3
"""An obstacle appears on the planned path; the robot gets to its goal past it."""

import navigation_test_case
import numpy as np


class PopUpTest(navigation_test_case.NavigationTestCase):

    def test_avoids_what_appears_and_reaches_the_goal(self):
        record = self.drive_scene("pop_up")
        # The obstacle was in the way: the first plan was not what was driven.
        driven = np.array([(p.x, p.y) for p in record.poses])
        first_plan = record.plans[0]
        off_plan = np.min(np.linalg.norm(
            driven[:, None, :] - first_plan[None, :, :], axis=2), axis=1)
        self.assertGreater(np.max(off_plan), 0.2)


if __name__ == "__main__":
    navigation_test_case.run("pop_up", PopUpTest)
