import os
import unittest

from driver import benchmark


class CycleTest(unittest.TestCase):

    def test_drives_the_jackal_unless_told_otherwise(self):
        config = benchmark.parse_arguments(["cycle"]).config
        self.assertEqual(os.path.basename(config), "jackal.yaml")
        self.assertTrue(os.path.isfile(config))
        other = os.path.join(os.path.dirname(config), "paper.yaml")
        self.assertEqual(
            benchmark.parse_arguments(["cycle", "--config", other]).config,
            other)

    def test_table_by_hand(self):
        figures = {"outcome": "success", "time_s": 16.4, "beams": 1080,
                   "stages": {"plan": {"count": 5, "median_us": 533.01,
                                       "p99_us": 20393.9},
                              "localize": {"count": 656, "median_us": 0.391,
                                           "p99_us": 277.0}}}
        self.assertEqual(benchmark.cycle_table(figures), [
            "stage                count   median [us]   99 % [us]",
            "localize               656         0.391         277",
            "plan                     5           533      20,394",
            "success after 16.4 s, 1080 beams"])


if __name__ == "__main__":
    unittest.main()
