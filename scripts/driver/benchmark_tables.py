"""Tables of BARN and DynaBARN figures that scripts/benchmark has written, beside
what has been published."""

import json
import os
from dataclasses import dataclass

from driver import confidence

_NEEDED = ("runs", "success", "collision", "timeout", "mean_time_s")
_SCORES = (("score_k4", "score, k = 4"), ("score_k2", "score, k = 2"))
# Of BARN, by its organisers and the papers on it: what, success, and the scores.
_PUBLISHED = (
    ("published: TrajectoryPlannerROS at 0.5 m/s", "85 to 94 %", "0.158", ""),
    ("published: the best learned one", "98 %", "", "0.489"),
    ("published: the winner of 2026, A* with VFH*", "", "", "0.4975"))


class FiguresError(Exception):
    """The message names the file and what is wrong with it."""


@dataclass(frozen=True)
class Benchmark:
    label: str
    figures: dict


def read(text):
    """[LABEL=]FILE; the label is the file's name where there is none. Raises
    FiguresError."""
    label, separator, file = text.rpartition("=")
    if not separator:
        label = os.path.splitext(os.path.basename(file))[0]
    try:
        with open(file) as stream:
            figures = json.load(stream)
    except (OSError, ValueError) as error:
        raise FiguresError("{}: {}".format(file, error)) from error
    missing = [name for name in _NEEDED if not isinstance(figures, dict)
               or name not in figures]
    if missing or not figures["runs"]:
        raise FiguresError("{}: it has no {}; expected what scripts/benchmark "
                           "barn or dynabarn writes with --json".format(
                               file, missing[0] if missing else "runs"))
    return Benchmark(label, figures)


def _rate(figures, name):
    runs = figures["runs"]
    low, high = confidence.rate_interval(
        sum(r["outcome"] == name for r in runs), len(runs))
    return "{:.1%} ({:.0%} to {:.0%})".format(figures[name], low, high)


def _mean(values, form):
    return confidence.mean_text(values, form) if values else ""


def _row(benchmark, scores):
    figures = benchmark.figures
    runs = figures["runs"]
    return [benchmark.label, str(len({r["world"] for r in runs})),
            str(len(runs)),
            *(_rate(figures, name) for name in ("success", "collision",
                                                "timeout")),
            _mean([r["time_s"] for r in runs if r["outcome"] == "success"],
                  "{:.1f}"),
            *(_mean([r[name] for r in runs if name in r], "{:.3f}")
              for name in scores)]


_HEADER = ["", "worlds", "runs", "success", "collision", "timeout",
           "time of successes [s]"]


def barn_table(benchmarks):
    """(header, rows) with the published ones at the end."""
    rows = [_row(b, [name for name, _ in _SCORES]) for b in benchmarks]
    rows += [[what, "", "", success, "", "", "", k4, k2]
             for what, success, k4, k2 in _PUBLISHED]
    return _HEADER + [title for _, title in _SCORES], rows


def dynabarn_table(benchmarks):
    return _HEADER, [_row(b, ()) for b in benchmarks]
