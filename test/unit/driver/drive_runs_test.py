import multiprocessing
import os
import tempfile
import time
import unittest

from driver import drive_runs, scene
from driver.drive_runs import DriveRun, RunStore

_PROGRAM = drive_runs.PROGRAM


def _simulated(results):
    """Without what says how fast the machine was."""
    return [{name: value for name, value in result.items()
             if not name.startswith("control_tick_")} for result in results]


def _labels_of(run):
    return dict(run.labels)


class DriveRunsTest(unittest.TestCase):

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.world = os.path.join(self._folder.name, "world")
        self.config = os.path.join(self._folder.name, "config")
        for file in (self.world, self.config):
            with open(file, "w") as content:
                content.write(file)
        # What the digest reads in the program's place.
        self.addCleanup(setattr, drive_runs, "PROGRAM", drive_runs.PROGRAM)
        drive_runs.PROGRAM = self.world
        self.library = os.path.join(self._folder.name, "library")
        with open(self.library, "w") as content:
            content.write("one")
        self.addCleanup(setattr, drive_runs, "LIBRARIES", drive_runs.LIBRARIES)
        drive_runs.LIBRARIES = (self.library,)
        self.runs = [DriveRun((("run", i),), self.world, self.config)
                     for i in range(5)]

    def store(self):
        return RunStore(self.runs, os.path.join(self._folder.name, "store"))

    def perform_all(self, perform):
        return drive_runs.perform_all(
            self.runs, drive_runs.make_executor(1), self.store(), perform)

    def test_results_keep_their_order(self):
        self.assertEqual(self.perform_all(lambda run: dict(run.labels)),
                         [{"run": i} for i in range(5)])

    def test_goes_on_where_it_was_cut_short(self):
        done = []

        def fail_at_three(run):
            if run.labels[0][1] == 3:
                raise drive_runs.DriveError("killed")
            done.append(run.labels[0][1])
            return dict(run.labels)

        with self.assertRaisesRegex(drive_runs.DriveError, "killed"):
            self.perform_all(fail_at_three)
        kept = self.store().load()
        self.assertLessEqual({0, 1, 2}, set(kept))

        done_again = []

        def perform(run):
            done_again.append(run.labels[0][1])
            return dict(run.labels)

        self.assertEqual(len(self.perform_all(perform)), 5)
        self.assertEqual(set(done_again), set(range(5)) - set(kept))
        # A complete set is forgotten.
        self.assertEqual(self.store().load(), {})

    def test_goes_on_after_it_was_killed(self):
        def perform_or_die(run):
            while run.labels[0][1] == 4 and len(self.store().load()) < 4:
                time.sleep(0.01)
            if run.labels[0][1] == 4:
                os._exit(9)
            return dict(run.labels)

        process = multiprocessing.get_context("fork").Process(
            target=self.perform_all, args=(perform_or_die,))
        process.start()
        process.join()
        self.assertEqual(process.exitcode, 9)
        done_again = []

        def perform(run):
            done_again.append(run.labels[0][1])
            return dict(run.labels)

        self.assertEqual(self.perform_all(perform),
                         [{"run": i} for i in range(5)])
        self.assertEqual(done_again, [4])

    def test_a_line_that_was_cut_off_does_not_count(self):
        store = self.store()
        store.add(0, {"time_s": 1.5})
        store.add(1, {"time_s": 2.5})
        file = os.path.join(self._folder.name, "store",
                            os.listdir(os.path.join(self._folder.name,
                                                    "store"))[0])
        with open(file) as lines:
            text = lines.read()
        with open(file, "w") as lines:
            lines.write(text[:-5])
        self.assertEqual(store.load(), {0: {"time_s": 1.5}})
        store.add(2, {"time_s": 3.5})
        self.assertEqual(store.load(), {0: {"time_s": 1.5},
                                        2: {"time_s": 3.5}})

    def test_reading_leaves_a_line_that_is_being_written(self):
        store = self.store()
        store.add(0, {"time_s": 1.5})
        store.add(1, {"time_s": 2.5})
        folder = os.path.join(self._folder.name, "store")
        file = os.path.join(folder, os.listdir(folder)[0])
        with open(file) as lines:
            text = lines.read()
        with open(file, "w") as lines:
            lines.write(text[:-5])
            lines.flush()
            self.assertEqual(store.load(), {0: {"time_s": 1.5}})
            lines.write(text[-5:])
        self.assertEqual(store.load(), {0: {"time_s": 1.5},
                                        1: {"time_s": 2.5}})

    def test_other_files_are_another_set(self):
        self.store().add(0, {})
        with open(self.config, "a") as content:
            content.write("changed")
        self.assertEqual(self.store().load(), {})

    def test_another_build_is_another_set(self):
        self.store().add(0, {})
        with open(self.library, "w") as content:
            content.write("two")
        self.assertEqual(self.store().load(), {})

    def test_a_dask_cluster_gives_the_same(self):
        try:
            import distributed
        except ImportError:
            self.skipTest("python3-distributed is not installed")
        with distributed.LocalCluster(
                n_workers=2, threads_per_worker=1, processes=False,
                dashboard_address=None) as cluster:
            results = drive_runs.perform_all(
                self.runs, drive_runs.make_executor(
                    1, cluster.scheduler_address), self.store(), _labels_of)
        self.assertEqual(results, self.perform_all(_labels_of))

    def test_two_dask_workers_drive_as_one_process_does(self):
        try:
            import distributed
        except ImportError:
            self.skipTest("python3-distributed is not installed")
        drive_runs.PROGRAM = _PROGRAM
        if not os.path.isfile(_PROGRAM):
            self.skipTest("the benchmark program is not built")
        self.runs = [DriveRun(
            (("run", i),), os.path.join(scene.ROOT, "worlds", "pop_up.yaml"),
            os.path.join(scene.ROOT, "config", "jackal.yaml"),
            ("--seed", str(i + 1), "--noise", "experiment", "--time-limit",
             "3")) for i in range(4)]
        alone = self.perform_all(drive_runs.perform)
        with distributed.LocalCluster(
                n_workers=2, threads_per_worker=1, processes=True,
                dashboard_address=None) as cluster:
            together = drive_runs.perform_all(
                self.runs, drive_runs.make_executor(
                    1, cluster.scheduler_address), self.store())
        self.assertEqual(_simulated(together), _simulated(alone))
        self.assertEqual(len({run["path_m"] for run in alone}), 4)

    def test_no_cluster_is_said(self):
        with self.assertRaisesRegex(drive_runs.DriveError, "--scheduler"):
            drive_runs.make_executor(1, "nonsense://nowhere:1")

    def test_a_failed_drive_says_why(self):
        drive_runs.PROGRAM = "/bin/false"
        with self.assertRaisesRegex(drive_runs.DriveError, "status 1"):
            drive_runs.perform(self.runs[0])

    def test_a_refusal_is_told_from_a_breakdown(self):
        def error_of(script):
            drive_runs.PROGRAM = os.path.join(self._folder.name, "program")
            with open(drive_runs.PROGRAM, "w") as file:
                file.write("#!/bin/sh\n" + script)
            os.chmod(drive_runs.PROGRAM, 0o755)
            with self.assertRaises(drive_runs.DriveError) as caught:
                drive_runs.perform(self.runs[0])
            return caught.exception

        refusal = error_of("echo no such speed >&2; exit 3\n")
        self.assertIsInstance(refusal, drive_runs.RefusedDriveError)
        self.assertIn("no such speed", str(refusal))
        for script in ("exit 1\n", "exit 2\n", "kill -9 $$\n"):
            self.assertNotIsInstance(error_of(script),
                                     drive_runs.RefusedDriveError)


if __name__ == "__main__":
    unittest.main()
