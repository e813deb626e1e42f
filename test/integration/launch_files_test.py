"""Every launch file loads, and what it starts is there."""

import glob
import os
import unittest

import rospkg
from roslaunch.rlutil import check_roslaunch

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))


class LaunchFilesTest(unittest.TestCase):

    def test_launch_files(self):
        files = glob.glob(os.path.join(ROOT, "launch", "*.launch"))
        self.assertTrue(files)
        for file in sorted(files):
            with self.subTest(os.path.basename(file)):
                self.assertIsNone(check_roslaunch(file))

    def test_default_files_are_there(self):
        self.assertEqual(rospkg.RosPack().get_path("vfh_astar"), ROOT)
        for file in ("worlds/hairpin.yaml", "config/jackal.yaml",
                     "urdf/jackal.urdf", "rviz/navigation.rviz"):
            self.assertTrue(os.path.isfile(os.path.join(ROOT, file)), file)


if __name__ == "__main__":
    unittest.main()
