"""How many units: few enough that starting them costs nothing, and so many that the last one does not run alone.

`bake --shard I/N` deals levels like cards, so every unit has levels of every building and kind, and units cost nearly the same.
What a room costs depends on its type, the options and the machine: it is not looked up, but measured with a small share.
"""

from __future__ import annotations

import math
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from .failure import Failure
from .job import MOST_UNITS
from .program import run

# Levels of the share that is measured.
SAMPLE_LEVELS = 24
UNIT_SECONDS = 45.0
# With eight units for each worker, the last ones take an eighth of the time at most, in which some workers may have nothing to do.
UNITS_OF_WORKER = 8
# A unit in which reading the plans takes longer than a fifth of the work is too small.
LARGEST_START_SHARE = 0.2


class Cost(NamedTuple):
    """What the measured share cost on one thread of this machine."""

    rooms: int
    seconds: float
    start_seconds: float
    room_milliseconds: float
    total_seconds: float


def measure(program: Path, folder: Path, arguments: list[str], counts: dict, cache: Path) -> Cost:
    """Bakes a small share, and an empty one for the time that every unit takes to read the plans."""
    shares = max(1, counts["levels"] // SAMPLE_LEVELS)
    empty = f"{counts['levels'] + 1}/{counts['levels'] + 1}"
    times = {}
    for share in (empty, f"1/{shares}"):
        with tempfile.TemporaryDirectory(prefix="roomwright-sample-") as out:
            # Textures of the cache are painted once, so the second time counts.
            started = time.monotonic()
            ran = run(program, "bake", *arguments, "--out", f"{out}/out", "--shard", share, "--threads", "1",
                      "--cache", str(cache), "--progress", "none", folder=folder)
            times[share] = time.monotonic() - started
            if ran.code > 1 or ran.code < 0:
                raise Failure(f"a first share could not be baked:\n{ran.errors}")
    rooms = max(1, ran.answer["totals"]["rooms"])
    work = max(0.0, times[f"1/{shares}"] - times[empty])
    return Cost(rooms, work, times[empty], 1000 * work / rooms, work / rooms * counts["rooms"])


def unit_count(cost: Cost, levels: int, workers: int) -> int:
    """The number of units for that cost."""
    by_time = math.ceil(cost.total_seconds / UNIT_SECONDS)
    for_workers = UNITS_OF_WORKER * workers
    # Small units are for many workers only as long as they do not mostly read plans.
    affordable = math.floor(cost.total_seconds * LARGEST_START_SHARE / max(cost.start_seconds, 1e-3))
    return max(1, min(max(by_time, min(for_workers, max(affordable, workers))), levels, MOST_UNITS))
