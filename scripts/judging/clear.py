"""Free space: how far one can step from a side of a piece, and where in a room one can walk."""

from __future__ import annotations

import numpy as np
import shapely

from .floors import Room
from .pieces import COVERING, Piece
from .shapes import pieces_of_area

# Metres: what hangs so high and reaches so far from its wall is in nobody's way (ADA 307.2: 0.10; shelves 0.15).
HANGING = 0.3
FLAT = 0.15
# Metres of height that a person before a side needs, and that walking people fill.
WAIST = 1.1
HEAD = 1.5
# Metres of a column's edges that a neighbour may touch.
INSET = 0.01
# Metres over an open boundary that one walks, so as to come around its end.
BEYOND = 0.5
# Metres between the ends of two open boundaries at a corner.
JOINT = 0.02


def free_depth(room: Room, piece: Piece, zone: shapely.Polygon, outward: np.ndarray, ignored: set[str]) -> tuple[float, str]:
    """Metres from a side of a piece to the first thing in a zone before it, and what that is; infinite if there is none."""
    edge = float(max(shapely.get_coordinates(piece.footprint) @ outward))
    start = min(edge, float(min(shapely.get_coordinates(zone) @ outward)) + 1e-6)
    found = [(reach(zone.difference(opened(room)), outward) - start, "a wall")]
    found += [(reach(zone.intersection(shape), outward) - start, "a column or stairs") for shape, _ in room.columns]
    for other in room.pieces:
        if other is piece or other.id in ignored or other.carrier is not None or not other.footprint.intersects(zone):
            continue
        if not is_flat(room, other):
            found.append((reach(zone.intersection(other.below(WAIST)), outward) - start, other.id))
    depth, what = min(found)
    return max(depth, 0.0), what


def reach(shape: shapely.Geometry, outward: np.ndarray) -> float:
    """How near a shape comes; slivers of rounding are none."""
    parts = [part for part in pieces_of_area(shape) if part.area > 2e-4]
    return min((float((shapely.get_coordinates(part) @ outward).min()) for part in parts), default=float("inf"))


def is_flat(room: Room, piece: Piece) -> bool:
    """Whether a piece hangs on a wall, out of people's way."""
    return piece.low >= HANGING and room.region.boundary.distance(piece.footprint) < 0.05 and min(piece.size) <= FLAT


def walkable(room: Room, width: float, furnished: bool) -> list[shapely.Polygon]:
    """Where the middle of a person of some width can be: connected areas."""
    key = width, furnished
    if key not in room.walkable:
        room.walkable[key] = free_areas(room, width, furnished)
    return room.walkable[key]


def free_areas(room: Room, width: float, furnished: bool) -> list[shapely.Polygon]:
    taken = [shape for shape, _ in room.columns]
    if furnished:
        taken += [piece.below(HEAD, COVERING) for piece in room.pieces if piece.carrier is None and piece.low < HEAD]
    free = opened(room).difference(shapely.union_all(taken))
    areas = pieces_of_area(free.buffer(-width / 2, quad_segs=4))
    shapely.prepare(areas)
    return areas


def opened(room: Room) -> shapely.Geometry:
    """A room with a step over its open boundaries: people walk over them, not along them."""
    beyond = [side.wall.strip(side.start, side.end, -BEYOND).buffer(JOINT, join_style="mitre")
              for opening, side in room.openings(doors=True) if opening.closure == "open"]
    return shapely.union_all([room.region, *beyond])
