"""Draws the paper's figures from drives of its scenes: trajectory over path, and
the errors over time."""

import csv
import dataclasses
import os
import tempfile

from driver import drive_runs, paper_scenes, world_shapes
from driver.picture import np, plt

_TITLES = {"paper": "one quintic (config/paper.yaml)",
           "jackal": "piecewise quintic (config/jackal.yaml)"}
_EIGHTS = {"figure_eight_1": "1 m/s", "figure_eight_2": "2 m/s"}
_DPI = 80  # small files, for the documentation


class Drive:
    """A drive's course, and the paths and trajectories it was given.

    trace, motions: the benchmark program's CSV files.
    """

    def __init__(self, trace, motions):
        self._rows = _read(trace)
        self._points = _read(motions)

    def driven(self):
        return _numbers(self._rows, "x", "y")

    def reference(self):
        return _numbers([r for r in self._rows if r["reference_x"]],
                        "reference_x", "reference_y")

    def lines(self, kind):
        """{motion: points} of its paths or trajectories."""
        motions = {}
        for row in self._points:
            if row["line"] == kind:
                motions.setdefault(int(row["motion"]), []).append(row)
        return {motion: _numbers(rows, "x", "y")
                for motion, rows in motions.items()}

    def errors(self):
        """Times (s) and distances from the reference (m), nan where it is not
        being tracked."""
        times = _numbers(self._rows, "time")[:, 0]
        errors = np.hypot(*_numbers(self._rows, "e1", "e2").T)
        states = np.array([row["state"] for row in self._rows])
        errors[states != "TRACKING"] = np.nan
        return times, errors


def _drive(name, configuration):
    run = paper_scenes.first_run(name, configuration)
    with tempfile.TemporaryDirectory() as folder:
        trace = os.path.join(folder, "trace.csv")
        motions = os.path.join(folder, "motions.csv")
        drive_runs.perform(dataclasses.replace(run, options=(
            *run.options, "--trace", trace, "--motions", motions)))
        return Drive(trace, motions)


def _read(file):
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))


def _numbers(rows, *names):
    return np.array([[float(row[name]) for name in names] for row in rows])


def _length(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def _draw_motions(axes, drive):
    """All that was planned faint, and strong the motion with the longest path."""
    paths, trajectories = drive.lines("path"), drive.lines("trajectory")
    longest = max(paths, key=lambda motion: _length(paths[motion]))
    for motion, points in trajectories.items():
        strong = motion == longest
        axes.plot(*points.T, color="tab:green", linewidth=3.0 if strong else 0.7,
                  alpha=1.0 if strong else 0.4,
                  label="trajectory" if strong else None)
    axes.plot(*paths[longest].T, color="tab:blue", linewidth=1.2, label="path")


def _draw_course(axes, drive):
    axes.plot(*drive.driven().T, color="tab:red", linewidth=1.2,
              label="driven (truth)")
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def _draw_hairpin(drives, file):
    world = paper_scenes.first_run("hairpin", "jackal").world
    walls = world_shapes.read(world).standing
    figure, both = plt.subplots(2, 1, figsize=(7, 8.2))
    for axes, (configuration, drive) in zip(both, drives.items()):
        for wall in walls:
            axes.fill(*wall.T, color="black")
        limits = axes.get_xlim(), axes.get_ylim()
        _draw_motions(axes, drive)
        _draw_course(axes, drive)
        axes.set(xlim=limits[0], ylim=limits[1], title=_TITLES[configuration])
    figure.subplots_adjust(hspace=0.28)
    both[-1].legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncol=3,
                    fontsize=8)
    _save(figure, file)


def _draw_eights(drives, file):
    figure, both = plt.subplots(1, 2, figsize=(9, 2.9))
    for axes, (name, drive) in zip(both, drives.items()):
        axes.plot(*drive.reference().T, color="tab:green", linewidth=3.0,
                  label="reference")
        _draw_course(axes, drive)
        axes.set_title(_EIGHTS[name])
    figure.legend(*both[0].get_legend_handles_labels(), loc="lower center",
                  ncol=2, fontsize=8)
    figure.subplots_adjust(bottom=0.25)
    _save(figure, file)


def _draw_errors(scenes, file):
    """scenes: {title: {configuration: Drive}}"""
    figure, rows = plt.subplots(len(scenes), 1, figsize=(8, 5))
    for axes, (title, drives) in zip(rows, scenes.items()):
        for configuration, drive in drives.items():
            axes.plot(*drive.errors(), linewidth=0.9,
                      label="config/{}.yaml".format(configuration))
        axes.set(title=title, xlabel="time [s]",
                 ylabel="error of position [m]")
        axes.grid(alpha=0.3)
        axes.legend(loc="best", fontsize=8)
    figure.tight_layout()
    _save(figure, file)


def _save(figure, file):
    figure.savefig(file, dpi=_DPI, bbox_inches="tight")
    plt.close(figure)


def draw_all(folder):
    """Drives the hairpin and the figure eights once more and writes the
    pictures. Raises DriveError as drive_runs.perform does."""
    os.makedirs(folder, exist_ok=True)
    drives = {name: {configuration: _drive(name, configuration)
                     for configuration in paper_scenes.CONFIGURATIONS}
              for name in ("hairpin", *_EIGHTS)}
    _draw_hairpin(drives["hairpin"],
                  os.path.join(folder, "trajectory_hairpin.png"))
    _draw_eights({name: drives[name]["jackal"] for name in _EIGHTS},
                 os.path.join(folder, "trajectory_eight.png"))
    _draw_errors({"hairpin": drives["hairpin"],
                  "figure eight at 2 m/s": drives["figure_eight_2"]},
                 os.path.join(folder, "trajectory_errors.png"))
