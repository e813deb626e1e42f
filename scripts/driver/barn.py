"""The BARN benchmark (Perille et al. 2020) and its dynamic sister DynaBARN
(Nair et al. 2022): worlds, runs and scores."""

import os
import re

import numpy as np

from driver import confidence
from driver.drive_runs import DriveRun

START = (-2.0, 3.0, 1.57)  # x, y (m), yaw (rad) of BARN until 2023
_GOAL_DISTANCE = 10.0  # m ahead of the start, along y
_FINISH_RADIUS = 1.0  # m
_START_DISTANCE = 0.1  # m of motion from which time counts
_TIME_LIMIT = 100.0  # s
OPTIMAL_SPEED = 2.0  # m/s
_SLOWEST = 8.0  # times the optimal time; slower runs score no less


class WorldSetError(Exception):
    """A folder of worlds that cannot be used; the message says why."""


def world_files(folder, pattern, indices=None):
    """{index: file} of the worlds in a folder.

    pattern: of the names, with a group for the index.
    indices: those wanted; None for all there are.
    Raises WorldSetError.
    """
    if not os.path.isdir(folder):
        raise WorldSetError("--worlds: there is no folder " + folder)
    found = {}
    for name in os.listdir(folder):
        match = re.fullmatch(pattern, name)
        if match:
            found[int(match.group(1))] = os.path.abspath(
                os.path.join(folder, name))
    if not found:
        raise WorldSetError("--worlds: {} has no file named like {}".format(
            folder, pattern))
    missing = sorted(set(indices or ()) - set(found))
    if missing:
        raise WorldSetError("--worlds: {} has no world {}".format(
            folder, missing[0]))
    return {index: found[index] for index in sorted(indices or found)}


def goal_of(start):
    return (start[0], start[1] + _GOAL_DISTANCE, start[2])


def pose_text(pose):
    """X,Y,YAW as the program reads it."""
    return ",".join(map(repr, pose))


def _run(index, number, world, config, options):
    return DriveRun((("world", index), ("run", number)), world, config, (
        "--laser", "barn", "--seed", str(number + 1),
        "--finish-radius", repr(_FINISH_RADIUS),
        "--start-distance", repr(_START_DISTANCE),
        "--time-limit", repr(_TIME_LIMIT), *options))


def static_runs(folder, config, indices, count, start):
    """`count` drives through each BARN world, each with a seed of its own."""
    files = world_files(folder, r"world_(\d+)\.world", indices)
    options = ("--start=" + pose_text(start),
               "--goal=" + pose_text(goal_of(start)))
    return [_run(index, number, file, config, options)
            for index, file in files.items() for number in range(count)]


def dynamic_runs(folder, config, indices, count):
    """The same for DynaBARN; its files name start and goal."""
    files = world_files(folder, r"world_(\d+)\.json", indices)
    return [_run(index, number, file, config, ())
            for index, file in files.items() for number in range(count)]


def reference_path(file):
    """The world's path, N x 2 in m, from its rows and columns of 0.15 m."""
    cells = np.load(file)
    if cells.ndim != 2 or cells.shape[1] != 2:
        raise WorldSetError("{}: its shape is {}; expected N x 2 (row, column)"
                            .format(file, cells.shape))
    return cells * 0.15 + (-4.575, 5.075)


def optimal_time(path, start):
    """s at the optimal speed along start, path and goal."""
    line = np.vstack([start[:2], path, goal_of(start)[:2]])
    return float(np.sum(np.hypot(*np.diff(line, axis=0).T))) / OPTIMAL_SPEED


def score(succeeded, time, optimal, k):
    """Of one run: success * OT / clip(T, k OT, 8 OT)."""
    if not succeeded:
        return 0.0
    return optimal / min(max(time, k * optimal), _SLOWEST * optimal)


def path_of_world(folder, index):
    """reference_path of a world in a folder. Raises WorldSetError."""
    file = os.path.join(folder, "path_{}.npy".format(index))
    if not os.path.isfile(file):
        raise WorldSetError("there is no file {}, which the score needs".format(
            file))
    return reference_path(file)


def add_scores(results, folder, start):
    """Gives each run its optimal_time_s, score_k4 and score_k2."""
    optimal = {index: optimal_time(path_of_world(folder, index), start)
               for index in {result["world"] for result in results}}
    for result in results:
        add_score(result, optimal[result["world"]])


def add_score(result, optimal):
    """The same for one run; optimal: s."""
    result["optimal_time_s"] = optimal
    for k in (4, 2):
        result["score_k{}".format(k)] = score(
            result["outcome"] == "success", result["time_s"], optimal, k)


def summary(results):
    """What a set of runs comes to: rates from 0 to 1, and means; the time's is
    over the runs that reached the goal."""
    def rate(outcome):
        return sum(r["outcome"] == outcome for r in results) / len(results)

    times = [r["time_s"] for r in results if r["outcome"] == "success"]
    figures = {"runs": results, "success": rate("success"),
               "collision": rate("collision"), "timeout": rate("timeout"),
               "mean_time_s": sum(times) / len(times) if times else None}
    for name in ("score_k4", "score_k2"):
        if name in results[0]:
            figures[name] = sum(r[name] for r in results) / len(results)
    return figures


def table(figures):
    """For people: figures with 95 % confidence intervals, failures by name."""
    results = figures["runs"]
    lines = ["{} runs in {} worlds".format(
        len(results), len({r["world"] for r in results}))]
    for name in ("success", "collision", "timeout"):
        low, high = confidence.rate_interval(
            sum(r["outcome"] == name for r in results), len(results))
        lines.append("{:12} {:6.1%}  ({:.1%} to {:.1%})".format(
            name, figures[name], low, high))
    columns = {"mean_time_s": [r["time_s"] for r in results
                               if r["outcome"] == "success"]}
    for name in ("score_k4", "score_k2"):
        if name in figures:
            columns[name] = [r[name] for r in results]
    for name, values in columns.items():
        if values:
            lines.append("{:12} {:6.4g}  (+- {:.2g})".format(
                name, figures[name], confidence.mean_deviation(values)))
    for result in results:
        if result["outcome"] != "success":
            lines.append("world {world}, run {run}: {outcome} after "
                         "{time_s:.1f} s: {message}".format(**result))
    return lines
