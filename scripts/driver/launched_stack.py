"""A roslaunch run with a ROS master of its own, ended whole on every way out."""

import ctypes
import os
import re
import signal
import socket
import subprocess
import tempfile
import time
import uuid

# Every process of a run carries this variable with the run's own value, so that
# each can be found whoever its parent is: roslaunch puts its children into
# sessions of their own.
RUN_VARIABLE = "VFH_ASTAR_RUN"
_PR_SET_PDEATHSIG = 1
_ENDING_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
_FATAL = re.compile(r"\[FATAL\] \[[^\]]*\]: (.*)")
_TERMINAL_COLOR = re.compile(r"\x1b\[[0-9;]*m")


class LaunchError(Exception):
    """The stack did not come up or did not stay up; the message says why."""


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def _end_with_parent():
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGINT)


def processes_of_run(run_id):
    """The ids of the living processes that carry the run's id."""
    wanted = "{}={}".format(RUN_VARIABLE, run_id).encode()
    pids = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit() or int(entry) == os.getpid():
            continue
        try:
            with open("/proc/{}/environ".format(entry), "rb") as environ:
                if wanted in environ.read().split(b"\0"):
                    pids.append(int(entry))
        except OSError:
            continue  # ended meanwhile, or another user's
    return pids


class LaunchedStack:
    """Use as a context manager: leaving it ends what was started."""

    def __init__(self, launch_file, arguments, log_file):
        """arguments: {name: value}; None leaves the launch file's default."""
        self._command = ["roslaunch", launch_file]
        for name, value in arguments.items():
            if value is not None:
                self._command.append("{}:={}".format(name, value))
        self._log_file = log_file
        self._ros_log = None  # ROS's own files, of use to nobody afterwards
        self._run_id = uuid.uuid4().hex
        self._process = None
        self.master_uri = "http://localhost:{}".format(free_port())

    def __enter__(self):
        port = self.master_uri.rsplit(":", 1)[1]
        environment = dict(os.environ)
        environment[RUN_VARIABLE] = self._run_id
        environment["ROS_MASTER_URI"] = self.master_uri
        self._ros_log = tempfile.TemporaryDirectory(prefix="vfh_astar_log_")
        environment["ROS_LOG_DIR"] = self._ros_log.name
        with open(self._log_file, "w") as log:
            self._process = subprocess.Popen(
                self._command + ["-p", port], env=environment, stdout=log,
                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                start_new_session=True, preexec_fn=_end_with_parent)
        return self

    def __exit__(self, *_):
        self.stop()

    def check_alive(self):
        """Raises LaunchError when roslaunch has ended."""
        status = self._process.poll()
        if status is not None:
            raise LaunchError(
                self.fatal_errors()
                or "roslaunch ended with status {}; the end of {}:\n{}".format(
                    status, self._log_file, self.log_tail()))

    def fatal_errors(self):
        """What nodes said as they gave up, a line each; empty if they did not."""
        with open(self._log_file, errors="replace") as log:
            lines = _TERMINAL_COLOR.sub("", log.read()).splitlines()
        return "\n".join(_FATAL.match(line).group(1) for line in lines
                         if _FATAL.match(line))

    def log_tail(self, lines=25):
        with open(self._log_file, errors="replace") as log:
            text = "".join(log.readlines()[-lines:])
        return _TERMINAL_COLOR.sub("", text)

    def stop(self):
        """Asks roslaunch to end, then ends what is left, more and more firmly.

        An impatient second Ctrl-C does not keep this from its end.
        """
        if self._process is None:
            return
        handlers = {number: signal.signal(number, signal.SIG_IGN)
                    for number in _ENDING_SIGNALS}
        try:
            self._end_all()
        finally:
            for number, handler in handlers.items():
                signal.signal(number, handler)

    def _end_all(self):
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)
            try:
                self._process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                pass
        for ending in (signal.SIGTERM, signal.SIGKILL):
            if not self._signal_rest(ending):
                break
        self._process.wait()
        self._process = None
        self._ros_log.cleanup()

    def _signal_rest(self, ending):
        """Returns whether something still runs afterwards."""
        for pid in processes_of_run(self._run_id):
            try:
                os.kill(pid, ending)
            except ProcessLookupError:
                pass
        deadline = time.monotonic() + 3.0
        while time.monotonic() < deadline:
            self._process.poll()
            if not processes_of_run(self._run_id):
                return False
            time.sleep(0.05)
        return True
