import argparse
import os
import tempfile
import unittest
from dataclasses import replace

import compared_drives
from driver import comparison
from driver.comparison import DriveStore, Scene
from driver.stacks import STACKS


class ComparisonTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.config = self.write("c.yaml", "a: 1\n")
        self.build = self.write("program", "one")
        self.store = DriveStore(os.path.join(self.folder, "drives"),
                                (self.build,))
        self.tasks = [replace(compared_drives.task(number=i),
                              config=self.config) for i in range(3)]
        self.performed = []
        self.lines = []

    def write(self, name, text):
        file = os.path.join(self.folder, name)
        with open(file, "w") as stream:
            stream.write(text)
        return file

    def perform(self, task, _):
        self.performed.append(task.number)
        return compared_drives.drive(number=task.number).record

    def perform_all(self, perform=None):
        return comparison.perform_all(self.tasks, self.folder, self.store,
                                      self.lines.append,
                                      perform or self.perform)

    def test_stacks_take_turns(self):
        options = argparse.Namespace(runs=2, seed=5, time_limit=9.0, pace=1.0,
                                     config="own.yaml")
        scenes = [Scene("a", "a.yaml", (0, 0, 0), (1, 0, 0))]
        tasks = comparison.make_tasks(["vfh_astar_paper", "vfh_astar"], scenes,
                                      ["clean", "experiment"], options)
        self.assertEqual(
            [(t.noise, t.number, t.stack, t.seed) for t in tasks],
            [(noise, number, stack, 5 + number)
             for noise in ("clean", "experiment") for number in (0, 1)
             for stack in ("vfh_astar_paper", "vfh_astar")])
        self.assertEqual(tasks[1].config, "own.yaml")
        self.assertTrue(tasks[0].config.endswith("config/paper.yaml"))
        self.assertEqual(len({t.name() for t in tasks}), len(tasks))

    def test_every_stack_has_its_configuration(self):
        for stack in STACKS.values():
            file = comparison.config_of(stack, self.config)
            self.assertTrue(os.path.isfile(file), file)
        self.assertEqual(comparison.config_of(STACKS["vfh_astar"],
                                              self.config), self.config)

    def test_missed_cycles_are_read_where_the_stack_tells_of_them(self):
        for name, source in (("vfh_astar", "diagnostics"),
                             ("vfh_astar_paper", "diagnostics"),
                             ("move_base_fast", "rosout")):
            self.assertEqual(comparison.source_of_missed_cycles(STACKS[name]),
                             source)

    def test_goes_on_where_it_was_cut_short(self):
        def be_killed(task, folder):
            if task.number == 2:
                raise KeyboardInterrupt
            return self.perform(task, folder)

        with self.assertRaises(KeyboardInterrupt):
            self.perform_all(be_killed)
        drives = self.perform_all()
        self.assertEqual(self.performed, [0, 1, 2])
        self.assertEqual([d.task.number for d in drives], [0, 1, 2])
        self.assertTrue(all(d.record.duration() == 3.0 for d in drives))
        self.store.clear(self.tasks)
        self.perform_all()
        self.assertEqual(self.performed, [0, 1, 2, 0, 1, 2])

    def test_another_file_or_build_is_another_drive(self):
        self.perform_all()
        self.write("c.yaml", "a: 2\n")
        self.perform_all()
        self.write("program", "two")
        self.perform_all()
        self.assertEqual(self.performed, [0, 1, 2] * 3)

    def test_a_stack_that_does_not_come_up_is_tried_again(self):
        drives = self.perform_all(lambda task, _: "there is no clock")
        self.assertEqual({d.why_missing for d in drives},
                         {"vfh_astar: there is no clock"})
        self.assertIn("there is no clock", self.lines)
        self.assertTrue(all(d.record for d in self.perform_all()))

    def test_a_stack_that_is_not_installed_is_left_out(self):
        stack = replace(STACKS["move_base"], packages=("no_such_package",))
        self.addCleanup(STACKS.__setitem__, "move_base", STACKS["move_base"])
        STACKS["move_base"] = stack
        self.tasks = [compared_drives.task("move_base")]
        drive, = self.perform_all()
        self.assertIsNone(drive.record)
        self.assertEqual(drive.why_missing, "move_base is not installed: there "
                         "is no ROS package no_such_package.")
        self.assertFalse(self.performed)


if __name__ == "__main__":
    unittest.main()
