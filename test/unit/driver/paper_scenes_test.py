import os
import unittest

from driver import paper_scenes


def _result(scenario, configuration, run, outcome, **figures):
    result = {"scenario": scenario, "configuration": configuration, "run": run,
              "outcome": outcome, "message": "", "time_s": 10.0, "path_m": 5.0,
              "min_clearance_m": 0.2, "rms_error_m": 0.01, "max_error_m": 0.05,
              "true_rms_error_m": 0.02, "goal_heading_error_deg": -1.0,
              "replans": 2}
    result.update(figures)
    return result


class PaperScenesTest(unittest.TestCase):

    def test_every_world_and_configuration_is_there(self):
        for run in paper_scenes.runs(1):
            self.assertTrue(os.path.isfile(run.config), run.config)
            if run.world is not None:
                self.assertTrue(os.path.isfile(run.world), run.world)

    def test_seeds_differ_between_runs_alone(self):
        runs = paper_scenes.runs(2)
        self.assertEqual(len(runs), 2 * len(paper_scenes.SCENES) *
                         len(paper_scenes.CONFIGURATIONS))
        first, second = runs[0], runs[1]
        self.assertEqual(first.world, second.world)
        self.assertNotEqual(first.options, second.options)

    def test_summary_by_hand(self):
        results = [_result(name, configuration, run, "success")
                   for name in paper_scenes.SCENES
                   for configuration in paper_scenes.CONFIGURATIONS
                   for run in range(2)]
        results[0].update(outcome="collision", collision={}, time_s=99.0,
                          min_clearance_m=0.0, max_error_m=0.5)
        results[1].update(time_s=12.0, goal_heading_error_deg=-3.0)
        figures = paper_scenes.summary(results)["scenarios"]["hairpin"]["paper"]
        self.assertEqual(figures["success"], 0.5)
        self.assertEqual(figures["collision"], 0.5)
        self.assertEqual(figures["time_s"], 12.0)
        self.assertEqual(figures["min_clearance_m"], 0.0)
        self.assertEqual(figures["max_error_m"], 0.5)
        self.assertEqual(figures["goal_heading_error_deg"], 3.0)
        self.assertEqual(figures["replans"], 2.0)

    def test_a_scene_that_nobody_finished_has_no_means(self):
        results = [_result(name, configuration, 0, "timeout",
                           min_clearance_m=None)
                   for name in paper_scenes.SCENES
                   for configuration in paper_scenes.CONFIGURATIONS]
        summary = paper_scenes.summary(results)
        figures = summary["scenarios"]["pop_up"]["jackal"]
        self.assertIsNone(figures["time_s"])
        self.assertIsNone(figures["min_clearance_m"])
        self.assertTrue(paper_scenes.table(summary))


if __name__ == "__main__":
    unittest.main()
