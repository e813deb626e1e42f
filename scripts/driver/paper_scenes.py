"""The scenes of the paper's experiments, driven with its configuration and with
the one that a Jackal should run."""

import os

from driver import confidence, scene
from driver.drive_runs import DriveRun

CONFIGURATIONS = ("paper", "jackal")
_TIME_LIMIT = 200.0  # s; the paper's configuration takes its time
_WORLDS = {"hairpin": "hairpin", "u_shape": "u_shape", "pop_up": "pop_up",
           "walker": "operator", "drifting_hairpin": "hairpin"}
_OPTIONS = {"drifting_hairpin": ("--noise", "experiment")}
_FIGURE_EIGHTS = {"figure_eight_1": "1.0", "figure_eight_2": "2.0"}  # m/s
SCENES = (*_WORLDS, *_FIGURE_EIGHTS)


def runs(count):
    """`count` drives of each scene with each configuration."""
    return [_run(name, configuration, number)
            for name in SCENES for configuration in CONFIGURATIONS
            for number in range(count)]


def _run(name, configuration, number):
    labels = (("scenario", name), ("configuration", configuration),
              ("run", number))
    config = os.path.join(scene.ROOT, "config", configuration + ".yaml")
    options = ("--seed", str(number + 1), "--time-limit", repr(_TIME_LIMIT))
    if name in _FIGURE_EIGHTS:
        return DriveRun(labels, None, config, (
            *options, "--figure-eight", _FIGURE_EIGHTS[name]))
    world = os.path.join(scene.ROOT, "worlds", _WORLDS[name] + ".yaml")
    return DriveRun(labels, world, config, (*options,
                                            *_OPTIONS.get(name, ())))


def first_run(name, configuration):
    return _run(name, configuration, 0)


def _mean(values):
    return sum(values) / len(values) if values else None


def summary(results):
    """{"scenarios": {scene: {configuration: figures}}}: rates from 0 to 1;
    means over the drives that reached the goal, of least clearance and greatest
    error the extreme over all drives."""
    scenarios = {}
    for name in SCENES:
        scenarios[name] = {}
        for configuration in CONFIGURATIONS:
            drives = [r for r in results if r["scenario"] == name
                      and r["configuration"] == configuration]
            scenarios[name][configuration] = _figures(drives)
    return {"scenarios": scenarios, "runs": results}


def _figures(drives):
    reached = [d for d in drives if d["outcome"] == "success"]
    clearances = [d["min_clearance_m"] for d in drives
                  if d["min_clearance_m"] is not None]
    return {
        "success": len(reached) / len(drives),
        "collision": sum("collision" in d for d in drives) / len(drives),
        "time_s": _mean([d["time_s"] for d in reached]),
        "path_m": _mean([d["path_m"] for d in reached]),
        "min_clearance_m": min(clearances, default=None),
        "rms_error_m": _mean([d["rms_error_m"] for d in reached]),
        "true_rms_error_m": _mean([d["true_rms_error_m"] for d in reached]),
        "max_error_m": max(d["max_error_m"] for d in drives),
        "goal_heading_error_deg": max(
            (abs(d["goal_heading_error_deg"]) for d in reached), default=None),
        "replans": _mean([d["replans"] for d in drives]),
    }


_COLUMNS = (("success", "success", "{:.0%}"),
            ("collision", "contact", "{:.0%}"),
            ("time_s", "time [s]", "{:.1f}"), ("path_m", "path [m]", "{:.1f}"),
            ("min_clearance_m", "least [m]", "{:.2f}"),
            ("rms_error_m", "rms [m]", "{:.3f}"),
            ("max_error_m", "max [m]", "{:.3f}"),
            ("replans", "replans", "{:.1f}"))


def table(figures):
    """A line for each scene and configuration, then what failed."""
    lines = ["{:17} {:7}".format("scene", "config") + "".join(
        "{:>11}".format(title) for _, title, _ in _COLUMNS)]
    for name, configurations in figures["scenarios"].items():
        for configuration, values in configurations.items():
            lines.append("{:17} {:7}".format(name, configuration) + "".join(
                "{:>11}".format("-" if values[key] is None
                                else form.format(values[key]))
                for key, _, form in _COLUMNS))
    runs_of_each = len(figures["runs"]) // (len(SCENES) * len(CONFIGURATIONS))
    lines.append("{} runs of each; all of them right means {:.0%} or more with "
                 "95 % confidence".format(
                     runs_of_each, confidence.rate_interval(
                         runs_of_each, runs_of_each)[0]))
    for drive in figures["runs"]:
        if drive["outcome"] != "success":
            lines.append("{scenario}, {configuration}, run {run}: {outcome} "
                         "after {time_s:.1f} s: {message}".format(**drive))
    return lines
