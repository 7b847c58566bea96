"""Faces that look up or down, seen from above: how much height is open over a place."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

# Square metres of what a face and a place share from which on the face is over the place.
LEAST_SHARED = 1e-4
# Metres that a face reaches above a place, at least, to be over it.
OVER = 0.01
# Cosine of the angle to the vertical from which on a face looks up or down.
LEVEL = 0.05


class Undersides:
    """The faces of some things that look down, by place."""

    def __init__(self, things: list[tuple[str, np.ndarray]]):
        """Names, and triangles in a frame with y up, n x 3 x 3."""
        looking_down = [(name, rings[upward(rings) < -LEVEL]) for name, rings in things]
        self.names = [name for name, rings in looking_down for _ in rings]
        self.rings = np.concatenate([np.zeros((0, 3, 3)), *(rings for _, rings in looking_down)])
        self.tree = shapely.STRtree(plan_shapes(self.rings))

    def over(self, place: shapely.Geometry, height: float) -> Iterator[tuple[str, float, shapely.Geometry]]:
        """Each face over a place of a height: the thing's name, the face's lowest height there, and what they share."""
        for number in sorted(self.tree.query(place, predicate="intersects")):
            shared = self.tree.geometries[number].intersection(place)
            if shared.area < LEAST_SHARED:
                continue
            heights = heights_of(self.rings[number], shapely.get_coordinates(shared))
            if heights.max() > height + OVER:
                yield self.names[number], float(heights.min()), shared


def area_above(rings: np.ndarray) -> shapely.Geometry:
    """What of the plan lies under faces that look up."""
    return shapely.union_all(plan_shapes(rings[upward(rings) > LEVEL]))


def upward(rings: np.ndarray) -> np.ndarray:
    """How far triangles look up: one where they are floors, less than zero where they look down."""
    normals = np.cross(rings[:, 1] - rings[:, 0], rings[:, 2] - rings[:, 0])
    return normals[:, 1] / np.maximum(np.linalg.norm(normals, axis=1), 1e-12)


def plan_shapes(rings: np.ndarray) -> np.ndarray:
    """Triangles from above, in the plan's axes."""
    return shapely.polygons(rings[:, :, [0, 2]] * (1, -1))


def heights_of(ring: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Heights of a triangle's plane at points of the plan."""
    normal = np.cross(ring[1] - ring[0], ring[2] - ring[0])
    offsets = points * (1, -1) - ring[0, [0, 2]]
    return ring[0, 1] - offsets @ normal[[0, 2]] / normal[1]
