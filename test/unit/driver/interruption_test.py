import os
import signal
import unittest

from driver import interruption


class InterruptionTest(unittest.TestCase):

    def test_leaves_by_an_exception(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            self.addCleanup(signal.signal, number, signal.getsignal(number))
        interruption.exit_on_signals()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.assertRaises(SystemExit) as caught:
                os.kill(os.getpid(), number)
                signal.pause()
            self.assertEqual(caught.exception.code, 128 + number)


if __name__ == "__main__":
    unittest.main()
