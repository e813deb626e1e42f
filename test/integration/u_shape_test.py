#!/usr/bin/env python3
"""A U that is open towards the robot stands before the goal; it goes around."""

import navigation_test_case


class UShapeTest(navigation_test_case.NavigationTestCase):

    def test_goes_around(self):
        record = self.drive_scene("u_shape")
        # Straight ahead is the dead end.
        sideways = max(abs(p.y - record.poses[0].y) for p in record.poses)
        self.assertGreater(sideways, 1.0)


if __name__ == "__main__":
    navigation_test_case.run("u_shape", UShapeTest)
