"""The tables of a comparison, as headers and rows of text."""

import os

from driver import confidence, scene
from driver.stacks import STACKS

_OWN_TITLES = {"vfh_astar": "ours",
               "vfh_astar_paper": "paper's configuration"}
NOISES = {"clean": "simulation without noise",
          "experiment": "experiment: odometry and laser with noise"}


def _mean_of(form):
    return lambda values: confidence.mean_text(values, form)


def _extreme(choose, form):
    return lambda values: form.format(choose(values))


# Figure of a drive's record, title, how those of several drives become one, and
# whether only drives that reached the goal without contact count.
_MEASURES = (
    ("time_s", "time [s]", _mean_of("{:.1f}"), True),
    ("path_m", "path [m]", _mean_of("{:.2f}"), True),
    ("min_clearance_m", "least clearance [m]", _extreme(min, "{:.2f}"), False),
    ("plan_rms_m", "RMS off the plan [m]", _mean_of("{:.3f}"), True),
    ("jerk_rms", "jerk RMS [m/s³]", _mean_of("{:.1f}"), True),
    ("turn_reversals", "turn reversals", _mean_of("{:.1f}"), True),
    ("replans", "replans", _mean_of("{:.1f}"), True),
    ("stops", "stops", _mean_of("{:.1f}"), True),
    ("cpu_s", "CPU [s]", _mean_of("{:.1f}"), True),
    ("peak_memory_mb", "peak memory [MB]", _extreme(max, "{:.0f}"), False),
    ("missed_cycles", "cycles missed", _mean_of("{:.1f}"), False),
    ("realtime_factor", "least real-time factor", _extreme(min, "{:.2f}"),
     False),
)


def names(values):
    """Each once, in their order."""
    return list(dict.fromkeys(values))


def _of(drives, stack, noise):
    return [d for d in drives if d.task.stack == stack
            and d.task.noise == noise]


def _reached(drives):
    return [d for d in drives if d.record
            and d.record.reached_without_contact()]


def stack_title(name):
    return "{} ({})".format(_OWN_TITLES.get(name, "navigation stack"), name)


def stacks(drives):
    """What each stack is made of."""
    rows = {}
    for task in (d.task for d in drives):
        arguments = STACKS[task.stack].launch_arguments
        plugins = [arguments[name] for name in ("global_planner",
                                                "local_planner")
                   if name in arguments]
        rows[task.stack] = [task.stack, os.path.relpath(
            task.config, scene.ROOT), ", ".join(plugins) or "–"]
    return ["stack", "configuration", "plugins"], list(rows.values())


def completion_times(drives):
    """The paper's Table I for one scene: a row for each noise, a column for each
    stack; seconds until the goal was reached without contact."""
    columns = names(d.task.stack for d in drives)

    def cell(stack, noise):
        own = _of(drives, stack, noise)
        driven = [d for d in own if d.record]
        reached = _reached(own)
        if not driven:
            return "not driven"
        if not reached:
            return "none of {}".format(len(driven))
        return "{} s ({} of {})".format(
            confidence.mean_text([d.record.duration() for d in reached],
                                 "{:.1f}"),
            len(reached), len(driven))

    return (["completion time"] + [stack_title(name) for name in columns],
            [[NOISES[noise]] + [cell(stack, noise) for stack in columns]
             for noise in names(d.task.noise for d in drives)])


def measures(drives):
    """All that was measured in one scene: a row for each measure, a column for
    each noise and stack that drove."""
    columns = []
    for noise in names(d.task.noise for d in drives):
        for stack in names(d.task.stack for d in drives):
            driven = [d for d in _of(drives, stack, noise) if d.record]
            if driven:
                columns.append(["{}, {}".format(stack, noise)]
                               + _measures_of(driven))
    titles = ["measure", "drives", "reached without contact", "contacts"] + [
        title for _, title, _, _ in _MEASURES]
    header, *rows = [list(row) for row in zip(titles, *columns)]
    return header, rows


def _measures_of(driven):
    every = [d.record.figures() for d in driven]
    reached = [d.record.figures() for d in _reached(driven)]
    cells = [str(len(driven)), str(len(reached)),
             str(sum(f["contact"] for f in every))]
    for key, _, combine, only_reached in _MEASURES:
        values = [f[key] for f in (reached if only_reached else every)
                  if f[key] is not None]
        cells.append(combine(values) if values else "–")
    return cells


def failures(drives):
    """A sentence for each drive that did not reach its goal without contact."""
    lines = []
    for drive in drives:
        record, task = drive.record, drive.task
        if record and not record.reached_without_contact():
            what = ("touched " + ", ".join(record.contacts)
                    if record.contacts else "did not reach the goal")
            lines.append("{}, {}, run {}: {} ({:.1f} s; {})".format(
                task.stack, task.noise, task.number + 1, what,
                record.duration(), record.message or "no message"))
    return lines
