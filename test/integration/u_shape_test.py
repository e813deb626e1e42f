#!/usr/bin/env python3
"""A U that is open towards the robot stands before the goal; it goes around."""

import navigation_test_case


class UShapeTest(navigation_test_case.NavigationTestCase):

    def test_goes_around(self):
        record = self.drive(self.goal_of_world("u_shape"), time_limit=120.0)
        self.assertTrue(record.succeeded, record.message)
        self.assertEqual(record.contacts, [])
        self.assertLess(record.distance_left(), 0.2)
        # Straight ahead is the dead end.
        self.assertGreater(max(abs(p.y - record.start[1])
                               for p in record.poses), 1.0)


if __name__ == "__main__":
    navigation_test_case.run("u_shape", UShapeTest)
