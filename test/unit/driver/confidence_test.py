import unittest

from driver import confidence


class RateIntervalTest(unittest.TestCase):

    def test_by_hand(self):
        # Wilson: (p + z^2/2n +- z sqrt(p q / n + z^2/4n^2)) / (1 + z^2/n)
        low, high = confidence.rate_interval(8, 10)
        self.assertAlmostEqual(low, 0.4902, 4)
        self.assertAlmostEqual(high, 0.9433, 4)

    def test_ends(self):
        self.assertEqual(confidence.rate_interval(0, 0), (0.0, 1.0))
        low, high = confidence.rate_interval(30, 30)
        self.assertAlmostEqual(low, 0.8865, 4)
        self.assertEqual(high, 1.0)


class MeanDeviationTest(unittest.TestCase):

    def test_by_hand(self):
        # Variance 2.5 of five values, so four degrees of freedom.
        self.assertAlmostEqual(confidence.mean_deviation([1, 2, 3, 4, 5]),
                               2.776 * (2.5 / 5) ** 0.5)
        # Variance 2 of two values.
        self.assertAlmostEqual(confidence.mean_deviation([1, 3]), 12.706)
        self.assertAlmostEqual(confidence.mean_deviation([1, -1] * 50),
                               1.96 / 99 ** 0.5)
        self.assertEqual(confidence.mean_deviation([4.0]), 0.0)

    def test_a_single_value_has_no_interval(self):
        self.assertEqual(confidence.mean_text([4.0], "{:.1f}"), "4.0")
        self.assertEqual(confidence.mean_text([1, 3], "{:.1f}"), "2.0 ± 12.7")


if __name__ == "__main__":
    unittest.main()
