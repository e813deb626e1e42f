"""Writes what a comparison has found: a table, the paths, the errors."""

import os

from driver import picture
from driver.picture import plt

_COLUMNS = (
    ("outcome", "outcome", "{}"),
    ("contact", "contact", "{}"),
    ("time_s", "time [s]", "{:.1f}"),
    ("path_m", "path [m]", "{:.2f}"),
    ("min_clearance_m", "least clearance [m]", "{:.2f}"),
    ("plan_rms_m", "RMS distance from the plan [m]", "{:.3f}"),
    ("plan_max_m", "greatest distance from the plan [m]", "{:.3f}"),
    ("cpu_s", "CPU [s]", "{:.1f}"),
)


def table(records):
    """In Markdown, one line for each stack."""
    lines = ["| stack | " + " | ".join(title for _, title, _ in _COLUMNS) + " |",
             "|---" * (len(_COLUMNS) + 1) + "|"]
    for name, record in records.items():
        figures = record.figures()
        cells = ["-" if figures[key] is None else form.format(figures[key])
                 for key, _, form in _COLUMNS]
        lines.append("| " + " | ".join([name] + cells) + " |")
    return "\n".join(lines)


def _draw_paths(records, file):
    figure, axes = plt.subplots(figsize=(9, 9))
    picture.draw_map(axes, next(iter(records.values())))
    for color, (name, record) in zip(picture.COLORS, records.items()):
        picture.draw_driven(axes, record, color, name)
    picture.frame(axes, list(records.values()))
    picture.legend_below(axes)
    figure.savefig(file, dpi=120, bbox_inches="tight")
    plt.close(figure)


def _draw_errors(records, file):
    figure, axes = plt.subplots(figsize=(9, 4))
    for color, (name, record) in zip(picture.COLORS, records.items()):
        distances = record.distances_from_plan()
        axes.plot([time - record.began for time, _ in distances],
                  [distance for _, distance in distances],
                  color=color, label=name)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("distance from the plan [m]")
    axes.grid(alpha=0.3)
    axes.legend(loc="best", fontsize=8)
    figure.savefig(file, dpi=120, bbox_inches="tight")
    plt.close(figure)


def write(records, notes, world, folder):
    """Writes report.md and its pictures; returns the table.

    records: {stack's name: DriveRecord}; notes: sentences on those left out.
    """
    parts = ["# {}".format(world)] + notes
    if records:
        parts.append(table(records))
        _draw_paths(records, os.path.join(folder, "paths.png"))
        _draw_errors(records, os.path.join(folder, "errors.png"))
        parts += ["Driven paths, by ground truth, over the map that {} built:"
                  .format(next(iter(records))),
                  "![paths](paths.png)",
                  "Distance of the robot from the newest plan:",
                  "![errors](errors.png)",
                  "CPU is what the stack's own processes used from sending the "
                  "goal to its result, without simulator and ROS master."]
    with open(os.path.join(folder, "report.md"), "w") as report:
        report.write("\n\n".join(parts) + "\n")
    return parts[len(notes) + 1] if records else ""
