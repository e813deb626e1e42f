"""How smoothly a robot drove, from its true speeds. No ROS."""

import math

import numpy as np

_PERIOD = 0.1  # s over which speeds are averaged: wheels tremble, bodies do not
_TURNING = 0.1  # rad/s from which on a robot turns
_STANDING_V = 0.05  # m/s below which, with
_STANDING_W = 0.1  # rad/s below this one, a robot stands
_STOP_TIME = 0.3  # s that it has to stand for a stop


def averaged(times, values):
    """Means over whole periods of 0.1 s since the first time; empty periods get
    none, and nothing after them counts as next to what was before."""
    if not len(times):
        return np.zeros(0)
    # A sample on a border belongs to the later period, whatever rounding does.
    periods = np.floor((np.asarray(times) - times[0]) / _PERIOD + 1e-6
                       ).astype(int)
    sums = np.bincount(periods, values)
    counts = np.bincount(periods)
    return np.where(counts > 0, sums / np.maximum(counts, 1), np.nan)


def jerk_rms(times, speeds):
    """m/s^3, of the forward speed (m/s); None for less than three periods."""
    jerks = np.diff(averaged(times, speeds), 2) / _PERIOD ** 2
    jerks = jerks[~np.isnan(jerks)]
    return math.sqrt(np.mean(jerks * jerks)) if len(jerks) else None


def turn_reversals(times, turn_rates):
    """How often the robot turned to the other side, its rates (rad/s) averaged
    and small ones left out."""
    rates = averaged(times, turn_rates)
    sides = np.sign(rates[np.abs(rates) > _TURNING])
    return int(np.count_nonzero(np.diff(sides)))


def stops(times, speeds, turn_rates):
    """How often the robot stood for 0.3 s or more after it had begun to move and
    before it had come to its last rest."""
    standing = ((np.abs(averaged(times, speeds)) < _STANDING_V)
                & (np.abs(averaged(times, turn_rates)) < _STANDING_W))
    moving = np.flatnonzero(~standing)
    # Between two moments of motion one after the other lies a rest, or none.
    rests = (np.diff(moving) - 1) * _PERIOD
    return int(np.count_nonzero(rests > _STOP_TIME - 1e-6))
