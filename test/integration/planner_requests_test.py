#!/usr/bin/env python3
"""A request does not wait for a long search, be it that of an older request or
of make_plan, and make_plan gets its answer all the same."""

import threading
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Pose, PoseStamped
from nav_msgs.msg import OccupancyGrid, Path
from nav_msgs.srv import GetPlan
from vfh_astar.msg import MotionFailure, MotionQuery

SIDE = 3000  # cells
RESOLUTION = 0.1  # m
START = (2.0, 2.0)
NEAR = (6.0, 2.0)
WALLED_IN = (295.0, 295.0)  # All other cells are searched in vain.


def pose(x, y):
    result = Pose()
    result.position.x, result.position.y = x, y
    result.orientation.w = 1.0
    return result


def walled_map():
    message = OccupancyGrid()
    message.header.frame_id = "map"
    message.header.stamp = rospy.Time.now()
    message.info.resolution = RESOLUTION
    message.info.width = message.info.height = SIDE
    message.info.origin.orientation.w = 1.0
    corner = SIDE - 100
    open_row = bytes(SIDE)
    wall_row = bytes(corner) + bytes([100] * 100)
    side_row = bytes(corner) + bytes([100]) + bytes(99)
    message.data = list(open_row * corner + wall_row + side_row * 99)
    return message


class PlannerRequestsTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        rospy.init_node("planner_requests_test")
        cls.answers = {}  # stamp -> (wall s, whether it is a plan)
        rospy.Subscriber("plan", Path, lambda path: cls.answer(path, True))
        rospy.Subscriber("plan_failure", MotionFailure,
                         lambda failure: cls.answer(failure, False))
        cls.requests = rospy.Publisher("plan_request", MotionQuery,
                                       queue_size=10)
        maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        maps.publish(walled_map())
        rospy.wait_for_service("make_plan", 20.0)
        cls.make_plan = rospy.ServiceProxy("make_plan", GetPlan)
        cls.maps = maps
        cls.await_map()
        began = time.monotonic()
        assert not cls.plan_to(WALLED_IN)
        cls.long_search = time.monotonic() - began

    @classmethod
    def answer(cls, message, is_plan):
        cls.answers[message.header.stamp] = (time.monotonic(), is_plan)

    @classmethod
    def await_map(cls):
        end = time.monotonic() + 30.0
        while cls.requests.get_num_connections() == 0 or not cls.plan_to(NEAR):
            assert time.monotonic() < end, "no plan on the map within 30 s"
            time.sleep(0.1)

    @classmethod
    def plan_to(cls, goal):
        start = PoseStamped()
        start.header.frame_id = "map"
        start.pose = pose(*START)
        end = PoseStamped()
        end.header.frame_id = "map"
        end.pose = pose(*goal)
        return cls.make_plan(start, end, 0.0).plan.poses

    def request(self, goal):
        """Returns the stamp that the answer will have."""
        query = MotionQuery()
        query.header.frame_id = "map"
        query.header.stamp = rospy.Time.from_sec(time.time())
        query.start, query.goal = pose(*START), pose(*goal)
        self.requests.publish(query)
        return query.header.stamp

    def seconds_to_plan(self, stamp, began):
        while stamp not in self.answers:
            self.assertLess(time.monotonic() - began, 30.0, "no answer")
            time.sleep(0.001)
        answered, is_plan = self.answers[stamp]
        self.assertTrue(is_plan)
        return answered - began

    def test_a_newer_request_cuts_an_older_one_short(self):
        older = self.request(WALLED_IN)
        time.sleep(0.1 * self.long_search)
        began = time.monotonic()
        newer = self.request(NEAR)
        waited = self.seconds_to_plan(newer, began)
        self.assertLess(waited, 0.5 * self.long_search)
        time.sleep(1.5 * self.long_search)
        self.assertNotIn(older, self.answers)

    def test_make_plan_makes_way_for_a_request_and_is_answered_after(self):
        paths = []
        caller = threading.Thread(
            target=lambda: paths.append(self.plan_to(WALLED_IN)))
        caller.start()
        time.sleep(0.1 * self.long_search)
        began = time.monotonic()
        waited = self.seconds_to_plan(self.request(NEAR), began)
        self.assertLess(waited, 0.5 * self.long_search)
        self.assertEqual(paths, [])
        caller.join(30.0)
        self.assertEqual(paths, [[]])


if __name__ == "__main__":
    rostest.rosrun("vfh_astar", "planner_requests", PlannerRequestsTest)
