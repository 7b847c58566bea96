"""Free pieces that begin inside of others: simulators would shoot them out.

Full models only touch. The blocks of `bake --detail boxes` overlap where a chair stands under a table, and so may pieces that
were moved by hand. Such pieces are fixed.
"""

from __future__ import annotations

import numpy as np

from ..checks.bodies import Part, part_of, unit
from ..checks.overlap import convex_overlap

from .bodies import Body, Box, Collider

# Metres that shapes may overlap: contacts push them apart by this much without a jump.
LEAST_PRESSING = 0.002


def fix_pressed(bodies: list[Body]) -> None:
    """Fixes each free piece that overlaps another body."""
    placed = [[part_at(collider, body.pose) for collider in body.colliders] for body in bodies]
    boxes = [box_of(parts) for parts in placed]
    lows, highs = np.stack([low for low, _ in boxes]), np.stack([high for _, high in boxes])
    pressed = []
    for number, body in enumerate(bodies):
        if body.is_free:
            near = (np.minimum(highs, highs[number]) - np.maximum(lows, lows[number])).min(axis=1) > LEAST_PRESSING
            near[number] = False
            if any(overlaps(placed[number], placed[other]) for other in np.flatnonzero(near)):
                pressed.append(body)
    for body in pressed:
        body.is_free, body.inertia = False, None


def part_at(collider: Collider, pose: np.ndarray) -> Part:
    if isinstance(collider, Box):
        axes = (pose[:3, :3] @ collider.turn).T
        corners = collider.corners @ pose[:3, :3].T + pose[:3, 3]
        return Part(corners, np.zeros((0, 3), int), True, axes, axes)
    part = part_of(collider.corners, collider.triangles)
    turn = pose[:3, :3].T
    return Part(part.corners @ turn + pose[:3, 3], part.triangles, part.is_convex, unit(part.directions @ turn),
                unit(part.normals @ turn))


def box_of(parts: list[Part]) -> tuple[np.ndarray, np.ndarray]:
    """Around all parts of a body; a body without shapes is nowhere."""
    if not parts:
        return np.full(3, np.inf), np.full(3, -np.inf)
    return np.min([part.low for part in parts], axis=0), np.max([part.high for part in parts], axis=0)


def overlaps(parts: list[Part], others: list[Part]) -> bool:
    """Whether two shapes overlap; simulators see hulls, so that parts count as convex."""
    low, high = box_of(parts)
    near = [other for other in others if (np.minimum(high, other.high) - np.maximum(low, other.low)).min() > LEAST_PRESSING]
    return any((np.minimum(one.high, other.high) - np.maximum(one.low, other.low)).min() > LEAST_PRESSING
               and convex_overlap(one, other, LEAST_PRESSING) > LEAST_PRESSING for one in parts for other in near)
