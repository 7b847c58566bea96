#!/usr/bin/env python3
"""Measures how the cost of a bake grows with its size, and prints the table of docs/figures.md as Markdown.

    python3 scripts/measure_growth.py [--program target/release/roomwright] [--runs 3]

Four series of plans: rooms of a level, levels of a site, corners of a room, objects in a room. Each plan is baked by one thread
without textures; its cost is the least processor time of the runs, less that of the smallest plan of the series, which stands for the
start of the program. The exponent is the slope of the logarithms between the two largest plans: 1 is in step with the size. Processor
time does not depend on what else the machine does, as far as caches go. Needs nothing but Python's standard library.
"""

import argparse
import json
import math
import sys
import tempfile
from pathlib import Path

from measuring import measured

ROOT = Path(__file__).resolve().parent.parent

ROOMS_OF_BLOCK = 50
MOST_LEVELS = 1000
ROOMS_OF_HOME = ["living_room", "bedroom", "kitchen", "bathroom"]


def plan(levels):
    """A plan in the program's own format, as JSON, which is YAML."""
    return json.dumps({"version": 1, "name": "Growth", "outlines": "center", "levels": levels})


def block(index, count):
    """Rooms on both sides of a corridor of their own."""
    low = index * 20.0
    rows = math.ceil(count / 2)
    corridor = {"id": f"corridor-{index}", "type": "corridor", "rectangle": [0, low + 6, rows * 4, 2]}
    rooms, openings = [corridor], []
    openings.append({"kind": "door", "at": [0, low + 7], "rooms": [corridor["id"]]})
    for number in range(count):
        column, is_above = divmod(number, 2)
        name = f"room-{index}-{number}"
        rooms.append({"id": name, "type": "bedroom", "rectangle": [column * 4, low + (8 if is_above else 0), 4, 6]})
        wall, outside = (low + 8, low + 14) if is_above else (low + 6, low)
        openings.append({"kind": "door", "at": [column * 4 + 3, wall], "rooms": [corridor["id"], name]})
        openings.append({"kind": "window", "at": [column * 4 + 2, outside], "rooms": [name]})
    return rooms, openings


def rooms_of_level(count):
    rooms, openings = [], []
    for index, first in enumerate(range(0, count, ROOMS_OF_BLOCK)):
        more = block(index, min(ROOMS_OF_BLOCK, count - first))
        rooms += more[0]
        openings += more[1]
    return [plan([{"id": "1", "height": 3, "rooms": rooms, "openings": openings}])]


def levels_of_site(count):
    """A level of four rooms; buildings have up to 1,000 of them."""
    rooms, openings = [], []
    for number, kind in enumerate(ROOMS_OF_HOME):
        rooms.append({"id": kind, "type": kind, "rectangle": [number * 4, 0, 4, 5]})
        openings.append({"kind": "window", "at": [number * 4 + 2, 5], "rooms": [kind]})
        if number:
            openings.append({"kind": "door", "at": [number * 4, 1], "rooms": [ROOMS_OF_HOME[number - 1], kind]})
    openings.append({"kind": "door", "at": [2, 0], "rooms": [ROOMS_OF_HOME[0]]})
    level = {"height": 3, "rooms": rooms, "openings": openings}
    return [plan([{"id": str(index), **level} for index in range(first, min(first + MOST_LEVELS, count))])
            for first in range(0, count, MOST_LEVELS)]


def corners_of_room(count):
    """A round room of 20 m across, as drawings have them: its wall is a polygon of up to as many corners as are read."""
    angles = [2 * math.pi * corner / count for corner in range(count)]
    outline = [[round(10 * math.cos(angle), 6), round(10 * math.sin(angle), 6)] for angle in angles]
    return [plan([{"id": "1", "height": 3, "rooms": [{"id": "round", "type": "living_room", "outline": outline}]}])]


def objects_in_room(count):
    """Tables with four chairs each, twice as far apart as in the paper's restaurant, where not all of so many find a place."""
    side = round(math.sqrt(count * 1.5), 2)
    room = {"id": "restaurant", "type": "restaurant", "style": f"growth_{count}", "rectangle": [0, 0, side, side]}
    door = {"kind": "door", "at": [side / 2, 0], "rooms": ["restaurant"]}
    return [plan([{"id": "1", "height": 3.5, "rooms": [room], "openings": [door]}])]


def catalogue(counts):
    """Styles that ask for so many objects in a restaurant."""
    tables = {count: {"class": "row_table", "count": count // 5, "required": True} for count in counts}
    chairs = {count: {"class": "restaurant_chair", "count": count - count // 5, "required": True} for count in counts}
    style = {"extends": "restaurant_simple", "room_types": ["restaurant"], "untidiness": {"turn": 0, "distance": 0}}
    styles = {f"growth_{count}": {**style, "label": f"{count} objects", "programmes": {"restaurant": [tables[count], chairs[count]]}}
              for count in counts}
    return json.dumps({"version": 1, "styles": styles})


OBJECTS = [5, 10, 100, 500, 1000]
SERIES = [
    ("rooms of a level", rooms_of_level, [1, 10, 100, 1000, 10_000]),
    ("levels of a site, 4 rooms each", levels_of_site, [1, 10, 100, 500, 2000]),
    ("corners of a room", corners_of_room, [4, 10, 100, 1000, 4096]),
    ("objects in a room", objects_in_room, OBJECTS),
]


def bake(program, folder, out):
    """Processor seconds and peak megabytes of one bake."""
    run = measured([program, "bake", folder / "plans", "--catalog", folder / "catalogue", "--out", folder / out, "--threads", "1",
                    "--textures", "none", "--quiet"])
    # Rooms that fail cost as much as others; without files there is nothing to measure.
    if run.code not in (0, 1):
        sys.exit(f"measure_growth: {run.stderr[-1000:]}")
    return run.processor_seconds, run.peak_bytes / 2**20


def measure(program, make, sizes, runs):
    """For each size: least processor seconds of the runs, and most megabytes."""
    costs = []
    for size in sizes:
        with tempfile.TemporaryDirectory(prefix="roomwright-growth-") as name:
            folder = Path(name)
            for part in ("plans", "catalogue/styles"):
                (folder / part).mkdir(parents=True)
            (folder / "catalogue" / "styles" / "growth.yaml").write_text(catalogue(OBJECTS))
            for number, text in enumerate(make(size)):
                (folder / "plans" / f"plan-{number}.yaml").write_text(text)
            # A folder for each run: what is there already is kept.
            results = [bake(program, folder, str(run)) for run in range(runs)]
        costs.append((min(seconds for seconds, _ in results), max(peak for _, peak in results)))
        print(f"{make.__name__}({size}): {costs[-1][0]:.3f} s, {costs[-1][1]:.0f} MB", file=sys.stderr)
    return costs


def exponent(sizes, seconds):
    """The slope between the two largest sizes, of what is beyond the smallest."""
    (less, more), (first, second) = sizes[-2:], [value - seconds[0] for value in seconds[-2:]]
    return math.log(second / first) / math.log(more / less)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "target" / "release" / "roomwright")
    parser.add_argument("--runs", type=int, default=3, help="runs of each plan (default 3)")
    options = parser.parse_args()
    print("| what grows | sizes | processor seconds | most memory | exponent at the end |\n|---|---|---|---|---|")
    for name, make, sizes in SERIES:
        costs = measure(options.program, make, sizes, options.runs)
        seconds = [cost for cost, _ in costs]
        shown = "; ".join(f"{size:,}" for size in sizes), "; ".join(f"{cost:.2f}" for cost in seconds)
        print(f"| {name} | {shown[0]} | {shown[1]} | {costs[-1][1]:.0f} MB | {exponent(sizes, seconds):.2f} |")


if __name__ == "__main__":
    main()
