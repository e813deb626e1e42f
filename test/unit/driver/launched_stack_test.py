import os
import sys
import tempfile
import time
import unittest

from driver.launched_stack import LaunchedStack, LaunchError, processes_of_run

# In roslaunch's place: starts a child in a session of its own that ignores
# every polite signal, tells its process id and waits.
_STUBBORN = """#!/bin/sh
exec {python} -c '
import signal, subprocess, sys, time
child = subprocess.Popen(
    ["sh", "-c", "trap : INT TERM; while :; do sleep 1; done"],
    start_new_session=True)
print(child.pid, flush=True)
time.sleep(100)
'
"""


class LaunchedStackTest(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.log = os.path.join(self.folder.name, "log")
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = self.folder.name + os.pathsep + path

    def replace_roslaunch(self, text):
        file = os.path.join(self.folder.name, "roslaunch")
        with open(file, "w") as script:
            script.write(text)
        os.chmod(file, 0o755)

    def wait_for_log(self, stack):
        while not stack.log_tail():
            stack.check_alive()
            time.sleep(0.01)
        return stack.log_tail()

    def test_ends_children_in_other_sessions(self):
        self.replace_roslaunch(_STUBBORN.format(python=sys.executable))
        stack = LaunchedStack("x.launch", {}, self.log)
        with self.assertRaises(SystemExit):
            with stack:
                child = int(self.wait_for_log(stack))
                self.assertIn(child, processes_of_run(stack._run_id))
                raise SystemExit(1)
        self.assertEqual(processes_of_run(stack._run_id), [])

    def test_tells_why_it_ended(self):
        self.replace_roslaunch("#!/bin/sh\necho no such world\nexit 3\n")
        with LaunchedStack("x.launch", {}, self.log) as stack:
            stack._process.wait()
            with self.assertRaisesRegex(LaunchError,
                                        "(?s)status 3.*no such world"):
                stack.check_alive()

    def test_tells_what_a_node_died_of_and_nothing_else(self):
        self.replace_roslaunch(
            "#!/bin/sh\necho started\n"
            "printf '\\033[31m[FATAL] [12.5]: no such world\\033[0m\\n'\n"
            "echo shutting down\n")
        with LaunchedStack("x.launch", {}, self.log) as stack:
            stack._process.wait()
            with self.assertRaises(LaunchError) as caught:
                stack.check_alive()
        self.assertEqual(str(caught.exception), "no such world")

    def test_passes_arguments(self):
        self.replace_roslaunch("#!/bin/sh\necho \"$@\"\n")
        with LaunchedStack("x.launch", {"a": 1, "b": None, "c": ""},
                           self.log) as stack:
            stack._process.wait()
            port = stack.master_uri.rsplit(":", 1)[1]
            self.assertEqual(stack.log_tail(),
                             "x.launch a:=1 c:= -p {}\n".format(port))


if __name__ == "__main__":
    unittest.main()
