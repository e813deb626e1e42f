"""The scene of a drive as the command line gives it: world, start and goal."""

import argparse
import dataclasses
import math
import os

from driver import poses, world_file

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
OUTPUT = os.path.join(ROOT, ".workspace")
DEFAULT_WORLD = os.path.join(ROOT, "worlds", "hairpin.yaml")


class SceneError(Exception):
    """The scene is not complete or a file is not there."""


def _seconds(text):
    seconds = float(text)
    if not 0.0 < seconds < math.inf:
        raise argparse.ArgumentTypeError(
            "{!r} is no finite time above 0 s".format(text))
    return seconds


def add_arguments(parser):
    parser.add_argument(
        "--world", metavar="FILE",
        default=DEFAULT_WORLD,
        help="world of this package, Gazebo .world, DynaBARN or map_server "
        "file (the hairpin)")
    parser.add_argument("--start", type=poses.pose_argument,
                        metavar="X,Y,YAW", help="m, m, rad (the world's own)")
    parser.add_argument("--goal", type=poses.goal_argument,
                        metavar="X,Y[,YAW]", help="m, m, rad (the world's own)")
    parser.add_argument("--config", metavar="FILE",
                        default=os.path.join(ROOT, "config", "jackal.yaml"),
                        help="the navigation's parameters (config/jackal.yaml)")
    parser.add_argument("--seed", type=int, default=1,
                        help="of the simulator's noise (1)")
    parser.add_argument("--time-limit", type=_seconds, default=300.0, metavar="S",
                        help="simulated seconds (300)")
    parser.add_argument("--json", metavar="FILE",
                        help="write the figures to a file too")


def complete(options, file_options=("world", "config")):
    """Gives files their whole names and takes from the world what the command
    line leaves open.

    Raises SceneError or world_file.WorldFileError.
    """
    find_files(options, file_options)
    count = len(world_file.read_robots(options.world))
    if count > 1:
        raise SceneError("{0} has {1} robots; expected one (scripts/demo "
                         "--robots {1} drives them all)".format(
                             options.world, count))
    own_start, own_goal = world_file.read_start_and_goal(options.world)
    options.start = options.start or own_start
    goal = options.goal or own_goal
    if options.start is None:
        raise SceneError("{} names no start: give --start X,Y,YAW".format(
            options.world))
    if goal is None:
        raise SceneError("{} names no goal: give --goal X,Y,YAW".format(
            options.world))
    options.goal = poses.with_yaw(goal, options.start)


def find_files(options, file_options):
    """The part of complete() that looks at files.

    Raises SceneError for one that is not there, or cannot be written.
    """
    for name in file_options:
        file = getattr(options, name)
        if file is None:
            continue
        if not os.path.isfile(file):
            raise SceneError("--{}: there is no file {}".format(name, file))
        setattr(options, name, os.path.abspath(file))
    if options.json and not os.path.isdir(
            os.path.dirname(os.path.abspath(options.json))):
        raise SceneError("--json: there is no folder for {}".format(
            options.json))


def robots_with_goals(world, count):
    """The world's robots, each with a whole pose as its goal.

    Raises SceneError unless there are so many and each has a goal, or
    world_file.WorldFileError.
    """
    robots = world_file.read_robots(world)
    if len(robots) != count:
        raise SceneError(
            "--robots is {}, and {} has {}; expected a world with as many".format(
                count, world, len(robots)))
    for robot in robots:
        if robot.goal is None:
            raise SceneError("{}: robot {} has no goal; expected one for each "
                             "robot".format(world, robot.name))
    return [dataclasses.replace(
        robot, goal=poses.with_yaw(robot.goal, robot.start))
        for robot in robots]


def world_name(options):
    return os.path.splitext(os.path.basename(options.world))[0]
