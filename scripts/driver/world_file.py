"""What a drive has to know of a world: where it starts and where it goes to.

Everything else in the file is the simulator's to read and to check.
"""

import math

import yaml


class WorldFileError(Exception):
    """The message names the file, the field, its value and what is expected."""


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


def read_start_and_goal(file):
    """(x, y, yaw) and (x, y[, yaw]) in m and rad, each None where the world
    does not say.

    Raises WorldFileError for a YAML file that cannot be parsed and for a start
    or goal that is not a pose.
    """
    if not file.endswith((".yaml", ".yml")):
        return None, None  # other formats have neither
    try:
        with open(file) as stream:
            document = yaml.safe_load(stream)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise WorldFileError("{}: {}".format(file, error)) from error
    return (_pose(document, "robots.0.start", file, (3,)),
            _pose(document, "goal", file, (2, 3)))
