"""scripts/compare drives a short way with the real stack and reports it."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))


class CompareTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.report = os.path.join(folder.name, "report")
        figures = os.path.join(folder.name, "figures.json")
        cls.comparison = subprocess.run(
            [sys.executable, "-m", "driver.compare", "--world",
             os.path.join(ROOT, "worlds", "pop_up.yaml"), "--goal", "3.2,1.25",
             "--stacks", "vfh_astar", "--noise", "experiment", "--time-limit",
             "20", "--report", cls.report, "--json", figures],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(
                [os.path.join(ROOT, "scripts"),
                 os.environ.get("PYTHONPATH", "")])})
        if cls.comparison.returncode == 0:
            with open(figures) as file:
                cls.figures = json.load(file)

    def setUp(self):
        self.assertEqual(self.comparison.returncode, 0,
                         self.comparison.stderr.decode())

    def test_measures_the_drive(self):
        run, = self.figures["runs"]
        self.assertEqual(run["outcome"], "success")
        self.assertFalse(run["contact"])
        self.assertAlmostEqual(run["path_m"], 2.0, delta=0.3)
        self.assertLess(run["time_s"], 20.0)
        # The corridor's walls are 1.2 m to each side, half a robot less.
        self.assertAlmostEqual(run["min_clearance_m"], 1.04, delta=0.2)
        self.assertGreater(run["jerk_rms"], 0.0)
        self.assertGreater(run["cpu_s"], 0.0)
        self.assertGreater(run["peak_memory_mb"], 10.0)
        # Its navigator reports every second.
        self.assertGreaterEqual(run["missed_cycles"], 0)
        self.assertGreater(run["realtime_factor"], 0.0)
        self.assertFalse(self.figures["missing"])

    def test_writes_every_section(self):
        for name in ("report.md", "report.html"):
            with open(os.path.join(self.report, name)) as file:
                text = file.read()
            for part in ("Completion time", "ours (vfh_astar)", "pop_up",
                         "experiment: odometry", "peak memory", "BARN",
                         "DynaBARN", "How it was measured", "Machine"):
                self.assertIn(part, text, name)
        for picture in ("plans", "trajectories", "driven", "errors"):
            file = "pop_up_experiment_{}.png".format(picture)
            with open(os.path.join(self.report, file), "rb") as png:
                self.assertEqual(png.read(8), b"\x89PNG\r\n\x1a\n")


if __name__ == "__main__":
    unittest.main()
