"""What stands and moves in a world of this package, as outlines to draw."""

import math
from dataclasses import dataclass
from typing import List

import numpy as np

from driver import world_file

_WALKER_RADIUS = 0.25  # m, where the file has none
_WALL_THICKNESS = 0.1  # m, likewise


@dataclass
class WorldShapes:
    """Outlines are N x 2 in m, closed."""

    standing: List[np.ndarray]
    # What moves, or pops up, where it begins, and the ways of what moves.
    appearing: List[np.ndarray]
    ways: List[np.ndarray]


def _circle(centre, radius):
    angles = np.linspace(0.0, 2.0 * math.pi, 33)
    return np.array(centre) + radius * np.stack(
        [np.cos(angles), np.sin(angles)], axis=1)


def _rectangle(x, y, yaw, length, width):
    corners = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1)]) * (
        length / 2.0, width / 2.0)
    cosine, sine = math.cos(yaw), math.sin(yaw)
    return corners @ np.array([(cosine, sine), (-sine, cosine)]) + (x, y)


def _wall(wall):
    points = np.array(wall["points"], dtype=float)
    if wall.get("closed"):
        points = np.vstack([points, points[:1]])
    thickness = wall.get("thickness", _WALL_THICKNESS)
    outlines = []
    for begin, end in zip(points, points[1:]):
        x, y = (begin + end) / 2.0
        along = end - begin
        outlines.append(_rectangle(
            x, y, math.atan2(along[1], along[0]),
            np.hypot(*along) + thickness, thickness))
    return outlines


def _outlines(kind, solid):
    """Of a solid of a world file; kind: its singular name."""
    if kind == "wall":
        return _wall(solid)
    if kind == "box":
        return [_rectangle(*solid["pose"], *solid["size"])]
    if kind == "cylinder":
        return [_circle(solid["position"], solid["radius"])]
    if kind == "polygon":
        outline = np.array(solid["outline"], dtype=float)
        return [np.vstack([outline, outline[:1]])]
    return []


def _mover(mover):
    """Its outline where it begins, and its way."""
    way = np.array([frame[1:] for frame in mover["keyframes"]]
                   if "keyframes" in mover else mover["waypoints"], dtype=float)
    (kind, shape), = mover["shape"].items()
    if kind == "cylinder":
        return _circle(way[0], shape["radius"]), way
    return _rectangle(*way[0], shape.get("yaw", 0.0), *shape["size"]), way


def read(file):
    """Nothing of a world in another format than this package's YAML; there the
    map that a robot builds has to do.

    Raises WorldFileError for a file that cannot be parsed.
    """
    shapes = WorldShapes([], [], [])
    document = world_file.read_document(file)
    if "version" not in document:
        return shapes
    for kind, plural in (("wall", "walls"), ("box", "boxes"),
                         ("cylinder", "cylinders"), ("polygon", "polygons")):
        for solid in document.get(plural, ()):
            shapes.standing += _outlines(kind, solid)
    for pop_up in document.get("pop_ups", ()):
        (kind, solid), = pop_up["shape"].items()
        shapes.appearing += _outlines(kind, solid)
    for walker in document.get("walkers", ()):
        shapes.appearing.append(_circle(
            walker["position"], walker.get("radius", _WALKER_RADIUS)))
    for mover in document.get("movers", ()):
        outline, way = _mover(mover)
        shapes.appearing.append(outline)
        shapes.ways.append(way)
    return shapes
