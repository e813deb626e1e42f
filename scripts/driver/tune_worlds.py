"""The worlds that a configuration is tuned on, and those that it is judged by."""

import hashlib
import json
import math
import os
import re
from dataclasses import dataclass

from driver import barn

_PATTERNS = {"barn": r"world_(\d+)\.world", "dynabarn": r"world_(\d+)\.json"}


@dataclass(frozen=True)
class TuneWorld:
    kind: str  # barn or dynabarn
    folder: str
    index: int
    file: str

    def name(self):
        return "{} {}".format(self.kind, self.index)

    def runs(self, config, count, start):
        """`count` drives with the seeds 1, 2, ...; start: of BARN's worlds."""
        if self.kind == "barn":
            return barn.static_runs(self.folder, config, [self.index], count,
                                    start)
        return barn.dynamic_runs(self.folder, config, [self.index], count)

    def optimal_time(self, start):
        """s: as BARN has it; for DynaBARN, which has none, of the straight
        line at the same speed. Raises WorldSetError."""
        if self.kind == "barn":
            return barn.optimal_time(barn.path_of_world(
                self.folder, self.index), start)
        with open(self.file) as stream:
            document = json.load(stream)
        return math.dist(document["start"][:2],
                         document["goal"][:2]) / barn.OPTIMAL_SPEED


def find(folders, indices=None):
    """The worlds of the folders, of both kinds. Raises WorldSetError."""
    worlds = []
    for folder in folders:
        names = os.listdir(folder) if os.path.isdir(folder) else ()
        kinds = [kind for kind, pattern in _PATTERNS.items()
                 if any(re.fullmatch(pattern, name) for name in names)]
        # The error for a folder with neither is the one for BARN's.
        for kind in kinds or ["barn"]:
            files = barn.world_files(folder, _PATTERNS[kind], indices)
            worlds += [TuneWorld(kind, os.path.abspath(folder), index, file)
                       for index, file in files.items()]
    return worlds


def split(worlds, share, seed):
    """(training, held out): of each kind about that share is held out, drawn by
    the seed; a world's draw does not depend on what other worlds there are.

    Raises WorldSetError where a kind has less than two worlds.
    """
    def draw(world):
        text = "{} {} {}".format(seed, world.kind, world.index)
        return hashlib.sha256(text.encode()).hexdigest()

    held_out = set()
    for kind in _PATTERNS:
        own = sorted((w for w in worlds if w.kind == kind), key=draw)
        if len(own) == 1:
            raise barn.WorldSetError(
                "--worlds: {} is the only world of its kind; expected two at "
                "least, one to search on and one to hold out".format(
                    own[0].name()))
        count = min(max(1, round(share * len(own))), len(own) - 1)
        held_out.update(own[:count] if own else ())
    return ([w for w in worlds if w not in held_out],
            [w for w in worlds if w in held_out])


def choose(folders, training, held_out, share, seed):
    """(training, held out) by indices, where they are given (the rest for the
    other where only one is), or as split() has it. Raises WorldSetError."""
    worlds = find(folders)
    if training is None and held_out is None:
        return split(worlds, share, seed)
    find(folders, (training or []) + (held_out or []))  # are they there?
    both = sorted(set(training or ()) & set(held_out or ()))
    if both:
        raise barn.WorldSetError("--train and --held-out: world {} is in both; "
                                 "expected each in one".format(both[0]))

    def chosen(wanted, other):
        return [w for w in worlds if (w.index not in other if wanted is None
                                      else w.index in wanted)]

    sets = chosen(training, held_out), chosen(held_out, training)
    for name, members in zip(("--train", "--held-out"), sets):
        if not members:
            raise barn.WorldSetError("{}: no world is left for it".format(name))
    return sets
