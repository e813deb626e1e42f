import argparse
import math
import unittest

from driver import poses


class PosesTest(unittest.TestCase):

    def test_reads_numbers(self):
        self.assertEqual(poses.pose_argument("-2,3,1.57"), (-2.0, 3.0, 1.57))
        self.assertEqual(poses.goal_argument("-2,13"), (-2.0, 13.0))
        self.assertEqual(poses.goal_argument("1e1, 2,0"), (10.0, 2.0, 0.0))

    def test_refuses_the_rest(self):
        for text in ("", "1", "1,2", "1,2,x", "1,2,3,4", "1,2,nan", "1,inf,0"):
            with self.assertRaises(argparse.ArgumentTypeError, msg=text) as c:
                poses.pose_argument(text)
            self.assertIn("'{}'".format(text), str(c.exception))

    def test_goal_without_yaw_looks_along_the_way(self):
        self.assertEqual(poses.with_yaw((1.0, 3.0), (1.0, 1.0, 0.0)),
                         (1.0, 3.0, math.pi / 2))
        self.assertEqual(poses.with_yaw((1.0, 3.0, 0.5), (1.0, 1.0, 0.0)),
                         (1.0, 3.0, 0.5))


if __name__ == "__main__":
    unittest.main()
