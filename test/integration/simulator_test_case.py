"""What the tests of the simulator node share."""

import time
import unittest

import rospy
from std_srvs.srv import SetBool
from vfh_astar.srv import Delete, Reset, SetPose, Spawn, Step

_WALL_LIMIT = 20.0  # s for anything that has to happen


class Newest:
    """The newest message of a topic."""

    def __init__(self, topic, message_type):
        self.message = None
        self.count = 0
        self._topic = topic
        rospy.Subscriber(topic, message_type, self._on_message, queue_size=100,
                         tcp_nodelay=True)

    def _on_message(self, message):
        self.message = message
        self.count += 1

    def next(self, condition=lambda message: True):
        """Waits for one that comes from now on and meets the condition."""
        return self._wait(self.count, condition)

    def until(self, condition):
        """As next(), but the one that is there will do."""
        return self._wait(0, condition)

    def _wait(self, seen, condition):
        end = time.monotonic() + _WALL_LIMIT
        while True:
            message = self.message
            if self.count > seen and condition(message):
                return message
            if time.monotonic() > end:
                raise AssertionError("no such message on " + self._topic)
            time.sleep(0.002)


class SimulatorTestCase(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        rospy.init_node("simulator_test", anonymous=True)
        services = {"reset": Reset, "set_pose": SetPose, "spawn": Spawn,
                    "delete": Delete, "step": Step, "simulator/pause": SetBool}
        for name, service_type in services.items():
            rospy.wait_for_service(name, timeout=30.0)
            setattr(cls, name.rsplit("/", 1)[-1],
                    staticmethod(rospy.ServiceProxy(name, service_type)))

    def setUp(self):
        self.pause(False)
        self.reset(1)
