"""The core and the simulation include no ROS header, directly or not.

Asks the compiler for the dependencies of each of their sources and of all their
headers, with the options that the build uses. Argument: the build's
compile_commands.json.
"""

import json
import os
import re
import shlex
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# The folders, below src/ and include/vfh_astar/, that belong to ROS.
_ROS_FOLDERS = {"nodelets", "nodes", "ros", "rviz"}
# ROS's headers by where both distributions put them, and this package's own
# generated ones, which lie in the devel space.
_ROS_HEADER = re.compile(
    r"/opt/ros/|/devel/|/include/(ros|rosgraph\w*|\w+_msgs|std_srvs|nodelet|"
    r"pluginlib|class_loader|tf2?|tf2_\w+|actionlib|dynamic_reconfigure|"
    r"diagnostic_updater|message_filters|bondcpp|rosconsole|rviz)/")


def ros_headers(dependencies):
    """Those files of make's dependency rules that are ROS's."""
    files = dependencies.replace("\\\n", " ").split()
    return sorted(file for file in files if _ROS_HEADER.search(file))


def is_core(path, base):
    folder = os.path.relpath(path, os.path.join(ROOT, base)).split(os.sep)[0]
    return folder != os.pardir and folder not in _ROS_FOLDERS


def options_of(command):
    """The compiler and its options, without input, output and dependency
    files."""
    words = shlex.split(command["command"])
    options, skip = [], False
    for word in words:
        if skip:
            skip = False
        elif word in ("-o", "-MF", "-MT", "-MQ"):
            skip = True
        elif word not in ("-c", "-MD", "-MMD") and word != command["file"]:
            options.append(word)
    return options


def dependencies(arguments, text=None):
    return subprocess.run(arguments, input=text, check=True,
                          stdout=subprocess.PIPE, universal_newlines=True).stdout


class CoreWithoutRosTest(unittest.TestCase):
    compile_commands = None

    @classmethod
    def setUpClass(cls):
        with open(cls.compile_commands) as file:
            commands = json.load(file)
        cls.core = [c for c in commands if is_core(c["file"], "src")]

    def test_recognises_ros_headers(self):
        rule = ("a.o: /usr/include/ros/ros.h /usr/include/string.h \\\n"
                " /usr/include/std_msgs/Header.h /opt/ros/noetic/include/x.h\n")
        self.assertEqual(ros_headers(rule),
                         ["/opt/ros/noetic/include/x.h",
                          "/usr/include/ros/ros.h",
                          "/usr/include/std_msgs/Header.h"])

    def test_sources(self):
        self.assertTrue(self.core)

        def check(command):
            found = ros_headers(dependencies(
                options_of(command) + ["-M", command["file"]]))
            return command["file"], found

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for file, found in pool.map(check, self.core):
                self.assertEqual(found, [], file)

    def test_headers(self):
        headers = []
        for folder, _, names in os.walk(os.path.join(ROOT, "include")):
            paths = [os.path.join(folder, name) for name in names]
            headers += [p for p in paths if is_core(p, "include/vfh_astar")]
        self.assertTrue(headers)
        text = "".join('#include "{}"\n'.format(h) for h in sorted(headers))
        # A source of the simulation has the include paths of both libraries.
        command = next(c for c in self.core if "/simulation/" in c["file"])
        found = ros_headers(dependencies(
            options_of(command) + ["-M", "-x", "c++", "-"], text))
        self.assertEqual(found, [])


if __name__ == "__main__":
    CoreWithoutRosTest.compile_commands = sys.argv.pop()
    unittest.main()
