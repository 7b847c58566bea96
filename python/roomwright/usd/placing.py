"""Transforms of nodes, and door leaves that turn on their hinges.

In the glTF file, a door leaf is as far open as it was baked. Here it has three operations that give the same place:
`translate:hinge` and `rotateY:shut` put it into its frame, and `rotateY:swing` opens it: degrees, 0 is shut. `swing` in its
customData holds the lowest and the highest angle.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np
from pxr import Gf, Sdf, Vt

from ..gltf_file import Node

from .specs import Types, attribute, transform_order

# The place of what stands where its parent stands.
UNMOVED = np.identity(4)
HINGE = "xformOp:translate:hinge"
SHUT = "xformOp:rotateY:shut"
SWING = "xformOp:rotateY:swing"
UP = "xformOp:rotateX:up"
# A leaf that was scaled or tipped over by hand has no swing.
RIGID = 1e-5


@dataclass(frozen=True)
class Swing:
    """How a leaf turns about the vertical through its origin. Degrees, counter-clockwise from above."""

    shut: float  # of the leaf's frame in its parent when it is shut
    now: float  # from there to where it stands
    full: float  # from there to where it is fully open

    @property
    def limits(self) -> tuple[float, float]:
        """Lowest and highest turn: what the plan allows and where it stands."""
        return min(0.0, self.full, self.now), max(0.0, self.full, self.now)


def place(prim: Sdf.PrimSpec, local: np.ndarray, before: tuple[str, ...] = ()) -> None:
    """The transform of a prim, after the operations that it has."""
    order = list(before)
    if local is not UNMOVED and (local != UNMOVED).any():
        matrix = Gf.Matrix4d(*local.T.reshape(-1).tolist())
        attribute(prim, "xformOp:transform", Types.Matrix4d, matrix)
        order.append("xformOp:transform")
    transform_order(prim, order)


def turn_up(prim: Sdf.PrimSpec) -> str:
    """Lays what is Y up into a stage that is Z up; the operation's name."""
    attribute(prim, UP, Types.Float, 90.0)
    return UP


def place_leaf(prim: Sdf.PrimSpec, local: np.ndarray, swing: Swing) -> None:
    attribute(prim, HINGE, Types.Double3, Gf.Vec3d(*local[:3, 3].tolist()))
    attribute(prim, SHUT, Types.Double, swing.shut)
    attribute(prim, SWING, Types.Double, swing.now)
    transform_order(prim, [HINGE, SHUT, SWING])
    data = dict(prim.customData)
    prim.SetInfo("customData", {**data, "swing": Vt.DoubleArray(list(swing.limits))})


def swing_of(node: Node) -> Swing | None:
    """How a node turns, if it is a leaf on hinges."""
    match = re.fullmatch(r"leaf(?:\.(\d+))?", node.extras.get("id", "")) if node.parent is not None else None
    if match is None or node.kind != "part" or node.parent.kind != "opening":
        return None
    leaves, number = node.parent.extras.get("leaves", []), int(match[1] or 1) - 1
    if number >= len(leaves) or not turns_about_the_vertical(node.local):
        return None
    leaf = leaves[number]
    # The opening's node stands in the plan's frame or turned in it; the leaf's angle is asked in its parent.
    parent = degrees_about_the_vertical(node.parent.world)
    shut = round(half_turn(plan_angle(leaf["hinge"], leaf["closed"]) - parent), 9)
    full = half_turn(plan_angle(leaf["hinge"], leaf["open"]) - parent - shut)
    now = half_turn(degrees_about_the_vertical(node.local) - shut)
    # Half a turn may be measured either way round; both angles are given the same way.
    return Swing(shut, now + 360.0 * round((full - now) / 360.0), round(full, 6))


def turns_about_the_vertical(local: np.ndarray) -> bool:
    turn = math.radians(degrees_about_the_vertical(local))
    expected = [[math.cos(turn), 0.0, math.sin(turn)], [0.0, 1.0, 0.0], [-math.sin(turn), 0.0, math.cos(turn)]]
    return bool(np.abs(local[:3, :3] - expected).max() < RIGID)


def degrees_about_the_vertical(matrix: np.ndarray) -> float:
    return math.degrees(math.atan2(-matrix[2, 0], matrix[0, 0]))


def plan_angle(start: list[float], end: list[float]) -> float:
    """Of a direction in the plan, which is x east and y north: counter-clockwise from above there and here."""
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))


def half_turn(degrees: float) -> float:
    """The same direction between -180 and 180."""
    return (degrees + 180.0) % 360.0 - 180.0
