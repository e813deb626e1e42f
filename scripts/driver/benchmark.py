"""Runs one of the benchmark program's commands and prints its figures as a
table. What a command measures and which options it has is the program's to say:
scripts/benchmark COMMAND --help."""

import argparse
import json
import os
import subprocess
import sys

from driver import scene

PROGRAM = os.path.join(scene.OUTPUT, "devel", "lib", "vfh_astar",
                       "vfh_astar_benchmark")
_COMMANDS = ("drive", "planner", "simulator")


def parse_arguments(arguments):
    """The options of this script, and those it hands on."""
    parser = argparse.ArgumentParser(prog="benchmark", description=__doc__,
                                     add_help=False, allow_abbrev=False)
    parser.add_argument("command", choices=_COMMANDS, nargs="?")
    parser.add_argument("--json", metavar="FILE",
                        help="write the figures to a file too")
    parser.add_argument("-h", "--help", action="store_true")
    options, rest = parser.parse_known_args(arguments)
    if options.command is None:
        if not options.help:
            parser.error("which command? One of " + ", ".join(_COMMANDS))
        parser.print_help()
        parser.exit(0)
    if options.help:
        rest.append("--help")
    if options.json and not os.path.isdir(
            os.path.dirname(os.path.abspath(options.json))):
        parser.error("--json: there is no folder for " + options.json)
    return options, rest


def table(figures, indent=""):
    """One line for each figure, its name as in the JSON file."""
    width = max((len(name) for name in figures), default=0)
    lines = []
    for name, value in figures.items():
        if isinstance(value, dict):
            lines += [indent + name, *table(value, indent + "  ")]
        else:
            lines.append("{}{}  {}".format(indent, name.ljust(width),
                                           _text(value)))
    return lines


def _text(value):
    """Four digits are more than a timing deserves."""
    if isinstance(value, float):
        return "{:,.0f}".format(value) if abs(value) >= 1e4 else \
            "{:.4g}".format(value)
    return str(value)


def main():
    options, rest = parse_arguments(sys.argv[1:])
    # Progress and errors go straight to the terminal.
    run = subprocess.run([PROGRAM, options.command] + rest,
                         stdout=subprocess.PIPE)
    if run.returncode != 0 or options.help:
        sys.stdout.write(run.stdout.decode())
        return run.returncode
    figures = json.loads(run.stdout.decode())
    print("\n".join(table(figures)))
    if options.json:
        with open(options.json, "w") as file:
            json.dump(figures, file, indent=2)
            file.write("\n")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
