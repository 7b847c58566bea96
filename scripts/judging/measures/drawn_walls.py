"""Fixtures at the walls where the architect drew them, in rooms whose plan has such a drawing.

The wall of a fixture is the wall nearest its back; stretches on one line are one wall. Of several fixtures of a kind, the wall
with most metres of them counts, or any of several equal ones.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..drawn import Drawn
from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import BASINS, BATHROOMS, ISLANDS, KITCHEN_UNITS, KITCHENS, TOILETS, TUBS
from ..shapes import Wall

# Metres of a back from its wall beyond which a fixture stands free, and within which a shower touches it.
FARTHEST = 0.5
TOUCH = 0.15
# Cosine of 30°: a back is parallel to its wall.
PARALLEL = 0.866
# Metres by which two arms of a kitchen are equal.
EQUAL = 0.01

CLASSES = {"toilet": TOILETS, "basin": BASINS, "bath": TUBS, "kitchen": KITCHEN_UNITS - ISLANDS}
ROOMS = {"toilet": BATHROOMS, "basin": BATHROOMS, "bath": BATHROOMS, "kitchen": KITCHENS}

Back = tuple[np.ndarray, np.ndarray, float]  # middle, unit vector out of the fixture, metres


def judge_kind(use: str) -> Callable[[Room], Answer | None]:
    def judge(room: Room) -> Answer | None:
        theirs = drawn_walls(room, [drawn for drawn in room.drawn if drawn.use == use])
        ours = own_walls(room, [piece for piece in room.of(CLASSES[use]) if piece.carrier is None and piece.low < 1.0])
        if room.kind not in ROOMS[use] or not theirs or not ours:
            return None
        if ours & theirs:
            return answer([], chance_of(room, theirs))
        return answer([Fault(f"ours at wall {names(room, ours)}, the architect's at {names(room, theirs)}")],
                      chance_of(room, theirs))

    return judge


def names(room: Room, walls: set[int]) -> str:
    return " or ".join(str(room.straight_walls[number][0].number) for number in sorted(walls))


def chance_of(room: Room, walls: set[int]) -> float:
    """The share of the outline that some walls are: how often chance alone agrees."""
    lengths = [sum(wall.length for wall in group) for group in room.straight_walls]
    return sum(lengths[number] for number in walls) / sum(lengths)


def drawn_walls(room: Room, drawn: list[Drawn]) -> set[int]:
    metres: dict[tuple[int, ...], float] = {}
    for fixture in drawn:
        found = sorted(((abs(distance), number, back[2]) for back in fixture.backs()
                        for distance, number in behind(room, back)), key=lambda entry: entry[0])
        if found:
            touched = {number for distance, number, _ in found if fixture.name == "shower" and distance < TOUCH}
            walls = tuple(sorted({found[0][1]} | touched))
            metres[walls] = metres.get(walls, 0.0) + found[0][2]
    return main_walls(metres)


def own_walls(room: Room, pieces: list[Piece]) -> set[int]:
    metres: dict[tuple[int, ...], float] = {}
    for piece in pieces:
        start, end, outward = piece.side("back")
        for _, number in behind(room, ((start + end) / 2, outward, float(piece.size[0]))):
            metres[number,] = metres.get((number,), 0.0) + float(piece.size[0])
    return main_walls(metres)


def main_walls(metres: dict[tuple[int, ...], float]) -> set[int]:
    most = max(metres.values(), default=0.0)
    return {wall for walls, sum_ in metres.items() if most - sum_ <= EQUAL for wall in walls}


def behind(room: Room, back: Back) -> list[tuple[float, int]]:
    """The straight wall nearest a back with its metres from it, if there is one."""
    middle, outward, width = back
    found = []
    for number, walls in enumerate(room.straight_walls):
        for wall in walls:
            distance = wall.distance(middle)
            if is_behind(wall, middle, outward, width) and abs(distance) < FARTHEST:
                found.append((distance, number))
    return [min(found, key=lambda entry: abs(entry[0]))] if found else []


def is_behind(wall: Wall, middle: np.ndarray, outward: np.ndarray, width: float) -> bool:
    at = float((middle - wall.start) @ wall.along)
    return -wall.inward @ outward > PARALLEL and -width / 2 < at < wall.length + width / 2


def measure(use: str, wanted: float) -> Measure:
    return Measure(f"{use}_wall", f"the {use} stands at the wall where the architect drew it", "share of the outline",
                   "the same wall", "the plan's drawing", judge_kind(use), wanted)


MEASURES = [measure("kitchen", 0.6), measure("toilet", 0.75), measure("basin", 0.7), measure("bath", 0.75)]
