#!/usr/bin/env python3
"""The simulator node in lock-step: whom its clock waits for, and that runs can
be repeated."""

import random
import sys
import time

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from vfh_astar.msg import NavigationState

from simulator_test_case import Newest, SimulatorTestCase

_STEP = 0.002  # s of physics
_LOCKSTEP_TIMEOUT = 2.0  # wall s, as in simulator_lockstep.test
_MOST_MISSES = 3  # as ScanAnswer has it


class Commander:
    """Answers every scan by a command, after a moment."""

    def __init__(self):
        self._publisher = rospy.Publisher("cmd_vel", Twist, queue_size=10,
                                          tcp_nodelay=True)
        self._subscriber = rospy.Subscriber("front/scan", LaserScan,
                                            self._on_scan, tcp_nodelay=True)
        self._random = random.Random()
        while self._publisher.get_num_connections() == 0 or \
                self._subscriber.get_num_connections() == 0:
            time.sleep(0.01)

    def _on_scan(self, scan):
        time.sleep(self._random.uniform(0.0, 0.004))
        command = Twist()
        ahead = [r for r in scan.ranges[500:580] if r == r]
        command.linear.x = 0.2 * min(ahead)
        command.angular.z = 1.0 if min(ahead) < 2.5 else -0.2
        self._publisher.publish(command)

    def close(self):
        self._subscriber.unregister()
        self._publisher.unregister()


class SimulatorLockstepTest(SimulatorTestCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.clock = Newest("/clock", Clock)
        cls.scan = Newest("front/scan", LaserScan)
        cls.truth = Newest("ground_truth/odom", Odometry)

    def advertise(self, topic, message_type):
        publisher = rospy.Publisher(topic, message_type, queue_size=10,
                                    tcp_nodelay=True)
        self.addCleanup(publisher.unregister)
        while publisher.get_num_connections() == 0:
            time.sleep(0.01)
        return publisher

    def step_taking(self, steps):
        """Steps, and returns the wall time that took in s."""
        began = time.monotonic()
        self.step(steps)
        return time.monotonic() - began

    def run_of(self, seed, seconds):
        """The true poses of a run, by their times."""
        poses = {}
        self.pause(True)
        self.reset(seed)
        time.sleep(0.3)  # What was on its way has come.
        subscriber = rospy.Subscriber(
            "ground_truth/odom", Odometry,
            lambda m: poses.__setitem__(m.header.stamp.to_nsec(), (
                m.pose.pose.position.x, m.pose.pose.position.y,
                m.pose.pose.orientation.z, m.twist.twist.linear.x)),
            tcp_nodelay=True)
        while subscriber.get_num_connections() == 0:
            time.sleep(0.01)
        time.sleep(0.3)
        end = self.step(int(seconds / _STEP)).time.to_nsec()
        limit = time.monotonic() + 10.0
        while end not in poses and time.monotonic() < limit:
            time.sleep(0.01)
        subscriber.unregister()
        self.assertEqual(len(poses), 50 * seconds)
        return poses

    def test_the_navigation_is_waited_for(self):
        navigation = self.advertise("navigation_state", NavigationState)

        def answer(scan):
            state = NavigationState()
            state.scan_stamp = state.header.stamp = scan.header.stamp
            navigation.publish(state)

        # Nobody answers: the clock goes on, but slowly.
        first = self.scan.next()
        began = time.monotonic()
        second = self.scan.next()
        self.assertGreater(time.monotonic() - began, 0.8 * _LOCKSTEP_TIMEOUT)
        # An answer to an older scan is none.
        answer(first)
        time.sleep(0.3)
        self.assertEqual(self.clock.message.clock, second.header.stamp)
        # Services are served meanwhile.
        self.assertTrue(self.set_pose("", 0.0, 1.0, 0.0).success)
        self.assertEqual(self.clock.message.clock, second.header.stamp)

        answer(second)
        third = self.scan.next()
        self.assertAlmostEqual(
            (third.header.stamp - second.header.stamp).to_sec(), 0.025,
            delta=0.003)
        answer(third)
        answers = rospy.Subscriber("front/scan", LaserScan, answer,
                                   tcp_nodelay=True)
        self.addCleanup(answers.unregister)
        began = time.monotonic()
        before = self.step(0).time.to_sec()
        after = self.step(500).time.to_sec()
        self.assertAlmostEqual(after - before, 500 * _STEP, 6)
        # Forty scans: had their answers not counted, it would take 80 s.
        self.assertLess(time.monotonic() - began, 20.0)

    def test_the_command_that_goes_with_a_state_is_waited_for(self):
        navigation = self.advertise("navigation_state", NavigationState)
        commands = self.advertise("cmd_vel", Twist)
        self.pause(True)

        def answer(scan):
            state = NavigationState(commanded=True)
            state.scan_stamp = state.header.stamp = scan.header.stamp
            navigation.publish(state)
            command = Twist()
            command.linear.x = 1.0
            time.sleep(0.02)
            commands.publish(command)

        answers = rospy.Subscriber("front/scan", LaserScan, answer,
                                   tcp_nodelay=True)
        self.addCleanup(answers.unregister)
        while answers.get_num_connections() == 0:
            time.sleep(0.01)
        self.reset(1)
        # Ten scans, each command 20 ms late.
        taken = self.step_taking(125)
        self.assertGreater(taken, 10 * 0.02)
        self.assertLess(taken, _LOCKSTEP_TIMEOUT)

    def test_an_idle_commander_is_waited_for_once(self):
        commands = self.advertise("cmd_vel", Twist)
        self.pause(True)
        self.reset(1)
        taken = self.step_taking(500)
        self.assertGreater(taken, 0.8 * _LOCKSTEP_TIMEOUT)
        self.assertLess(taken, 2.0 * _LOCKSTEP_TIMEOUT)
        # After a command he is waited for again, but not for ever.
        for i in range(_MOST_MISSES + 2):
            commands.publish(Twist())
            time.sleep(0.3)
            taken = self.step_taking(50)
            if i < _MOST_MISSES - 1:
                self.assertGreater(taken, 0.8 * _LOCKSTEP_TIMEOUT, i)
            else:
                self.assertLess(taken, 0.8 * _LOCKSTEP_TIMEOUT, i)

    def test_a_run_is_repeated_bit_by_bit(self):
        commander = Commander()
        self.addCleanup(commander.close)
        self.step_taking(50)
        first = self.run_of(7, 6)
        self.assertEqual(first, self.run_of(7, 6))
        self.assertNotEqual(first, self.run_of(8, 6))
        poses = [first[stamp] for stamp in sorted(first)]
        self.assertGreater(max(p[2] for p in poses) -
                           min(p[2] for p in poses), 0.2)


if __name__ == "__main__":
    rostest.rosrun("vfh_astar", "simulator_lockstep", SimulatorLockstepTest,
                   sys.argv)
