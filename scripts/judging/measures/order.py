"""What faces what, and how a room is filled. QUALITY §2 and §4."""

from __future__ import annotations

import numpy as np
import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import (BASINS, BEDROOMS, BEDS, COOKERS, CUBICLES, DESKS, DOUBLE_BEDS, DRESSING, FRIDGES, HALLS, HOME_ROOMS,
                     KITCHENS, LIVING_ROOMS, MIRRORS, OFFICE_CHAIRS, SINKS, SOFAS, STORAGE, TOILETS, TUBS, TV_STANDS)
from ..shapes import angle_between, pieces_of_area, width_of

FACING = 30.0
# Metres before a toilet bowl.
TOILET_FRONT = 0.53
# Metres beside a bed that let one in.
BED_SIDE = 0.3
# Square metres from which a room has halves, and the share of the footprint in one of them.
HALVES_AREA = 10.0
# Metres that the line between two halves may be off.
HALVES_ROUNDING = 0.02
HALF = 0.85
# Metres of a main walkway: HUD.
WALKWAY = 0.75
CROOKED = 5.0
# The share of requested pieces that rest.
RESTING = 0.9
# The share of the surfaces that carry something.
CARRYING = 0.5
# Half of the least density by default: 25 % of the floor in living spaces, 10 % in circulation; from this area on.
SPARSE = {True: 0.05, False: 0.125}
SPARSE_AREA = 4.0
# Metres of width below which nothing should stand in a hall: `hall_narrow`.
NARROW_HALL = 1.2


def judge_desks(room: Room) -> Answer | None:
    pairs = [(desk, chair) for desk in room.of(DESKS) for chair in room.of(OFFICE_CHAIRS) if chair.parent == desk.id]
    mirrors = room.of(MIRRORS)
    if not pairs and not mirrors:
        return None
    faults = [Fault(f"it looks {turned:.0f}° past {desk.id}", (chair.id,), turned) for desk, chair in pairs
              if (turned := angle_between(chair.front, towards(chair, desk))) > FACING]
    faults += [Fault("it hangs over nothing", (mirror.id,)) for mirror in mirrors if not has_below(room, mirror)]
    return answer(faults)


def towards(chair: Piece, desk: Piece) -> np.ndarray:
    nearest = shapely.shortest_line(shapely.Point(chair.center), desk.footprint)
    start, end = shapely.get_coordinates(nearest)
    return end - start


def has_below(room: Room, mirror: Piece) -> bool:
    zone = mirror.zone("back", -0.6, 0.05)
    return any(piece.stands and piece.footprint.intersects(zone) for piece in room.of(BASINS | DRESSING))


def judge_wet(room: Room) -> Answer | None:
    toilets = room.of(TOILETS)
    if not toilets:
        return None
    faults = []
    for toilet in toilets:
        zone = toilet.zone("front", TOILET_FRONT, 0.01)
        faults += [Fault(f"{tub.id} is right before it", (toilet.id, tub.id)) for tub in room.of(TUBS)
                   if tub.footprint.intersection(zone).area > 1e-3]
    return answer(faults)


def judge_bedside(room: Room) -> Answer | None:
    """A double bed with its side to a wall, in a room where the bed could stand off it."""
    beds = room.of(DOUBLE_BEDS)
    if not beds:
        return None
    faults = []
    for bed in beds:
        free = [name for name in ("left", "right") if is_free(room, bed, name)]
        if len(free) == 1 and room.area > HALVES_AREA:
            faults.append(Fault(f"only its {free[0]} side is free", (bed.id,)))
    return answer(faults)


def is_free(room: Room, bed: Piece, name: str) -> bool:
    zone = bed.zone(name, BED_SIDE, 0.02).buffer(-0.01)
    others = [piece for piece in room.standing if piece is not bed and piece.parent != bed.id]
    return room.region.covers(zone) and not any(piece.footprint.intersects(zone) for piece in others)


def judge_halves(room: Room) -> Answer | None:
    standing = [piece for piece in room.standing if piece.footprint.area > 0.05]
    if room.area <= HALVES_AREA or len(standing) < 2:
        return None
    whole = sum(piece.footprint.area for piece in standing)
    fullest, emptier = max((half_share(standing, half, whole), axis) for axis, halves in enumerate(halves_of(room))
                           for half in halves)
    if fullest <= HALF:
        return answer([], fullest)
    largest = max(standing, key=lambda piece: piece.footprint.area)
    if not has_room(room, standing, largest, halves_of(room)[emptier], whole):
        return answer([], fullest)
    return answer([Fault(f"{fullest:.0%} of the furniture is in one half", (), fullest)], fullest)


def halves_of(room: Room) -> list[tuple[shapely.Geometry, shapely.Geometry]]:
    """The halves of a room by area, across its main axes."""
    box = shapely.get_coordinates(shapely.minimum_rotated_rectangle(room.region))
    axes = [box[1] - box[0], box[2] - box[1]]
    return [split_in_half(room.region, axis / max(np.hypot(*axis), 1e-9)) for axis in axes]


def split_in_half(region: shapely.Geometry, axis: np.ndarray) -> tuple[shapely.Geometry, shapely.Geometry]:
    """Two parts of a region of equal area, cut across an axis: the middle of its extent would leave a niche for a half."""
    along = shapely.get_coordinates(region) @ axis
    low, high = float(along.min()), float(along.max())
    while high - low > HALVES_ROUNDING:
        middle = (low + high) / 2
        low, high = (middle, high) if beyond(region, axis, middle).area > region.area / 2 else (low, middle)
    farther = beyond(region, axis, (low + high) / 2)
    return farther, region.difference(farther)


def beyond(region: shapely.Geometry, axis: np.ndarray, distance: float) -> shapely.Geometry:
    """What of a region lies farther along an axis than a distance from the origin."""
    far = float(np.ptp(shapely.get_coordinates(region), axis=0).sum())
    across = np.array([-axis[1], axis[0]])
    center = axis * distance + across * (np.asarray(region.centroid.coords[0]) @ across)
    corners = [center - across * far, center + across * far, center + (across + axis) * far, center + (axis - across) * far]
    return region.intersection(shapely.Polygon(corners))


def half_share(standing: list[Piece], half: shapely.Geometry, whole: float) -> float:
    return sum(piece.footprint.intersection(half).area for piece in standing) / whole


def has_room(room: Room, standing: list[Piece], largest: Piece, halves: tuple, whole: float) -> bool:
    """Whether the emptier half could take the largest piece, and leave a walkway before it."""
    half = min(halves, key=lambda one: half_share(standing, one, whole))
    doors = [side.before(WALKWAY) for _, side in room.openings(doors=True)]
    free = half.difference(shapely.union_all([*(piece.footprint for piece in standing), *doors]))
    short, long = sorted(float(length) for length in largest.size)
    wide = (short + WALKWAY) / 2
    return any(longest_side(part) >= long for part in pieces_of_area(free.buffer(-wide).buffer(wide)))


def longest_side(part: shapely.Polygon) -> float:
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(part))
    return float(np.hypot(*np.diff(corners, axis=0).T).max())


def judge_crooked(room: Room) -> Answer | None:
    """Wall furniture against the wall at its back."""
    pieces = [piece for piece in room.of(STORAGE | BEDS | TV_STANDS | SOFAS) if piece.stands]
    faults, judged = [], 0
    for piece in pieces:
        start, end, outward = piece.side("back")
        near = [wall for wall in room.walls if wall.length > 0.3 and 0 <= wall.distance((start + end) / 2) < 0.15
                and 0 < ((start + end) / 2 - wall.start) @ wall.along < wall.length]
        if near:
            judged += 1
            turned = min(angle_between(-outward, wall.inward) for wall in near)
            if turned > CROOKED:
                faults.append(Fault(f"{turned:.0f}° off its wall", (piece.id,), turned))
    return answer(faults) if judged else None


UNITS = {"sink": SINKS, "cooker": COOKERS, "fridge": FRIDGES}
REQUIRED = dict.fromkeys(BEDROOMS, {"bed": BEDS}) | {"bathroom": {"toilet": TOILETS}, "toilet": {"toilet": TOILETS | CUBICLES},
            "kitchen": UNITS, "kitchen_dining": UNITS, "living_kitchen": UNITS | {"sofa": SOFAS},
            "studio_kitchen": UNITS | {"bed": BEDS},
            "living_room": {"sofa": SOFAS}, "living_dining": {"sofa": SOFAS}}
# Square metres from which an empty room of a kind can hold what it requires, whatever its doors.
REQUIRED_AREA = dict.fromkeys(BEDROOMS, 8.0) | {"bathroom": 2.0, "toilet": 1.4} | dict.fromkeys(KITCHENS | LIVING_ROOMS, 6.0)


def judge_required(room: Room) -> Answer | None:
    if room.kind not in REQUIRED or room.area < REQUIRED_AREA[room.kind]:
        return None
    missing = [word for word, kinds in REQUIRED[room.kind].items() if not room.of(kinds)]
    missing += [f"chair at {desk.id}" for desk in room.of(DESKS) if room.kind in HOME_ROOMS and not
                any(chair.parent == desk.id for chair in room.of(OFFICE_CHAIRS | {"chair", "stool"}))]
    return answer([Fault(f"no {kind}", ()) for kind in missing])


def judge_unfulfilled(room: Room) -> Answer | None:
    requested = room.extras.get("requested", 0)
    if not requested:
        return None
    share = len(room.pieces) / requested
    return answer([Fault(f"{share:.0%} of the requested pieces rest", (), share)] if share < RESTING else [], share)


def judge_sparse(room: Room) -> Answer | None:
    is_hall = room.kind in HALLS
    if not is_hall and room.kind not in HOME_ROOMS or room.area < SPARSE_AREA:
        return None
    if is_hall and width_of(room.region) < NARROW_HALL:
        return None
    # What hangs low takes floor as well; what lies flat does not.
    filled = shapely.union_all([piece.footprint for piece in room.standing]).area / room.area
    least = SPARSE[is_hall]
    return answer([Fault(f"{filled:.1%} of the floor are furnished", (), filled)] if filled < least else [], filled)


SURFACES = {"desk", "small_desk", "executive_desk", "sideboard", "worktop", "prep_worktop", "landing_worktop"}


def judge_empty(room: Room) -> Answer | None:
    surfaces = [piece for piece in room.of(SURFACES) if piece.stands]
    if not surfaces:
        return None
    carrying = {piece.carrier.id for piece in room.pieces if piece.carrier is not None}
    empty = [piece.id for piece in surfaces if piece.id not in carrying]
    share = 1 - len(empty) / len(surfaces)
    faults = [Fault(f"{len(empty)} of {len(surfaces)} surfaces are empty", tuple(empty), share)]
    return answer(faults if share < CARRYING else [], share)


MEASURES = [
    Measure("facing", "a desk's chair looks at it, a mirror hangs over something", "°", "≤ 30", "Merrell et al. 2011",
            judge_desks, audit="facing"),
    Measure("wet_room", "no tub or shower is right before the toilet", "m", "0.53", "NKBA", judge_wet, audit="wet_room"),
    Measure("bedside", "both sides of a double bed are free in rooms over 10 m²", "m", "0.30", "HUD 1973", judge_bedside,
            audit="bedside"),
    Measure("crowded_half", "no half of a room over 10 m² has nearly all furniture while the other has room", "share",
            "≤ 85 %", "QUALITY §2", judge_halves, audit="crowded_half"),
    Measure("crooked", "wall furniture is parallel to its wall", "°", "≤ 5", "QUALITY §2", judge_crooked, audit="crooked"),
    Measure("missing_required", "a room has what its kind requires, and a desk its chair", "", "by kind, from 1.4–8 m² on",
            "QUALITY §4", judge_required, audit="missing_required"),
    Measure("unfulfilled", "the requested pieces rest", "share", "≥ 90 %", "QUALITY §4", judge_unfulfilled, audit="unfulfilled"),
    Measure("sparse", "furniture covers enough of the floor", "share", "≥ 12.5 %; ways 5 %, from 1.2 m of width on", "QUALITY §4", judge_sparse,
            audit="sparse"),
    Measure("empty_surfaces", "surfaces carry small things", "share", "≥ half of them", "QUALITY §4", judge_empty, audit="bare"),
]
