"""Drives the robots of a launched stack to a goal each."""

import math
import time
from dataclasses import dataclass
from typing import Tuple

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Quaternion
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from sensor_msgs.msg import LaserScan

from driver.drive_record import DriveRecord
from driver.launched_stack import LaunchError
from driver.observer import Observer

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
    """The move_base action of a robot and what must be there to use it."""

    def __init__(self, stack, observer):
        self._stack = stack
        self._observer = observer
        self._scan_seen = False
        self._scan_topic = observer.topic("front/scan")
        self._action = observer.topic("move_base")
        self._scan_subscriber = rospy.Subscriber(
            self._scan_topic, LaserScan, self._on_scan, queue_size=1)
        self._client = actionlib.SimpleActionClient(self._action,
                                                    MoveBaseAction)

    def _on_scan(self, _):
        self._scan_seen = True
        self._scan_subscriber.unregister()

    def wait_until_ready(self):
        """Raises LaunchError naming the first thing that does not come up."""
        self.wait_until_served()
        _wait(self._stack, lambda: self._scan_seen,
              "no scan on " + self._scan_topic)
        _wait(self._stack, self._observer.has_map,
              "no map on " + self._observer.topic("map"))

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
        _wait(self._stack, self._is_served,
              "no action server on " + self._action)

    def send(self, goal):
        """goal: x, y (m), yaw (rad) in the world."""
        x, y, yaw = self._observer.in_map(goal)
        message = MoveBaseGoal()
        message.target_pose.header.frame_id = "map"
        message.target_pose.header.stamp = rospy.Time.now()
        message.target_pose.pose.position.x = x
        message.target_pose.pose.position.y = y
        message.target_pose.pose.orientation = Quaternion(
            0.0, 0.0, math.sin(yaw / 2.0), math.cos(yaw / 2.0))
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


@dataclass
class DriveTask:
    """What one robot is to do; poses are x, y (m), yaw (rad) in the world.
    """

    observer: Observer
    start: Tuple[float, float, float]
    goal: Tuple[float, float, float]


class _Pursuit:
    """One robot on its way to its goal."""

    def __init__(self, stack, task):
        self._task = task
        self._client = GoalClient(stack, task.observer)
        self._cancelled_at = None  # simulated s
        self._sent_at = None  # s of the wall clock
        self.record = DriveRecord(task.start, task.goal)

    def wait_until_ready(self):
        self._client.wait_until_ready()

    def begin(self, now):
        self._task.observer.begin(self.record)
        self.record.began = now
        self._sent_at = time.monotonic()
        self._client.send(self._task.goal)

    def is_over(self):
        return self.record.ended is not None

    def update(self, now, time_limit):
        """Ends the record when the robot is there or has no time left."""
        if not self._client.is_done():
            if self._cancelled_at is None:
                if now - self.record.began > time_limit:
                    self._cancelled_at = now
                    self._client.cancel()
                return
            if now - self._cancelled_at <= _CANCEL_LIMIT:
                return
        timed_out = self._cancelled_at is not None
        self.record.ended = rospy.get_time()
        self.record.wall_seconds = time.monotonic() - self._sent_at
        self.record.timed_out = timed_out
        self.record.succeeded = self._client.succeeded() and not timed_out
        self.record.message = self._client.text()
        if timed_out:
            self.record.message = "not there after {:.0f} s of simulated " \
                "time".format(time_limit)
        self._task.observer.finish()


def drive_all(stack, tasks, time_limit, report):
    """Sends each task's robot to its goal, all at the same time; returns a
    DriveRecord for each.

    time_limit: simulated seconds after which a goal is cancelled.
    report: called now and then with the simulated seconds since the goals.
    """
    pursuits = [_Pursuit(stack, task) for task in tasks]
    for pursuit in pursuits:
        pursuit.wait_until_ready()
    clock = _ClockWatch(stack)
    began = clock.now()
    for pursuit in pursuits:
        pursuit.begin(began)
    while not all(pursuit.is_over() for pursuit in pursuits):
        stack.check_alive()
        now = clock.now()
        report(now - began)
        for pursuit in pursuits:
            if not pursuit.is_over():
                pursuit.update(now, time_limit)
        time.sleep(0.02)
    return [pursuit.record for pursuit in pursuits]


def drive(stack, observer, start, goal, time_limit, report):
    """As drive_all, for one robot; returns its record."""
    task = DriveTask(observer, start, goal)
    return drive_all(stack, [task], time_limit, report)[0]
