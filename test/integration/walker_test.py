#!/usr/bin/env python3
"""Somebody keeps stepping into the robot's way; it is not touched."""

import navigation_test_case


class WalkerTest(navigation_test_case.NavigationTestCase):

    def test_gets_past_who_keeps_blocking_the_way(self):
        record = self.drive_scene("operator")
        self.assertIn("AVOIDING", {s.state for s in record.states})


if __name__ == "__main__":
    navigation_test_case.run("walker", WalkerTest)
