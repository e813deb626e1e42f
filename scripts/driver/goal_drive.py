"""Drives a launched stack to one goal."""

import math
import time

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Quaternion
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from sensor_msgs.msg import LaserScan

from driver.drive_record import DriveRecord
from driver.launched_stack import LaunchError

_STARTUP_LIMIT = 60.0  # s of the wall clock for each thing to come up
_CLOCK_LIMIT = 30.0  # s of the wall clock without simulated progress
_CANCEL_LIMIT = 5.0  # simulated s for the answer to a cancel


def _wait(stack, condition, missing, limit=_STARTUP_LIMIT):
    """Waits until condition() holds; LaunchError says what is missing."""
    deadline = time.monotonic() + limit
    while not condition():
        stack.check_alive()
        if time.monotonic() > deadline:
            raise LaunchError("{} after {:.0f} s; the end of the log:\n{}".format(
                missing, limit, stack.log_tail()))
        time.sleep(0.05)


def connect(stack, node_name):
    """Waits for the stack's master and joins it as a node; once per process,
    with ROS_MASTER_URI set."""
    import rosgraph
    _wait(stack, rosgraph.is_master_online, "the ROS master does not answer")
    _wait(stack, lambda: rosgraph.Master(node_name).hasParam("/use_sim_time"),
          "the launch file has set no parameters")
    rospy.init_node(node_name, anonymous=True, disable_signals=True)


class GoalClient:
    """The move_base action of a stack and what must be there to use it."""

    def __init__(self, stack, observer):
        self._stack = stack
        self._observer = observer
        self._scan_seen = False
        self._scan_subscriber = rospy.Subscriber(
            "front/scan", LaserScan, self._on_scan, queue_size=1)
        self._client = actionlib.SimpleActionClient("move_base", MoveBaseAction)

    def _on_scan(self, _):
        self._scan_seen = True
        self._scan_subscriber.unregister()

    def wait_until_ready(self):
        """Raises LaunchError naming the first thing that does not come up."""
        self.wait_until_served()
        _wait(self._stack, lambda: self._scan_seen, "no scan on front/scan")
        _wait(self._stack, self._observer.has_map, "no map on map")

    def _is_served(self):
        # The client's own wait counts simulated time and would never end with a
        # clock that stands still.
        client = self._client.action_client
        return (client.pub_goal.get_num_connections() > 0
                and client.pub_cancel.get_num_connections() > 0
                and client.last_status_msg is not None)

    def wait_until_served(self):
        """As wait_until_ready, for the clock and the action server alone."""
        _wait(self._stack, lambda: rospy.get_time() > 0.0,
              "there is no clock")
        _wait(self._stack, self._is_served, "no action server on move_base")

    def send(self, goal):
        """goal: x, y (m), yaw (rad) in the frame map."""
        message = MoveBaseGoal()
        message.target_pose.header.frame_id = "map"
        message.target_pose.header.stamp = rospy.Time.now()
        message.target_pose.pose.position.x = goal[0]
        message.target_pose.pose.position.y = goal[1]
        message.target_pose.pose.orientation = Quaternion(
            0.0, 0.0, math.sin(goal[2] / 2.0), math.cos(goal[2] / 2.0))
        self.send_message(message)

    def send_message(self, message):
        """message: a MoveBaseGoal, whatever is in it."""
        self._client.send_goal(message)

    def status(self):
        """One of actionlib_msgs/GoalStatus."""
        return self._client.get_state()

    def is_done(self):
        return self.status() not in (GoalStatus.PENDING, GoalStatus.ACTIVE)

    def succeeded(self):
        return self.status() == GoalStatus.SUCCEEDED

    def text(self):
        return self._client.get_goal_status_text()

    def cancel(self):
        self._client.cancel_goal()

    def cancel_all(self):
        self._client.cancel_all_goals()


class _ClockWatch:
    """Raises LaunchError when simulated time stands still for too long."""

    def __init__(self, stack):
        self._stack = stack
        self._simulated = None
        self._seen = time.monotonic()

    def now(self):
        """Simulated seconds."""
        simulated = rospy.get_time()
        if simulated != self._simulated:
            self._simulated = simulated
            self._seen = time.monotonic()
        elif time.monotonic() - self._seen > _CLOCK_LIMIT:
            raise LaunchError(
                "the simulated clock stands still since {:.0f} s; the end of "
                "the log:\n{}".format(_CLOCK_LIMIT, self._stack.log_tail()))
        return simulated


def _pursue(stack, client, clock, began, time_limit, report):
    """Waits for the goal's end; returns whether the limit ended it."""
    cancelled_at = None
    while not client.is_done():
        stack.check_alive()
        now = clock.now()
        report(now - began)
        if cancelled_at is None and now - began > time_limit:
            cancelled_at = now
            client.cancel()
        if cancelled_at is not None and now - cancelled_at > _CANCEL_LIMIT:
            break
        time.sleep(0.02)
    return cancelled_at is not None


def drive(stack, observer, start, goal, time_limit, report):
    """Drives to the goal and returns the record.

    start, goal: x, y (m), yaw (rad) in the frame map.
    time_limit: simulated seconds after which the goal is cancelled.
    report: called now and then with the simulated seconds since the goal.
    """
    client = GoalClient(stack, observer)
    client.wait_until_ready()
    clock = _ClockWatch(stack)
    record = DriveRecord(start, goal)
    observer.begin(record)
    record.began = clock.now()
    client.send(goal)
    timed_out = _pursue(stack, client, clock, record.began, time_limit, report)
    record.ended = rospy.get_time()
    record.succeeded = client.succeeded() and not timed_out
    record.message = client.text()
    if timed_out:
        record.message = "not there after {:.0f} s of simulated time".format(
            time_limit)
    observer.finish()
    return record
