"""Draws a drive: the map, what was planned and what was driven."""

import itertools
import math

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.transforms import Affine2D, ScaledTranslation  # noqa: E402

COLORS = ("tab:red", "tab:purple", "tab:green", "tab:brown", "tab:cyan",
          "tab:olive", "tab:pink")  # in turn
_LEGEND_SPACE = 0.5  # inches below the axes, for their label
_MARGIN = 1.5  # m around everything that was driven or planned
# m, the Jackal with its wheels about base_link: (front, rear, half width).
_FOOTPRINT = (0.229, 0.229, 0.208)


def _shades(cells):
    """Unknown light grey, free white, occupied black."""
    shades = 1.0 - np.clip(cells, 0, 100) / 100.0
    shades[cells < 0] = 0.82
    return shades


def _footprint_outline(x, y, yaw):
    front, rear, half = _FOOTPRINT
    corners = np.array([(front, half), (-rear, half), (-rear, -half),
                        (front, -half), (front, half)])
    cosine, sine = math.cos(yaw), math.sin(yaw)
    return corners @ np.array([(cosine, sine), (-sine, cosine)]) + (x, y)


def _draw_lines(axes, lines, color, label, width):
    """The last of the lines strong, those it replaced faint."""
    for line in lines[:-1]:
        axes.plot(line[:, 0], line[:, 1], color=color, alpha=0.25, linewidth=0.7)
    if lines:
        last = lines[-1]
        axes.plot(last[:, 0], last[:, 1], color=color, linewidth=width,
                  label=label)


def _points_of(record):
    yield np.array([record.start[:2], record.goal[:2]])
    yield from record.plans
    yield from record.trajectories
    if record.poses:
        yield np.array([(p.x, p.y) for p in record.poses])


def limits(records):
    """The corners (m) of what was driven and planned, with some room."""
    points = np.concatenate([p for r in records for p in _points_of(r)])
    return points.min(axis=0) - _MARGIN, points.max(axis=0) + _MARGIN


def frame(axes, records):
    """Shows what was driven and planned, not the whole of a large map, on a
    figure of that shape."""
    low, high = limits(records)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    width, height = high - low
    axes.figure.set_size_inches(
        9, min(14.0, max(4.0, 9.0 * height / width)))


def draw_driven(axes, record, color, label):
    driven = np.array([(p.x, p.y) for p in record.poses])
    if driven.size:
        axes.plot(driven[:, 0], driven[:, 1], color=color, linewidth=1.4,
                  label=label)


def draw_outlines(axes, record, color):
    """An outline every second."""
    next_outline = -math.inf
    for pose in record.poses:
        if pose.time >= next_outline:
            outline = _footprint_outline(pose.x, pose.y, pose.yaw)
            axes.plot(outline[:, 0], outline[:, 1], color=color, linewidth=0.5,
                      alpha=0.6)
            next_outline = pose.time + 1.0


def draw_map(axes, record):
    if record.map is not None:
        x, y, yaw = record.map.pose
        axes.imshow(_shades(record.map.cells), origin="lower", cmap="gray",
                    vmin=0.0, vmax=1.0, extent=record.map.extent(),
                    interpolation="nearest",
                    transform=(Affine2D().rotate(yaw).translate(x, y)
                               + axes.transData))
    draw_ends(axes, record)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def draw_ends(axes, record, named=True):
    """Start and goal; `named` in the legend."""
    axes.plot(*record.start[:2], "o", color="tab:blue", markersize=7,
              label="start" if named else None)
    axes.plot(*record.goal[:2], "*", color="tab:orange", markersize=13,
              label="goal" if named else None)


def legend_below(axes, columns=5):
    """Where it hides nothing of the map."""
    below_label = ScaledTranslation(0.0, -_LEGEND_SPACE,
                                    axes.figure.dpi_scale_trans)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0),
                bbox_transform=axes.transAxes + below_label, ncol=columns,
                fontsize=8)


def _draw_one(axes, record):
    _draw_lines(axes, record.trajectories, "tab:green", "trajectory", 4.0)
    _draw_lines(axes, record.plans, "tab:blue", "plan", 1.2)
    draw_driven(axes, record, "tab:red", "driven (ground truth)")
    draw_outlines(axes, record, "tab:red")


def _draw_several(axes, records):
    for color, (name, record) in zip(itertools.cycle(COLORS), records.items()):
        draw_ends(axes, record, named=False)
        draw_driven(axes, record, color, name)
        draw_outlines(axes, record, color)


def draw(records, file, title):
    """Writes a PNG of one robot's drive with its plans, or of several robots'
    at the same time, over the first one's map.

    records: {robot's name: DriveRecord}
    """
    figure, axes = plt.subplots(figsize=(9, 9))
    first = next(iter(records.values()))
    draw_map(axes, first)
    if len(records) == 1:
        _draw_one(axes, first)
    else:
        _draw_several(axes, records)
    frame(axes, list(records.values()))
    axes.set_title(title)
    legend_below(axes)
    figure.savefig(file, dpi=120, bbox_inches="tight")
    plt.close(figure)
