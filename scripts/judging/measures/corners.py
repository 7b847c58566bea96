"""Corners and niches: what is built in reaches the walls beside it, and who lies alone lies along a wall."""

from __future__ import annotations

import numpy
import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..places import has_place
from ..roles import BATHROOMS, BINS, SINGLE_BEDS, TUBS, TV_STANDS
from .kitchens import units_of

# Metres beside a piece within which a wall or another piece closes its side: a joint.
JOINT = 0.04
# Metres beside a kitchen unit, or beside a bath in a corner, that are lost: more than a joint, less than another unit is wide.
UNIT_GAP = (0.03, 0.6)
BATH_GAP = (0.12, 0.6)
# Shares of the depth at which a side is closed by the end of a unit's own wall.
DEPTHS = (0.02, 0.98)
# Metres from the mattress to the wall: a board, and a hand that tucks in the sheet. A jog of the wall or a piece closes a side
# of a bed along a quarter of its length, half a metre: who sits up in it leans there, or rolls no farther.
BED_GAP = 0.1
BED_SHARE = 0.25
# Metres between the sides of twin beds at most, a way beside each (HUD: 1.07), and by which one is before the other at most.
TWIN_GAP = 1.2
TWIN_SHIFT = 0.3
# Metres before a screen's stand that stay empty, metres of height over which a piece is in the way, and square metres of it.
BEFORE = 0.8
IN_THE_WAY = 0.55
LEAST = 0.1
FARTHEST = 3.0


def gap(room: Room, piece: Piece, name: str, share: float = 0.5) -> tuple[float, bool]:
    """Metres from a side, at a share of its length, to what closes it, 3 at most, and whether that is a wall without an opening."""
    start, end, outward = piece.side(name)
    first = start + (end - start) * share + outward * 0.005
    ray = shapely.LineString([first, first + outward * FARTHEST])
    inside = shapely.intersection(ray, room.region)
    metres = max((part.length for part in shapely.get_parts(inside) if part.distance(shapely.Point(first)) < JOINT), default=0.0)
    is_wall = metres < FARTHEST - JOINT and not any(
        shapely.LineString([side.wall.at(side.start), side.wall.at(side.end)]).distance(shapely.Point(first + outward * metres)) < JOINT
        for _, side in room.openings(doors=True))
    for other in room.standing:
        if other is not piece and other.kind not in BINS:
            met = shapely.intersection(ray, other.footprint)
            away = shapely.Point(first).distance(met) if not met.is_empty else metres
            metres, is_wall = (away, False) if away < metres else (metres, is_wall)
    return metres, is_wall


def sides(room: Room, piece: Piece) -> list[tuple[float, bool]]:
    """The gaps at its left and right, the smaller one first."""
    return sorted(gap(room, piece, name) for name in ("left", "right"))


def reaches_end(room: Room, piece: Piece, name: str) -> bool:
    """Whether a part of a side is closed: before a slanted wall, or beside a jog, a row reaches the end of its own wall."""
    return any(gap(room, piece, name, share)[0] <= UNIT_GAP[0] for share in DEPTHS)


def judge_kitchen_ends(room: Room) -> Answer | None:
    units = units_of(room)
    if not units:
        return None
    faults = []
    for unit in units:
        for name in ("left", "right"):
            metres, is_wall = gap(room, unit, name)
            if is_wall and UNIT_GAP[0] < metres < UNIT_GAP[1] and not reaches_end(room, unit, name):
                faults.append(Fault(f"{metres:.2f} m of wall are lost beside it", (unit.id,), metres))
    return answer(faults, max((fault.measured for fault in faults), default=0.0))


def baths_of(room: Room) -> list[Piece]:
    return room.of(TUBS) if room.kind in BATHROOMS else []


def closed_at_a_side(nearest: dict[str, float], limit: float) -> Answer | None:
    """Pieces whose nearer side, by their ids, is farther from a wall or piece than the limit fail."""
    if not nearest:
        return None
    faults = [Fault(f"no side is closed within {metres:.2f} m", (name,), metres) for name, metres in nearest.items() if metres > limit]
    return answer(faults, max(nearest.values()))


def judge_bath_corners(room: Room) -> Answer | None:
    return closed_at_a_side({bath.id: sides(room, bath)[0][0] for bath in baths_of(room)}, JOINT)


def judge_bath_niches(room: Room) -> Answer | None:
    baths = baths_of(room)
    if not baths:
        return None
    faults = []
    for bath in baths:
        (corner, _), (metres, is_wall) = sides(room, bath)
        if corner <= JOINT and is_wall and BATH_GAP[0] < metres < BATH_GAP[1]:
            faults.append(Fault(f"{metres:.2f} m of the niche are left", (bath.id,), metres))
    return answer(faults, max((fault.measured for fault in faults), default=0.0))


def leaned_on(room: Room, bed: Piece, name: str) -> float:
    """Metres to what closes a side along BED_SHARE of its length: of rays at even steps, the farthest of the nearest ones."""
    steps = 12
    gaps = sorted(gap(room, bed, name, (step + 0.5) / steps)[0] for step in range(steps))
    return gaps[round(BED_SHARE * steps) - 1]


def judge_beds(room: Room) -> Answer | None:
    """Of twin beds, which stand side by side, one is enough at the wall. Doors and windows may leave no wall as long as a bed."""
    beds = room.of(SINGLE_BEDS | {"bunk_bed"})
    gaps = {bed.id: min(leaned_on(room, bed, name) for name in ("left", "right")) for bed in beds}
    leaning = [bed for bed in beds if gaps[bed.id] <= BED_GAP]
    free = [bed for bed in beds if not any(bed is other or are_twins(bed, other) for other in leaning)]
    free = [bed for bed in free if has_place(room, bed, along_wall=True)]
    return closed_at_a_side({bed.id: gaps[bed.id] for bed in free or leaning}, BED_GAP) or (answer([]) if beds else None)


def are_twins(one: Piece, other: Piece) -> bool:
    """Whether two beds look the same way, with no more than a way between their long sides."""
    outward, across = one.side("front")[2], one.side("left")[2]
    between = other.footprint.centroid.coords[0] - numpy.array(one.footprint.centroid.coords[0])
    is_beside = abs(float(between @ outward)) < TWIN_SHIFT and abs(float(between @ across)) > TWIN_SHIFT
    return is_beside and float(outward @ other.side("front")[2]) > 0.99 and one.footprint.distance(other.footprint) <= TWIN_GAP


def judge_before_screens(room: Room) -> Answer | None:
    stands = room.of(TV_STANDS)
    if not stands:
        return None
    faults = []
    for stand in stands:
        zone = stand.zone("front", BEFORE)
        faults += [Fault(f"it stands before {stand.id}", (piece.id,)) for piece in room.standing
                   if piece is not stand and piece.high > IN_THE_WAY and piece.footprint.intersection(zone).area > LEAST]
    return answer(faults)


SOURCE = "drawn floor plans"
MEASURES = [
    Measure("kitchen_end_gap", "rows of units reach the walls at their ends", "m", "≤ 0.03, or ≥ 0.6", SOURCE, judge_kitchen_ends),
    Measure("bath_corner", "tubs and showers stand in a corner", "m", "≤ 0.04", SOURCE, judge_bath_corners),
    Measure("bath_niche", "they leave no useless rest of a niche", "m", "≤ 0.12, or ≥ 0.6", SOURCE, judge_bath_niches),
    Measure("bed_along_wall", "a bed for one has a long side at a wall or a piece; of twin beds one", "m", "≤ 0.1", SOURCE, judge_beds),
    Measure("before_screen", "nothing high stands right before a television", "", "0.8 m; 0.55 m high", SOURCE, judge_before_screens),
]
