"""Searches the parameters of a configuration with Optuna: one trial after the
other, each with all its drives at the same time.

That a search which was cut short goes on to the same trials needs two things: a
sampler with a seed of its own for every trial, and nothing but finished trials in
the storage, so that one that was not finished is drawn anew from the same ones.
"""

import contextlib
import fcntl
import hashlib
import os
import warnings
from dataclasses import dataclass
from typing import Tuple

from driver import barn, drive_runs, scene
from driver.config_text import ConfigText
from driver.search_space import Parameter
from driver.tune_worlds import TuneWorld

_STORE = os.path.join(scene.OUTPUT, "benchmark", "tune")
_RANDOM_TRIALS = 10  # before the sampler has enough to go by
# What the search maximizes is the score and this part of the mean of OT / T over
# what succeeds: the score alone is the same for all that is quick enough, and
# then the quicker one is the better one.
_HASTE = 0.02


class TuneError(Exception):
    """The search cannot be made; the message says why."""


@dataclass(frozen=True)
class TuneTask:
    base: ConfigText
    space: Tuple[Parameter, ...]
    training: Tuple[TuneWorld, ...]
    runs: int  # in each world
    start: Tuple[float, float, float]  # of BARN's worlds
    k: int  # of the score
    trials: int
    seed: int

    def base_values(self):
        return {p.name: self.base.number(p.name) for p in self.space}

    def config_text(self, values):
        """The configuration with those values; its own where they are."""
        own = self.base_values()
        return self.base.with_numbers({name: value for name, value
                                       in values.items() if value != own[name]})

    def digest(self):
        """Of all that a trial's score follows from, and the draws."""
        digest = hashlib.sha256(repr((
            self.base.text, self.space, self.training, self.runs, self.start,
            self.k, self.seed)).encode())
        for file in (drive_runs.PROGRAM, *drive_runs.LIBRARIES,
                     *(w.file for w in self.training)):
            with open(file, "rb") as content:
                digest.update(content.read())
        return digest.hexdigest()[:16]


class Driver:
    """Drives configurations through worlds."""

    def __init__(self, task, executor, folder, advance=lambda count: None,
                 perform_one=drive_runs.perform):
        """folder: for configurations and results that wait for the others.
        advance: called with the number of drives that are done."""
        self._task, self._executor, self._folder = task, executor, folder
        self._advance, self._perform_one = advance, perform_one

    def results(self, worlds, text, name):
        """Those of the drives with a configuration's text, with their scores;
        name: of its file. Raises DriveError."""
        config = os.path.join(self._folder, name + ".yaml")
        with open(config, "w") as file:
            file.write(text)
        drives = [(world, run) for world in worlds for run in world.runs(
            config, self._task.runs, self._task.start)]
        runs = [run for _, run in drives]
        store = drive_runs.RunStore(runs, self._folder)
        self._advance(len(store.load()))
        results = drive_runs.perform_each(
            runs, self._executor, store, self._perform_one,
            lambda: self._advance(1))
        for (world, _), result in zip(drives, results):
            result["set"] = world.kind
            barn.add_score(result, world.optimal_time(self._task.start))
        return results

    def values(self, results):
        """Mean score, and what the search maximizes."""
        name = "score_k{}".format(self._task.k)
        score = sum(r[name] for r in results) / len(results)
        haste = sum(r["optimal_time_s"] / r["time_s"] for r in results
                    if r["outcome"] == "success") / len(results)
        return score, score + _HASTE * haste


def load_optuna():
    """Optuna, quiet. Raises TuneError where there is none."""
    try:
        import optuna
    except ImportError as error:
        raise TuneError("tune needs Optuna ({}): run scripts/setup --tune, or "
                        "install python3-optuna".format(error)) from error
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    return optuna


@contextlib.contextmanager
def search_folder(task, store=_STORE):
    """A folder of this search's own; nobody else has it meanwhile. Raises
    TuneError."""
    folder = os.path.join(store, task.digest())
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "lock"), "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise TuneError("the same search runs already, in " + folder) \
                from error
        yield folder


class Search:
    """The trials of a task, kept in Optuna's storage in a folder."""

    def __init__(self, task, folder):
        self._optuna = load_optuna()
        self._task = task
        self._study = self._optuna.create_study(
            storage="sqlite:///" + os.path.join(folder, "study.sqlite"),
            study_name="tune", direction="maximize", load_if_exists=True)

    def _finished(self):
        states = (self._optuna.trial.TrialState.COMPLETE,)
        return self._study.get_trials(deepcopy=False, states=states)

    def trials(self):
        """[{trial, parameters, score, objective, refused}] of the finished
        ones, at most as many as the task has."""
        return [{"trial": i, "parameters": self._values(t.params),
                 "score": t.user_attrs["score"], "objective": t.value,
                 "refused": t.user_attrs["refused"]}
                for i, t in enumerate(self._finished()[:self._task.trials])]

    def perform(self, driver):
        """Goes on until all the task's trials are there; the first has the
        base's own values. Raises DriveError."""
        for number in range(len(self._finished()), self._task.trials):
            params = self._draw(number)
            score, objective, refusal = self._score(driver, number, params)
            self._study.add_trial(self._trial(
                params, objective, {"score": score, "refused": refusal}))

    def _trial(self, params, objective, attributes):
        """With its parameters in the space's order, which the storage does not
        keep and the sampler depends on."""
        return self._optuna.trial.create_trial(
            params={p.name: params[p.name] for p in self._task.space},
            distributions=self._distributions(), value=objective,
            user_attrs=attributes)

    def _distributions(self):
        return {p.name: p.distribution() for p in self._task.space}

    def _draw(self, number):
        """The parameters of a trial, which follow from the finished ones."""
        if number == 0:
            return self._task.base_values()
        with warnings.catch_warnings():
            # A sampler that takes parameters together counts as experimental.
            warnings.simplefilter("ignore",
                                  self._optuna.exceptions.ExperimentalWarning)
            sampler = self._optuna.samplers.TPESampler(
                seed=(self._task.seed * 1000003 + number) % 2 ** 32,
                n_startup_trials=_RANDOM_TRIALS, multivariate=True)
        # In memory: what was asked for and not finished leaves no trace.
        study = self._optuna.create_study(direction="maximize", sampler=sampler)
        study.add_trials([self._trial(t.params, t.value, {})
                          for t in self._finished()])
        return study.ask(self._distributions()).params

    def _values(self, params):
        return {p.name: p.rounded(params[p.name]) for p in self._task.space}

    def _score(self, driver, number, params):
        """Mean score, what is maximized, and why the program did not take the
        parameters, if it did not: that is a finding, but for the base a
        failure."""
        text = self._task.config_text(self._values(params))
        try:
            return (*driver.values(driver.results(
                self._task.training, text, "trial_{:04d}".format(number))), None)
        except drive_runs.RefusedDriveError as error:
            if number == 0:
                raise
            return 0.0, 0.0, str(error)
