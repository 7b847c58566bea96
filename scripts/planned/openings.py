"""Openings: whether they are in walls of their rooms, and whether habitable rooms have doors and daylight."""

from __future__ import annotations

from itertools import combinations

from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from .plan import Building, Level, Opening, Room
from .roles import OUTSIDE, is_habitable
from .table import Fault

# Metres of view that a window needs.
VIEW = 2.0
# Metres within which openings are in the same wall.
SAME_WALL = 0.2
TOUCH = 0.02


def opening_faults(building: Building) -> list[Fault]:
    faults = []
    for level in building.levels:
        faults += misplaced(building, level)
        faults += overlapping(building, level)
        faults += habitable_faults(building, level)
        faults += windows_inside(building, level)
    return faults


def misplaced(building: Building, level: Level) -> list[Fault]:
    faults = []
    for opening in level.openings:
        middle = Point(opening.at)
        for room in opening.rooms:
            if room not in level.rooms:
                faults.append(Fault("opening_misplaced", building.id, level.id, opening.id, f"there is no room {room}", 9.0))
                continue
            distance = middle.distance(level.rooms[room].shape)
            if distance > building.exterior / 2 + 0.1:
                text = f"{opening.kind} {distance:.2f} m from {room}"
                faults.append(Fault("opening_misplaced", building.id, level.id, opening.id, text, distance))
    return faults


def line_of(opening: Opening) -> LineString:
    (x, y), (along_x, along_y) = opening.at, opening.along
    half = max(opening.width / 2 - TOUCH, TOUCH)
    return LineString([(x - along_x * half, y - along_y * half), (x + along_x * half, y + along_y * half)])


def overlapping(building: Building, level: Level) -> list[Fault]:
    faults = []
    lines = [(opening, line_of(opening)) for opening in level.openings]
    for (first, line), (second, other) in combinations(lines, 2):
        if line.distance(other) > SAME_WALL or not share_a_room(first, second) or not are_parallel(first, second):
            continue
        shared = overlap_along(first, second)
        if shared > TOUCH:
            text = f"{first.kind} and {second.kind} by {shared:.2f} m"
            faults.append(Fault("openings_overlap", building.id, level.id, f"{first.id}, {second.id}", text, shared))
    return faults


def share_a_room(first: Opening, second: Opening) -> bool:
    return bool(set(first.rooms) & set(second.rooms))


def are_parallel(first: Opening, second: Opening) -> bool:
    return abs(first.along[0] * second.along[1] - first.along[1] * second.along[0]) < 0.1


def overlap_along(first: Opening, second: Opening) -> float:
    offset = sum((there - here) * way for here, there, way in zip(first.at, second.at, first.along))
    return (first.width + second.width) / 2 - abs(offset)


def leads_out(opening: Opening, level: Level) -> bool:
    """Whether the open air or a balcony is on its other side."""
    return opening.is_outer or any(level.rooms[room].type in OUTSIDE for room in opening.rooms if room in level.rooms)


def gives_light(opening: Opening, level: Level) -> bool:
    return leads_out(opening, level) and opening.kind in ("window", "sliding_door")


def habitable_faults(building: Building, level: Level) -> list[Fault]:
    faults = []
    lit = {room for opening in level.openings if gives_light(opening, level) for room in opening.rooms}
    opened = {room for opening in level.openings if opening.is_way for room in opening.rooms}
    borrowed = {room for opening in level.openings if opening.kind == "open_boundary" and set(opening.rooms) & lit
                for room in opening.rooms}
    for room in level.rooms.values():
        if not is_habitable(room.type):
            continue
        text = f"{room.type} {room.shape.area:.1f} m²"
        if room.id not in opened:
            faults.append(Fault("no_door", building.id, level.id, room.id, text, room.shape.area))
        if room.id not in lit | borrowed:
            faults.append(Fault("no_window", building.id, level.id, room.id, text, room.shape.area))
    return faults


def view_of(window: Opening, room: Polygon, wall: float, depth: float) -> Polygon | None:
    """The rectangle in front of a window, from the outer face of its wall; None where it is not clear which side is out."""
    (x, y), (along_x, along_y) = window.at, window.along
    normal = (along_y, -along_x)
    step = wall / 2 + 0.1
    is_inside = [room.distance(Point(x + sign * normal[0] * step, y + sign * normal[1] * step)) < 0.02 for sign in (1, -1)]
    if is_inside[0] == is_inside[1]:
        return None
    sign = -1 if is_inside[0] else 1
    half = max(window.width / 2 - 0.05, 0.05)
    near, far = sign * wall / 2, sign * (wall / 2 + depth)
    corner = lambda side, out: (x + along_x * side * half + normal[0] * out, y + along_y * side * half + normal[1] * out)
    return Polygon([corner(-1, near), corner(1, near), corner(1, far), corner(-1, far)])


def windows_inside(building: Building, level: Level) -> list[Fault]:
    faults = []
    for window in level.openings:
        if window.kind != "window":
            continue
        if not leads_out(window, level):
            rooms = ", ".join(window.rooms)
            faults.append(Fault("window_inside", building.id, level.id, window.id, f"from {rooms}", window.width))
            continue
        seen = own_room_seen(building, level, window)
        if seen:
            text = f"from {window.rooms[0]} into {seen}"
            faults.append(Fault("window_inside", building.id, level.id, window.id, text, window.width))
    return faults


def room_behind(window: Opening, level: Level) -> Room | None:
    """The room that looks out of a window."""
    rooms = [level.rooms[room] for room in window.rooms if room in level.rooms]
    return next((room for room in rooms if room.type not in OUTSIDE), None)


def own_room_seen(building: Building, level: Level, window: Opening) -> str | None:
    room = room_behind(window, level)
    view = room and view_of(window, room.shape, building.exterior, 0.5)
    if view is None:
        return None
    return next((other.id for other in level.indoor if other.shape.is_valid and area_of_overlap(view, other.shape) > 0.01), None)


def area_of_overlap(first: BaseGeometry, second: BaseGeometry) -> float:
    return first.intersection(second).area if first.intersects(second) else 0.0
