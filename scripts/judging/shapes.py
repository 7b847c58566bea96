"""Shapes in the plan's axes: x east, y north, metres."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

# Metres that stretches of one wall may lie off its line (pipe boxing, pillars), and the cosine of 5° for their directions.
SAME_LINE = 0.1
SAME_DIRECTION = 0.996


@dataclass(frozen=True)
class Wall:
    """One edge of a room's outline."""

    number: int
    start: np.ndarray
    end: np.ndarray
    inward: np.ndarray  # unit vector into the room

    @property
    def length(self) -> float:
        return float(np.hypot(*(self.end - self.start)))

    @property
    def along(self) -> np.ndarray:
        return (self.end - self.start) / max(self.length, 1e-9)

    def at(self, metres: float) -> np.ndarray:
        return self.start + self.along * metres

    def distance(self, point: np.ndarray) -> float:
        """Metres from the wall's line into the room."""
        return float((point - self.start) @ self.inward)

    def strip(self, start: float, end: float, depth: float) -> shapely.Polygon:
        """The part of the room before a stretch of the wall."""
        return rectangle(self.at(start), self.at(end), self.inward * depth)


def rectangle(start: np.ndarray, end: np.ndarray, offset: np.ndarray) -> shapely.Polygon:
    return shapely.Polygon([start, end, end + offset, start + offset])


def walls_of(outline: list, holes: list) -> list[Wall]:
    """The edges of an outline, then those of its holes, numbered as docs/output.md has it."""
    region = shapely.Polygon(outline, holes)
    edges = ring_edges(outline)
    for hole in holes:
        edges += [(end, start) for start, end in ring_edges(hole)]
    return [Wall(number, start, end, inward_of(start, end, region)) for number, (start, end) in enumerate(edges)]


def ring_edges(ring: list) -> list[tuple[np.ndarray, np.ndarray]]:
    points = np.asarray(ring, float)
    return list(zip(points, np.roll(points, -1, axis=0)))


def inward_of(start: np.ndarray, end: np.ndarray, region: shapely.Polygon) -> np.ndarray:
    """The normal of an edge on whose side the region lies."""
    along = end - start
    normal = np.array([-along[1], along[0]]) / max(np.hypot(*along), 1e-9)
    probe = (start + end) / 2 + normal * 1e-4
    return normal if region.covers(shapely.Point(probe)) else -normal


def straight_walls(walls: list[Wall]) -> list[list[Wall]]:
    """Walls as people see them: edges that lie on one line and face one way are one wall."""
    found: list[list[Wall]] = []
    for wall in walls:
        home = next((group for group in found if any(is_one_wall(wall, other) for other in group)), None)
        if home is None:
            found.append([wall])
        else:
            home.append(wall)
    return found


def is_one_wall(one: Wall, other: Wall) -> bool:
    middle = (one.start + one.end) / 2
    return one.inward @ other.inward > SAME_DIRECTION and abs(other.distance(middle)) < SAME_LINE


def angle_between(one: np.ndarray, other: np.ndarray) -> float:
    """Degrees from 0 to 180; 0 where one of them has no length."""
    lengths = np.hypot(*one) * np.hypot(*other)
    if lengths < 1e-12:
        return 0.0
    return float(np.degrees(np.arccos(np.clip(one @ other / lengths, -1.0, 1.0))))


def hull(points: np.ndarray) -> shapely.Geometry:
    return shapely.MultiPoint(points).convex_hull


def pieces_of_area(geometry: shapely.Geometry) -> list[shapely.Polygon]:
    """The polygons of what an operation left."""
    return [part for part in shapely.get_parts(geometry).tolist() if isinstance(part, shapely.Polygon) and not part.is_empty]


def width_of(region: shapely.Polygon) -> float:
    """The shorter side of the rectangle that has the area and the perimeter of a region: how wide a corridor is."""
    half = region.length / 4
    root = half * half - region.area
    return half - np.sqrt(root) if root > 0 else half
