"""Doors that open, and ways that people walk. QUALITY §2."""

from __future__ import annotations

from collections.abc import Callable

import shapely

from ..clear import walkable
from ..floors import Opening, Room, Side
from ..measure import Answer, Fault, Measure, answer
from ..pieces import COVERING, Piece
from ..roles import (BASINS, BEDS, COOKERS, DESKS, DISHWASHERS, FRIDGES, OFFICE_CHAIRS, SINKS, SOFAS, TOILETS, TUBS,
                     WARDROBES)

# Metres: an approach is as deep as its door is wide, and at most this.
APPROACH = 0.8
# Metres by which a body may be in it, and by which coordinates are rounded.
INTRUSION = 0.003
# Metres of a minor walkway, and where the plan itself is narrower.
PERSON = 0.45
NARROW = 0.3
# Metres that a raster of 5 cm, by which QUALITY measures, may round in people's favour: its diagonal.
RASTER = 0.07
# Metres before a side at which its user stands.
USE = 0.6
Place = tuple[str, tuple[str, ...], list[shapely.Polygon]]  # what it is, its pieces, where one may stand: any of these
FRONTS = TOILETS | BASINS | TUBS | SINKS | COOKERS | FRIDGES | DISHWASHERS | WARDROBES | SOFAS


def judge_doors(room: Room) -> Answer | None:
    doors = [(opening, side) for opening, side in room.openings(doors=True) if opening.closure != "open"]
    if not doors:
        return None
    faults = []
    for opening, side in doors:
        kept = shapely.union_all([side.before(min(opening.width, APPROACH)), *opening.swings]).buffer(-INTRUSION)
        for piece in room.pieces:
            if piece.carrier is None and piece.footprint.intersects(kept) and is_in(piece, kept, opening):
                faults.append(Fault(f"in the way of door {opening.id}", (piece.id,)))
    return answer(faults)


def is_in(piece: Piece, kept: shapely.Geometry, opening: Opening) -> bool:
    return not piece.is_covering and piece.below(opening.height, COVERING).intersection(kept).area > 1e-4


def judge_reached(person: float) -> Callable[[Room], Answer | None]:
    """Whether a person of a width comes from the first door to the others and to what is used."""
    def judge(room: Room) -> Answer | None:
        doors = [side for _, side in room.openings(doors=True)]
        places = [(f"the door in wall {side.wall.number}", (), [door_zone(side)]) for side in doors]
        places += [(f"the {piece.kind}", (piece.id,), zones) for piece in room.pieces if (zones := zones_of(piece, room))]
        if not doors or len(places) < 2 or not room.standing:
            return None
        cut_off = unreached(room, places, person)
        return answer([Fault(f"{what} cannot be reached", pieces, person) for what, pieces in cut_off])

    return judge


def unreached(room: Room, places: list[Place], person: float) -> list[tuple[str, tuple[str, ...]]]:
    """What furniture cuts off; where the plan itself is narrow, from narrower people."""
    start = places[0][2]
    left = [place for place in places[1:] if not is_joined(start, place[2], walkable(room, person, True))]
    if not left:
        return []
    cut_off = [place[:2] for place in left if is_joined(start, place[2], walkable(room, person, False))]
    narrow = [place for place in left if place[:2] not in cut_off]
    if narrow and person > NARROW:
        cut_off += unreached(room, [places[0], *narrow], NARROW)
    return cut_off


def judge_walkable(room: Room) -> Answer | None:
    """The share of the free floor that a narrow person reaches, of all doors the least: PhyScene's walkable rate."""
    doors = [side for _, side in room.openings(doors=True)]
    areas = walkable(room, NARROW, True)
    whole = sum(area.area for area in areas)
    if not doors or not room.standing or not whole:
        return None
    return answer([], min(sum(area.area for area in areas if area.intersects(door_zone(side))) / whole for side in doors))


def door_zone(side: Side) -> shapely.Polygon:
    return side.before(PERSON)


def zones_of(piece: Piece, room: Room) -> list[shapely.Polygon]:
    """Where one may stand to use a piece: any of these."""
    if piece.carrier is not None:
        return []
    if piece.kind in BEDS:
        return [piece.zone(name, USE) for name in ("left", "right", "front")]
    if piece.kind in FRONTS:
        return [piece.zone("front", USE)]
    if piece.kind in DESKS:
        chairs = [chair for chair in room.of(OFFICE_CHAIRS) if chair.parent == piece.id]
        return [chair.footprint.buffer(USE / 2) for chair in chairs]
    return []


def is_joined(ones: list[shapely.Polygon], others: list[shapely.Polygon], areas: list[shapely.Polygon]) -> bool:
    return any(any(area.intersects(one) for one in ones) and any(area.intersects(other) for other in others)
               for area in areas)


MEASURES = [
    Measure("door_blocked", "no body is in a door's swing or approach", "m", "as deep as wide, at most 0.8", "QUALITY §2",
            judge_doors, audit="door_blocked"),
    Measure("unreachable", "a person comes from every door to every other and to every used side", "m",
            "0.45 by a raster of 5 cm: 0.38; 0.30 in narrow plans", "UK Part M, HUD; PhyScene",
            judge_reached(PERSON - RASTER), audit="unreachable"),
    Measure("way_narrow", "the same without rounding", "m", "0.45; 0.30 in narrow plans", "UK Part M, HUD; PhyScene",
            judge_reached(PERSON), audit="unreachable"),
    Measure("walkable_rate", "the free floor is reached from every door (a distribution, no limit)", "of the free floor",
            "0.30 m", "PhyScene", judge_walkable),
]
