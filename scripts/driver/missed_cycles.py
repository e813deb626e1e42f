"""Counts the control cycles that a running stack says it has missed."""

import re
import threading
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Log

_REPORT_LIMIT = 3.0  # s of the wall clock for a report that comes every second
_LATE_LOOP = re.compile(r"[Cc]ontrol loop missed its desired rate")


class MissedCycles:
    """Of the reports once a second of this package's navigator, and of the
    warnings of move_base."""

    def __init__(self, source):
        """source: diagnostics or rosout."""
        self._lock = threading.Lock()
        self._count = 0
        self._reports = 0
        self._source = source
        if source == "diagnostics":
            rospy.Subscriber("/diagnostics", DiagnosticArray,
                             self._on_diagnostics, queue_size=100)
        else:
            rospy.Subscriber("/rosout", Log, self._on_log, queue_size=1000)

    def begin(self):
        with self._lock:
            self._count = 0

    def finish(self):
        """Those since the beginning, to a second; None where a stack that
        should report did not."""
        if self._source == "diagnostics":
            with self._lock:
                reports = self._reports
            deadline = time.monotonic() + _REPORT_LIMIT
            while self._reports == reports:
                if time.monotonic() > deadline:
                    return None
                time.sleep(0.05)
        with self._lock:
            return self._count

    def _on_diagnostics(self, message):
        for status in message.status:
            for entry in status.values:
                if entry.key == "cycles missed":
                    with self._lock:
                        self._count += int(entry.value)
                        self._reports += 1

    def _on_log(self, message):
        if _LATE_LOOP.search(message.msg):
            with self._lock:
                self._count += 1
