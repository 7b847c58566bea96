"""Pieces of furniture where they stand, measured on their meshes."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import shapely

from checks.bodies import Part, parts_of
from gltf_file import Node

from .shapes import hull, rectangle

# Metres of height up to which what lies on the floor is floor: rugs.
COVERING = 0.021
# Metres above the floor from which on a piece hangs and does not stand.
STANDING = 0.03


@dataclass
class Mesh:
    """A mesh in its own frame, measured once for all its pieces."""

    primitives: list[dict]

    @cached_property
    def corners(self) -> np.ndarray:
        return np.concatenate([primitive["positions"] for primitive in self.primitives]).astype(float)

    @cached_property
    def parts(self) -> list[Part]:
        return parts_of(self.primitives)

    @cached_property
    def rim(self) -> np.ndarray:
        """The corners of its hull from above: x, z."""
        flat = hull(self.corners[:, [0, 2]])
        return shapely.get_coordinates(flat)

    @cached_property
    def layers(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Of each part the lowest and highest height and its hull from above, in x and z."""
        parts = self.parts
        points = np.concatenate([part.corners[:, [0, 2]] for part in parts])
        owners = np.repeat(np.arange(len(parts)), [len(part.corners) for part in parts])
        hulls = shapely.convex_hull(shapely.multipoints(points, indices=owners))
        solid = shapely.get_type_id(hulls) == shapely.GeometryType.POLYGON
        lows, highs = (np.array([getattr(part, end)[1] for part in parts]) for end in ("low", "high"))
        return lows[solid], highs[solid], hulls[solid]


@dataclass(eq=False)
class Piece:
    """A piece of furniture where it stands."""

    id: str
    kind: str  # its class
    parent: str  # what it was arranged by
    node: Node
    mesh: Mesh
    carrier: Piece | None  # what it stands or hangs on, unless that is its room
    _slices: dict[tuple[float, float], shapely.Geometry] = field(default_factory=dict)

    def flat(self, points: np.ndarray) -> np.ndarray:
        """Points x, z of the mesh in the plan's axes; pieces stand upright."""
        world = self.node.world
        turned = points @ world[[0, 2]][:, [0, 2]].T + world[[0, 2], 3]
        return turned * (1.0, -1.0)

    @cached_property
    def footprint(self) -> shapely.Geometry:
        return shapely.Polygon(self.flat(self.mesh.rim)) if len(self.mesh.rim) > 2 else hull(self.flat(self.mesh.rim))

    @cached_property
    def heights(self) -> tuple[float, float]:
        """Lowest and highest point above the floor."""
        scale, lift = self.node.world[1, 1], self.node.world[1, 3]
        own = self.mesh.corners[:, 1]
        return float(own.min() * scale + lift), float(own.max() * scale + lift)

    @property
    def low(self) -> float:
        return self.heights[0]

    @property
    def high(self) -> float:
        return self.heights[1]

    @cached_property
    def front(self) -> np.ndarray:
        """Unit vector to its front."""
        vector = np.array([self.node.world[0, 2], -self.node.world[2, 2]])
        return vector / max(np.hypot(*vector), 1e-9)

    @cached_property
    def right(self) -> np.ndarray:
        return np.array([self.front[1], -self.front[0]])

    @cached_property
    def center(self) -> np.ndarray:
        low, high = self.mesh.corners.min(axis=0), self.mesh.corners.max(axis=0)
        return self.flat(((low + high) / 2)[None, [0, 2]])[0]

    @cached_property
    def size(self) -> np.ndarray:
        """Width and depth of the mesh."""
        return np.ptp(self.mesh.corners[:, [0, 2]], axis=0)

    def side(self, name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Both ends of a side of its box, and the unit vector out of it."""
        width, depth = self.size / 2
        outward = {"front": self.front, "back": -self.front, "right": self.right, "left": -self.right}[name]
        reach, half = (depth, width) if name in ("front", "back") else (width, depth)
        across = np.array([-outward[1], outward[0]])
        middle = self.center + outward * reach
        return middle - across * half, middle + across * half, outward

    def zone(self, name: str, depth: float, inset: float = 0.0) -> shapely.Polygon:
        """The floor before a side."""
        start, end, outward = self.side(name)
        along = (end - start) / max(np.hypot(*(end - start)), 1e-9)
        return rectangle(start + along * inset, end - along * inset, outward * depth)

    @cached_property
    def layers(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Its solid parts: lowest and highest height above the floor, and shape from above."""
        scale, lift = self.node.world[1, 1], self.node.world[1, 3]
        lows, highs, hulls = self.mesh.layers
        return lows * scale + lift, highs * scale + lift, shapely.transform(hulls, self.flat)

    def below(self, height: float, above: float = COVERING) -> shapely.Geometry:
        """What of it lies between two heights, from above."""
        if (height, above) not in self._slices:
            lows, highs, shapes = self.layers
            self._slices[height, above] = shapely.union_all(shapes[(lows < height) & (highs > above)])
        return self._slices[height, above]

    @property
    def is_covering(self) -> bool:
        return self.carrier is None and self.high <= COVERING

    @property
    def stands(self) -> bool:
        """Whether it stands on the floor of its room."""
        return self.carrier is None and self.low < STANDING and not self.is_covering
