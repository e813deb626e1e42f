import os
import time
import unittest

from driver import machine, node_processes


class NodeProcessesTest(unittest.TestCase):

    def test_cpu_time_grows_with_work(self):
        before = node_processes.cpu_seconds(os.getpid())
        clock = time.process_time()
        while time.process_time() - clock < 0.2:
            pass
        self.assertAlmostEqual(
            node_processes.cpu_seconds(os.getpid()) - before, 0.2, delta=0.1)

    def test_peak_memory_remembers(self):
        before = node_processes.peak_memory(os.getpid())
        block = bytearray(os.urandom(1000)) * 200000  # 200 MB
        del block
        self.assertAlmostEqual(
            node_processes.peak_memory(os.getpid()) - before, 200.0, delta=40.0)

    def test_machine(self):
        facts = machine.describe()
        self.assertGreaterEqual(int(facts["processors"]), 1)
        self.assertRegex(facts["memory"], r"\d GB")
        self.assertTrue(all(facts.values()))


if __name__ == "__main__":
    unittest.main()
