"""What levels cost, by the types of their rooms and a measured sample, and the units that they are cut into.

A kitchen takes four times as long as a study, and a hotel's floor a hundred times as long as a cottage's. `costs.json` has
measured milliseconds for each type; a sample of the levels, baked with the options of the job, says how far this machine and
these options are from them.
"""

from __future__ import annotations

import json
import math
import os
import tempfile
from pathlib import Path
from typing import NamedTuple

from .failure import Failure
from .job import MOST_UNITS
from .listing import room_count
from .program import run

# Levels of the sample: this part of all, but not more than have so many rooms, within these bounds. It is baked twice, and the
# first of it once more.
SAMPLE_PART = 0.005
ENOUGH_ROOMS = 100
LEAST_SAMPLE, LARGEST_SAMPLE = 3, 24
# Seconds of the largest units, if the plans are read soon: what a lost machine costs.
UNIT_SECONDS = 45.0
# A unit takes at most this part of what is left for each worker, so that units become smaller towards the end and the last
# ones end together (guided self-scheduling; C. Polychronopoulos and D. Kuck, 1987). Half, as the costs are known well (factoring;
# S. Hummel, E. Schonberg and L. Flynn, 1992): a smaller part makes more units, each of which has a start.
PART_OF_REST = 1 / 2
# The start takes a fifteenth of the smallest units at most, and a thirtieth of the others.
SMALLEST_IN_STARTS = 15.0
LARGEST_IN_STARTS = 30.0


class Costs(NamedTuple):
    """Milliseconds, as measured once on one thread."""

    level: float
    room: float
    rooms: dict[str, float]

    def of(self, level: dict) -> float:
        """Milliseconds of a level as `bake --list-levels` lists it."""
        return self.level + sum(self.rooms.get(kind, self.room) * count for kind, count in level["rooms"].items())


class Sample(NamedTuple):
    """What a sample cost on one thread of this machine, in seconds of its processor."""

    rooms: int
    # Of the levels alone.
    seconds: float
    # Of a unit before its first level.
    start_seconds: float
    # Measured seconds for a millisecond of `Costs`.
    scale: float


def read_costs() -> Costs:
    table = json.loads(Path(__file__).with_name("costs.json").read_text(encoding="utf-8"))
    return Costs(table["level"], table["other"], table["rooms"])


def measure(program: Path, folder: Path, arguments: list[str], listed: dict, cache: Path) -> Sample:
    """Bakes some of the levels, and one of them for the time that every unit takes before its first: to read plans and make models."""
    levels, times = listed["levels"], []
    chosen = sample_of(levels)
    with tempfile.TemporaryDirectory(prefix="roomwright-sample-") as scratch:
        # The first run of the sample makes textures and models, which units find on their machine.
        for number, some in enumerate((chosen, chosen[:1], chosen)):
            file = Path(scratch) / f"{number}.json"
            file.write_text(json.dumps({"program": listed["program"], "levels": some}), encoding="utf-8")
            started = spent()
            ran = run(program, "bake", *arguments, "--out", f"{scratch}/{number}", "--shard", "1/1", "--only-levels", str(file),
                      "--threads", "1", "--cache", str(cache), "--progress", "none", folder=folder)
            times.append(spent() - started)
            if ran.code not in (0, 1) or "totals" not in ran.answer:
                raise Failure(f"a sample of the levels could not be baked:\n{ran.errors}")
    _, first, whole = times
    costs = read_costs()
    cost_of_first, cost = costs.of(chosen[0]), sum(map(costs.of, chosen))
    # A sample of one level says nothing about the start: all of it counts as work.
    scale = max(1e-3, whole - first) / (cost - cost_of_first) if len(chosen) > 1 else whole / cost
    start = max(0.0, whole - scale * cost)
    return Sample(room_count(chosen), scale * cost, start, scale)


def sample_of(levels: list[dict]) -> list[dict]:
    """Levels from all over the plans."""
    enough = math.ceil(ENOUGH_ROOMS * len(levels) / max(1, room_count(levels)))
    count = min(LARGEST_SAMPLE, max(LEAST_SAMPLE, min(round(SAMPLE_PART * len(levels)), enough)))
    return levels[:: max(1, len(levels) // count)][:count]


def spent() -> float:
    """Processor time of the processes that ended, which other work on the machine does not lengthen; seconds where it is not counted."""
    times = os.times()
    return times.children_user + times.children_system if os.name == "posix" else times.elapsed


def cut(seconds: list[float], workers: int, start_seconds: float) -> list[range]:
    """Consecutive levels as units, the longest units first: whoever takes them in this order ends with short ones."""
    left = sum(seconds)
    most = max(UNIT_SECONDS, LARGEST_IN_STARTS * start_seconds, 2 * left / MOST_UNITS)
    least = min(most, max(SMALLEST_IN_STARTS * start_seconds, left / MOST_UNITS))
    units, begin, spent = [], 0, 0.0
    target = size_of(left, workers, least, most)
    for index, cost in enumerate(seconds):
        spent += cost
        if spent >= target or index + 1 == len(seconds):
            units.append((spent, range(begin, index + 1)))
            left, begin, spent = left - spent, index + 1, 0.0
            target = size_of(left, workers, least, most)
    return in_order(units)


def size_of(left: float, workers: int, least: float, most: float) -> float:
    return min(most, max(least, left / workers * PART_OF_REST))


def cut_into(seconds: list[float], count: int) -> list[range]:
    """A given number of units of about the same cost."""
    count = min(count, len(seconds))
    total, spent, begin, units = sum(seconds), 0.0, 0, []
    cost = 0.0
    for index, level in enumerate(seconds):
        spent, cost = spent + level, cost + level
        open_units, levels_left = count - len(units), len(seconds) - index - 1
        is_full = spent >= total * (len(units) + 1) / count
        # Every unit that is still to come has a level.
        if open_units > 1 and levels_left >= open_units - 1 and (is_full or levels_left == open_units - 1):
            units.append((cost, range(begin, index + 1)))
            begin, cost = index + 1, 0.0
    units.append((cost, range(begin, len(seconds))))
    return in_order(units)


def in_order(units: list[tuple[float, range]]) -> list[range]:
    return [levels for _, levels in sorted(units, key=lambda unit: (-unit[0], unit[1].start))]
