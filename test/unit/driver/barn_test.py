import os
import tempfile
import unittest

import numpy as np

from driver import barn


class OptimalTimeTest(unittest.TestCase):

    def test_by_hand(self):
        # From (-2, 3) 4 m up, 3 m to the right, 6 m up, 3 m back to the goal.
        path = np.array([(-2.0, 7.0), (1.0, 7.0), (1.0, 13.0)])
        self.assertAlmostEqual(barn.optimal_time(path, barn.START),
                               (4.0 + 3.0 + 6.0 + 3.0) / 2.0)

    def test_reference_path(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "path_0.npy")
            np.save(file, np.array([(0, 0), (10, 20)]))
            np.testing.assert_allclose(barn.reference_path(file),
                                       [(-4.575, 5.075), (-3.075, 8.075)])
            np.save(file, np.array([1, 2, 3]))
            with self.assertRaisesRegex(barn.WorldSetError, r"\(3,\)"):
                barn.reference_path(file)

    def test_real_path(self):
        folder = os.path.join(os.path.dirname(__file__), "..", "..", "..", "..",
                              "shared", "data", "barn")
        if not os.path.isdir(folder):
            self.skipTest("no ../shared/data/barn")
        path = barn.reference_path(os.path.join(folder, "path_11.npy"))
        # It leads from below the obstacles to above them.
        self.assertLess(path[0][1], 5.5)
        self.assertGreater(path[-1][1], 9.0)
        time = barn.optimal_time(path, barn.START)
        self.assertGreater(time, 5.0)
        self.assertLess(time, 8.0)


class ScoreTest(unittest.TestCase):

    def test_clips(self):
        self.assertEqual(barn.score(True, 1.0, 5.0, 4), 0.25)
        self.assertEqual(barn.score(True, 20.0, 5.0, 4), 0.25)
        self.assertEqual(barn.score(True, 25.0, 5.0, 4), 0.2)
        self.assertEqual(barn.score(True, 1000.0, 5.0, 4), 0.125)
        self.assertEqual(barn.score(True, 9.0, 5.0, 2), 0.5)
        self.assertEqual(barn.score(True, 12.5, 5.0, 2), 0.4)
        self.assertEqual(barn.score(False, 1.0, 5.0, 2), 0.0)

    def test_summary(self):
        runs = [dict(world=1, run=i, outcome=o, time_s=t, score_k2=s)
                for i, (o, t, s) in enumerate((
                    ("success", 10.0, 0.5), ("success", 20.0, 0.3),
                    ("collision", 1.0, 0.0), ("timeout", 100.0, 0.0)))]
        figures = barn.summary(runs)
        self.assertEqual(figures["success"], 0.5)
        self.assertEqual(figures["collision"], 0.25)
        self.assertEqual(figures["timeout"], 0.25)
        self.assertEqual(figures["mean_time_s"], 15.0)
        self.assertAlmostEqual(figures["score_k2"], 0.2)
        self.assertNotIn("score_k4", figures)
        self.assertIsNone(barn.summary(runs[2:])["mean_time_s"])


class WorldFilesTest(unittest.TestCase):

    def test_worlds_of_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("world_10.world", "world_2.world", "path_2.npy"):
                open(os.path.join(folder, name), "w").close()
            pattern = r"world_(\d+)\.world"
            self.assertEqual(list(barn.world_files(folder, pattern)), [2, 10])
            self.assertEqual(list(barn.world_files(folder, pattern, [10])),
                             [10])
            with self.assertRaisesRegex(barn.WorldSetError, "no world 3"):
                barn.world_files(folder, pattern, [2, 3])
            with self.assertRaisesRegex(barn.WorldSetError, "no file"):
                barn.world_files(folder, r"(\d+)\.json")
        with self.assertRaisesRegex(barn.WorldSetError, "no folder"):
            barn.world_files(folder, pattern)

    def test_every_run_has_a_seed_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            open(os.path.join(folder, "world_7.world"), "w").close()
            runs = barn.static_runs(folder, "c.yaml", None, 3, (-2.25, 3, 1.57))
        self.assertEqual([run.labels for run in runs],
                         [(("world", 7), ("run", i)) for i in range(3)])
        self.assertEqual(len({run.options for run in runs}), 3)
        self.assertIn("--goal=-2.25,13.0,1.57", runs[0].options)


if __name__ == "__main__":
    unittest.main()
