#!/usr/bin/env python3
"""How goals end that are withdrawn, cannot be reached or make no sense.

The world and its map are two rooms without a door; the robot is in the left one,
where a block of 2 m x 2 m stands about (4, 5).
"""

import math

import navigation_test_case
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseGoal
from navigation_test_case import is_motion

_ANSWER_LIMIT = 5.0  # simulated s


def goal_at(x, y, frame="map", z=0.0, w=1.0):
    goal = MoveBaseGoal()
    goal.target_pose.header.frame_id = frame
    goal.target_pose.pose.position.x = x
    goal.target_pose.pose.position.y = y
    goal.target_pose.pose.orientation.z = z
    goal.target_pose.pose.orientation.w = w
    return goal


class GoalsTest(navigation_test_case.NavigationTestCase):

    def setUp(self):
        self.client = self.ready_client()
        self.wait_simulated(self.stands, 5.0)

    def stands(self):
        return abs(self.observer.last_speed) < 0.01

    def answer(self, goal):
        """Sends a goal that has to fail; returns its status and text."""
        self.client.send_message(goal)
        self.wait_simulated(self.client.is_done, _ANSWER_LIMIT)
        return self.client.status(), self.client.text()

    def assert_refused(self, goal, words):
        before = self.observer.last_pose
        status, text = self.answer(goal)
        self.assertIn(status, (GoalStatus.ABORTED, GoalStatus.REJECTED))
        self.assertRegex(text, words)
        after = self.observer.last_pose
        self.assertLess(math.hypot(after.x - before.x, after.y - before.y),
                        0.02, "the robot moved for a goal it cannot reach")

    def assert_still_works(self):
        """A short drive to a good goal succeeds."""
        pose = self.observer.last_pose
        x = 1.5 if pose.x > 1.7 else 2.0
        record = self.drive((x, 2.0, 0.0), time_limit=30.0)
        self.assertTrue(record.succeeded, record.message)
        self.assertEqual(record.contacts, [])

    def test_unreachable(self):
        self.assert_refused(goal_at(9.0, 4.0), "(?i)no path")
        self.assert_still_works()

    def test_outside_the_map(self):
        self.assert_refused(goal_at(500.0, 2.0), "(?i)outside")

    def test_in_an_obstacle(self):
        self.assert_refused(goal_at(4.0, 5.0),
                            "(?i)blocked|obstacle|occupied|not free")

    def test_unknown_frame(self):
        self.assert_refused(goal_at(2.0, 2.0, frame="no_such_frame"),
                            "no_such_frame")

    def test_not_a_number(self):
        self.assert_refused(goal_at(math.nan, 2.0), "(?i)nan|finite")

    def test_zero_quaternion(self):
        self.assert_refused(goal_at(2.0, 2.0, w=0.0),
                            "(?i)quaternion|orientation")
        self.assert_still_works()

    def test_cancel_stops_within_half_a_second(self):
        self.client.send_message(goal_at(4.5, 7.0))
        self.wait_simulated(lambda: self.observer.last_speed > 0.4, 10.0)
        self.client.cancel()
        cancelled = rospy.get_time()
        self.wait_simulated(self.stands, 0.5)
        self.wait_simulated(self.client.is_done, 1.0)
        self.assertEqual(self.client.status(), GoalStatus.PREEMPTED)
        self.assert_no_motion_until(cancelled + 0.5, cancelled + 5.0)

    def test_a_clicked_goal_is_driven_and_cancelled(self):
        publisher = rospy.Publisher("move_base_simple/goal", PoseStamped,
                                    queue_size=1)
        self.wait_simulated(lambda: publisher.get_num_connections() > 0, 5.0)
        publisher.publish(goal_at(1.5, 6.0, z=math.sqrt(0.5),
                                  w=math.sqrt(0.5)).target_pose)
        self.wait_simulated(lambda: self.observer.last_speed > 0.3, 10.0)
        self.client.cancel_all()
        cancelled = rospy.get_time()
        self.wait_simulated(self.stands, 0.5)
        self.assert_no_motion_until(cancelled + 0.5, cancelled + 3.0)

    def assert_no_motion_until(self, begin, end):
        """From begin to end (simulated s) nothing moves and nothing is asked
        to."""
        self.wait_simulated(lambda: rospy.get_time() >= begin, 2.0)
        before = self.observer.last_pose
        self.wait_simulated(lambda: rospy.get_time() >= end, 10.0)
        after = self.observer.last_pose
        self.assertLess(math.hypot(after.x - before.x, after.y - before.y),
                        0.005)
        self.assertEqual([time for time, command in self.commands
                          if begin <= time <= end and is_motion(command)], [])


if __name__ == "__main__":
    navigation_test_case.run("goals", GoalsTest)
