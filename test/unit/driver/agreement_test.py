"""When drives in one process and through ROS agree."""

import contextlib
import io
import os
import tempfile
import unittest

from driver.agreement import Outcome, compare, parse_arguments


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


class AgreementOptionsTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        for i in range(12):
            with open(os.path.join(self.folder, "world_{}.world".format(i)),
                      "w"):
                pass

    def error_of(self, *arguments):
        with contextlib.redirect_stderr(io.StringIO()) as stream, \
                self.assertRaises(SystemExit):
            parse_arguments(["--worlds", self.folder, *arguments])
        return stream.getvalue()

    def test_the_first_ten_worlds_or_those_that_are_named(self):
        options = parse_arguments(["--worlds", self.folder])
        self.assertEqual(list(options.files), list(range(10)))
        options = parse_arguments(["--worlds", self.folder, "--indices",
                                   "11,3"])
        self.assertEqual(list(options.files), [3, 11])

    def test_errors(self):
        self.assertIn("0 is not 1 or more", self.error_of("--runs", "0"))
        self.assertIn("is no number above 0", self.error_of("--pace", "0"))
        self.assertIn("'1,x'", self.error_of("--indices", "1,x"))
        self.assertIn("has no world 99", self.error_of("--indices", "99"))


if __name__ == "__main__":
    unittest.main()
