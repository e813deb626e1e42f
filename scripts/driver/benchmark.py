"""Measures a part of the package, or the whole, without a ROS master: prints a
table, and with --json writes the same figures to a file."""

import argparse
import json
import os
import subprocess
import sys

from driver import (amounts, barn, config_text, drive_runs, interruption,
                    paper_pictures, paper_scenes, poses, scene, search_space,
                    tune, tune_command)

# What the benchmark program does in one run, with options of its own.
_PROGRAM_COMMANDS = {
    "drive": "one drive in one world",
    "mapping": "the map and the poses made of a CARMEN log",
    "planner": "the path search over MovingAI scenarios or a world's map",
    "simulator": "the simulator's speed",
}

_STAGES = ("localize", "map_insert", "inflation_update", "plan", "fit",
           "control_tick")
_HAIRPIN = os.path.join(scene.ROOT, "worlds", "hairpin.yaml")


def _add_run_options(parser, count):
    parser.add_argument("--runs", type=amounts.count, default=count, metavar="N",
                        help="of each, every one with a seed of its own "
                        "({})".format(count))
    parser.add_argument("--jobs", type=amounts.count, default=os.cpu_count(),
                        metavar="N", help="processes at a time (one for each "
                        "processor)")
    parser.add_argument("--scheduler", metavar="ADDRESS",
                        help="hand the runs to a Dask cluster instead")


def _add_world_options(parser):
    parser.add_argument("--worlds", required=True, metavar="DIR",
                        help="folder of the worlds")
    parser.add_argument("--indices", type=amounts.indices, metavar="I,J,...",
                        help="of the worlds (all there are)")
    _add_config_option(parser)


def _add_config_option(parser):
    parser.add_argument("--config", metavar="FILE",
                        default=os.path.join(scene.ROOT, "config",
                                             "jackal.yaml"),
                        help="parameters of the stack (config/jackal.yaml)")


def make_parser():
    parser = argparse.ArgumentParser(prog="benchmark", description=__doc__)
    commands = parser.add_subparsers(dest="command", metavar="COMMAND")
    commands.required = True
    for name, what in _PROGRAM_COMMANDS.items():
        commands.add_parser(name, help=what, add_help=False,
                            allow_abbrev=False)
    cycle = commands.add_parser("cycle", help="what each stage of the stack "
                                "takes in a drive of the paper's hairpin")
    _add_config_option(cycle)
    static = commands.add_parser("barn", help="drives through BARN's worlds")
    static.add_argument("--start", type=poses.pose_argument,
                        default=barn.START, metavar="X,Y,YAW",
                        help="the goal lies 10 m ahead along y (-2,3,1.57)")
    dynamic = commands.add_parser("dynabarn",
                                  help="drives through DynaBARN's worlds")
    paper = commands.add_parser("paper", help="drives through the paper's "
                                "scenes with its configuration and the usual one")
    paper.add_argument("--pictures", metavar="FOLDER",
                       help="draw paths, trajectories and errors there")
    for command in (static, dynamic):
        _add_world_options(command)
    tuning = commands.add_parser("tune", help=tune_command.HELP)
    tune_command.add_options(tuning)
    _add_config_option(tuning)
    for command in (static, dynamic, paper, tuning):
        _add_run_options(command, 1)
    for command in commands.choices.values():
        command.add_argument("--json", metavar="FILE",
                             help="write the figures to a file too")
    return parser


def parse_arguments(arguments):
    """The options, and in `rest` what is for the program to read."""
    parser = make_parser()
    options, options.rest = parser.parse_known_args(arguments)
    if options.rest and options.command not in _PROGRAM_COMMANDS:
        parser.error("unknown: " + " ".join(options.rest))
    if options.json and not os.path.isdir(
            os.path.dirname(os.path.abspath(options.json))):
        parser.error("--json: there is no folder for " + options.json)
    if getattr(options, "config", None):
        if not os.path.isfile(options.config):
            parser.error("--config: there is no file " + options.config)
        options.config = os.path.abspath(options.config)
    if options.command == "tune":
        tune_command.check(options, parser.error)
    return options


def run_program(options):
    """Returns the figures; ends with the program's status when it fails or has
    none."""
    # Progress and errors go straight to the terminal.
    run = subprocess.run([drive_runs.PROGRAM, options.command] + options.rest,
                         stdout=subprocess.PIPE)
    try:
        return json.loads(run.stdout.decode()) if run.returncode == 0 else \
            sys.exit(run.returncode)
    except ValueError:
        sys.stdout.write(run.stdout.decode())  # its help
        sys.exit(0)


def _perform_all(runs, options):
    return drive_runs.perform_all(runs, drive_runs.make_executor(
        options.jobs, options.scheduler))


def run_cycle(options):
    options.rest = ["--world", _HAIRPIN, "--config", options.config]
    return run_program(options)


def run_barn(options):
    runs = barn.static_runs(options.worlds, options.config, options.indices,
                            options.runs, options.start)
    results = _perform_all(runs, options)
    barn.add_scores(results, options.worlds, options.start)
    return barn.summary(results)


def run_dynabarn(options):
    runs = barn.dynamic_runs(options.worlds, options.config, options.indices,
                             options.runs)
    return barn.summary(_perform_all(runs, options))


def run_paper(options):
    if options.pictures:
        paper_pictures.draw_all(options.pictures)
    return paper_scenes.summary(_perform_all(
        paper_scenes.runs(options.runs), options))


def table(figures):
    """One line for each figure, its name as in the JSON file."""
    width = max(map(len, figures))
    return ["{}  {}".format(name.ljust(width), _text(value))
            for name, value in figures.items()]


def cycle_table(figures):
    """One line for each stage, in the order in which a cycle takes them, then
    of what drive they are."""
    form = "{:18}{:>8}{:>14}{:>12}".format
    stages = sorted(figures["stages"].items(),
                    key=lambda stage: _STAGES.index(stage[0]))
    return [form("stage", "count", "median [us]", "99 % [us]"),
            *(form(name, values["count"], _text(values["median_us"]),
                   _text(values["p99_us"])) for name, values in stages),
            "{outcome} after {time_s:.1f} s, {beams} beams".format(**figures)]


def _text(value):
    if isinstance(value, float):
        return "{:,.0f}".format(value) if abs(value) >= 1e4 else \
            "{:.4g}".format(value)
    return str(value)


def run(options):
    """The figures of a command, and the lines of its table."""
    commands = {"cycle": (run_cycle, cycle_table),
                "barn": (run_barn, barn.table),
                "dynabarn": (run_dynabarn, barn.table),
                "paper": (run_paper, paper_scenes.table),
                "tune": (tune_command.run, tune_command.table)}
    perform, make_table = commands.get(options.command, (run_program, table))
    figures = perform(options)
    return figures, make_table(figures)


def main():
    interruption.exit_on_signals()
    options = parse_arguments(sys.argv[1:])
    try:
        figures, lines = run(options)
    except (barn.WorldSetError, config_text.ConfigError, drive_runs.DriveError,
            search_space.SpaceError, tune.TuneError) as error:
        print("benchmark: {}".format(error), file=sys.stderr)
        return 1
    print("\n".join(lines))
    if options.json:
        with open(options.json, "w") as file:
            json.dump(figures, file, indent=2)
            file.write("\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
