import math
import unittest

import numpy as np

from driver.drive_record import (DriveRecord, PoseSample, StateSample,
                                 distance_from_line)


def state_sample(state, error_x, error_y):
    return StateSample(0.0, state, "", (error_x, error_y, 0.0), 1.0, 0.5, 2.0)


class DriveRecordTest(unittest.TestCase):

    def setUp(self):
        self.record = DriveRecord(start=(0, 0, 0), goal=(3, 5, 0))

    def test_path_is_the_sum_of_the_steps(self):
        for time, x, y in ((0, 0, 0), (1, 3, 0), (2, 3, 4), (3, 3, 4)):
            self.record.poses.append(PoseSample(time, x, y, 0.0))
        self.assertAlmostEqual(self.record.path_length(), 7.0)
        self.assertAlmostEqual(self.record.distance_left(), 1.0)

    def test_nothing_driven(self):
        self.assertEqual(self.record.path_length(), 0.0)
        self.assertEqual(self.record.duration(), 0.0)
        self.assertTrue(math.isinf(self.record.distance_left()))
        self.assertIsNone(self.record.tracking_errors())

    def test_tracking_errors_count_tracking_only(self):
        self.record.states = [state_sample("TRACKING", 0.3, 0.4),
                              state_sample("AVOIDING", 9.0, 9.0),
                              state_sample("TRACKING", 0.0, 0.1)]
        rms, greatest = self.record.tracking_errors()
        self.assertAlmostEqual(rms, math.sqrt((0.25 + 0.01) / 2))
        self.assertAlmostEqual(greatest, 0.5)

    def test_distance_from_a_line(self):
        line = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)])
        for point, distance in (((1.0, 0.5), 0.5), ((-3.0, 4.0), 5.0),
                                ((2.5, 1.0), 0.5), ((2.0, 3.0), 1.0)):
            self.assertAlmostEqual(
                distance_from_line(np.array(point), line), distance)
        self.assertAlmostEqual(
            distance_from_line(np.array((3.0, 4.0)), line[:1]), 5.0)

    def test_the_newest_plan_counts(self):
        self.record.plans = [np.array([(0.0, 0.0), (9.0, 0.0)]),
                             np.array([(0.0, 1.0), (9.0, 1.0)])]
        self.record.plan_times = [1.0, 3.0]
        self.record.poses = [PoseSample(t, t, 0.25, 0.0) for t in (0, 1, 2, 3)]
        self.assertEqual(self.record.distances_from_plan(),
                         [(1, 0.25), (2, 0.25), (3, 0.75)])

    def test_the_longest_trajectory_goes_with_its_plan(self):
        self.assertIsNone(self.record.longest_trajectory())
        lines = [np.array([(0.0, 0.0), (length, 0.0)])
                 for length in (1.0, 2.0, 3.0, 4.0)]
        self.record.plans, self.record.plan_times = lines[:3], [1.0, 2.0, 5.0]
        # The last one has no plan before it.
        self.record.trajectories = [lines[0], lines[2], lines[1], lines[3]]
        self.record.trajectory_times = [1.1, 2.0, 5.1, 0.5]
        trajectory, plan = self.record.longest_trajectory()
        self.assertIs(trajectory, lines[2])
        self.assertIs(plan, lines[1])

    def test_contact_spoils_success(self):
        self.record.succeeded = True
        self.assertTrue(self.record.reached_without_contact())
        self.record.contacts.append("wall")
        self.assertFalse(self.record.reached_without_contact())

    def test_duration_is_from_goal_to_result(self):
        self.record.began, self.record.ended = 2.5, 12.0
        self.assertAlmostEqual(self.record.duration(), 9.5)

    def test_clearance_that_was_not_measured_is_none(self):
        self.assertIsNone(self.record.figures()["min_clearance_m"])
        self.record.least_clearance = 0.2
        self.assertEqual(self.record.figures()["min_clearance_m"], 0.2)


if __name__ == "__main__":
    unittest.main()
