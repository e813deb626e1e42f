"""Drives the simulated Jackal to a goal, tells how it went and draws it."""

import argparse
import json
import os
import signal
import sys
import time

from driver import scene, world_file
from driver.launched_stack import LaunchedStack, LaunchError

_OUTPUT = os.path.join(scene.OUTPUT, "demo")
_MAP_MARGIN = 20.0  # m


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="demo", description=__doc__)
    parser.add_argument("--headless", action="store_true",
                        help="no RViz; ends with the drive")
    scene.add_arguments(parser)
    parser.add_argument("--map", metavar="FILE", help="a map_server map known "
                        "beforehand (none: the robot builds it as it drives)")
    parser.add_argument("--picture", metavar="PNG",
                        help="(.workspace/demo/<world>.png)")
    options = parser.parse_args(arguments)
    try:
        scene.complete(options, ("world", "config", "map"))
    except (scene.SceneError, world_file.WorldFileError) as error:
        parser.error(str(error))
    if options.picture is None:
        options.picture = os.path.join(_OUTPUT,
                                       scene.world_name(options) + ".png")
    return options


def map_extent(options):
    """The map to begin with, with room around start and goal; a map given
    beforehand has its own extent."""
    if options.map is not None:
        return {}
    (x, y, _), (goal_x, goal_y, _) = options.start, options.goal
    return {"xmin": min(x, goal_x) - _MAP_MARGIN,
            "ymin": min(y, goal_y) - _MAP_MARGIN,
            "xmax": max(x, goal_x) + _MAP_MARGIN,
            "ymax": max(y, goal_y) + _MAP_MARGIN}


def launch_arguments(options):
    x, y, yaw = options.start
    return {
        **map_extent(options),
        "world": options.world, "x": x, "y": y, "yaw": yaw,
        # The map has the world's coordinates when the robot knows where in the
        # world it starts.
        "initial_pose_x": x, "initial_pose_y": y, "initial_pose_a": yaw,
        "seed": options.seed, "config": options.config,
        "map_file": options.map, "rviz": str(not options.headless).lower(),
        "lockstep": str(options.headless).lower(),
    }


class ProgressPrinter:
    """One line every second of simulated time, and at every new state."""

    def __init__(self, observer):
        self._observer = observer
        self._next = 0.0
        self._state = None

    def __call__(self, elapsed):
        state = self._observer.last_state
        if state is None:
            return
        if elapsed < self._next and state.state == self._state:
            return
        self._next = max(self._next, elapsed) + (elapsed >= self._next)
        self._state = state.state
        # Rounded first, and 0 added: no "-0.00".
        print("{:7.1f} s  {:<10} {:6.2f} m to go  {:5.2f} m/s  "
              "clearance {:.2f} m".format(
                  elapsed, state.state, state.distance_to_goal,
                  round(state.speed, 2) + 0.0, state.clearance), flush=True)


def print_outcome(record, picture):
    figures = record.figures()
    print()
    print("{}: {}".format("Goal reached" if record.succeeded
                          else "Goal not reached", record.message))
    print("time {:.1f} s (simulated), path {:.2f} m, least clearance {}, "
          "{}".format(
              figures["time_s"], figures["path_m"],
              "unknown" if figures["min_clearance_m"] is None
              else "{:.2f} m".format(figures["min_clearance_m"]),
              "contact with " + ", ".join(record.contacts)
              if record.contacts else "no contact"))
    print("picture: {}".format(picture))


def run(options):
    """Returns whether the goal was reached without contact."""
    os.makedirs(_OUTPUT, exist_ok=True)
    os.makedirs(os.path.dirname(os.path.abspath(options.picture)),
                exist_ok=True)
    launch_file = os.path.join(scene.ROOT, "launch", "demo.launch")
    log = os.path.join(_OUTPUT, "roslaunch.log")
    with LaunchedStack(launch_file, launch_arguments(options), log) as stack:
        os.environ["ROS_MASTER_URI"] = stack.master_uri
        # They read the environment of the master when they are loaded.
        from driver import goal_drive, picture
        from driver.observer import Observer
        print("World {}, from {} to {}".format(
            options.world, _text(options.start), _text(options.goal)))
        print("ROS master {}, log {}".format(stack.master_uri, log), flush=True)
        goal_drive.connect(stack, "demo")
        observer = Observer()
        record = goal_drive.drive(stack, observer, options.start, options.goal,
                                  options.time_limit, ProgressPrinter(observer))
        picture.draw(record, options.picture,
                     os.path.basename(options.world))
        print_outcome(record, options.picture)
        if options.json:
            with open(options.json, "w") as file:
                json.dump(record.figures(), file, indent=2)
        if not options.headless:
            follow_clicks(stack, observer)
    return record.reached_without_contact()


def _text(pose):
    return "({:g}, {:g}, {:.3g})".format(*pose)


def follow_clicks(stack, observer):
    """Tells what the robot does with clicked goals until the launch ends."""
    print("\nClick goals with '2D Nav Goal' in RViz; Ctrl-C ends.", flush=True)
    shown = None
    while True:
        try:
            stack.check_alive()
        except LaunchError:
            return
        state = observer.last_state
        if state is not None and (state.state, state.reason) != shown:
            shown = (state.state, state.reason)
            print("{:<10} {}".format(*shown), flush=True)
        time.sleep(0.1)


def _end_on_signal(number, _):
    raise SystemExit(128 + number)


def main():
    options = parse_arguments(sys.argv[1:])
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _end_on_signal)
    try:
        return 0 if run(options) else 1
    except LaunchError as error:
        print("demo: {}".format(error), file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
