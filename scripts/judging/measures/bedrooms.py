"""Bedrooms: the bed that a room of its size has, and where it stands."""

from __future__ import annotations

import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..places import SWING_REACH, has_place, swings_of
from ..roles import BEDROOMS, BEDS, DOUBLE_BEDS, SINGLE_BEDS, WARDROBES

# Square metres.
DOUBLE_AREA = 11.5
WARDROBE_AREA = 8.0
ROUNDING = 0.002


def bedrooms_of_flat(room: Room) -> list[Room]:
    flats = room.floor.flats
    return [other for other in room.floor.rooms
            if other.kind in BEDROOMS and flats.get(other.id, -1) == flats.get(room.id, -2)]


def judge_single(room: Room) -> Answer | None:
    if room.kind not in BEDROOMS or room.area <= DOUBLE_AREA or not room.of(BEDS):
        return None
    # Two single beds are a room for two: guests, or children who share it.
    if room.of(DOUBLE_BEDS) or len(room.of(SINGLE_BEDS)) != 1:
        return answer([])
    smaller = [other for other in bedrooms_of_flat(room) if other.area < room.area and other.of(DOUBLE_BEDS)]
    faults = [Fault(f"a single bed on {room.area:.1f} m², while room {other.id} with {other.area:.1f} m² of the same flat "
                    "has a double bed", (room.of(SINGLE_BEDS)[0].id,)) for other in smaller[:1]]
    return answer(faults)


def judge_wardrobe(room: Room) -> Answer | None:
    if room.kind not in BEDROOMS or room.area <= WARDROBE_AREA:
        return None
    return answer([] if room.of(WARDROBES) else [Fault(f"no wardrobe on {room.area:.1f} m²")])


def judge_bed(room: Room) -> Answer | None:
    if room.kind not in BEDROOMS:
        return None
    return answer([] if room.of(BEDS) else [Fault(f"no bed on {room.area:.1f} m²")])


def judge_swing(room: Room) -> Answer | None:
    """Beds against the leaves that swing into their room, where the empty room has a place that is clear of them."""
    beds = room.of(BEDS) if room.kind in BEDROOMS else []
    swings = swings_of(room)
    if not beds or not swings:
        return None
    faults, nearest = [], float("inf")
    for bed in beds:
        metres = min(bed.footprint.distance(swing) for swing in swings)
        nearest = min(nearest, metres)
        if metres < SWING_REACH - ROUNDING and has_place(room, bed):
            faults.append(Fault(f"{metres:.2f} m from the swing of a door", (bed.id,), metres))
    return answer(faults, nearest)


def judge_before_door(room: Room) -> Answer | None:
    """Beds against the floor right inside doors; open boundaries are walked around."""
    beds = room.of(BEDS) if room.kind in BEDROOMS else []
    doors = [side for opening, side in room.openings(doors=True) if opening.closure != "open"]
    if not beds or not doors:
        return None
    walks = shapely.union_all([side.before(SWING_REACH) for side in doors])
    near = [bed.id for bed in beds if bed.footprint.intersection(walks).area > 0.01]
    return answer([Fault("it reaches into the 0.75 m before a door", (bed,)) for bed in near])


MEASURES = [
    Measure("single_in_larger_bedroom", "no smaller bedroom of the flat has a double bed where this one has one single", "",
            "over 11.5 m²", "project", judge_single),
    Measure("bedroom_without_wardrobe", "a bedroom has a wardrobe", "", "over 8 m²", "project", judge_wardrobe),
    Measure("bedroom_without_bed", "a bedroom has a bed", "", "", "QUALITY §4", judge_bed, audit="missing_required"),
    Measure("bed_at_swing", "a bed is clear of leaves that swing into the room", "m", "≥ 0.75", "project", judge_swing),
    Measure("bed_before_door", "a bed is clear of the floor before doors", "", "0.75 m", "project", judge_before_door,
            audit="door_blocked"),
]
