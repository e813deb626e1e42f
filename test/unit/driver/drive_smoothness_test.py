import math
import unittest

import numpy as np

from driver import drive_smoothness

_TIMES = np.arange(0.0, 4.0, 0.02)  # 50 Hz


class DriveSmoothnessTest(unittest.TestCase):

    def test_means_of_periods(self):
        means = drive_smoothness.averaged(
            [1.0, 1.05, 1.1, 1.12, 1.35], [2.0, 4.0, 1.0, 2.0, 7.0])
        np.testing.assert_array_equal(means, [3.0, 1.5, math.nan, 7.0])
        self.assertEqual(len(drive_smoothness.averaged([], [])), 0)

    def test_jerk_of_a_parabola(self):
        # v = 3/2 t^2: its second derivative is 3 everywhere, means too.
        self.assertAlmostEqual(
            drive_smoothness.jerk_rms(_TIMES, 1.5 * _TIMES ** 2), 3.0)
        # A constant acceleration has none.
        self.assertAlmostEqual(
            drive_smoothness.jerk_rms(_TIMES, 2.0 * _TIMES), 0.0)
        self.assertIsNone(drive_smoothness.jerk_rms([0.0, 0.1], [1.0, 2.0]))

    def test_no_jerk_across_a_gap(self):
        times = np.concatenate([_TIMES[:50], _TIMES[100:]])
        speeds = np.where(times < 1.5, 0.0, 1.0)
        self.assertEqual(drive_smoothness.jerk_rms(times, speeds), 0.0)

    def test_turn_reversals(self):
        def count(turn_rates):
            return drive_smoothness.turn_reversals(_TIMES, turn_rates)

        # Sides of a sine of 1 s: 8 in 4 s, so 7 changes between them.
        self.assertEqual(count(np.sin(2.0 * math.pi * _TIMES)), 7)
        # Less than 0.1 rad/s is straight on.
        self.assertEqual(count(0.09 * np.sin(2.0 * math.pi * _TIMES)), 0)
        # And does not hide that the sides before and after differ.
        self.assertEqual(count(np.where(_TIMES < 1.0, 1.0, np.where(
            _TIMES < 2.0, 0.0, -1.0))), 1)
        # What trembles within a tenth of a second is no turn.
        self.assertEqual(count(np.where(
            np.arange(len(_TIMES)) % 2 == 0, 0.4, -0.4)), 0)

    def test_stops(self):
        def count(moves):
            v = np.where(moves, 1.0, 0.0)
            return drive_smoothness.stops(_TIMES, v, np.zeros(len(v)))

        self.assertEqual(count(_TIMES >= 1.0), 0)  # before it began to move
        self.assertEqual(count(_TIMES < 3.0), 0)  # at the end
        self.assertEqual(count((_TIMES < 1.0) | (_TIMES >= 1.5)), 1)
        self.assertEqual(count((_TIMES < 1.0) | (_TIMES >= 1.2)), 0)  # 0.2 s
        self.assertEqual(count((_TIMES % 1.0) < 0.5), 3)
        self.assertEqual(count(_TIMES < 0.0), 0)  # never moves

    def test_who_turns_on_the_spot_does_not_stand(self):
        v = np.where((_TIMES < 1.0) | (_TIMES >= 2.0), 1.0, 0.0)
        self.assertEqual(drive_smoothness.stops(_TIMES, v, 0.5 - v / 2.0), 0)


if __name__ == "__main__":
    unittest.main()
