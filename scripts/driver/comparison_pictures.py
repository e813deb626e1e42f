"""Draws one drive of each stack through one scene with one noise: the paper's
figures, for as many stacks as there are."""

import itertools
import math
import os

from driver import picture, world_shapes
from driver.comparison_tables import stack_title
from driver.picture import np, plt

_DPI = 90
_PANELS_IN_A_ROW = 2
_FAINT = 0.3  # alpha of a plan that was replaced, and less where there are many
_ERRORS = ("along [m]", "across [m]", "heading [rad]")


class Pictures:
    """Draws into a folder.

    drives: those of one scene and noise with a record, one for each stack.
    """

    def __init__(self, drives, folder):
        self._drives, self._folder = drives, folder
        task = drives[0].task
        self._prefix = "{}_{}_".format(task.scene.name, task.noise)
        self._shapes = world_shapes.read(task.scene.world)

    def _colored(self):
        return zip(itertools.cycle(picture.COLORS), self._drives)

    def _save(self, figure, name):
        file = self._prefix + name + ".png"
        figure.savefig(os.path.join(self._folder, file), dpi=_DPI,
                       bbox_inches="tight")
        plt.close(figure)
        return file

    def _panels(self, drives):
        """A figure with a map for each drive, side by side, of one extent."""
        low, high = picture.limits([d.record for d in drives])
        width, height = high - low
        columns = min(len(drives), _PANELS_IN_A_ROW)
        rows = math.ceil(len(drives) / columns)
        panel = 5.0 if width > height else 3.5
        figure, axes = plt.subplots(
            rows, columns, squeeze=False, sharey=True,
            figsize=(panel * columns, (panel * height / width + 0.8) * rows))
        axes = axes.flatten()
        for axis in axes[len(drives):]:
            axis.remove()
        for axis, drive in zip(axes, drives):
            picture.draw_map(axis, drive.record)
            axis.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]),
                     title=stack_title(drive.task.stack))
        return figure, axes[:len(drives)]

    def _legend(self, figure, axes):
        """Below, with whatever any of the panels shows."""
        entries = {}
        for axis in axes:
            handles, labels = axis.get_legend_handles_labels()
            entries.update(zip(labels, handles))
        figure.legend(entries.values(), entries.keys(), loc="upper center",
                      bbox_to_anchor=(0.5, 0.02), ncol=6, fontsize=8)

    def draw_plans(self):
        """Each stack's first plan strong, the later ones faint. Nothing where no
        stack has published one."""
        drives = [d for d in self._drives if d.record.plans]
        if not drives:
            return None
        figure, axes = self._panels(drives)
        for axis, drive in zip(axes, drives):
            first, *later = drive.record.plans
            faint = max(0.03, _FAINT / max(1.0, len(later) / 20.0))
            for plan in later:
                axis.plot(*plan.T, color="tab:blue", alpha=faint, linewidth=0.6)
            axis.plot(*first.T, color="tab:blue", linewidth=2.0,
                      label="first plan")
        self._legend(figure, axes)
        return self._save(figure, "plans")

    def draw_trajectories(self):
        """The longest trajectory of each over the path that it was fitted to.
        Nothing where no stack publishes trajectories."""
        pairs = [(drive, drive.record.longest_trajectory())
                 for drive in self._drives]
        pairs = [(drive, pair) for drive, pair in pairs if pair]
        if not pairs:
            return None
        figure, axes = self._panels([drive for drive, _ in pairs])
        for axis, (_, (trajectory, plan)) in zip(axes, pairs):
            axis.plot(*trajectory.T, color="tab:green", linewidth=3.5,
                      label="trajectory")
            axis.plot(*plan.T, color="tab:blue", linewidth=1.2, label="path")
        self._legend(figure, axes)
        return self._save(figure, "trajectories")

    def draw_driven(self):
        """All stacks' driven paths among the world's obstacles."""
        figure, axes = plt.subplots(figsize=(9, 9))
        records = [d.record for d in self._drives]
        if not self._shapes.standing:
            picture.draw_map(axes, records[0])
        else:
            picture.draw_ends(axes, records[0])
            axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
        self._draw_shapes(axes)
        for color, drive in self._colored():
            picture.draw_driven(axes, drive.record, color,
                                stack_title(drive.task.stack))
            picture.draw_outlines(axes, drive.record, color)
        picture.frame(axes, records)
        picture.legend_below(axes, columns=3)
        return self._save(figure, "driven")

    def _draw_shapes(self, axes):
        for outline in self._shapes.standing:
            axes.fill(*outline.T, color="black", linewidth=0)
        for way in self._shapes.ways:
            axes.plot(*way.T, ":", color="tab:gray")
        for i, outline in enumerate(self._shapes.appearing):
            axes.fill(*outline.T, color="tab:gray", alpha=0.6,
                      label=None if i else "moves or pops up")

    def draw_errors(self):
        """Distances from the newest plan over time, of every stack; and below
        them the tracking errors of those that publish them."""
        tracked = [(color, d) for color, d in self._colored()
                   if any(s.state == "TRACKING" for s in d.record.states)]
        rows = 1 + (len(_ERRORS) if tracked else 0)
        figure, axes = plt.subplots(rows, 1, squeeze=False, sharex=True,
                                    figsize=(9, 1.2 + 2.0 * rows))
        axes = axes[:, 0]
        for color, drive in self._colored():
            record = drive.record
            axes[0].plot(*np.array(
                [(time - record.began, distance) for time, distance
                 in record.distances_from_plan()]).reshape(-1, 2).T,
                color=color, linewidth=1.0, label=stack_title(drive.task.stack))
        axes[0].set_ylabel("off the plan [m]")
        axes[0].legend(loc="best", fontsize=8)
        for i, title in enumerate(_ERRORS if tracked else ()):
            for color, drive in tracked:
                times, errors = _tracking_errors(drive.record, i)
                axes[1 + i].plot(times, errors, color=color, linewidth=0.9)
            axes[1 + i].set_ylabel(title)
        for axis in axes:
            axis.grid(alpha=0.3)
        axes[-1].set_xlabel("time [s]")
        figure.tight_layout()
        return self._save(figure, "errors")


def _tracking_errors(record, component):
    """Times since the goal was sent, and errors, nan where nothing is
    tracked."""
    times = [s.time - record.began for s in record.states]
    errors = [s.error[component] if s.state == "TRACKING" else np.nan
              for s in record.states]
    return times, errors
