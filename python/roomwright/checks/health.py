"""Sound meshes: closed, without faces that have no area, with normals that look outwards."""

from __future__ import annotations

from typing import Iterator

import numpy as np

# Metres: corners closer than this are one corner when asking whether a mesh is closed.
WELD = 1e-5
# Square metres: a face with less area is a line.
NO_AREA = 1e-12
# How far the length of a normal may be from one, and how far a normal may turn from its face: the cosine of 90 degrees
# and something. Round surfaces have normals between those of their faces.
UNIT = 1e-3
BACKWARD = -1e-3


def complaints(primitives: list[dict]) -> Iterator[str]:
    """The faults of a mesh."""
    rim = open_edges(primitives)
    if rim:
        yield rim
    flat = sum(int((areas(primitive)[1] < NO_AREA).sum()) for primitive in primitives)
    if flat:
        yield f"the mesh has {flat} faces without area"
    wrong = [count for primitive in primitives for count in wrong_normals(primitive)]
    if sum(wrong[::2]):
        yield f"the mesh has {sum(wrong[::2])} normals that are not one long"
    if sum(wrong[1::2]):
        yield f"the mesh has {sum(wrong[1::2])} corners whose normals look into it"


def areas(primitive: dict) -> tuple[np.ndarray, np.ndarray]:
    """The normal of each face, as long as its area is large, and the area in square metres."""
    ring = primitive["positions"].astype(float)[primitive["triangles"]]
    normals = np.cross(ring[:, 1] - ring[:, 0], ring[:, 2] - ring[:, 0]) / 2.0
    return normals, np.linalg.norm(normals, axis=1)


def wrong_normals(primitive: dict) -> tuple[int, int]:
    """How many normals are not one long, and how many corners of faces have one that looks backward."""
    normals = primitive["normals"]
    if normals is None:
        return 0, 0
    not_unit = np.abs(np.linalg.norm(normals, axis=1) - 1.0) > UNIT
    faces, area = areas(primitive)
    cosines = np.einsum("ij,ikj->ik", faces / np.maximum(area, NO_AREA)[:, None],
                        normals.astype(float)[primitive["triangles"]])
    backward = (cosines < BACKWARD) & (area > NO_AREA)[:, None]
    return int(not_unit.sum()), int(backward.sum())


def open_edges(primitives: list[dict]) -> str:
    """Why a mesh is not closed, or an empty text.

    Closed means: after joining corners at the same place, every edge is walked as often one way as the
    other, so the surface has no rim. Parts that touch along an edge are fine, single sheets are not. Each
    part of one material is asked first, since a rim may be filled by another part only in the whole mesh.
    """
    if all(rim_length(*weld([primitive])) == 0 for primitive in primitives):
        return ""
    rim = rim_length(*weld(primitives))
    return f"the mesh is not closed: {rim} edges have a side missing" if rim else ""


def weld(primitives: list[dict]) -> tuple[np.ndarray, int]:
    """The triangles of some primitives with corners at the same place joined, and the number of corners."""
    offsets = np.cumsum([0] + [len(primitive["positions"]) for primitive in primitives])
    corners = np.concatenate([primitive["positions"] for primitive in primitives])
    triangles = np.concatenate([primitive["triangles"] + offset for primitive, offset in zip(primitives, offsets)])
    _, joined = np.unique(np.round(corners / WELD).astype(np.int64), axis=0, return_inverse=True)
    return joined.reshape(-1)[triangles], len(corners)


def rim_length(triangles: np.ndarray, corner_count: int) -> int:
    """How many edges are walked more often one way than the other."""
    start = triangles.reshape(-1)
    end = np.roll(triangles, -1, axis=1).reshape(-1)
    edges = np.minimum(start, end) * corner_count + np.maximum(start, end)
    ways = np.where(start < end, 1, -1) * (start != end)
    _, which = np.unique(edges, return_inverse=True)
    return int(np.count_nonzero(np.bincount(which.reshape(-1), weights=ways)))
