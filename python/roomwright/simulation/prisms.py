"""Walls, floors and frames as boxes and convex prisms.

Between two heights of its corners, a part of the shell is an upright prism (checks/shell_parts.py). Each of these storeys is
cut into convex pieces in the plan, so that doorways and windows stay open:

      +-----------------+      +-----------------+
      |    +-------+    |      |-----------------|
      |    |       |    |  →   |    |       |    |
      |    |       |    |      |    |       |    |
      +----+       +----+      +----+       +----+
"""

from __future__ import annotations

import numpy as np
import shapely

from ..checks.bodies import Part
from ..checks.shell_parts import ShellPart

from .bodies import Box, Collider, Surface

# Metres to which the ends of cuts are rounded, so that those of neighbouring triangles meet.
GRID = 1e-5
# Square metres: slivers that rounding leaves.
LEAST_AREA = 1e-6
# Of a piece and its convex hull, or of a piece and the rectangle around it: areas that are this alike are the same.
ALIKE = 1.0 - 1e-6


def colliders_of_shell(part: Part) -> list[Collider]:
    """The pieces of a part that stands upright, in Z-up axes; `part` is in those of glTF."""
    cut = ShellPart(None, None, part)
    heights = np.unique(np.round(part.corners[:, 1], 4))
    found = []
    for middle, segments in cut.cuts:
        above = int(np.searchsorted(heights, middle))
        for area in convex_pieces(area_of(segments)):
            found.append(prism(area, float(heights[above - 1]), float(heights[above])))
    return stacked(found)


def area_of(segments: np.ndarray) -> shapely.Geometry:
    """The area inside a contour: what lies in an odd number of its rings."""
    rounded = np.round(segments / GRID) * GRID
    lines = shapely.linestrings(rounded[(rounded[:, 0] != rounded[:, 1]).any(axis=1)])
    rings = shapely.polygonize([shapely.node(shapely.multilinestrings(lines))]).geoms if len(lines) else []
    inside = [ring for ring in rings if is_inside(ring.representative_point(), rounded)]
    return shapely.union_all(inside)


def is_inside(point: shapely.Point, segments: np.ndarray) -> bool:
    """Whether a ray from a point crosses segments an odd number of times."""
    (start_x, start_y), (end_x, end_y) = segments[:, 0].T, segments[:, 1].T
    spans = (start_y > point.y) != (end_y > point.y)
    rise = np.where(spans, end_y - start_y, 1.0)
    return bool((spans & (start_x + (point.y - start_y) / rise * (end_x - start_x) > point.x)).sum() % 2)


def convex_pieces(area: shapely.Geometry) -> list[shapely.Polygon]:
    """Convex polygons that fill an area: its triangles, joined as long as the result is convex (the idea of S. Hertel and
    K. Mehlhorn, 1983, without their bound)."""
    whole = [polygon for polygon in getattr(area, "geoms", [area]) if polygon.area > LEAST_AREA]
    pieces = []
    for polygon in whole:
        polygon = polygon.simplify(GRID)
        if is_convex(polygon):
            pieces.append(polygon)
        else:
            triangles = shapely.constrained_delaunay_triangles(polygon).geoms
            pieces += joined([triangle for triangle in triangles if triangle.area > LEAST_AREA])
    return pieces


def joined(pieces: list[shapely.Polygon]) -> list[shapely.Polygon]:
    """Pieces, of which no two neighbours are convex together; the longest shared edges go first."""
    pieces = list(pieces)
    while True:
        pairs = [(shapely.intersection(one, other).length, i, j) for i, one in enumerate(pieces)
                 for j, other in enumerate(pieces[:i]) if one.touches(other)]
        for length, i, j in sorted(pairs, key=lambda pair: (-round(pair[0], 6), pair[1:])):
            union = shapely.union(pieces[i], pieces[j]).simplify(GRID) if length > GRID else None
            if union is not None and union.geom_type == "Polygon" and is_convex(union):
                pieces = [piece for k, piece in enumerate(pieces) if k not in (i, j)] + [union]
                break
        else:
            return pieces


def is_convex(polygon: shapely.Polygon) -> bool:
    return not polygon.interiors and polygon.area >= polygon.convex_hull.area * ALIKE


def prism(area: shapely.Polygon, low: float, high: float) -> Collider:
    """A convex polygon of the plan between two heights."""
    around = area.minimum_rotated_rectangle
    if around.geom_type == "Polygon" and area.area >= around.area * ALIKE:
        ring = shapely.get_coordinates(around)[:4]
        along, across = ring[1] - ring[0], ring[2] - ring[1]
        length, width = np.linalg.norm(along), np.linalg.norm(across)
        x, y = along / length
        turn = np.array([[x, -y, 0.0], [y, x, 0.0], [0.0, 0.0, 1.0]])
        centre = np.array([*ring.mean(axis=0), (low + high) / 2])
        return Box(centre, turn, np.array([length, width, high - low]) / 2)
    ring = shapely.get_coordinates(shapely.orient_polygons(area).exterior)[:-1]
    count = len(ring)
    corners = np.concatenate([np.column_stack([ring, np.full(count, height)]) for height in (low, high)])
    fan = np.array([[0, i, i + 1] for i in range(1, count - 1)])
    sides = [[[i, j, j + count], [i, j + count, i + count]] for i, j in ((i, (i + 1) % count) for i in range(count))]
    return Surface(corners, np.concatenate([fan[:, ::-1], fan + count, np.array(sides).reshape(-1, 3)]))


def stacked(pieces: list[Collider]) -> list[Collider]:
    """Boxes of the same outline that stand on each other become one."""
    found: list[Collider] = []
    for piece in pieces:
        below = next((other for other in found if is_under(other, piece)), None)
        if below is None:
            found.append(piece)
            continue
        low, high = below.centre[2] - below.half[2], piece.centre[2] + piece.half[2]
        found[found.index(below)] = Box(np.array([*piece.centre[:2], (low + high) / 2]), piece.turn,
                                        np.array([*piece.half[:2], (high - low) / 2]))
    return found


def is_under(one: Collider, other: Collider) -> bool:
    if not isinstance(one, Box) or not isinstance(other, Box):
        return False
    same = (np.abs(one.centre[:2] - other.centre[:2]).max() < GRID and np.abs(one.half[:2] - other.half[:2]).max() < GRID
            and np.abs(one.turn - other.turn).max() < GRID)
    return same and abs(one.centre[2] + one.half[2] - other.centre[2] + other.half[2]) < GRID
