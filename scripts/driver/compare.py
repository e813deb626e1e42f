"""Drives scenes with each of several navigation stacks, without noise and with,
and writes a report that compares them."""

import argparse
import json
import os
import sys

from driver import (amounts, benchmark_tables, comparison, interruption, machine,
                    scene, world_file)
from driver.stacks import STACKS

_STACKS = ("move_base", "vfh_astar_paper", "vfh_astar")  # as the paper has them
_NOISES = ("clean", "experiment")


def _list(known, what):
    """A reader of a list whose members have to be among the known."""
    def read(text):
        names = text.split(",")
        for name in names:
            if name not in known:
                raise argparse.ArgumentTypeError(
                    "'{}' is no {}; expected names out of {} with commas "
                    "between them".format(name, what, ", ".join(known)))
        return list(dict.fromkeys(names))
    return read


def make_parser():
    parser = argparse.ArgumentParser(prog="compare", description=__doc__)
    parser.add_argument("--stacks", type=_list(STACKS, "stack"),
                        default=list(_STACKS), metavar="NAME,...",
                        help="out of {} ({})".format(", ".join(STACKS),
                                                     ",".join(_STACKS)))
    parser.add_argument("--scenes", metavar="NAME,...", help="worlds of "
                        "worlds/, or files with a start and a goal (hairpin)")
    parser.add_argument("--noise", type=_list(_NOISES, "noise"),
                        default=list(_NOISES), metavar="NAME,...",
                        help="out of {} (both)".format(", ".join(_NOISES)))
    parser.add_argument("--runs", type=amounts.count, default=1, metavar="N",
                        help="of each, every one with a seed of its own (1)")
    parser.add_argument("--pace", type=amounts.pace, default=1.0, metavar="FACTOR",
                        help="simulated seconds per second of the wall clock; "
                        "below 1 every stack has more of a slow machine (1)")
    scene.add_arguments(parser)
    parser.set_defaults(world=None)
    for name, text in (("barn", "BARN"), ("dynabarn", "DynaBARN")):
        parser.add_argument("--" + name, action="append", default=[],
                            metavar="[LABEL=]FILE", help="figures of scripts/"
                            "benchmark {} --json for the report's {} table; "
                            "may be given again".format(name, text))
    parser.add_argument("--report", metavar="FOLDER",
                        help="where report.html, report.md and the pictures go "
                        "(.workspace/compare/<scenes>)")
    return parser


def parse_arguments(arguments):
    parser = make_parser()
    options = parser.parse_args(arguments)
    try:
        options.scenes = _scenes(options)
        options.benchmarks = {
            name: [benchmark_tables.read(text) for text in getattr(options,
                                                                   name)]
            for name in ("barn", "dynabarn")}
    except (benchmark_tables.FiguresError, scene.SceneError,
            world_file.WorldFileError) as error:
        parser.error(str(error))
    options.report = os.path.abspath(options.report or os.path.join(
        comparison.OUTPUT, "_".join(s.name for s in options.scenes)))
    return options


def _scenes(options):
    """Those of --scenes, or the one of --world, --start and --goal."""
    own = [name for name in ("world", "start", "goal")
           if getattr(options, name) is not None]
    if own and options.scenes:
        raise scene.SceneError("--{} is for a scene of one's own; expected it "
                               "without --scenes".format(own[0]))
    if own:
        return [_scene(options.world or scene.DEFAULT_WORLD, options)]
    scenes = {}
    for name in (options.scenes or "hairpin").split(","):
        place = _scene(_world_of(name), options)
        # Logs, pictures and tables are told apart by it.
        other = scenes.setdefault(place.name, place)
        if other.world != place.world:
            raise scene.SceneError(
                "--scenes: {} and {} are both called {}; expected one of "
                "them".format(other.world, place.world, place.name))
    return list(scenes.values())


def _world_of(name):
    """The file of a world that is named, or given as a file."""
    if os.path.sep in name or "." in name:
        return name
    file = os.path.join(scene.ROOT, "worlds", name + ".yaml")
    if not os.path.isfile(file):
        raise scene.SceneError("--scenes: there is no world {}".format(file))
    return file


def _scene(world, options):
    complete = argparse.Namespace(**vars(options))
    complete.world = world
    scene.complete(complete)
    options.config = complete.config
    return comparison.Scene(scene.world_name(complete), complete.world,
                            complete.start, complete.goal)


def _to_json(drives, facts):
    return {
        "machine": facts,
        "runs": [{"scene": d.task.scene.name, "noise": d.task.noise,
                  "stack": d.task.stack, "run": d.task.number,
                  "seed": d.task.seed, **d.record.figures()}
                 for d in drives if d.record],
        "missing": sorted({d.why_missing for d in drives if not d.record}),
    }


def main():
    options = parse_arguments(sys.argv[1:])
    interruption.exit_on_signals()
    logs = os.path.join(options.report, "logs")
    os.makedirs(logs, exist_ok=True)
    tasks = comparison.make_tasks(options.stacks, options.scenes, options.noise,
                                  options)
    facts = machine.describe()
    store = comparison.DriveStore()
    drives = comparison.perform_all(
        tasks, logs, store,
        lambda line: print(line, file=sys.stderr, flush=True))
    from driver import comparison_report
    table = comparison_report.write(drives, options.benchmarks, facts,
                                    options.report)
    print(table)
    print("report: {}".format(os.path.join(options.report, "report.html")))
    if options.json:
        with open(options.json, "w") as file:
            json.dump(_to_json(drives, facts), file, indent=2)
            file.write("\n")
    # A stack that is not installed is no failure; one that did not come up is.
    broken = any(d.record is None and not comparison.why_not_installed(
        STACKS[d.task.stack]) for d in drives)
    if not broken:
        store.clear(tasks)
    return 0 if not broken and any(d.record for d in drives) else 1


if __name__ == "__main__":
    sys.exit(main())
