"""Many drives of the benchmark program: in parallel, with progress, and kept, so
that a run that was cut short goes on where it was."""

import concurrent.futures
import hashlib
import json
import os
import subprocess
from dataclasses import dataclass
from typing import Dict, Optional, Tuple

from driver import scene

PROGRAM = os.path.join(scene.OUTPUT, "devel", "lib", "vfh_astar",
                       "vfh_astar_benchmark")
# What it drives with: catkin links them when the program starts, so that it stays
# the same file when they change.
LIBRARIES = tuple(os.path.join(scene.OUTPUT, "devel", "lib", name) for name in (
    "libvfh_astar_core.so", "libvfh_astar_simulation.so"))
_REFUSED = 3  # the program's status for parameters that the stack does not take
_STORE = os.path.join(scene.OUTPUT, "benchmark")


class DriveError(Exception):
    """A drive gave no result; the message says why."""


class RefusedDriveError(DriveError):
    """The program did not take what it was given, rather than break down."""


@dataclass(frozen=True)
class DriveRun:
    """One drive: what its result is called by, the files it reads and its
    options."""

    labels: Tuple[Tuple[str, object], ...]  # such as ("world", 11), ("run", 0)
    world: Optional[str]  # None where the options make one
    config: str
    options: Tuple[str, ...] = ()

    def command(self):
        world = [] if self.world is None else ["--world", self.world]
        return [PROGRAM, "drive", *world, "--config", self.config,
                *self.options]


def perform(run):
    """The drive's figures with its labels before them. Raises DriveError."""
    done = subprocess.run(run.command(), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE)
    if done.returncode != 0:
        error = RefusedDriveError if done.returncode == _REFUSED else DriveError
        raise error("{}: {}".format(
            " ".join(run.command()),
            done.stderr.decode().strip() or "status {}".format(
                done.returncode)))
    return {**dict(run.labels), **json.loads(done.stdout.decode())}


class RunStore:
    """Keeps the results of one set of runs in a file until the set is complete.
    The file is the set's own: other runs, files or another build have another.
    """

    def __init__(self, runs, folder=_STORE):
        self._file = os.path.join(folder, self._digest(runs) + ".jsonl")

    @staticmethod
    def _digest(runs):
        digest = hashlib.sha256()
        files = {PROGRAM, *LIBRARIES}
        for run in runs:
            files |= {run.config} | ({run.world} - {None})
            digest.update(repr(run).encode())
        for file in sorted(files):
            with open(file, "rb") as content:
                digest.update(content.read())
        return digest.hexdigest()[:16]

    def load(self) -> Dict[int, dict]:
        """{the run's place in the set: its result}"""
        return dict(json.loads(line)
                    for line in self._whole_lines().splitlines())

    def add(self, place, result):
        os.makedirs(os.path.dirname(self._file), exist_ok=True)
        with open(self._file, "ab") as lines:
            # The last line may have been cut off; this one has to stand alone.
            lines.truncate(len(self._whole_lines()))
            lines.write(json.dumps([place, result]).encode() + b"\n")

    def _whole_lines(self):
        if not os.path.exists(self._file):
            return b""
        with open(self._file, "rb") as content:
            lines = content.read()
        return lines[:lines.rfind(b"\n") + 1]

    def clear(self):
        if os.path.exists(self._file):
            os.remove(self._file)


def make_executor(jobs, scheduler=None):
    """What runs are submitted to: `jobs` processes on this machine, or the
    workers of a Dask cluster. The workers need this package's scripts folder on
    their PYTHONPATH, the same build and the same files in the same places.

    scheduler: its address, such as tcp://host:8786.
    Raises DriveError.
    """
    if scheduler is None:
        return concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        import distributed
    except ImportError as error:
        raise DriveError("--scheduler needs Dask's distributed: install "
                         "python3-distributed") from error
    try:
        return distributed.Client(scheduler).get_executor()
    except (OSError, ValueError) as error:
        raise DriveError("--scheduler: {} does not answer: {}".format(
            scheduler, error)) from error


def perform_all(runs, executor, store=None, perform_one=perform):
    """As perform_each, with a progress bar on a terminal's error stream; the
    executor is of no use afterwards."""
    store = store or RunStore(runs)
    with executor, make_bar(len(runs), len(store.load())) as bar:
        return perform_each(runs, executor, store, perform_one, bar.update)


def make_bar(total, done):
    """A progress bar with the time that remains; none without a terminal."""
    from tqdm import tqdm
    return tqdm(total=total, initial=done, unit="run", ncols=79, disable=None)


def perform_each(runs, executor, store, perform_one, advance):
    """The results of all runs, in their order.

    executor: see make_executor.
    store: RunStore of these runs.
    advance: called after each run that was not in the store.
    Raises DriveError after the first run without a result; what was done by
    then is kept.
    """
    results = store.load()
    waiting = {executor.submit(perform_one, run): place
               for place, run in enumerate(runs) if place not in results}
    try:
        for future in concurrent.futures.as_completed(waiting):
            place = waiting[future]
            results[place] = future.result()
            store.add(place, results[place])
            advance()
    except BaseException:
        for future in waiting:
            future.cancel()
        raise
    store.clear()
    return [results[place] for place in range(len(runs))]
