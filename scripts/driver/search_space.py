"""What a search may change: a YAML file of names and ranges.

    navigator.vfh.look_ahead: {low: 0.3, high: 1.2}
    navigator.vfh.smoothing: {low: 1, high: 5}                 # whole numbers
    path_planner.inflation_radius: {low: 0.4, high: 1.2, step: 0.1}
    navigator.evasion.haste_cost: {low: 2.0, high: 30.0, log: true}
"""

import math
from dataclasses import dataclass
from typing import Optional, Union

import yaml

_FIELDS = ("low", "high", "step", "log")
_DIGITS = 4  # that a found value is written with


class SpaceError(Exception):
    """The message names the file, the entry, its value and what is expected."""


@dataclass(frozen=True)
class Parameter:
    name: str
    low: Union[int, float]
    high: Union[int, float]
    step: Optional[Union[int, float]] = None
    log: bool = False
    is_whole: bool = False

    def distribution(self):
        """As Optuna has it."""
        import optuna
        if self.is_whole:
            return optuna.distributions.IntDistribution(
                self.low, self.high, log=self.log, step=self.step or 1)
        return optuna.distributions.FloatDistribution(
            float(self.low), float(self.high), log=self.log, step=self.step)

    def rounded(self, value):
        """Within the range, with no more digits than anybody cares for."""
        if self.is_whole:
            return int(value)
        value = float("{:.{}g}".format(value, _DIGITS))
        return min(max(value, float(self.low)), float(self.high))


def _is_number(value):
    return (isinstance(value, (int, float)) and not isinstance(value, bool)
            and math.isfinite(value))


def _is_multiple(length, step):
    count = length / step
    return abs(count - round(count)) < 1e-6


class _Entry:
    """One line of the file on its way to a Parameter."""

    def __init__(self, file, name, fields, base):
        self._file, self._name = file, name
        self._fields, self._base = fields, base

    def _fail(self, field, value, expected):
        place = self._name + ("." + field if field else "")
        raise SpaceError("{}: {} is {!r}; expected {}".format(
            self._file, place, value, expected))

    def parameter(self):
        self._check_fields()
        low, high = self._fields["low"], self._fields["high"]
        step, log = self._fields.get("step"), self._fields.get("log", False)
        if low >= high:
            self._fail("high", high, "more than low, which is {}".format(low))
        if not isinstance(log, bool):
            self._fail("log", log, "true or false")
        if log and step is not None:
            self._fail("step", step, "none together with log")
        if log and low <= 0:
            self._fail("low", low, "more than 0 together with log")
        if step is not None and (step <= 0 or
                                 not _is_multiple(high - low, step)):
            self._fail("step", step, "a fraction of high - low, which is "
                       "{:g}".format(high - low))
        self._check_base(low, high, step)
        return Parameter(self._name, low, high, step, log,
                         isinstance(self._base, int))

    def _check_fields(self):
        if not isinstance(self._fields, dict):
            self._fail("", self._fields, "{low: ..., high: ...}")
        for field in self._fields:
            if field not in _FIELDS:
                self._fail("", field, "only " + ", ".join(_FIELDS))
        for field in ("low", "high", "step"):
            if field == "step" and field not in self._fields:
                continue
            value = self._fields.get(field)
            if not _is_number(value):
                self._fail(field, value, "a finite number")
            if isinstance(self._base, int) and not isinstance(value, int):
                self._fail(field, value, "a whole number, as the configuration "
                           "has {}".format(self._base))

    def _check_base(self, low, high, step):
        """The search begins with the configuration's own values."""
        if not low <= self._base <= high:
            self._fail("", self._base, "from {} to {}, in the configuration "
                       "too, with which the search begins".format(low, high))
        if step is not None and not _is_multiple(self._base - low, step):
            self._fail("", self._base, "{} and steps of {}, in the "
                       "configuration too, with which the search begins".format(
                           low, step))


def read(file, config):
    """The parameters of a search space, in the file's order.

    config: ConfigText that it is about.
    Raises SpaceError, or ConfigError for a name that the configuration lacks.
    """
    try:
        with open(file) as stream:
            document = yaml.safe_load(stream)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise SpaceError("{}: {}".format(file, error)) from error
    if not isinstance(document, dict) or not document:
        raise SpaceError("{}: expected lines of the form NAME: {{low: ..., "
                         "high: ...}}".format(file))
    parameters, names = [], {}
    for name, fields in document.items():
        parameters.append(_Entry(file, str(name), fields,
                                 config.number(str(name))).parameter())
        other = names.setdefault(config.place(str(name)), name)
        if other != name:
            raise SpaceError("{}: {} and {} are one and the same value; "
                             "expected one of them".format(file, other, name))
    return parameters
