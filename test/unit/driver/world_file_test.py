import os
import tempfile
import unittest

from driver import world_file


class WorldFileTest(unittest.TestCase):

    def read(self, text, name="world.yaml"):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, name)
            with open(file, "w") as world:
                world.write(text)
            return world_file.read_start_and_goal(file)

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


if __name__ == "__main__":
    unittest.main()
