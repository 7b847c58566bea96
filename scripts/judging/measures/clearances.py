"""Free floor before what is used. QUALITY §3."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..clear import INSET, free_depth
from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import (ART, BASINS, BEDS, COFFEE_TABLES, COOKERS, DESKS, DISHWASHERS, DOUBLE_BEDS, FRIDGES, OFFICE_CHAIRS, SINKS,
                     SOFAS, STORAGE, TOILETS, TUBS)
from ..shapes import rectangle

# Metres that people do not feel, for the figures are rounded from inches, and rounding.
SLACK = 0.012
# Metres of a bed's side, from its foot, at which one gets in; a nightstand stands beside the rest.
BED_SIDE = 1.2
# Class, minimum and good depth before the front: HUD 1973 (storage), NKBA (kitchens and baths).
FRONTS = [(STORAGE, 0.60, 0.91), (COOKERS | FRIDGES | DISHWASHERS | SINKS, 0.75, 1.0), (TOILETS | BASINS | TUBS, 0.53, 0.76)]
DESK = (0.75, 0.91)
BED_USED = (0.56, 1.07)
BED_OTHER = (0.30, 0.60)
BED_FOOT = (0.56, 0.91)
TOILET_AXIS = (0.38, 0.45)
COFFEE = (0.36, 0.60)
ART_HEIGHT = (1.35, 1.75)


class Clearance(NamedTuple):
    """A side with the depth that it has and those that it should have."""

    piece: Piece
    what: str
    depth: float
    minimum: float
    good: float
    taker: str


def clearances_of(room: Room) -> Iterator[Clearance]:
    for kinds, minimum, good in FRONTS:
        for piece in room.of(kinds):
            if piece.stands:
                yield front(room, piece, "front", minimum, good)
    for desk in room.of(DESKS):
        chair = next((chair for chair in room.of(OFFICE_CHAIRS) if chair.parent == desk.id), None)
        if chair is not None and desk.stands:
            yield front(room, desk, side_towards(desk, chair), *DESK)
    for bed in room.of(BEDS):
        if bed.stands:
            yield from bed_clearances(room, bed)
    for toilet in room.of(TOILETS):
        yield toilet_axis(room, toilet)


def front(room: Room, piece: Piece, side: str, minimum: float, good: float) -> Clearance:
    outward = piece.side(side)[2]
    depth, taker = free_depth(room, piece, piece.zone(side, good, INSET), outward, followers(room, piece))
    return Clearance(piece, side, depth, minimum, good, taker)


def followers(room: Room, piece: Piece) -> set[str]:
    """What was arranged by a piece, and moves away from it: chairs, nightstands, benches."""
    return {other.id for other in room.pieces if other.parent == piece.id}


def side_towards(piece: Piece, other: Piece) -> str:
    offset = other.center - piece.center
    return max(("front", "back", "left", "right"), key=lambda name: float(piece.side(name)[2] @ offset))


def bed_clearances(room: Room, bed: Piece) -> Iterator[Clearance]:
    ignored = followers(room, bed)
    sides = []
    for name in ("left", "right"):
        outward = bed.side(name)[2]
        foot = bed.center + bed.front * bed.size[1] / 2 + outward * bed.size[0] / 2
        zone = rectangle(foot, foot - bed.front * BED_SIDE, outward * BED_USED[1])
        sides.append((*free_depth(room, bed, zone.buffer(-INSET, join_style="mitre"), outward, ignored), name))
    sides.sort(key=lambda side: -side[0])
    yield Clearance(bed, "used side", sides[0][0], *BED_USED, sides[0][1])
    if bed.kind in DOUBLE_BEDS:
        yield Clearance(bed, "other side", sides[1][0], *BED_OTHER, sides[1][1])
        yield front(room, bed, "front", *BED_FOOT)


def toilet_axis(room: Room, toilet: Piece) -> Clearance:
    """From a toilet's middle line to what is beside it."""
    nearest, taker = float("inf"), ""
    for name in ("left", "right"):
        outward = toilet.side(name)[2]
        depth, what = free_depth(room, toilet, toilet.zone(name, TOILET_AXIS[1], INSET), outward, set())
        if depth < nearest:
            nearest, taker = depth, what
    return Clearance(toilet, "middle line", nearest + float(toilet.size[0]) / 2, *TOILET_AXIS, taker)


def judge_blocked(room: Room) -> Answer | None:
    found = list(clearances_of(room))
    if not found:
        return None
    return answer([fault_of(one) for one in found if one.depth < one.minimum - SLACK])


def judge_tight(room: Room) -> Answer | None:
    found = list(clearances_of(room))
    if not found:
        return None
    return answer([fault_of(one) for one in found if one.minimum - SLACK <= one.depth < one.good - SLACK])


def fault_of(one: Clearance) -> Fault:
    return Fault(f"{one.depth:.2f} m at the {one.what} of the {one.piece.kind}, to {one.taker}", (one.piece.id,), one.depth)


def judge_coffee(room: Room) -> Answer | None:
    tables, sofas = room.of(COFFEE_TABLES), room.of(SOFAS)
    if not tables or not sofas:
        return None
    faults = []
    for table in tables:
        metres = min(table.footprint.distance(sofa.footprint) for sofa in sofas)
        if not COFFEE[0] - SLACK <= metres <= COFFEE[1] + SLACK:
            faults.append(Fault(f"{metres:.2f} m from the sofa", (table.id,), metres))
    return answer(faults, min((table.footprint.distance(sofa.footprint) for table in tables for sofa in sofas)))


def judge_art(room: Room) -> Answer | None:
    art = [piece for piece in room.of(ART) if piece.low > 0.5]
    if not art:
        return None
    middles = [(piece, (piece.low + piece.high) / 2) for piece in art]
    faults = [Fault(f"its middle is at {middle:.2f} m", (piece.id,), middle) for piece, middle in middles
              if not ART_HEIGHT[0] - SLACK <= middle <= ART_HEIGHT[1] + SLACK]
    return answer(faults, float(np.median([middle for _, middle in middles])))


MEASURES = [
    Measure("blocked_use", "nothing takes the minimum clearance of a used side", "m",
            "bed 0.56, other 0.30, foot 0.56; storage 0.60; desk 0.75; appliance 0.75; WC, basin, tub 0.53; WC axis 0.38",
            "HUD 1973; NKBA", judge_blocked, audit="blocked_use"),
    Measure("tight_use", "nothing takes the good clearance of a used side", "m",
            "bed 1.07, 0.60, 0.91; storage 0.91; desk 0.91; appliance 1.0; WC, basin, tub 0.76; WC axis 0.45", "HUD 1973; NKBA",
            judge_tight, audit="tight_use"),
    Measure("sofa_to_table", "a sofa's low table is in reach and not in the way", "m", "0.36–0.60", "Infinigen, Merrell",
            judge_coffee),
    Measure("art_height", "the middle of what hangs on walls is at eye height", "m", "1.35–1.75", "SceneSmith", judge_art),
]
