"""Pieces of furniture where they stand, measured on their meshes."""

from __future__ import annotations

import hashlib
import itertools
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import shapely

from roomwright.checks.bodies import Part, connected, parts_of, weld
from roomwright.gltf_file import Node

from .shapes import hull, rectangle

# Metres of height up to which what lies on the floor is floor: rugs.
COVERING = 0.021
# Metres above its lowest point up to which a piece touches what it stands on.
FOOT = 0.02
# Cosine of 25°: a face less steep carries things.
LEVEL = 0.9
# Which end of x, y and z each corner of a box takes.
CORNERS = [list(ends) for ends in itertools.product((0, 1), repeat=3)]
# Meshes that one process remembers, of some 100 kB.
MOST_MESHES = 3000
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
    def part_corners(self) -> np.ndarray:
        """The eight corners of the box of each part."""
        ends = np.array([(part.low, part.high) for part in self.parts]).reshape(-1, 2, 3)
        return np.stack([ends[:, choice, [0, 1, 2]] for choice in CORNERS], axis=1)

    @cached_property
    def tops(self) -> tuple[np.ndarray, np.ndarray]:
        """Faces that something can stand on: their heights, and their shapes in x and z."""
        rings = np.concatenate([primitive["positions"][primitive["triangles"]] for primitive in self.primitives]).astype(float)
        normals = np.cross(rings[:, 1] - rings[:, 0], rings[:, 2] - rings[:, 0])
        up = normals[:, 1] > LEVEL * np.maximum(np.linalg.norm(normals, axis=1), 1e-12)
        shapes = shapely.polygons(rings[up][:, [0, 1, 2, 0]][:, :, [0, 2]])
        sound = shapely.area(shapes) > 1e-8
        return rings[up][:, :, 1].mean(axis=1)[sound], shapes[sound]

    @cached_property
    def foot(self) -> np.ndarray:
        """The corners of the hull of its lowest 2 cm from above, in x and z."""
        own = self.corners
        return shapely.get_coordinates(hull(own[own[:, 1] < own[:, 1].min() + FOOT][:, [0, 2]]))

    @cached_property
    def rim(self) -> np.ndarray:
        """The corners of its hull from above: x, z."""
        flat = hull(self.corners[:, [0, 2]])
        return shapely.get_coordinates(flat)

    @cached_property
    def layers(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Of each part the lowest and highest height and its hull from above, in x and z."""
        points, owners = [], []
        for primitive in self.primitives:
            corners, triangles = weld(primitive)
            if len(triangles):
                used = np.unique(triangles)
                owners.append(connected(len(corners), triangles)[used] + sum(map(len, points)))
                points.append(corners[used])
        corners, (_, labels) = np.concatenate(points), np.unique(np.concatenate(owners), return_inverse=True)
        order = np.argsort(labels, kind="stable")
        corners, labels = corners[order], labels[order]
        starts = np.flatnonzero(np.diff(labels, prepend=-1))
        hulls = shapely.convex_hull(shapely.multipoints(corners[:, [0, 2]], indices=labels))
        solid = shapely.get_type_id(hulls) == shapely.GeometryType.POLYGON
        heights = corners[:, 1]
        return np.minimum.reduceat(heights, starts)[solid], np.maximum.reduceat(heights, starts)[solid], hulls[solid]


class MeshShelf:
    """Meshes by their content: the files of a bake show the same few thousand models again and again."""

    def __init__(self):
        self.known: dict[bytes, Mesh] = {}

    def mesh(self, primitives: list[dict]) -> Mesh:
        digest = hashlib.blake2b(digest_size=16)
        for primitive in primitives:
            digest.update(primitive["positions"].tobytes() + b"/" + primitive["triangles"].tobytes() + b"/")
        if len(self.known) > MOST_MESHES:
            self.known.clear()
        return self.known.setdefault(digest.digest(), Mesh(primitives))


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
    _parts: dict[int, Part] = field(default_factory=dict)

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

    def part(self, number: int) -> Part:
        """One of its solid parts in the file's frame."""
        if number not in self._parts:
            self._parts[number] = self.mesh.parts[number].placed(self.node.world)
        return self._parts[number]

    @cached_property
    def part_boxes(self) -> np.ndarray:
        """Boxes around its parts: least and greatest x, y and z in the file's frame."""
        corners = self.mesh.part_corners @ self.node.world[:3, :3].T + self.node.world[:3, 3]
        return np.concatenate([corners.min(axis=1), corners.max(axis=1)], axis=1)

    @cached_property
    def tops(self) -> tuple[np.ndarray, np.ndarray, shapely.STRtree]:
        """Faces that something can stand on: heights above the floor, shapes, and a tree of them."""
        heights, shapes = self.mesh.tops
        placed = shapely.transform(shapes, self.flat)
        return heights * self.node.world[1, 1] + self.node.world[1, 3], placed, shapely.STRtree(placed)

    @cached_property
    def foot(self) -> shapely.Geometry:
        """Its shape from above where it touches what it stands on."""
        return hull(self.flat(self.mesh.foot))

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
