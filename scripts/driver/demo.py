"""Drives the simulated Jackal to a goal, or several of them to a goal each,
tells how it went and draws it."""

import argparse
import json
import os
import sys
import time

from driver import demo_report, interruption, scene, world_file
from driver.launched_stack import LaunchedStack, LaunchError

_OUTPUT = os.path.join(scene.OUTPUT, "demo")
_MAP_MARGIN = 20.0  # m
_WORLD_OF_SEVERAL = os.path.join(scene.ROOT, "worlds", "three_robots.yaml")


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="demo", description=__doc__)
    parser.add_argument("--headless", action="store_true",
                        help="no RViz; ends with the drive")
    scene.add_arguments(parser)
    parser.add_argument("--robots", type=int, metavar="N",
                        help="all N robots of a world drive at once, each to "
                        "its own goal (3 exchange places where no --world is "
                        "given)")
    parser.add_argument("--map", metavar="FILE", help="a map_server map known "
                        "beforehand (none: the robot builds it as it drives)")
    parser.add_argument("--picture", metavar="PNG",
                        help="(.workspace/demo/<world>.png)")
    options = parser.parse_args(arguments)
    try:
        if options.robots in (None, 1):
            complete_for_one(options)
        else:
            complete_for_several(options)
    except (scene.SceneError, world_file.WorldFileError) as error:
        parser.error(str(error))
    if options.picture is None:
        options.picture = os.path.join(_OUTPUT,
                                       scene.world_name(options) + ".png")
    return options


def complete_for_one(options):
    scene.complete(options, ("world", "config", "map"))
    # Its topics are in no namespace, whatever the world calls it.
    options.robots = [world_file.Robot("", options.start, options.goal)]


def complete_for_several(options):
    if options.start is not None or options.goal is not None:
        raise scene.SceneError("--start and --goal are for one robot; with "
                               "--robots they are in the world file")
    if options.world == scene.DEFAULT_WORLD:
        options.world = _WORLD_OF_SEVERAL
    scene.find_files(options, ("world", "config", "map"))
    options.robots = scene.robots_with_goals(options.world, options.robots)


def map_extent(options):
    """The map to begin with, with room around starts and goals; a map given
    beforehand has its own extent."""
    if options.map is not None:
        return {}
    places = [place for robot in options.robots
              for place in (robot.start, robot.goal)]
    return {"xmin": min(x for x, _, _ in places) - _MAP_MARGIN,
            "ymin": min(y for _, y, _ in places) - _MAP_MARGIN,
            "xmax": max(x for x, _, _ in places) + _MAP_MARGIN,
            "ymax": max(y for _, y, _ in places) + _MAP_MARGIN}


def launch_arguments(options):
    arguments = {
        **map_extent(options),
        "world": options.world, "seed": options.seed, "config": options.config,
        "map_file": options.map, "rviz": str(not options.headless).lower(),
        "lockstep": str(options.headless).lower(),
    }
    # The map has the world's coordinates when the robots know where in the
    # world they start.
    if len(options.robots) > 1:
        arguments["names"] = " ".join(r.name for r in options.robots)
        arguments["starts"] = " ".join(
            ",".join(map(str, r.start)) for r in options.robots)
    else:
        x, y, yaw = options.robots[0].start
        arguments.update(x=x, y=y, yaw=yaw, initial_pose_x=x, initial_pose_y=y,
                         initial_pose_a=yaw)
    return arguments


def launch_file(options):
    name = "robots.launch" if len(options.robots) > 1 else "demo.launch"
    return os.path.join(scene.ROOT, "launch", name)


def run(options):
    """Returns whether every goal was reached without contact."""
    os.makedirs(_OUTPUT, exist_ok=True)
    os.makedirs(os.path.dirname(os.path.abspath(options.picture)),
                exist_ok=True)
    log = os.path.join(_OUTPUT, "roslaunch.log")
    with LaunchedStack(launch_file(options), launch_arguments(options),
                       log) as stack:
        os.environ["ROS_MASTER_URI"] = stack.master_uri
        # They read the environment of the master when they are loaded.
        from driver import goal_drive, picture
        from driver.observer import Observer
        demo_report.print_scene(options.world, options.robots)
        print("ROS master {}, log {}".format(stack.master_uri, log), flush=True)
        goal_drive.connect(stack, "demo")
        names = [robot.name for robot in options.robots]
        observers = [Observer(namespace=name) for name in names]
        records = goal_drive.drive_all(
            stack,
            [goal_drive.DriveTask(observer, robot.start, robot.goal)
             for observer, robot in zip(observers, options.robots)],
            options.time_limit,
            demo_report.ProgressPrinter(dict(zip(names, observers))))
        outcome = dict(zip(names, records))
        picture.draw(outcome, options.picture, os.path.basename(options.world))
        demo_report.print_outcome(outcome, options.picture)
        if options.json:
            with open(options.json, "w") as file:
                json.dump(demo_report.figures(outcome), file, indent=2)
        if not options.headless:
            follow_clicks(stack, dict(zip(names, observers)))
    return all(record.reached_without_contact() for record in records)


def follow_clicks(stack, observers):
    """Tells what the robots do with clicked goals until the launch ends.

    observers: {robot's name: Observer}
    """
    print("\nClick goals with '2D Nav Goal' in RViz; Ctrl-C ends.", flush=True)
    shown = {}
    while True:
        try:
            stack.check_alive()
        except LaunchError:
            return
        for name, observer in observers.items():
            state = observer.last_state
            now = state and (state.state, state.reason)
            if now and now != shown.get(name):
                shown[name] = now
                print("{}{:<10} {}".format(name and name + "  ", *now),
                      flush=True)
        time.sleep(0.1)


def main():
    options = parse_arguments(sys.argv[1:])
    interruption.exit_on_signals()
    try:
        return 0 if run(options) else 1
    except LaunchError as error:
        print("demo: {}".format(error), file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
