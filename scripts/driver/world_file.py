"""What a drive has to know of a world: where robots start and go to.

Everything else in the file is the simulator's to read and to check.
"""

import math
from dataclasses import dataclass
from typing import Optional, Tuple

import yaml


class WorldFileError(Exception):
    """The message names the file, the field, its value and what is expected."""


@dataclass(frozen=True)
class Robot:
    """As the world file has it."""

    name: str
    start: Tuple[float, float, float]  # m, m, rad
    goal: Optional[Tuple[float, ...]]  # m, m[, rad]


def _pose(document, name, file, counts):
    value = document
    for key in name.split("."):
        try:
            value = value[int(key) if key.isdigit() else key]
        except (KeyError, IndexError, TypeError):
            return None
    numbers = (isinstance(value, list) and len(value) in counts
               and all(isinstance(v, (int, float)) and math.isfinite(v)
                       for v in value))
    if not numbers:
        raise WorldFileError("{}: {} is {!r}; expected {} finite numbers".format(
            file, name, value, " or ".join(map(str, counts))))
    return tuple(float(v) for v in value)


def _parse(file):
    try:
        with open(file) as stream:
            return yaml.safe_load(stream)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise WorldFileError("{}: {}".format(file, error)) from error


def read_document(file):
    """What a YAML world holds; nothing of other formats.

    Raises WorldFileError for a file that cannot be parsed.
    """
    document = _parse(file) if file.endswith((".yaml", ".yml")) else None
    return document if isinstance(document, dict) else {}


def read_start_and_goal(file):
    """(x, y, yaw) and (x, y[, yaw]) in m and rad, each None where the world
    does not say.

    Raises WorldFileError for a YAML file that cannot be parsed and for a start
    or goal that is not a pose.
    """
    document = read_document(file)
    return (_pose(document, "robots.0.start", file, (3,)),
            _pose(document, "goal", file, (2, 3)))


def read_robots(file):
    """The robots of a world of this package, each with its start and its own
    goal.

    Raises WorldFileError as read_start_and_goal does, and for a robot without a
    start.
    """
    document = read_document(file)
    entries = document.get("robots")
    robots = []
    for i, entry in enumerate(entries if isinstance(entries, list) else []):
        field = "robots.{}".format(i)
        start = _pose(document, field + ".start", file, (3,))
        if start is None:
            raise WorldFileError("{}: {}.start is missing; expected 3 finite "
                                 "numbers".format(file, field))
        robots.append(Robot(
            str(entry.get("name", "robot_{}".format(i + 1))), start,
            _pose(document, field + ".goal", file, (2, 3))))
    return robots
