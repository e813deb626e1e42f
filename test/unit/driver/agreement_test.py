"""When drives in one process and through ROS agree."""

import unittest

from driver.agreement import Outcome, compare


def outcomes(times, failures=0):
    return [Outcome(i, 0, i >= failures, time) for i, time in enumerate(times)]


class AgreementTest(unittest.TestCase):

    def test_means_are_over_the_runs_that_both_finished(self):
        figures = compare(outcomes([100.0, 6.0, 8.0], failures=1),
                          outcomes([5.0, 6.0, 8.7]))
        self.assertEqual(figures["mean_time_in_process_s"], 7.0)
        self.assertEqual(figures["mean_time_through_ros_s"], 7.35)
        self.assertAlmostEqual(figures["time_difference"], 0.05)
        self.assertAlmostEqual(figures["success_in_process"], 2.0 / 3.0)
        self.assertFalse(figures["agree"])

    def test_one_failure_in_fifty_is_allowed(self):
        whole = outcomes([7.0] * 50)
        self.assertTrue(compare(whole, outcomes([7.0] * 50, 1))["agree"])
        self.assertFalse(compare(whole, outcomes([7.0] * 50, 2))["agree"])

    def test_means_may_differ_by_a_twentieth(self):
        whole = outcomes([10.0] * 3)
        self.assertTrue(compare(whole, outcomes([9.51] * 3))["agree"])
        self.assertFalse(compare(whole, outcomes([10.51] * 3))["agree"])

    def test_nothing_finished_is_no_agreement(self):
        failed = outcomes([100.0] * 2, failures=2)
        self.assertFalse(compare(failed, failed)["agree"])


if __name__ == "__main__":
    unittest.main()
