import os
import re
import tempfile
import unittest

import compared_drives
from driver import comparison_report, picture
from driver.barn import summary
from driver.benchmark_tables import Benchmark
from driver.comparison_tables import stack_title
from driver.stacks import STACKS

_NO_BENCHMARKS = {"barn": [], "dynabarn": []}


class ComparisonReportTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, drives, benchmarks=_NO_BENCHMARKS):
        printed = comparison_report.write(drives, benchmarks,
                                          {"processor": "an abacus"},
                                          self.folder)
        texts = []
        for name in ("report.md", "report.html"):
            with open(os.path.join(self.folder, name)) as file:
                texts.append(file.read())
        return (printed, *texts)

    def test_every_part_is_there(self):
        run = {"world": 1, "outcome": "success", "time_s": 9.0}
        drives = [compared_drives.drive(stack, noise)
                  for noise in ("clean", "experiment") for stack in
                  ("move_base", "vfh_astar_paper", "vfh_astar")]
        printed, markdown, page = self.write(drives, {
            "barn": [Benchmark("ours", summary([{
                **run, "score_k4": 0.2, "score_k2": 0.4}]))],
            "dynabarn": [Benchmark("ours too", summary([run]))]})
        for text in ("Completion time", "field", "BARN", "DynaBARN", "Machine",
                     "an abacus", "0.489", "ours too", "3.0 s (1 of 1)",
                     "simulation without noise", "experiment", "peak memory"):
            self.assertIn(text, markdown)
            self.assertIn(text, page)
        self.assertIn("3.0 s (1 of 1)", printed)
        pictures = [name for name in os.listdir(self.folder)
                    if name.endswith(".png")]
        self.assertEqual(len(pictures), 8)
        for name in pictures:
            self.assertIn("({})".format(name), markdown)
        self.assertEqual(page.count("data:image/png;base64,"), 8)

    def test_the_page_needs_nothing_else(self):
        _, _, page = self.write([compared_drives.drive()])
        for source in re.findall(r'(?:src|href)\s*=\s*"([^"]{0,30})', page):
            self.assertTrue(source.startswith("data:"), source)
        for word in ("http", "url(", "@import", "<script", "<link"):
            self.assertNotIn(word, re.sub(r"base64,[^\"]*", "", page))

    def test_what_is_missing_is_said_once(self):
        _, markdown, page = self.write([
            compared_drives.missing(), compared_drives.missing(
                noise="experiment"), compared_drives.drive()])
        for text in (markdown, page):
            self.assertEqual(text.count("move_base is not installed."), 1)
            self.assertIn("BARN was not driven", text)
            self.assertIn("DynaBARN was not driven", text)
            self.assertIn("not driven", text)
        self.assertNotIn("0.4975", page)

    def test_no_drive_at_all(self):
        _, markdown, _ = self.write([compared_drives.missing()])
        self.assertIn("move_base is not installed.", markdown)
        self.assertNotIn("png", markdown)

    def test_no_stack_is_left_out_for_want_of_a_colour(self):
        names = list(STACKS)[:9]
        self.assertEqual(len(names), 9)
        drawn = []
        original = picture.draw_driven
        self.addCleanup(setattr, picture, "draw_driven", original)

        def draw_driven(axes, record, color, label):
            drawn.append(label)
            original(axes, record, color, label)

        picture.draw_driven = draw_driven
        self.write([compared_drives.drive(name) for name in names])
        self.assertEqual(drawn, [stack_title(name) for name in names])

    def test_a_stack_without_trajectories(self):
        _, markdown, _ = self.write([compared_drives.drive("move_base")])
        self.assertIn("No stack here publishes trajectories.", markdown)
        self.assertNotIn("trajectories.png", markdown)

    def test_a_robot_that_never_moved(self):
        drive = compared_drives.drive()
        drive.record.poses, drive.record.plans = [], []
        drive.record.plan_times, drive.record.trajectories = [], []
        drive.record.states, drive.record.map = [], None
        drive.record.succeeded = False
        _, markdown, _ = self.write([drive])
        self.assertIn("No stack published a plan.", markdown)
        self.assertIn("none of 1", markdown)


if __name__ == "__main__":
    unittest.main()
