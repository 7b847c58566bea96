"""Whether a room without its furniture has a place for a bed: what no architect can place better is no fault of who placed it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from .floors import Room
from .pieces import Piece
from .shapes import Wall, rectangle

# Metres between the places that are tried along a wall, and by which a bed may reach past an outline: rounding.
STEP = 0.05
ROUNDING = 0.01
# Metres between a bed and the sector that a leaf sweeps.
SWING_REACH = 0.75
# Metres beside a bed that who gets up needs along one of its long sides (QUALITY §3), and inside doors that stay free.
BESIDE = 0.56
BEFORE_DOOR = 0.75
# Metres that a head may rise over a sill, and before a window in which it takes light (QUALITY §2).
OVER_SILL = 0.1
BEFORE_WINDOW = 0.5


def swings_of(room: Room) -> list[shapely.Polygon]:
    """Where leaves swing into a room."""
    return [swing for opening, _ in room.openings(doors=True) for swing in opening.swings
            if swing.intersection(room.region).area > swing.area / 2]


def has_place(room: Room, bed: Piece, along_wall: bool = False) -> bool:
    """Whether a bed of the same size could stand with its head at a wall, or with a long side where `along_wall` asks for it:
    clear of leaves, doors and windows that it would darken, with a way along a long side."""
    taken = [side.before(BEFORE_DOOR) for opening, side in room.openings(doors=True) if opening.closure != "open"]
    taken += [swing.buffer(SWING_REACH - ROUNDING) for swing in swings_of(room)]
    taken += [shape for shape, _ in room.columns]
    dark = [side.before(BEFORE_WINDOW) for opening, side in room.openings(doors=False) if opening.sill + OVER_SILL < bed.high]
    inside = room.region.buffer(ROUNDING)
    floor = inside.difference(shapely.union_all(taken))
    at_head = floor.difference(shapely.union_all(dark))
    shapely.prepare([inside, floor, at_head])
    width, length = sorted(bed.size)
    places = sideways if along_wall else upright
    return any(floor.covers(stand) and at_head.covers(head) and any(inside.covers(strip) for strip in strips)
               for wall in room.walls for stand, head, strips in places(wall, width, length))


Place = tuple[shapely.Polygon, shapely.Polygon, list[shapely.Polygon]]  # the bed, its head, the strips beside it


def starts(wall: Wall, metres: float) -> np.ndarray:
    """Where something so long may begin along a wall; its end last."""
    last = wall.length - metres
    return np.unique(np.append(np.arange(0.0, last, STEP), last)) if last > -ROUNDING else np.empty(0)


def upright(wall: Wall, width: float, length: float) -> Iterator[Place]:
    """Beds with their heads at a wall."""
    for start in starts(wall, width):
        left, right = wall.at(start), wall.at(start + width)
        aside, out = wall.along * BESIDE, wall.inward * length
        strips = [rectangle(left - aside, left, out), rectangle(right, right + aside, out)]
        yield rectangle(left, right, out), rectangle(left, right, wall.inward * width / 2), strips


def sideways(wall: Wall, width: float, length: float) -> Iterator[Place]:
    """Beds with a long side at a wall and their heads at either end."""
    for start in starts(wall, length):
        near, far, out = wall.at(start), wall.at(start + length), wall.inward * width
        strip = rectangle(near + out, far + out, wall.inward * BESIDE)
        half = wall.along * width / 2
        for head in (rectangle(near, near + half, out), rectangle(far - half, far, out)):
            yield rectangle(near, far, out), head, [strip]
