#!/usr/bin/env python3
"""Writes plans of random polygons for validate.py: random_polygons.py FOLDER [--count N] [--seed N]

Each plan has 50 polygons: stars with 3 to 10 corners, and rows of two to four rooms whose borders are nearly parallel, with
doors between them and windows. Walls of a plan are 1 to 50 cm thick; the gaps between rooms of a row are 0 to 0.7 m. One door in
a few thousand fits on no wall: `bake` reports it and ends with exit code 1.

    python scripts/random_polygons.py plans --count 10000
    roomwright bake plans --out out --textures none
    python scripts/validate.py out --no-khronos
"""

from __future__ import annotations

import argparse
import json
import math
import random
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.TOOLS, __name__)

import shapely

ROOMS_OF_A_PLAN = 50
# Metres between groups of rooms, more than two walls and the tips of their corners, and groups in a row.
INTERVAL = 25.0
COLUMNS = 8
# Square metres of the smallest polygon.
LEAST_AREA = 0.5
# Metres: width of openings, by how much a side is longer than its opening, and the thickest wall with a door.
WIDTH = 0.8
MARGIN = 0.4
THICKEST = 0.4
# Metres: thicknesses of walls, gaps between rooms of a row, and how far the corners of their borders lie off a line.
THICKNESSES = (0.01, 0.07, 0.1, 0.2, 0.35, 0.5)
GAPS = (0.0, 0.001, 0.03, 0.1, 0.2, 0.4, 0.7)
BENDS = (0.0, 0.01, 0.05, 0.4)
TYPES = ("bedroom", "living_room", "office", "storeroom", "bathroom")

Point = tuple[float, float]


def star(draw: random.Random) -> list[Point]:
    while True:
        angles = sorted(draw.uniform(0, math.tau) for _ in range(draw.randint(3, 10)))
        radii = [draw.uniform(0.5, 4.0) for _ in angles]
        corners = [(radius * math.cos(angle), radius * math.sin(angle)) for angle, radius in zip(angles, radii)]
        if area(corners) > LEAST_AREA:
            return corners


def area(corners: list[Point]) -> float:
    return sum(ax * by - bx * ay for (ax, ay), (bx, by) in sides(corners)) / 2


def sides(corners: list[Point]) -> list[tuple[Point, Point]]:
    return list(zip(corners, corners[1:] + corners[:1]))


def row(draw: random.Random) -> list[list[Point]]:
    """Rooms beside each other, between lines from south to north."""
    heights = [0.0]
    for _ in range(draw.randint(2, 6)):
        heights.append(heights[-1] + draw.uniform(0.03, 1.5))
    bend = draw.choice(BENDS)
    west = [(draw.uniform(-bend, bend), y) for y in heights]
    rooms = []
    for _ in range(draw.randint(2, 4)):
        width = draw.uniform(1.0, 4.0)
        east = [(x + width + draw.uniform(0, bend), y) for x, y in west]
        south = ((west[0][0] + east[0][0]) / 2, heights[0] - draw.uniform(0, bend))
        north = ((west[-1][0] + east[-1][0]) / 2, heights[-1] + draw.uniform(0, bend))
        rooms.append([west[0], south, *east, north, *reversed(west[1:])])
        gap, more = draw.choice(GAPS), draw.choice(GAPS)
        west = [(x + gap + draw.uniform(0, more), y) for x, y in east]
    return rooms


def plan(draw: random.Random, count: int) -> dict:
    rooms, openings = [], []
    while len(rooms) < count:
        shapes = [star(draw)] if draw.random() < 1 / 3 else row(draw)
        if not all(shapely.Polygon(shape).is_valid for shape in shapes):
            continue
        shapes = [moved(shape, len(rooms)) for shape in shapes[:count - len(rooms)]]
        first = len(rooms)
        rooms += [{"id": str(first + number), "type": draw.choice(TYPES), "outline": shape}
                  for number, shape in enumerate(shapes)]
        # Of a row, only the sides in the south are nobody else's.
        edges = 2 if len(shapes) > 1 else None
        openings += [opening for room in rooms[first:] for opening in own_opening(draw, room, edges)]
        openings += [door for one, two in zip(rooms[first:], rooms[first + 1:]) for door in joint(one, two)]
    walls = {"exterior": draw.choice(THICKNESSES), "interior": draw.choice(THICKNESSES)}
    return {"version": 1, "walls": walls, "levels": [{"id": "1", "rooms": rooms, "openings": openings}]}


def moved(shape: list[Point], number: int) -> list[Point]:
    east, north = number % COLUMNS * INTERVAL, number // COLUMNS * INTERVAL
    return [(round(x + east, 4), round(y + north, 4)) for x, y in shape]


def own_opening(draw: random.Random, room: dict, edges: int | None) -> list[dict]:
    """A door or window in the longest side of a room, or of its first few."""
    lengths = [math.dist(*side) for side in sides(room["outline"])[:edges]]
    edge = lengths.index(max(lengths))
    if lengths[edge] < WIDTH + MARGIN:
        return []
    return [{"kind": draw.choice(("door", "window")), "room": room["id"], "edge": edge, "width": WIDTH}]


def joint(one: dict, two: dict) -> list[dict]:
    """A door between two rooms of a row, in the longest side that looks east, if it is long and the wall not too thick."""
    steps = (len(one["outline"]) - 2) // 2
    east = one["outline"][2:2 + steps]
    west = [two["outline"][0], *reversed(two["outline"][2 + steps + 1:])]
    stretches = list(zip(zip(east, east[1:]), zip(west, west[1:])))
    (low, high), (far_low, far_high) = max(stretches, key=lambda pair: math.dist(*pair[0]))
    middle = middle_of(low, high)
    far = middle_of(far_low, far_high)
    if math.dist(low, high) < WIDTH + MARGIN or math.dist(middle, far) > THICKEST:
        return []
    return [{"kind": "door", "rooms": [one["id"], two["id"]], "width": WIDTH, "at": middle_of(middle, far)}]


def middle_of(one: Point, two: Point) -> Point:
    return (one[0] + two[0]) / 2, (one[1] + two[1]) / 2


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--count", type=int, default=10_000, help="polygons (10000)")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    for number in range(-(-options.count // ROOMS_OF_A_PLAN)):
        count = min(ROOMS_OF_A_PLAN, options.count - number * ROOMS_OF_A_PLAN)
        draw = random.Random(f"{options.seed}/{number}")
        (options.folder / f"polygons-{number:03}.json").write_text(json.dumps(plan(draw, count)))


if __name__ == "__main__":
    main()
