"""Every launch file loads, and what it starts is there."""

import glob
import os
import unittest

import roslaunch
import rospkg
from roslaunch.rlutil import check_roslaunch

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
# Start packages that need not be installed: these have to load, no more.
_WITH_OPTIONAL_PACKAGES = {"move_base.launch", "compare.launch"}


def node_names(file, arguments):
    config = roslaunch.config.load_config_default(
        [(file, arguments)], port=None, verbose=False)
    return {node.name for node in config.nodes}


class LaunchFilesTest(unittest.TestCase):

    def test_launch_files(self):
        files = glob.glob(os.path.join(ROOT, "launch", "*.launch"))
        self.assertTrue(files)
        for file in sorted(files):
            if os.path.basename(file) not in _WITH_OPTIONAL_PACKAGES:
                with self.subTest(os.path.basename(file)):
                    self.assertIsNone(check_roslaunch(file))

    def test_compare_starts_one_stack(self):
        file = os.path.join(ROOT, "launch", "compare.launch")
        scene = ["world:=w", "x:=1", "y:=2", "yaw:=3"]
        jackal = os.path.join(ROOT, "config", "jackal.yaml")
        clearpath = os.path.join(ROOT, "config", "move_base", "clearpath.yaml")
        own = node_names(file, scene + ["stack:=vfh_astar", "config:=" + jackal])
        self.assertLessEqual({"navigation_manager", "simulator"}, own)
        self.assertNotIn("move_base", own)
        other = node_names(file, scene + ["stack:=move_base", "config:=" + clearpath])
        self.assertLessEqual({"move_base", "slam_gmapping", "simulator"}, other)
        self.assertNotIn("navigation_manager", other)

    def test_each_robot_has_a_navigation_of_its_own(self):
        file = os.path.join(ROOT, "launch", "robots.launch")
        config = roslaunch.config.load_config_default(
            [(file, ["names:=anna bert", "starts:=1,2,3 4,5,6"])], port=None,
            verbose=False)
        namespaces = {node.namespace for node in config.nodes
                      if node.type == "navigation_node"}
        self.assertEqual(namespaces, {"/anna/", "/bert/"})
        for name, x in (("anna", 1.0), ("bert", 4.0)):
            def value(parameter):
                return config.params[
                    "/{}/{}".format(name, parameter)].value
            self.assertEqual(value("grid_mapper/initial_pose_x"), x)
            self.assertEqual(value("navigator/odom_frame"), name + "/odom")
            self.assertEqual(value("tf_prefix"), name)

    def test_jackal_has_a_simulator_only_when_asked(self):
        file = os.path.join(ROOT, "launch", "jackal.launch")
        self.assertNotIn("simulator", node_names(file, []))
        self.assertIn("simulator", node_names(file, ["sim:=true"]))

    def test_the_checkout_is_what_ros_finds(self):
        self.assertEqual(
            os.path.realpath(rospkg.RosPack().get_path("vfh_astar")),
            os.path.realpath(ROOT))


if __name__ == "__main__":
    unittest.main()
