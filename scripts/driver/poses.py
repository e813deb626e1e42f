"""Poses on the command line and in world files: x, y in m, yaw in rad."""

import argparse
import math

import yaml


def _numbers(text, counts):
    parts = text.split(",")
    try:
        values = tuple(float(part) for part in parts)
    except ValueError:
        values = ()
    if len(values) not in counts or not all(map(math.isfinite, values)):
        raise argparse.ArgumentTypeError(
            "'{}': expected {} finite numbers with commas between them".format(
                text, " or ".join(map(str, counts))))
    return values


def pose_argument(text):
    """X,Y,YAW"""
    return _numbers(text, (3,))


def goal_argument(text):
    """X,Y or X,Y,YAW"""
    return _numbers(text, (2, 3))


def with_yaw(goal, start):
    """A goal without yaw looks the way one comes from the start."""
    if len(goal) == 3:
        return goal
    return (goal[0], goal[1],
            math.atan2(goal[1] - start[1], goal[0] - start[0]))
