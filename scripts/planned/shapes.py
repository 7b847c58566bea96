"""What a storey encloses, measured from its rooms alone, and whether the rooms fill it."""

from __future__ import annotations

from itertools import combinations
from statistics import median

from shapely import STRtree, unary_union
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from .plan import Building, Level
from .roles import OUTSIDE, least_width
from .table import Fault

MOST_OVERLAP = 0.01
# Square metres of a balcony within the outer faces of the walls: those run not quite straight.
MOST_INSIDE = 0.05
LEAST_COVER = 0.995
LEAST_STOREY = 0.75
MOST_AREA_CHANGE = 0.05
# Square metres from which on a hole may be a courtyard.
COURTYARD = 4.0
# Inner walls are between these; what is farther apart has a court or a gap between.
WALL_RANGE = (0.02, 0.5)
USUAL_WALL = 0.12
SLIVER_WIDTH, SLIVER_AREA = 0.3, 0.05
# Metres of the width of what the arcs of a buffer leave along straight walls.
NOISE = 0.001
# Metres that rounding may take off a width.
ROUNDING = 0.005


def mitred(shape: BaseGeometry, distance: float) -> BaseGeometry:
    return shape.buffer(distance, join_style="mitre", mitre_limit=3.0)


def wall_thickness(level: Level) -> float:
    """The usual distance between neighbouring rooms."""
    shapes = [room.shape for room in level.indoor]
    tree = STRtree(shapes)
    low, high = WALL_RANGE
    pairs = tree.query(shapes, predicate="dwithin", distance=high).T
    gaps = [shapes[first].distance(shapes[second]) for first, second in pairs if first < second]
    walls = [gap for gap in gaps if gap >= low]
    return median(walls) if walls else USUAL_WALL


def parts(shape: BaseGeometry) -> list[Polygon]:
    pieces = shape.geoms if hasattr(shape, "geoms") else [shape]
    return [piece for piece in pieces if isinstance(piece, Polygon) and not piece.is_empty]


def enclosed(level: Level, wall: float) -> BaseGeometry:
    """The storey within its outer walls: rooms and the walls between them; holes are kept."""
    # A little more than half a wall, so that walls of twice the usual thickness count as gaps that were filled.
    reach = wall + ROUNDING
    rooms = unary_union([mitred(room.shape.buffer(0), reach) for room in level.indoor])
    return mitred(rooms, -reach)


def without_small_holes(shape: BaseGeometry, courtyards: BaseGeometry | None) -> BaseGeometry:
    """Fills the holes that are no courtyards: those are large, and on all levels."""
    def is_courtyard(hole: Polygon) -> bool:
        if hole.area < COURTYARD:
            return False
        return courtyards is None or hole.intersection(courtyards).area > 0.9 * hole.area

    filled = []
    for part in parts(shape):
        holes = [hole for hole in part.interiors if is_courtyard(Polygon(hole))]
        filled.append(Polygon(part.exterior, holes))
    return unary_union(filled)


def holes_of(shape: BaseGeometry) -> BaseGeometry:
    return unary_union([Polygon(hole) for part in parts(shape) for hole in part.interiors])


def floors_of(building: Building) -> list[BaseGeometry]:
    """What each level encloses, with courtyards as holes."""
    raw = [enclosed(level, wall_thickness(level)) for level in building.levels]
    courtyards = None
    for floor in raw:
        holes = holes_of(floor)
        courtyards = holes if courtyards is None else courtyards.intersection(holes)
    return [without_small_holes(floor, courtyards) for floor in raw]


def shape_faults(building: Building, floors: list[BaseGeometry], area: float | None) -> list[Fault]:
    """`area`: square metres of the building's outline, where the report says so."""
    whole = unary_union(floors).area
    faults = []
    for level, floor in zip(building.levels, floors):
        wall = wall_thickness(level)
        faults += outline_faults(building, level, wall)
        faults += cover_faults(building, level, floor, wall)
        faults += balcony_faults(building, level, floor)
        if floor.area < LEAST_STOREY * whole:
            share = floor.area / whole
            faults.append(Fault("storey_differs", building.id, level.id, "", f"{share:.0%} of all storeys' floor", 1 - share))
        if area:
            faults += area_faults(building, level, floor, area)
    return faults


def balcony_faults(building: Building, level: Level, floor: BaseGeometry) -> list[Fault]:
    outer = mitred(floor, building.exterior)
    balconies = [room for room in level.rooms.values() if room.type in OUTSIDE]
    inside = [(room, room.shape.intersection(outer).area) for room in balconies]
    return [Fault("balcony_inside", building.id, level.id, room.id, f"{area:.2f} m²", area)
            for room, area in inside if area > MOST_INSIDE]


def area_faults(building: Building, level: Level, floor: BaseGeometry, area: float) -> list[Fault]:
    change = mitred(floor, building.exterior).area / area - 1
    # Walls of small buildings may be thinner than their kind's: then the rooms alone are compared.
    if abs(change) <= MOST_AREA_CHANGE or floor.area <= area <= mitred(floor, building.exterior).area:
        return []
    return [Fault("area_differs", building.id, level.id, "", f"{change:+.1%} of {area:.1f} m²", abs(change))]


def outline_faults(building: Building, level: Level, wall: float) -> list[Fault]:
    faults = []
    for room in level.rooms.values():
        if not room.shape.is_valid or room.shape.area <= 0:
            faults.append(Fault("room_not_simple", building.id, level.id, room.id, room.type, room.shape.area))
            continue
        faults += width_faults(building, level, room, wall)
    rooms = [room for room in level.rooms.values() if room.shape.is_valid]
    for first, second in combinations(rooms, 2):
        if not first.shape.intersects(second.shape):
            continue
        overlap = first.shape.intersection(second.shape).area
        if overlap > MOST_OVERLAP:
            faults.append(Fault("rooms_overlap", building.id, level.id, f"{first.id}, {second.id}", f"{overlap:.2f} m²", overlap))
    return faults


def width_faults(building: Building, level: Level, room, wall: float) -> list[Fault]:
    faults = []
    least = least_width(room.type)
    if room.shape.buffer(-(least - wall) / 2 + ROUNDING).is_empty:
        width = widest(room.shape)
        faults.append(Fault("too_narrow", building.id, level.id, room.id, f"{room.type} {width:.2f} m", least - wall - width))
    # Round corners: what they leave of square ones is a tenth of a sliver, and mitres fail for some nearly straight corners.
    core = room.shape.buffer(-SLIVER_WIDTH / 2).buffer(SLIVER_WIDTH / 2)
    # Corners that only rounding joins are parts by themselves.
    rest = room.shape.difference(core).buffer(-NOISE).buffer(NOISE)
    thin = [part.area for part in parts(rest) if part.area > SLIVER_AREA]
    if thin:
        faults.append(Fault("sliver", building.id, level.id, room.id, f"{room.type}, {sum(thin):.2f} m²", sum(thin)))
    return faults


def widest(shape: Polygon) -> float:
    """The diameter of the largest disc, to a centimetre."""
    low, high = 0.0, 3.0
    while high - low > 0.01:
        middle = (low + high) / 2
        low, high = (low, middle) if shape.buffer(-middle / 2).is_empty else (middle, high)
    return low


def cover_faults(building: Building, level: Level, floor: BaseGeometry, wall: float) -> list[Fault]:
    rooms = unary_union([mitred(room.shape.buffer(0), wall / 2 + ROUNDING) for room in level.rooms.values()])
    missing = floor.difference(rooms).area
    cover = 1 - missing / floor.area if floor.area > 0 else 0.0
    if cover >= LEAST_COVER:
        return []
    return [Fault("not_covered", building.id, level.id, "", f"{cover:.1%}, {missing:.2f} m² missing", missing)]
