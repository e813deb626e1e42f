import os
import tempfile
import unittest

from driver import world_file


class WorldFileTest(unittest.TestCase):

    def read(self, text, name="world.yaml",
             read=world_file.read_start_and_goal):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, name)
            with open(file, "w") as world:
                world.write(text)
            return read(file)

    def robots(self, text):
        return self.read(text, read=world_file.read_robots)

    def test_start_and_goal(self):
        self.assertEqual(
            self.read("robots: [{start: [1, 2, 0.5]}, {start: [9, 9, 9]}]\n"
                      "goal: [-2, 13]\n"),
            ((1.0, 2.0, 0.5), (-2.0, 13.0)))

    def test_a_world_need_not_have_them(self):
        for text in ("", "image: a.pgm\nresolution: 0.1\n", "robots: []\n",
                     "robots: [{}]\n", "[]\n"):
            self.assertEqual(self.read(text), (None, None), text)
        self.assertEqual(self.read("<sdf/>", "x.world"), (None, None))

    def test_errors_name_the_field(self):
        for text, field in (("goal: [1]\n", "goal"), ("goal: [1, .nan]", "goal"),
                            ("goal: here\n", "goal"),
                            ("robots: [{start: [1, 2]}]\n", "robots.0.start")):
            with self.assertRaisesRegex(world_file.WorldFileError, field):
                self.read(text)

    def test_broken_yaml(self):
        with self.assertRaisesRegex(world_file.WorldFileError, "line 2"):
            self.read("a: 1\nb: ]\n")

    def test_robots(self):
        self.assertEqual(
            self.robots("robots: [{name: anna, start: [1, 2, 3], goal: [4, 5]},"
                        " {start: [6, 7, 8]}]\n"),
            [world_file.Robot("anna", (1.0, 2.0, 3.0), (4.0, 5.0)),
             world_file.Robot("robot_2", (6.0, 7.0, 8.0), None)])
        for text in ("", "[]\n", "image: a.pgm\n", "robots: none\n"):
            self.assertEqual(self.robots(text), [], text)

    def test_robots_errors_name_the_field(self):
        for text, field in (
                ("robots: [{start: [1, 2, 3]}, {}]\n", "robots.1.start"),
                ("robots: [{start: [1, 2, 3], goal: 4}]\n", "robots.0.goal")):
            with self.assertRaisesRegex(world_file.WorldFileError, field):
                self.robots(text)


if __name__ == "__main__":
    unittest.main()
