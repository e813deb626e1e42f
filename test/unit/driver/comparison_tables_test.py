import unittest

import compared_drives
from driver import comparison_tables


class ComparisonTablesTest(unittest.TestCase):

    def test_completion_times(self):
        drives = [compared_drives.missing()]
        for i, seconds in enumerate((3.0, 5.0, 99.0)):
            drives.append(compared_drives.drive(number=i, seconds=seconds))
        drives[-1].record.contacts.append("wall")
        drives.append(compared_drives.drive("vfh_astar_paper"))
        drives[-1].record.succeeded = False
        drives.append(compared_drives.drive(noise="experiment", seconds=4.0))
        header, rows = comparison_tables.completion_times(drives)
        self.assertEqual(header, [
            "completion time", "navigation stack (move_base)",
            "ours (vfh_astar)", "paper's configuration (vfh_astar_paper)"])
        # 3 and 5 s: deviation sqrt(2), by sqrt(2), 1.96 times.
        self.assertEqual(rows, [
            ["simulation without noise", "not driven",
             "4.0 ± 12.7 s (2 of 3)", "none of 1"],
            ["experiment: odometry and laser with noise", "not driven",
             "4.0 s (1 of 1)", "not driven"]])

    def test_measures(self):
        drives = [compared_drives.missing(), compared_drives.drive(),
                  compared_drives.drive(number=1)]
        drives[2].record.contacts.append("wall")
        drives[2].record.least_clearance = 0.0
        drives[2].record.cpu_seconds = 77.0
        header, rows = comparison_tables.measures(drives)
        self.assertEqual(header, ["measure", "vfh_astar, clean"])
        self.assertLessEqual({
            "drives": "2", "reached without contact": "1", "contacts": "1",
            "time [s]": "3.0", "path [m]": "2.98",
            "least clearance [m]": "0.00", "CPU [s]": "2.0",
            "jerk RMS [m/s³]": "0.0", "cycles missed": "0.0 ± 0.0"}.items(),
            dict(rows).items())

    def test_measures_of_several_stacks(self):
        header, rows = comparison_tables.measures([
            compared_drives.drive(noise=noise, stack=stack, seconds=seconds)
            for noise, stack, seconds in (
                ("clean", "move_base", 4.0), ("clean", "vfh_astar", 3.0),
                ("experiment", "vfh_astar", 5.0))])
        self.assertEqual(header, [
            "measure", "move_base, clean", "vfh_astar, clean",
            "vfh_astar, experiment"])
        self.assertIn(["time [s]", "4.0", "3.0", "5.0"], rows)

    def test_what_was_not_measured_is_no_number(self):
        drives = [compared_drives.drive()]
        drives[0].record.missed_cycles = None
        _, rows = comparison_tables.measures(drives)
        self.assertIn(["cycles missed", "–"], rows)

    def test_stacks(self):
        _, rows = comparison_tables.stacks([
            compared_drives.drive(), compared_drives.drive(number=1),
            compared_drives.missing("move_base_fast_navfn_dwa")])
        self.assertEqual([row[0] for row in rows],
                         ["vfh_astar", "move_base_fast_navfn_dwa"])
        self.assertIn("dwa_local_planner/DWAPlannerROS", rows[1][2])

    def test_failures_say_what_happened(self):
        drives = [compared_drives.drive(), compared_drives.drive(number=1),
                  compared_drives.drive(number=2), compared_drives.missing()]
        drives[1].record.contacts.append("pillar")
        drives[2].record.succeeded = False
        drives[2].record.message = "no path"
        touched, failed = comparison_tables.failures(drives)
        self.assertIn("run 2: touched pillar", touched)
        self.assertIn("run 3: did not reach the goal (3.0 s; no path)", failed)


if __name__ == "__main__":
    unittest.main()
