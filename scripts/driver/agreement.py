"""Drives BARN worlds through ROS and in one process, and says whether the two
agree: in success to one run in fifty, in mean time to 5 %."""

import argparse
import json
import os
import sys
from dataclasses import dataclass

from driver import (amounts, barn, comparison, drive_runs, interruption, poses,
                    scene)

_OUTPUT = os.path.join(scene.OUTPUT, "agreement")
_CONFIG = os.path.join(scene.ROOT, "config", "jackal.yaml")
_SUCCESS_TOLERANCE = 1.0 / 50.0  # of the runs
_TIME_TOLERANCE = 0.05  # of the mean time
_TIME_LIMIT = 100.0  # simulated s


@dataclass(frozen=True)
class Outcome:
    world: int
    run: int
    succeeded: bool
    time: float  # s, simulated, from the goal to its result


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="agreement", description=__doc__)
    parser.add_argument("--worlds", metavar="FOLDER", required=True,
                        help="of world_<index>.world files")
    parser.add_argument("--indices", metavar="N,...", type=amounts.indices,
                        help="of the worlds (the first ten)")
    parser.add_argument("--runs", type=amounts.count, default=5, metavar="N",
                        help="of each world, each with a seed of its own (5)")
    parser.add_argument("--start", type=poses.pose_argument,
                        metavar="X,Y,YAW", default=barn.START,
                        help="m, m, rad (-2,3,1.57)")
    parser.add_argument("--pace", type=amounts.pace, default=1.0,
                        metavar="FACTOR",
                        help="simulated seconds per second through ROS (1)")
    parser.add_argument("--json", metavar="FILE",
                        help="write the figures to a file too")
    options = parser.parse_args(arguments)
    try:
        files = barn.world_files(options.worlds, r"world_(\d+)\.world",
                                 options.indices)
    except barn.WorldSetError as error:
        parser.error(str(error))
    count = len(files) if options.indices else 10
    options.files = dict(list(files.items())[:count])
    return options


def drive_in_process(index, file, number, options):
    """Raises drive_runs.DriveError."""
    figures = drive_runs.perform(drive_runs.DriveRun(
        (), file, _CONFIG, (
            "--seed", str(number + 1), "--time-limit", repr(_TIME_LIMIT),
            "--start=" + barn.pose_text(options.start),
            "--goal=" + barn.pose_text(barn.goal_of(options.start)))))
    return Outcome(index, number, figures["outcome"] == "success",
                   figures["time_s"])


def drive_through_ros(index, file, number, options):
    """Raises drive_runs.DriveError."""
    task = comparison.Task(
        "vfh_astar", _CONFIG,
        comparison.Scene("world_{}".format(index), file, options.start,
                         barn.goal_of(options.start)),
        "clean", number, number + 1, _TIME_LIMIT, options.pace)
    record = comparison.perform_apart(task, _OUTPUT)
    if isinstance(record, str):
        raise drive_runs.DriveError("{}: {}".format(file, record))
    return Outcome(index, number, record.succeeded and not record.contacts,
                   record.duration())


def compare(in_process, through_ros):
    """The figures of two lists of Outcomes of the same runs, and whether they
    agree."""
    def rate(outcomes):
        return sum(o.succeeded for o in outcomes) / len(outcomes)

    both = [(a.time, b.time) for a, b in zip(in_process, through_ros)
            if a.succeeded and b.succeeded]
    means = [sum(times) / len(both) for times in zip(*both)] or [None, None]
    rates = rate(in_process), rate(through_ros)
    difference = means[1] / means[0] - 1.0 if both else None
    agree = (both != [] and abs(difference) <= _TIME_TOLERANCE
             and abs(rates[1] - rates[0]) <= _SUCCESS_TOLERANCE + 1e-9)
    return {"runs": len(in_process), "success_in_process": rates[0],
            "success_through_ros": rates[1], "mean_time_in_process_s": means[0],
            "mean_time_through_ros_s": means[1],
            "time_difference": difference, "agree": agree}


def drive_all(options):
    """Two lists of Outcomes: in one process, through ROS."""
    in_process, through_ros = [], []
    total = len(options.files) * options.runs
    for index, file in options.files.items():
        for number in range(options.runs):
            in_process.append(drive_in_process(index, file, number, options))
            through_ros.append(drive_through_ros(index, file, number, options))
            print("{} of {}: world {}, run {}: {:.2f} s in one process, {:.2f} "
                  "s through ROS".format(
                      len(in_process), total, index, number + 1,
                      in_process[-1].time, through_ros[-1].time),
                  file=sys.stderr, flush=True)
    return in_process, through_ros


def main():
    options = parse_arguments(sys.argv[1:])
    interruption.exit_on_signals()
    os.makedirs(_OUTPUT, exist_ok=True)
    try:
        outcomes = drive_all(options)
    except drive_runs.DriveError as error:
        print("agreement: {}".format(error), file=sys.stderr)
        return 1
    figures = compare(*outcomes)
    for name, value in figures.items():
        print("{:26} {}".format(name, value))
    if options.json:
        figures["outcomes"] = [
            {"world": a.world, "run": a.run, "in_process_s": a.time,
             "in_process_success": a.succeeded, "through_ros_s": b.time,
             "through_ros_success": b.succeeded} for a, b in zip(*outcomes)]
        with open(options.json, "w") as file:
            json.dump(figures, file, indent=2)
            file.write("\n")
    return 0 if figures["agree"] else 1


if __name__ == "__main__":
    sys.exit(main())
