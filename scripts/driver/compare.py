"""Drives one scene with each of several navigation stacks and compares them."""

import argparse
import json
import multiprocessing
import os
import signal
import sys

from driver import scene, world_file
from driver.launched_stack import LaunchedStack, LaunchError
from driver.stacks import STACKS

_OUTPUT = os.path.join(scene.OUTPUT, "compare")


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="compare", description=__doc__)
    parser.add_argument("--stacks", default="vfh_astar,move_base",
                        help="names with commas between them out of {} (both)"
                        .format(", ".join(STACKS)))
    scene.add_arguments(parser)
    parser.add_argument("--report", metavar="FOLDER",
                        help="where report.md and its pictures go "
                        "(.workspace/compare/<world>)")
    options = parser.parse_args(arguments)
    options.stacks = options.stacks.split(",")
    unknown = [name for name in options.stacks if name not in STACKS]
    if unknown:
        parser.error("--stacks: '{}' is not one of {}".format(
            unknown[0], ", ".join(STACKS)))
    try:
        scene.complete(options)
    except (scene.SceneError, world_file.WorldFileError) as error:
        parser.error(str(error))
    options.report = options.report or os.path.join(
        _OUTPUT, scene.world_name(options))
    return options


def drive_stack(name, options):
    """Runs in a process of its own, as a process can join one ROS master only.
    Returns a DriveRecord, or the sentence that says why there is none."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _end_on_signal)
    stack = STACKS[name]
    x, y, yaw = options.start
    arguments = dict(stack.launch_arguments, world=options.world, x=x, y=y,
                     yaw=yaw, seed=options.seed)
    if name == "vfh_astar":
        arguments["config"] = options.config
    launch_file = os.path.join(scene.ROOT, "launch", "compare.launch")
    log = os.path.join(options.report, name + ".log")
    try:
        with LaunchedStack(launch_file, arguments, log) as launched:
            os.environ["ROS_MASTER_URI"] = launched.master_uri
            # They read the master's address when they are loaded.
            from driver import goal_drive, node_cpu
            from driver.observer import Observer
            goal_drive.connect(launched, "compare")
            observer = Observer(
                stack.plan_topic,
                options.start if stack.starts_at_zero else (0.0, 0.0, 0.0))
            goal_drive.GoalClient(launched, observer).wait_until_ready()
            cpu_before = node_cpu.cpu_seconds_of_nodes(stack.nodes)
            record = goal_drive.drive(launched, observer, options.start,
                                      options.goal, options.time_limit,
                                      lambda elapsed: None)
            record.cpu_seconds = (node_cpu.cpu_seconds_of_nodes(stack.nodes)
                                  - cpu_before)
            return record
    except LaunchError as error:
        return str(error)


def drive_all(options):
    """{stack's name: DriveRecord or the sentence why there is none}"""
    results = {}
    for name in options.stacks:
        missing = STACKS[name].missing_packages()
        if missing:
            results[name] = ("{} is not installed here (no package {}); it is "
                             "left out.".format(name, ", ".join(missing)))
        else:
            print("Driving {} with {} ...".format(
                scene.world_name(options), name), flush=True)
            context = multiprocessing.get_context("spawn")
            with context.Pool(1) as pool:
                results[name] = pool.apply(drive_stack, (name, options))
                pool.close()
                pool.join()
        if isinstance(results[name], str):
            print(results[name], file=sys.stderr, flush=True)
    return results


def _end_on_signal(number, _):
    raise SystemExit(128 + number)


def main():
    options = parse_arguments(sys.argv[1:])
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _end_on_signal)
    os.makedirs(options.report, exist_ok=True)
    results = drive_all(options)
    records = {name: result for name, result in results.items()
               if not isinstance(result, str)}
    notes = [result for result in results.values() if isinstance(result, str)]
    from driver import comparison_report
    table = comparison_report.write(records, notes, scene.world_name(options),
                                    options.report)
    print(table)
    print("report: {}".format(os.path.join(options.report, "report.md")))
    if options.json:
        with open(options.json, "w") as file:
            json.dump({name: record.figures()
                       for name, record in records.items()}, file, indent=2)
    # A stack that is not installed is no failure; one that did not come up is.
    broken = [name for name, result in results.items()
              if isinstance(result, str)
              and not STACKS[name].missing_packages()]
    return 0 if records and not broken else 1


if __name__ == "__main__":
    sys.exit(main())
