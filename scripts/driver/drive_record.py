"""What was seen of one drive, and the figures that follow from it. No ROS."""

import math
from dataclasses import dataclass, field
from typing import List, Optional, Tuple

import numpy as np


@dataclass
class GridMap:
    """An occupancy map: cells[row, column] from 0 to 100, -1 unknown; (0, 0) at
    the origin's corner."""

    resolution: float  # m
    origin: Tuple[float, float]  # m
    cells: np.ndarray
    pose: Tuple[float, float, float] = (0.0, 0.0, 0.0)  # in the world; m, m, rad

    def extent(self):
        """left, right, bottom, top in m, in the map's own frame."""
        rows, columns = self.cells.shape
        left, bottom = self.origin
        return (left, left + columns * self.resolution,
                bottom, bottom + rows * self.resolution)


def distance_from_line(point, line):
    """m from a point to a polyline, N x 2 with N >= 1."""
    if len(line) == 1:
        return float(np.linalg.norm(point - line[0]))
    begins, steps = line[:-1], np.diff(line, axis=0)
    lengths = np.maximum(np.sum(steps * steps, axis=1), 1e-18)
    along = np.clip(np.sum((point - begins) * steps, axis=1) / lengths, 0.0, 1.0)
    nearest = begins + along[:, None] * steps
    return float(np.min(np.linalg.norm(point - nearest, axis=1)))


def _rms_and_max(values):
    """Nothing of nothing."""
    if not values:
        return None
    return (math.sqrt(sum(v * v for v in values) / len(values)), max(values))


@dataclass
class PoseSample:
    time: float  # s, simulated
    x: float  # m, ground truth in the world's frame
    y: float
    yaw: float  # rad


@dataclass
class StateSample:
    time: float  # s, simulated
    state: str
    reason: str
    error: Tuple[float, float, float]  # m, m, rad
    clearance: float  # m, to the nearest hit of the scan
    speed: float  # m/s
    distance_to_goal: float  # m


@dataclass
class DriveRecord:
    start: Tuple[float, float, float]
    goal: Tuple[float, float, float]
    poses: List[PoseSample] = field(default_factory=list)
    states: List[StateSample] = field(default_factory=list)
    plans: List[np.ndarray] = field(default_factory=list)  # N x 2, m
    plan_times: List[float] = field(default_factory=list)  # s, simulated
    trajectories: List[np.ndarray] = field(default_factory=list)
    map: Optional[GridMap] = None
    least_clearance: float = math.inf  # m, ground truth
    contacts: List[str] = field(default_factory=list)  # what was touched
    succeeded: bool = False
    message: str = ""
    began: Optional[float] = None  # s, simulated: the goal was sent
    ended: Optional[float] = None  # s, simulated: the result came
    cpu_seconds: Optional[float] = None  # of the navigation's processes

    def duration(self):
        """Simulated seconds from sending the goal to its result."""
        if self.began is None or self.ended is None:
            return 0.0
        return self.ended - self.began

    def path_length(self):
        """Metres driven, by ground truth."""
        return sum(math.hypot(b.x - a.x, b.y - a.y)
                   for a, b in zip(self.poses, self.poses[1:]))

    def distance_left(self):
        """Metres from the last true position to the goal."""
        if not self.poses:
            return math.inf
        last = self.poses[-1]
        return math.hypot(self.goal[0] - last.x, self.goal[1] - last.y)

    def tracking_errors(self):
        """Root mean square and greatest distance from the reference, m, over
        the samples in TRACKING; nothing without one."""
        return _rms_and_max([math.hypot(s.error[0], s.error[1])
                             for s in self.states if s.state == "TRACKING"])

    def distances_from_plan(self):
        """(simulated s, m) for each pose since the first plan: how far the robot
        is from the line of the newest one. Means the same for every stack."""
        distances = []
        newest = -1
        for pose in self.poses:
            while (newest + 1 < len(self.plans)
                   and self.plan_times[newest + 1] <= pose.time):
                newest += 1
            if newest >= 0:
                distances.append((pose.time, distance_from_line(
                    np.array((pose.x, pose.y)), self.plans[newest])))
        return distances

    def reached_without_contact(self):
        return self.succeeded and not self.contacts

    def figures(self):
        """For a table or a JSON file; None where nothing was measured."""
        errors = self.tracking_errors()
        plan_errors = _rms_and_max(
            [distance for _, distance in self.distances_from_plan()])
        return {
            "outcome": "success" if self.succeeded else "failure",
            "message": self.message,
            "contact": bool(self.contacts),
            "time_s": self.duration(),
            "path_m": self.path_length(),
            "min_clearance_m": (None if math.isinf(self.least_clearance)
                                else self.least_clearance),
            "rms_error_m": errors[0] if errors else None,
            "max_error_m": errors[1] if errors else None,
            "plan_rms_m": plan_errors[0] if plan_errors else None,
            "plan_max_m": plan_errors[1] if plan_errors else None,
            "cpu_s": self.cpu_seconds,
        }
