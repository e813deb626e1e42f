import contextlib
import io
import os
import shutil
import tempfile
import unittest

import compared_drives
from driver import compare


class CompareOptionsTest(unittest.TestCase):

    def error_of(self, *arguments):
        with contextlib.redirect_stderr(io.StringIO()) as stream, \
                self.assertRaises(SystemExit):
            compare.parse_arguments(list(arguments))
        return stream.getvalue()

    def test_the_papers_table_by_default(self):
        options = compare.parse_arguments([])
        self.assertEqual(options.stacks,
                         ["move_base", "vfh_astar_paper", "vfh_astar"])
        self.assertEqual([s.name for s in options.scenes], ["hairpin"])
        self.assertEqual(options.noise, ["clean", "experiment"])
        self.assertEqual(options.scenes[0].start, (1.2, 1.15, 0.0))

    def test_lists(self):
        options = compare.parse_arguments([
            "--stacks", "vfh_astar,vfh_astar", "--noise", "experiment",
            "--scenes", "u_shape,u_shape," + compared_drives.WORLD])
        self.assertEqual(options.stacks, ["vfh_astar"])
        self.assertEqual(options.noise, ["experiment"])
        self.assertEqual([s.name for s in options.scenes],
                         ["u_shape", "open_field"])
        self.assertTrue(options.report.endswith("u_shape_open_field"))

    def test_a_scene_of_ones_own(self):
        options = compare.parse_arguments([
            "--world", compared_drives.WORLD, "--goal", "2,0"])
        self.assertEqual(options.scenes[0].goal, (2.0, 0.0, 0.0))

    def test_errors(self):
        self.assertIn("'teb' is no stack", self.error_of("--stacks", "teb"))
        self.assertIn("'fog' is no noise", self.error_of("--noise", "fog"))
        self.assertIn("no world", self.error_of("--scenes", "mars"))
        self.assertIn("--goal is for a scene of one's own", self.error_of(
            "--scenes", "hairpin", "--goal", "1,1"))
        self.assertIn("0 is not 1 or more", self.error_of("--runs", "0"))
        self.assertIn("is no number above 0 up to 1",
                      self.error_of("--pace", "1.5"))
        with tempfile.TemporaryDirectory() as folder:
            other = os.path.join(folder, "open_field.yaml")
            shutil.copy(compared_drives.WORLD, other)
            self.assertIn("are both called open_field", self.error_of(
                "--scenes", "open_field," + other))
            file = os.path.join(folder, "x.json")
            self.assertIn("x.json", self.error_of("--barn", file))
            with open(file, "w") as stream:
                stream.write("{}")
            self.assertIn("it has no runs", self.error_of("--dynabarn",
                                                          "a=" + file))


if __name__ == "__main__":
    unittest.main()
