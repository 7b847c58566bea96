"""Walls, columns, frames and leaves against rooms, doorways and furniture, measured on the meshes."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from ..gltf_file import GltfFile, Node

from .geometry import footprint
from .pieces import Piece, pieces_of
from .report import Note
from .shell_parts import LIMIT, RoomFloor, Shell, ShellPart

# Metres between the points of a contour that are measured.
STEP = 0.02
# Metres above the floor and below the ceiling that are not measured: walls stand in floors and ceilings.
MARGIN = 0.01
# Metres between a wall and the edge of the floor from which on one sees through, and metres between the places asked.
WIDEST_GAP = 0.02
GAP_STEP = 0.05


def check_shell(gltf: GltfFile) -> Iterator[Note]:
    level = Shell(gltf)
    furniture = Furniture([piece for piece in pieces_of(gltf) if not piece.is_covering])
    for part in level.parts:
        yield from check_rooms(part, level, furniture)
        if part.owner.kind == "room":
            yield from check_doorways(part, level)
        else:
            yield from check_furniture(part, furniture)
    for room in level.rooms:
        yield from check_gaps(room, level)


class Furniture:
    """The pieces of a level by place."""

    def __init__(self, pieces: list[Piece]):
        self.pieces = pieces
        boxes = [(piece.low[0], -piece.high[2], piece.high[0], -piece.low[2]) for piece in pieces]
        self.tree = shapely.STRtree([shapely.box(*box) for box in boxes])

    def near(self, area: shapely.Geometry) -> list[Piece]:
        return [self.pieces[number] for number in sorted(self.tree.query(area))]


# --- rooms ---


def check_rooms(part: ShellPart, level: Shell, furniture: Furniture) -> Iterator[Note]:
    for room in level.rooms_near(part):
        if part.node.extras["part"] == "leaf" and is_side(part.owner, room):
            continue
        points = points_inside(part, room, level)
        if len(points) == 0:
            continue
        depths = shapely.distance(room.outline.boundary, shapely.points(points[:, :2]))
        x, y, _ = points[depths.argmax()]
        pierced = [piece.node.name for piece in furniture.near(part.box) if is_pierced(piece, points)]
        through = f", through {', '.join(pierced)}" if pierced else ""
        yield Note("shell", part.node.name, f"it reaches {depths.max() * 1000:.0f} mm into {room.node.name} at "
                                            f"({x:.3f}, {y:.3f}){through}")


def is_pierced(piece: Piece, points: np.ndarray) -> bool:
    """Whether one of some points, with their heights, lies in a piece by more than the limit."""
    met = points[(points[:, 2] > piece.low[1]) & (points[:, 2] < piece.high[1])]
    area = footprint(piece.corners).buffer(-LIMIT)
    return bool(shapely.intersects_xy(area, met[:, 0], met[:, 1]).any())


def is_side(opening: Node, room: RoomFloor) -> bool:
    return any(side["room"] == room.node.extras["room"] for side in opening.extras.get("sides", []))


def points_inside(part: ShellPart, room: RoomFloor, level: Shell) -> np.ndarray:
    """Points of a part, with their heights, that lie deeper in the floor of a room than they may."""
    inner = room.free_of_fittings if part.is_fitting else room.free
    frame = level.frame_strips.get((room.node.extras["room"], part.owner.index))
    found = [np.zeros((0, 3))]
    for height, segments in part.cuts:
        if not MARGIN < height < room.node.extras["height"] - MARGIN or len(segments) == 0:
            continue
        met = segments[shapely.intersects(inner, shapely.linestrings(segments))]
        if len(met) == 0:
            continue
        points = spread(met)
        free = inner if frame is None else inner.difference(frame)
        inside = points[shapely.intersects_xy(free, points[:, 0], points[:, 1])]
        found.append(np.column_stack([inside, np.full(len(inside), height)]))
    return np.concatenate(found)


def spread(segments: np.ndarray) -> np.ndarray:
    """Points along segments, at most STEP apart, with their ends."""
    found = [np.zeros((0, 2))]
    for start, end in segments:
        count = max(2, int(np.ceil(np.linalg.norm(end - start) / STEP)) + 1)
        found.append(start + (end - start) * np.linspace(0, 1, count)[:, None])
    return np.concatenate(found)


# --- doorways ---


def check_doorways(part: ShellPart, level: Shell) -> Iterator[Note]:
    for number in sorted(level.doorway_tree.query(part.box)):
        doorway = level.doorways[number]
        for height, segments in part.cuts:
            if not MARGIN < height < doorway.top - MARGIN or len(segments) == 0:
                continue
            lines = shapely.intersection(doorway.area, shapely.linestrings(segments))
            lines = lines[~shapely.is_empty(lines)]
            if len(lines) and shapely.length(lines).sum() > LIMIT:
                x, y = shapely.get_coordinates(lines)[0]
                yield Note("shell", part.node.name, f"it stands in {doorway.node.name} at ({x:.3f}, {y:.3f})")
                break


# --- furniture ---


def check_furniture(part: ShellPart, furniture: Furniture) -> Iterator[Note]:
    """A frame, sill, leaf or handle against the furniture beside it."""
    for piece in furniture.near(part.box):
        depth = depth_in(part, piece)
        if depth > LIMIT:
            yield Note("shell", part.node.name, f"it is {depth * 1000:.0f} mm inside of {piece.node.name}")


def depth_in(part: ShellPart, piece: Piece) -> float:
    """Metres that a part reaches into a piece, seen from above at each of the part's own heights."""
    if (np.minimum(part.part.high, piece.high) - np.maximum(part.part.low, piece.low)).min() <= 0.0:
        return 0.0
    return max((depth_at(height, segments, piece) for height, segments in part.cuts if len(segments)), default=0.0)


def depth_at(height: float, segments: np.ndarray, piece: Piece) -> float:
    cut = [footprint(part.corners) for part in piece.parts if part.low[1] < height < part.high[1]]
    # Bodies of boards are no way in: of a ring of boards, all counts.
    area = shapely.union_all([shapely.Polygon(shape.exterior) for shape in polygons(shapely.union_all(cut))])
    points = spread(segments[shapely.intersects(area, shapely.linestrings(segments))])
    inside = points[shapely.intersects_xy(area, points[:, 0], points[:, 1])]
    return float(shapely.distance(area.boundary, shapely.points(inside)).max()) if len(inside) else 0.0


def polygons(area: shapely.Geometry) -> list[shapely.Polygon]:
    return [shape for shape in shapely.get_parts(area) if shape.geom_type == "Polygon"]


# --- gaps ---


def check_gaps(room: RoomFloor, level: Shell) -> Iterator[Note]:
    """Stretches of a room's border where no wall stands at the floor's edge and no opening is."""
    if not level.is_walled(room):
        return
    for number, (start, end) in enumerate(room.borders):
        places = closed_places(np.linalg.norm(end - start), level.holes.get((room.node.extras["room"], number), []))
        if len(places) == 0:
            continue
        along = (end - start) / np.linalg.norm(end - start)
        points = start + along * places[:, None]
        walled, _ = level.wall_tree.query(shapely.points(points), predicate="dwithin", distance=WIDEST_GAP)
        is_open = ~np.isin(np.arange(len(points)), walled)
        # Two places beside each other, so that rounding at one is none.
        gaps = np.flatnonzero(is_open[1:] & is_open[:-1] & (np.diff(places) < 2 * GAP_STEP))
        if len(gaps):
            x, y = points[gaps[0]]
            yield Note("shell", room.node.name, f"no wall stands at the edge of its floor at ({x:.3f}, {y:.3f}), "
                                                f"side {number}")


def closed_places(length: float, holes: list[tuple[float, float]]) -> np.ndarray:
    """Places along a side, in metres from its start, that lie in none of its openings."""
    count = int(length / GAP_STEP)
    places = (np.arange(count) + 0.5) * GAP_STEP
    for low, high in holes:
        places = places[(places < low - GAP_STEP) | (places > high + GAP_STEP)]
    return places
