"""Distances between pieces of a group: aisles, seats in talk, seats behind which one passes. QUALITY §3."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import shapely

from ..clear import INSET, free_depth
from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import CHAIRS, EASY_CHAIRS, KITCHEN_UNITS, KITCHENS, LIBRARY_SHELVES, LIVING_ROOMS, SOFAS, TABLES
from ..shapes import angle_between
from .living import is_for_reading

# Metres: NKBA (kitchens, dining), Merrell (talk), ADA (libraries).
KITCHEN_AISLE = 1.0
BEHIND_SEAT = 0.81
TALK = (1.2, 3.0)
LIBRARY_AISLE = 0.9
# Degrees within which a seat faces a sofa.
OPPOSITE = 60.0
# Metres beyond which two rows of units are no aisle.
FARTHEST = 2.5
SLACK = 0.01


def judge_facing(kinds: set[str], rooms: set[str] | None, least: float) -> Callable[[Room], Answer | None]:
    """The narrowest aisle between pieces that face each other."""
    def judge(room: Room) -> Answer | None:
        pieces = [piece for piece in room.of(kinds) if piece.stands]
        aisles = list(facing_pairs(pieces)) if rooms is None or room.kind in rooms else []
        if not aisles:
            return None
        faults = [Fault(f"{metres:.2f} m between them", (one.id, other.id), metres) for one, other, metres in aisles
                  if metres < least - SLACK]
        return answer(faults, min(metres for _, _, metres in aisles))

    return judge


def facing_pairs(pieces: list[Piece]) -> Iterator[tuple[Piece, Piece, float]]:
    for number, one in enumerate(pieces):
        zone = one.zone("front", FARTHEST, INSET)
        for other in pieces[:number]:
            if angle_between(one.front, -other.front) < 10.0 and other.footprint.intersection(zone).area > 0.01:
                yield one, other, one.footprint.distance(other.footprint)


def judge_behind_seats(room: Room) -> Answer | None:
    """From the edge of a table to what is behind a seat at it."""
    tables = [piece for piece in room.of(TABLES) if piece.stands]
    if not tables:
        return None
    faults, nearest = [], float("inf")
    for table in tables:
        seats = {chair.id for chair in room.of(CHAIRS) if chair.parent == table.id}
        for chair in room.of(CHAIRS):
            metres = behind(room, table, chair, seats) if chair.id in seats else float("inf")
            nearest = min(nearest, metres)
            if metres < BEHIND_SEAT - SLACK:
                faults.append(Fault(f"{metres:.2f} m from the edge of {table.id} to what is behind", (chair.id,), metres))
    return answer(faults, nearest) if np.isfinite(nearest) else None


def behind(room: Room, table: Piece, chair: Piece, seats: set[str]) -> float:
    """Metres from a table, through a seat at it, to the first thing behind the seat."""
    start, end, _ = chair.side("front")
    middle = shapely.Point((start + end) / 2)
    is_under = table.footprint.covers(middle)
    under = middle.distance(table.footprint.boundary) if is_under else -middle.distance(table.footprint)
    zone = chair.zone("back", FARTHEST, INSET)
    depth, _ = free_depth(room, chair, zone, -chair.front, seats | {table.id})
    return min(depth, FARTHEST) + float(chair.size[1]) - under


def judge_talk(room: Room) -> Answer | None:
    """Seats and sofas that face each other, from seat to seat; a reading corner is a place of its own."""
    sofas, chairs = room.of(SOFAS), room.of(EASY_CHAIRS)
    if room.kind not in LIVING_ROOMS or not sofas or not chairs:
        return None
    pairs = [(sofa, chair, float(np.hypot(*(sofa.center - chair.center)))) for sofa in sofas for chair in chairs]
    facing = [(chair, metres) for sofa, chair, metres in pairs
              if angle_between(chair.front, sofa.center - chair.center) < OPPOSITE
              and angle_between(sofa.front, chair.center - sofa.center) < OPPOSITE and not is_for_reading(room, chair)]
    if not facing:
        return None
    faults = [Fault(f"{metres:.2f} m from the sofa", (chair.id,), metres) for chair, metres in facing
              if not TALK[0] - SLACK <= metres <= TALK[1] + SLACK]
    return answer(faults, min(metres for _, metres in facing))


MEASURES = [
    Measure("kitchen_aisle", "units that face each other leave an aisle", "m", "≥ 1.0", "NKBA",
            judge_facing(KITCHEN_UNITS, KITCHENS, KITCHEN_AISLE)),
    Measure("library_aisle", "shelves that face each other leave an aisle", "m", "≥ 0.9", "ADA",
            judge_facing(LIBRARY_SHELVES, None, LIBRARY_AISLE)),
    Measure("behind_seat", "a seat can be pushed back from its table", "m", "≥ 0.81 from the table's edge", "NKBA",
            judge_behind_seats),
    Measure("talk", "easy chairs that face a sofa are near enough to talk", "m", "1.2–3.0", "Merrell et al. 2011", judge_talk),
]
