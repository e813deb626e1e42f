"""Drives made up for the tests of comparisons."""

import os

import numpy as np

from driver.comparison import Drive, Scene, Task
from driver.drive_record import (DriveRecord, GridMap, PoseSample, StateSample)

WORLD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..",
                     "..", "worlds", "open_field.yaml")


def task(stack="vfh_astar", noise="clean", number=0):
    return Task(stack, "c.yaml", Scene("field", WORLD, (0, 0, 0), (3, 0, 0)),
                noise, number, number + 1, 100.0, 1.0)


def drive(stack="vfh_astar", noise="clean", number=0, seconds=3.0):
    """1 m/s along x, on its plan for a start."""
    record = DriveRecord((0, 0, 0), (3, 0, 0), began=1.0, ended=1.0 + seconds,
                         succeeded=True, least_clearance=0.5,
                         cpu_seconds=2.0, peak_memory=100.0, missed_cycles=0,
                         wall_seconds=seconds)
    times = np.arange(0.0, seconds, 0.02)
    record.poses = [PoseSample(1.0 + t, t, 0.0, 0.0, 1.0, 0.0) for t in times]
    record.plans = [np.array([(0.0, 0.0), (3.0, 0.0)])]
    record.plan_times = [1.0]
    record.map = GridMap(0.5, (-2.0, -2.0), np.zeros((8, 16), dtype=np.int8))
    if stack != "move_base":
        record.trajectories = [np.array([(0.0, 0.0), (3.0, 0.1)])]
        record.trajectory_times = [1.0]
        record.states = [StateSample(1.0 + t, "TRACKING", "", (0.1, 0.0, 0.0),
                                     1.0, 1.0, 3.0 - t) for t in times]
    return Drive(task(stack, noise, number), record)


def missing(stack="move_base", noise="clean"):
    return Drive(task(stack, noise), None, stack + " is not installed.")
