"""Drives of several stacks through several scenes: which there are to be, each of
them, and what is kept until all are done."""

import hashlib
import multiprocessing
import os
import pickle
from dataclasses import dataclass
from typing import Optional, Tuple

from driver import drive_runs, interruption, scene
from driver.drive_record import DriveRecord
from driver.launched_stack import LaunchedStack, LaunchError
from driver.stacks import STACKS, Stack

OUTPUT = os.path.join(scene.OUTPUT, "compare")
_LAUNCH_FILE = os.path.join(scene.ROOT, "launch", "compare.launch")
# What a drive's result follows from besides its files.
_BUILD = drive_runs.LIBRARIES + tuple(
    os.path.join(scene.OUTPUT, "devel", "lib", *name) for name in (
        ("libvfh_astar_nodelets.so",), ("vfh_astar", "simulator_node")))


@dataclass(frozen=True)
class Scene:
    name: str
    world: str  # file
    start: Tuple[float, float, float]  # m, m, rad
    goal: Tuple[float, float, float]


@dataclass(frozen=True)
class Task:
    """One drive."""

    stack: str  # its name
    config: str  # file
    scene: Scene
    noise: str  # clean or experiment
    number: int  # of the run
    seed: int  # of the simulator's noise
    time_limit: float  # simulated s
    pace: float  # simulated seconds per second of the wall clock

    def name(self):
        return "{}_{}_{}_{}".format(self.scene.name, self.noise, self.stack,
                                    self.number + 1)


@dataclass
class Drive:
    task: Task
    record: Optional[DriveRecord]
    why_missing: str = ""  # a sentence, where there is no record


def make_tasks(stacks, scenes, noises, options):
    """In the order in which they are driven: stacks take turns, so that what
    else the machine does concerns all of them.

    options: runs, seed, time_limit, pace, config.
    """
    return [Task(name, config_of(STACKS[name], options.config), place, noise,
                 number, options.seed + number, options.time_limit,
                 options.pace)
            for place in scenes for noise in noises
            for number in range(options.runs) for name in stacks]


def config_of(stack, given):
    """The file of a stack's parameters; given: by the command line, for
    vfh_astar."""
    if stack.name == "vfh_astar":
        return given
    return stack.launch_arguments["config"]


def source_of_missed_cycles(stack):
    """Where it tells of them; see MissedCycles."""
    own = stack.launch_arguments["stack"] == "vfh_astar"
    return "diagnostics" if own else "rosout"


def why_not_installed(stack: Stack):
    """A sentence, or nothing when the stack can be driven."""
    missing = stack.missing_packages()
    if not missing:
        return ""
    return ("{} is not installed: there {} no ROS {} {}.".format(
        stack.name, "are" if len(missing) > 1 else "is",
        "packages" if len(missing) > 1 else "package", ", ".join(missing)))


class DriveStore:
    """Keeps the records of drives until a comparison is complete, so that one
    that was cut short goes on where it was."""

    def __init__(self, folder=os.path.join(OUTPUT, "drives"), build=_BUILD):
        self._folder, self._build = folder, build

    def _file(self, task):
        digest = hashlib.sha256(repr((task, STACKS[task.stack])).encode())
        for file in (task.scene.world, task.config, *self._build):
            with open(file, "rb") as content:
                digest.update(content.read())
        return os.path.join(self._folder, digest.hexdigest()[:16] + ".pickle")

    def load(self, task):
        """None where there is none, or not all of it."""
        try:
            with open(self._file(task), "rb") as file:
                return pickle.load(file)
        except FileNotFoundError:
            return None

    def add(self, task, record):
        os.makedirs(self._folder, exist_ok=True)
        file = self._file(task)
        with open(file + ".part", "wb") as part:
            pickle.dump(record, part)
        os.replace(file + ".part", file)

    def clear(self, tasks):
        for task in tasks:
            if os.path.exists(self._file(task)):
                os.remove(self._file(task))


def perform_all(tasks, log_folder, store, report, perform_one=None):
    """A Drive for each task, in their order.

    report: called with a line before each drive, and why it gave no record.
    """
    drives = []
    for i, task in enumerate(tasks):
        missing = why_not_installed(STACKS[task.stack])
        if missing:
            drives.append(Drive(task, None, missing))
            continue
        record = store.load(task)
        if record is None:
            report("{} of {}: {}, {}, {}, run {} ...".format(
                i + 1, len(tasks), task.scene.name, task.noise, task.stack,
                task.number + 1))
            record = (perform_one or perform_apart)(task, log_folder)
            if isinstance(record, str):
                report(record)
                drives.append(Drive(task, None, "{}: {}".format(
                    task.stack, record)))
                continue
            store.add(task, record)
        drives.append(Drive(task, record))
    return drives


def perform_apart(task, log_folder):
    """As perform, in a process of its own, as a process can join one ROS master
    only."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        result = pool.apply(perform, (task, log_folder))
        pool.close()
        pool.join()
    return result


def perform(task, log_folder):
    """The drive's DriveRecord, or the sentence that says why there is none."""
    interruption.exit_on_signals()
    stack = STACKS[task.stack]
    x, y, yaw = task.scene.start
    arguments = dict(stack.launch_arguments, world=task.scene.world, x=x, y=y,
                     yaw=yaw, seed=task.seed, noise=task.noise,
                     real_time_factor=task.pace, config=task.config)
    log = os.path.join(log_folder, task.name() + ".log")
    try:
        with LaunchedStack(_LAUNCH_FILE, arguments, log) as launched:
            os.environ["ROS_MASTER_URI"] = launched.master_uri
            return _drive(task, stack, launched)
    except LaunchError as error:
        return str(error)
    except OSError as error:  # /proc has no such process any more
        return "a process of the stack has ended: {}".format(error)


def _drive(task, stack, launched):
    # They read the master's address when they are loaded.
    from driver import goal_drive, node_processes
    from driver.missed_cycles import MissedCycles
    from driver.observer import Observer
    goal_drive.connect(launched, "compare")
    start = task.scene.start
    observer = Observer(stack.plan_topic,
                        start if stack.starts_at_zero else (0.0, 0.0, 0.0))
    missed = MissedCycles(source_of_missed_cycles(stack))
    goal_drive.GoalClient(launched, observer).wait_until_ready()
    processes = node_processes.processes_of_nodes(stack.nodes)

    def cpu_seconds():
        return sum(map(node_processes.cpu_seconds, processes))

    cpu_before = cpu_seconds()
    missed.begin()
    record = goal_drive.drive(launched, observer, start, task.scene.goal,
                              task.time_limit, lambda elapsed: None)
    record.cpu_seconds = cpu_seconds() - cpu_before
    record.peak_memory = sum(map(node_processes.peak_memory, processes))
    record.missed_cycles = missed.finish()
    return record
