"""Places of nodes, from the frame of a glTF file to that of the plan."""

from __future__ import annotations

from typing import Any, NamedTuple

from .records import Quaternion, Vector

UNMOVED: Vector = (0.0, 0.0, 0.0)
UNTURNED: Quaternion = (0.0, 0.0, 0.0, 1.0)


class Pose(NamedTuple):
    """Where a node stands in a file, y up."""

    position: Vector = UNMOVED
    rotation: Quaternion = UNTURNED

    def child(self, node: dict[str, Any]) -> Pose:
        """The pose of a node below this one. Raises ValueError for what no bake has: sheared and scaled nodes."""
        if "matrix" in node or list(node.get("scale", (1, 1, 1))) != [1, 1, 1]:
            raise ValueError("it is scaled, or has a matrix, as no node of a bake")
        x, y, z = map(float, node.get("translation", UNMOVED))
        a, b, c, w = map(float, node.get("rotation", UNTURNED))
        moved = turned((x, y, z), self.rotation)
        at, step = self.position, moved
        return Pose((at[0] + step[0], at[1] + step[1], at[2] + step[2]), product(self.rotation, (a, b, c, w)))

    def in_plan(self) -> Pose:
        """The same pose with z up: the file has (x, y, z) where the plan has (x, -z, y)."""
        x, y, z = self.position
        a, b, c, w = self.rotation
        return Pose((x, -z, y), (a, -c, b, w))


def product(first: Quaternion, second: Quaternion) -> Quaternion:
    """The turn `second`, and then `first`."""
    ax, ay, az, aw = first
    bx, by, bz, bw = second
    return (aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz)


def turned(vector: Vector, rotation: Quaternion) -> Vector:
    x, y, z, w = rotation
    back = (-x, -y, -z, w)
    a, b, c, _ = product(product(rotation, (*vector, 0.0)), back)
    return (a, b, c)
