"""How deep two solid parts overlap.

Two convex parts: the separating axis theorem (S. Gottschalk, "Separating axis theorem", 1996). Two parts are apart if and
only if they are apart along a normal of a face of one of them or along the cross product of an edge of each. The least
overlap along all these axes is the distance that one must move for the two to part.

A part that is not convex: points a millimetre under the surface of one part that lie inside the other, so that touching
parts have none. At the deepest of these points, the overlap is as thick as its distances from both surfaces together.
"""

from __future__ import annotations

import numpy as np

from .bodies import Part, unit

# Cross products of edges at once; parts with many edges are round, and their normals say nearly all.
MOST_CROSSES = 4000
# Where triangles are asked, as shares of their corners: in the middle, near corners, near the middle of edges.
SAMPLES = np.array([[1, 1, 1], [28, 1, 1], [1, 28, 1], [1, 1, 28], [5, 5, 1], [5, 1, 5], [1, 5, 5]], float)
SAMPLES /= SAMPLES.sum(axis=1, keepdims=True)
# Metres under the surface at which points are asked; thinner sheets are asked by the other part's points.
INSET = 0.001
# A direction that no edge of a model has: rays that graze edges say nothing.
RAY = unit(np.array([[0.5773, 0.6931, 0.4321]]))[0]


def overlap(one: Part, other: Part, tolerance: float) -> float:
    """Metres of overlap; at most `tolerance` where there is none to speak of."""
    boxes = np.minimum(one.high, other.high) - np.maximum(one.low, other.low)
    if boxes.min() <= tolerance:
        return boxes.min()
    if one.is_convex and other.is_convex:
        return convex_overlap(one, other, tolerance)
    return min(max(depth_inside(one, other), depth_inside(other, one)), float(boxes.min()))


def convex_overlap(one: Part, other: Part, tolerance: float) -> float:
    depth = least_overlap(one, other, np.concatenate([one.normals, other.normals]))
    if depth <= tolerance:
        return depth
    crosses = np.cross(one.directions[:, None], other.directions[None]).reshape(-1, 3)
    lengths = np.linalg.norm(crosses, axis=1)
    crosses = crosses[lengths > 1e-3] / lengths[lengths > 1e-3, None]
    return min(depth, least_overlap(one, other, crosses[:MOST_CROSSES])) if len(crosses) else depth


def least_overlap(one: Part, other: Part, axes: np.ndarray) -> float:
    first, second = one.corners @ axes.T, other.corners @ axes.T
    return float((np.minimum(first.max(axis=0) - second.min(axis=0), second.max(axis=0) - first.min(axis=0))).min())


def depth_inside(one: Part, other: Part) -> float:
    """How thick the overlap is at points under the surface of one part that are inside another; 0 where none is."""
    ring = one.corners[one.triangles]
    normals = np.cross(ring[:, 1] - ring[:, 0], ring[:, 2] - ring[:, 0])
    points = (SAMPLES @ ring - unit(normals)[:, None] * INSET).reshape(-1, 3)
    near = ((points > other.low) & (points < other.high)).all(axis=1)
    points = points[near]
    points = points[is_inside(points, other)]
    points = points[is_inside(points, one)]
    return float((plane_distance(points, one) + plane_distance(points, other)).max()) if len(points) else 0.0


def is_inside(points: np.ndarray, part: Part) -> np.ndarray:
    """By the number of times that a ray from each point goes through the surface (T. Moeller, B. Trumbore, 1997)."""
    if len(points) == 0:
        return np.zeros(0, bool)
    origin = part.corners[part.triangles[:, 0]]
    along, across = (part.corners[part.triangles[:, corner]] - origin for corner in (1, 2))
    ray = np.cross(RAY, across)
    scale = np.einsum("ij,ij->i", along, ray)
    scale = np.where(np.abs(scale) < 1e-15, np.inf, scale)
    offset = points[:, None] - origin[None]
    u = np.einsum("pij,ij->pi", offset, ray) / scale
    normal = np.cross(offset, along[None])
    v = normal @ RAY / scale
    t = np.einsum("pij,ij->pi", normal, across) / scale
    return ((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0)).sum(axis=1) % 2 == 1


def plane_distance(points: np.ndarray, part: Part) -> np.ndarray:
    """Metres from each point to the nearest plane of a face: not more than to the surface."""
    ring = part.corners[part.triangles]
    normals = unit(np.cross(ring[:, 1] - ring[:, 0], ring[:, 2] - ring[:, 0]))
    return np.abs(points @ normals.T - np.einsum("ij,ij->i", normals, ring[:, 0])).min(axis=1)
