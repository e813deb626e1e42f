"""What was seen of one drive, and the figures that follow from it. No ROS."""

import math
from dataclasses import dataclass, field
from typing import List, Optional, Tuple

import numpy as np

from driver import drive_smoothness


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


def line_length(line):
    """m, of a polyline, N x 2."""
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


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
    v: float = 0.0  # m/s, forward
    w: float = 0.0  # rad/s


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
    trajectory_times: List[float] = field(default_factory=list)  # likewise
    map: Optional[GridMap] = None
    least_clearance: float = math.inf  # m, ground truth
    contacts: List[str] = field(default_factory=list)  # what was touched
    succeeded: bool = False
    message: str = ""
    began: Optional[float] = None  # s, simulated: the goal was sent
    ended: Optional[float] = None  # s, simulated: the result came
    wall_seconds: Optional[float] = None  # from sending the goal to its result
    timed_out: bool = False
    cpu_seconds: Optional[float] = None  # of the navigation's processes
    peak_memory: Optional[float] = None  # MB, likewise
    missed_cycles: Optional[int] = None  # of the control, as the stack says

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

    def longest_trajectory(self):
        """The longest and the plan that was the newest at its time; nothing
        without one."""
        pairs = [(trajectory, [plan for plan, planned in zip(
            self.plans, self.plan_times) if planned <= time])
            for trajectory, time in zip(self.trajectories,
                                        self.trajectory_times)]
        pairs = [(trajectory, plans[-1]) for trajectory, plans in pairs
                 if plans]
        return max(pairs, key=lambda pair: line_length(pair[0]), default=None)

    def reached_without_contact(self):
        return self.succeeded and not self.contacts

    def smoothness(self):
        """jerk_rms, turn_reversals and stops; see drive_smoothness."""
        times, speeds, turn_rates = np.array(
            [(p.time, p.v, p.w) for p in self.poses]).reshape(-1, 3).T
        return {"jerk_rms": drive_smoothness.jerk_rms(times, speeds),
                "turn_reversals": drive_smoothness.turn_reversals(
                    times, turn_rates),
                "stops": drive_smoothness.stops(times, speeds, turn_rates)}

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
            **self.smoothness(),
            # The same for every stack: what it published as its plan.
            "replans": max(0, len(self.plans) - 1),
            "cpu_s": self.cpu_seconds,
            "peak_memory_mb": self.peak_memory,
            "missed_cycles": self.missed_cycles,
            "realtime_factor": (self.duration() / self.wall_seconds
                                if self.wall_seconds else None),
        }
