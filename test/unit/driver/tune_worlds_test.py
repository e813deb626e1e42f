import json
import os
import tempfile
import unittest

import numpy as np

from driver import barn, tune_worlds
from driver.barn import WorldSetError


class TuneWorldsTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.static = os.path.join(folder.name, "static")
        self.dynamic = os.path.join(folder.name, "dynamic")
        os.mkdir(self.static)
        os.mkdir(self.dynamic)
        for i in range(10):
            open(os.path.join(self.static, "world_{}.world".format(i)),
                 "w").close()
        for i in range(4):
            with open(os.path.join(self.dynamic, "world_{}.json".format(i)),
                      "w") as file:
                json.dump({"start": [3, 0, 0], "goal": [0, 4]}, file)

    def names(self, worlds):
        return {world.name() for world in worlds}

    def test_finds_both_kinds(self):
        worlds = tune_worlds.find([self.static, self.dynamic])
        self.assertEqual(len(self.names(worlds)), 14)
        self.assertIn("barn 3", self.names(worlds))
        self.assertIn("dynabarn 3", self.names(worlds))
        with self.assertRaisesRegex(WorldSetError, "no folder"):
            tune_worlds.find([self.static + "x"])

    def test_split_by_seed(self):
        worlds = tune_worlds.find([self.static, self.dynamic])
        training, held_out = tune_worlds.split(worlds, 0.5, 1)
        self.assertEqual(self.names(training) | self.names(held_out),
                         self.names(worlds))
        self.assertFalse(self.names(training) & self.names(held_out))
        kinds = [world.kind for world in held_out]
        self.assertEqual((kinds.count("barn"), kinds.count("dynabarn")), (5, 2))
        self.assertEqual(tune_worlds.split(worlds, 0.5, 1),
                         (training, held_out))
        self.assertTrue(any(
            tune_worlds.split(worlds, 0.5, seed)[1] != held_out
            for seed in range(2, 6)))

    def test_each_side_gets_a_world(self):
        worlds = tune_worlds.find([self.dynamic])
        for share, count in ((0.01, 1), (0.99, 3)):
            self.assertEqual(len(tune_worlds.split(worlds, share, 1)[1]), count)
        with self.assertRaisesRegex(WorldSetError, "only world"):
            tune_worlds.split(worlds[:1], 0.5, 1)

    def test_given_indices(self):
        def choose(training, held_out):
            return [[w.index for w in side] for side in tune_worlds.choose(
                [self.dynamic], training, held_out, 0.5, 1)]

        self.assertEqual(choose([0], [2, 3]), [[0], [2, 3]])
        self.assertEqual(choose([0], None), [[0], [1, 2, 3]])
        self.assertEqual(choose(None, [1, 2]), [[0, 3], [1, 2]])
        for training, held_out, text in (
                ([0, 1], [1], "world 1 is in both"),
                ([0, 7], [1], "no world 7"),
                ([0, 1, 2, 3], None, "--held-out: no world is left")):
            with self.assertRaisesRegex(WorldSetError, text):
                choose(training, held_out)

    def test_optimal_times(self):
        # (3, 0) to (0, 4) at 2 m/s.
        self.assertEqual(tune_worlds.find([self.dynamic])[0].optimal_time(None),
                         2.5)
        world = tune_worlds.find([self.static])[0]
        with self.assertRaisesRegex(WorldSetError, "path_0.npy"):
            world.optimal_time(barn.START)
        np.save(os.path.join(self.static, "path_0.npy"), [(17, 0), (17, 30)])
        # Straight up from (-2, 3) but for a start and goal 0.025 m beside it.
        self.assertAlmostEqual(world.optimal_time(barn.START), 5.0, places=3)

    def test_drives_with_seeds_of_their_own(self):
        for folder in (self.static, self.dynamic):
            runs = tune_worlds.find([folder], [2])[0].runs(
                "c.yaml", 3, barn.START)
            self.assertEqual(len({run.options for run in runs}), 3)
            self.assertEqual({run.config for run in runs}, {"c.yaml"})


if __name__ == "__main__":
    unittest.main()
