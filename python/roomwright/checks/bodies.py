"""Solid parts of meshes: connected closed surfaces.

Models are built of beams, boards and turned parts. Most parts are convex, and overlap.py measures their overlap exactly. A
bowl or a bath is not convex; its overlap is measured at points inside of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

# Metres: corners closer than this are one corner.
WELD = 1e-5
# Metres: a part is convex if none of its corners lies farther than this before one of its faces.
FLAT = 1e-4


@dataclass(frozen=True)
class Part:
    """A closed surface in some frame."""

    corners: np.ndarray  # n x 3
    triangles: np.ndarray  # m x 3, counter-clockwise from outside
    is_convex: bool
    directions: np.ndarray  # of edges, one of each
    normals: np.ndarray  # of faces, one of each

    @cached_property
    def low(self) -> np.ndarray:
        return self.corners.min(axis=0)

    @cached_property
    def high(self) -> np.ndarray:
        return self.corners.max(axis=0)

    def placed(self, matrix: np.ndarray) -> Part:
        """The part in another frame, by a matrix without shear."""
        turn = matrix[:3, :3]
        corners = self.corners @ turn.T + matrix[:3, 3]
        return Part(corners, self.triangles, self.is_convex, unit(self.directions @ turn.T),
                    unit(self.normals @ np.linalg.inv(turn)))


def parts_of(primitives: list[dict]) -> list[Part]:
    """The parts of a mesh; those of different materials are parts of their own."""
    return [part for primitive in primitives for part in split(*weld(primitive))]


def weld(primitive: dict) -> tuple[np.ndarray, np.ndarray]:
    """Corners and triangles with corners at the same place joined, and no triangle without area."""
    corners = primitive["positions"].astype(float)
    _, first, joined = np.unique(np.round(corners / WELD).astype(np.int64), axis=0, return_index=True,
                                 return_inverse=True)
    triangles = joined.reshape(-1)[primitive["triangles"]]
    proper = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    return corners[first], triangles[proper]


def split(corners: np.ndarray, triangles: np.ndarray) -> list[Part]:
    """The connected surfaces."""
    if len(triangles) == 0:
        return []
    labels = connected(len(corners), triangles)[triangles[:, 0]]
    order = np.argsort(labels, kind="stable")
    starts = np.flatnonzero(np.diff(labels[order])) + 1
    return [part_of(corners, triangles[chosen]) for chosen in np.split(order, starts)]


def solids_of(primitive: dict) -> list[Part]:
    """The parts of a mesh; of those that meet along an edge, as the steps of a flight do, each is one."""
    return [part_of(corners, triangles) for corners, triangles in surfaces_of(primitive)]


def surfaces_of(primitive: dict) -> list[tuple[np.ndarray, np.ndarray]]:
    """The corners and triangles of the solids of a mesh."""
    corners, triangles = weld(primitive)
    if len(triangles) == 0:
        return []
    labels = joined_faces(triangles)
    whole = connected(len(corners), triangles)[triangles[:, 0]]
    # Bodies in the same place have no edge of two triangles: what they are connected with stays together.
    is_open = np.isin(labels, open_surfaces(triangles, labels))
    labels = np.where(np.isin(whole, whole[is_open]), whole + len(triangles), labels)
    return [own_corners(corners, triangles[labels == label]) for label in np.unique(labels)]


def joined_faces(triangles: np.ndarray) -> np.ndarray:
    """For each triangle, a number that those share which lead to each other over edges of two triangles alone."""
    edges = np.sort(edges_of(triangles), axis=1)
    _, edge, count = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    owners = np.tile(np.arange(len(triangles)), 3)[np.argsort(edge.reshape(-1), kind="stable")]
    first = (np.cumsum(count) - count)[count == 2]
    return connected(len(triangles), np.stack([owners[first], owners[first + 1]], axis=1))


def open_surfaces(triangles: np.ndarray, labels: np.ndarray) -> np.ndarray:
    """The labels of surfaces with an edge that has more triangles on one side than on the other."""
    ends = edges_of(triangles)
    signs = np.where(ends[:, 0] < ends[:, 1], 1, -1)
    keys, edge = np.unique(np.column_stack([np.tile(labels, 3), np.sort(ends, axis=1)]), axis=0, return_inverse=True)
    return np.unique(keys[np.bincount(edge.reshape(-1), signs) != 0, 0])


def is_closed(part: Part) -> bool:
    """Whether each edge has as many triangles on one side as on the other."""
    return len(open_surfaces(part.triangles, np.zeros(len(part.triangles), int))) == 0


def edges_of(triangles: np.ndarray) -> np.ndarray:
    """The first edges of all triangles, then the second ones, then the third ones."""
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def connected(count: int, triangles: np.ndarray) -> np.ndarray:
    """For each corner, the least corner that it is connected with; the rows are triangles, or pairs."""
    labels = np.arange(count)
    while True:
        least = labels[triangles].min(axis=1)
        before = labels.copy()
        for column in triangles.T:
            np.minimum.at(labels, column, least)
        labels = labels[labels]
        if np.array_equal(labels, before):
            return labels


def part_of(corners: np.ndarray, triangles: np.ndarray) -> Part:
    corners, triangles = own_corners(corners, triangles)
    ring = corners[triangles]
    normals = np.cross(ring[:, 1] - ring[:, 0], ring[:, 2] - ring[:, 0])
    flat = np.linalg.norm(normals, axis=1) > 1e-12
    normals = unit(normals[flat])
    edges = unit((np.roll(ring, -1, axis=1) - ring).reshape(-1, 3))
    # Heights of all corners over all faces: the first corner of a face is at height 0.
    faces, offsets = distinct_faces(normals, np.einsum("ij,ij->i", normals, ring[flat][:, 0]))
    is_convex = len(faces) > 0 and bool((corners @ faces.T - offsets).max() < FLAT)
    return Part(corners, triangles, is_convex, distinct(edges), distinct(normals))


def own_corners(corners: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Some triangles with the corners that they use alone."""
    used, renumbered = np.unique(triangles, return_inverse=True)
    return corners[used], renumbered.reshape(-1, 3)


def distinct_faces(normals: np.ndarray, offsets: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Planes, one of each."""
    planes = np.column_stack([normals, offsets])
    _, first = np.unique(np.round(planes, 5), axis=0, return_index=True)
    return normals[first], offsets[first]


def distinct(directions: np.ndarray) -> np.ndarray:
    """Directions, of opposite ones one."""
    rounded = np.round(directions, 4) + 0.0
    leading = rounded[np.arange(len(rounded)), (rounded != 0).argmax(axis=1)]
    _, first = np.unique(rounded * np.where(leading < 0, -1, 1)[:, None] + 0.0, axis=0, return_index=True)
    return directions[first]


def unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-30)
