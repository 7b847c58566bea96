"""Doors and windows of a level, from what is drawn on their layers.

What an opening is drawn of is a group (`groups`). An arc is the swing of a leaf: its middle
is the hinge, its radius the width of the leaf, and of its two ends the one in the wall is where the leaf shuts.

       open end +-.
                |  `.         the room that the leaf opens into
                |    \\
    ------------o-----+------------   wall
              hinge   shut end
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from ezdxf.entities.ellipse import Ellipse
from shapely import LineString, MultiPoint, Polygon, STRtree
from shapely import Point as Location

from .drawing import Drawn
from .faults import Place, Report
from .groups import Group, Swing, groups_of
from .rooms import Room
from .shapes import FARTHEST, Point, Scale

# Metres that an opening may be wide, and a leaf.
OPENING_WIDTH, LEAF_WIDTH = (0.2, 20.0), (0.3, 2.5)
# Radians that a leaf swings.
SWING = (math.radians(15), math.radians(200))
# Metres across the wall that something may be and still be a straight opening.
DEEPEST = 1.0
# Metres between the shut ends of the leaves of a double door.
MEETING = 0.15
# Metres between hinges, or radii, of what is one leaf drawn with two lines.
SAME_LEAF = 0.1
# From this ratio of its sides on, the longer side of a box lies along the wall; else the nearest wall decides.
LENGTHY = 1.6
# Metres from which on a door without a leaf slides: it is wider than leaves are.
SLIDING = 2.4
# Metres from the middle of an opening to the nearest outline at most: the program looks no farther (src/plan/attach.rs).
REACH = 0.6


@dataclass(frozen=True)
class Opening:
    """A door or window in metres, in the frame of the drawing."""

    kind: str  # door, sliding_door, window or open_boundary
    middle: Point
    along: Point  # a unit vector
    width: float
    place: Place
    hinge: str | None = None  # left or right, seen from the room that the leaf opens into
    opens_into: str | None = None
    leaves: int | None = None
    swing: float | None = None  # degrees
    rooms: tuple[str, ...] = ()


@dataclass(frozen=True)
class Leaf:
    """The swing of a leaf, in metres."""

    hinge: Point
    shut: Point
    opened: Point
    sweep: float  # radians
    place: Place

    @property
    def width(self) -> float:
        return math.dist(self.hinge, self.shut)


class Rooms:
    """Questions about places among the rooms of a level."""

    def __init__(self, rooms: list[Room]):
        self.rooms = rooms
        self.tree = STRtree([room.polygon for room in rooms])
        self.edges = [edge for room in rooms for ring in (room.polygon.exterior, *room.polygon.interiors)
                      for edge in zip(ring.coords[:-1], ring.coords[1:])]
        self.edge_tree = STRtree([LineString(edge) for edge in self.edges])

    def at(self, point: Point) -> str | None:
        """The id of the room that a point lies in."""
        hits = sorted(int(index) for index in self.tree.query(Location(point), predicate="within"))
        return self.rooms[hits[0]].id if hits else None

    def depth(self, point: Point) -> float:
        """Metres that a point lies inside its room; less than 0 for one in no room, by the metres to the nearest."""
        location = Location(point)
        index = int(self.tree.nearest(location))
        polygon = self.rooms[index].polygon
        outside = float(polygon.distance(location))
        return -outside if outside > 0 else float(polygon.boundary.distance(location))

    def wall_direction(self, point: Point) -> Point | None:
        """The direction of the nearest wall within reach."""
        index = self.edge_tree.query_nearest(Location(point), max_distance=REACH, all_matches=False)
        return unit(*self.edges[int(index[0])]) if len(index) else None


def openings_of(found: Iterable[Drawn], role: str, rooms: Rooms, scale: Scale, report: Report) -> list[Opening]:
    """The openings of one role, doors or windows, in the order of the drawing."""
    openings: list[Opening] = []
    for group in groups_of(found, scale, report):
        read = openings_of_group(group, role, rooms, scale)
        if isinstance(read, str):
            report.error(group.place, read)
        else:
            openings += read
    return openings


def at_walls(openings: list[Opening], rooms: Rooms, report: Report) -> list[Opening]:
    """The openings that lie at a wall of a room; the others are reported."""
    kept = []
    for opening in openings:
        if abs(rooms.depth(opening.middle)) <= REACH:
            kept.append(opening)
        else:
            report.warning(opening.place, f"this {opening.kind.replace('_', ' ')} is at no wall of a room, and is left out")
    return kept


def openings_of_group(group: Group, role: str, rooms: Rooms, scale: Scale) -> list[Opening] | str:
    """The openings that a group draws, or why it is none."""
    if role == "doors":
        leaves = distinct([leaf for arc in group.arcs if (leaf := leaf_of(*arc, rooms, scale)) is not None])
        if leaves:
            return doors_of(leaves, rooms)
    along = direction_of(group.points, rooms)
    low, high = extent(group.points, along)
    deep_low, deep_high = extent(group.points, (-along[1], along[0]))
    width, depth = high - low, deep_high - deep_low
    if not OPENING_WIDTH[0] <= width <= OPENING_WIDTH[1]:
        return f"is {width:.3g} m wide: no opening has this width"
    if depth > max(DEEPEST, width):
        return f"reaches {depth:.3g} m across its wall: it is no straight opening"
    middle = place_of((low + high) / 2, (deep_low + deep_high) / 2, along)
    kind = "window" if role == "windows" else "sliding_door" if width > SLIDING else "door"
    return [Opening(kind, middle, along, width, group.place)]


def leaf_of(arc: Swing, place: Place, rooms: Rooms, scale: Scale) -> Leaf | None:
    """The leaf that an arc is the swing of, or None where no leaf is so wide or swings so far."""
    if isinstance(arc, Ellipse):
        center, sweep = arc.dxf.center, (arc.dxf.end_param - arc.dxf.start_param) % math.tau
    else:
        center, sweep = arc.ocs().to_wcs(arc.dxf.center), math.radians(arc.dxf.end_angle - arc.dxf.start_angle) % math.tau
    ends = [scale.point(end.x, end.y) for end in (arc.start_point, arc.end_point)]
    hinge = scale.point(center.x, center.y)
    numbers = [*hinge, *ends[0], *ends[1], sweep]
    if not all(abs(number) <= FARTHEST for number in numbers):
        return None
    if not (LEAF_WIDTH[0] <= math.dist(hinge, ends[0]) <= LEAF_WIDTH[1] and SWING[0] <= sweep <= SWING[1]):
        return None
    # A shut leaf lies in the wall, an open one stands in a room.
    shut, opened = sorted(ends, key=lambda end: rooms.depth(halfway(hinge, end)))
    return Leaf(hinge, shut, opened, sweep, Place(place.layer, place.handle, place.kind, scale.drawn_at(hinge)))


def distinct(leaves: list[Leaf]) -> list[Leaf]:
    """Leaves without those that are drawn a second time beside themselves."""
    kept: list[Leaf] = []
    for leaf in leaves:
        same = [other for other in kept if math.dist(leaf.hinge, other.hinge) < SAME_LEAF
                and math.dist(leaf.shut, other.shut) < SAME_LEAF and math.dist(leaf.opened, other.opened) < SAME_LEAF]
        if not same:
            kept.append(leaf)
    return kept


def doors_of(leaves: list[Leaf], rooms: Rooms) -> list[Opening]:
    """Doors with one leaf, or with two whose shut ends meet."""
    doors = []
    waiting = list(leaves)
    while waiting:
        leaf = waiting.pop(0)
        partner = next((other for other in waiting if math.dist(leaf.shut, other.shut) <= MEETING
                        and math.dist(leaf.hinge, other.hinge) > max(leaf.width, other.width)), None)
        far = leaf.shut if partner is None else partner.hinge
        if partner is not None:
            waiting.remove(partner)
        doors.append(door_of(leaf, far, 1 if partner is None else 2, rooms))
    return doors


def door_of(leaf: Leaf, far: Point, leaves: int, rooms: Rooms) -> Opening:
    """A door from a leaf's hinge to its far end."""
    middle, along = halfway(leaf.hinge, far), unit(leaf.hinge, far)
    into = (leaf.opened[0] - leaf.hinge[0], leaf.opened[1] - leaf.hinge[1])
    # Whoever looks at the wall from the room has the hinge at the left if the leaf opens clockwise from the wall.
    is_left = along[0] * into[1] - along[1] * into[0] < 0
    room = rooms.at(halfway(leaf.hinge, leaf.opened)) or "outside"
    hinge = None if leaves == 2 else "left" if is_left else "right"
    return Opening("door", middle, along, math.dist(leaf.hinge, far), leaf.place, hinge=hinge, opens_into=room, leaves=leaves,
                   swing=math.degrees(leaf.sweep))


def direction_of(points: Iterable[Point], rooms: Rooms) -> Point:
    """The direction of the wall that something lies in: that of its longer side, or of the nearest wall."""
    points = list(points)
    box = MultiPoint(points).minimum_rotated_rectangle
    if isinstance(box, LineString):
        return unit(box.coords[0], box.coords[-1])
    if not isinstance(box, Polygon):
        return (1.0, 0.0)
    corners = list(box.exterior.coords)
    sides = sorted(((math.dist(a, b), unit(a, b)) for a, b in zip(corners[:2], corners[1:3])), reverse=True)
    if sides[0][0] >= LENGTHY * sides[1][0]:
        return sides[0][1]
    wall = rooms.wall_direction((box.centroid.x, box.centroid.y))
    return wall or sides[0][1]


def unit(start: Point, end: Point) -> Point:
    length = math.dist(start, end)
    return ((end[0] - start[0]) / length, (end[1] - start[1]) / length) if length > 0 else (1.0, 0.0)


def halfway(start: Point, end: Point) -> Point:
    return ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)


def extent(points: Iterable[Point], along: Point) -> tuple[float, float]:
    """From where to where points reach in a direction, in metres."""
    reaches = np.array(list(points)) @ np.array(along)
    return float(reaches.min()), float(reaches.max())


def place_of(ahead: float, across: float, along: Point) -> Point:
    """The point at these metres in a direction and to its left."""
    return (ahead * along[0] - across * along[1], ahead * along[1] + across * along[0])


def ends_of(opening: Opening) -> tuple[Point, Point]:
    """The ends of an opening, on the line through its middle."""
    half = opening.width / 2
    x, y = opening.middle
    return ((x - opening.along[0] * half, y - opening.along[1] * half), (x + opening.along[0] * half, y + opening.along[1] * half))
