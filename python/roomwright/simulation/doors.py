"""Leaves of doors: hinges and slides, with the range that the plan gives them.

A hinge turns between shut (0) and open, about the upright edge where the leaf's node has its origin. A sliding leaf runs
along its wall until it lies behind the other leaf, or beside the opening where it is the only one.
"""

from __future__ import annotations

import math

import numpy as np

from ..gltf_file import GltfFile, Node
from ..usd.physics import leaf_mass
from ..usd.placing import swing_of

from .bodies import Collider, Inertia, Joint

UP_AXIS = (0.0, 0.0, 1.0)
# Damping and dry friction of leaves (newton metres and seconds, newtons and seconds): a door that is let go stops and stays,
# and ten newtons at the handle move it.
RESISTANCE = {"hinge": (2.0, 1.0), "slide": (10.0, 4.0)}
# Metres of a pair's leaves that stay beside each other's ends when one is fully open, for the stiles to stay in line.
OVERLAP = 0.06
# Metres that a leaf's body keeps from its frame.
CLEARANCE = 0.004
# Kilograms of a leaf whose surface is not closed.
LEAST_MASS = 1.0


def is_leaf(node: Node) -> bool:
    return (node.kind == "part" and node.extras.get("part") == "leaf" and node.mesh is not None
            and node.parent is not None and node.parent.kind == "opening")


def joint_of(gltf: GltfFile, node: Node) -> Joint | None:
    """How a leaf moves; not at all where its node was scaled or tipped over by hand."""
    swing = swing_of(node)
    if swing is not None:
        low, high = (math.radians(limit) for limit in swing.limits)
        return Joint("hinge", UP_AXIS, low, high, math.radians(swing.now))
    if node.parent.extras.get("closure") == "sliding":
        return slide_of(gltf, node)
    return None


def slide_of(gltf: GltfFile, node: Node) -> Joint:
    """Along x of the opening, towards the other leaf; the only leaf runs towards its own end of the wall."""
    own = extent(gltf, node)
    others = [extent(gltf, other) for other in gltf.nodes
              if is_leaf(other) and other.parent is node.parent and other is not node]
    way = own[1] - own[0] - (OVERLAP if others else 0.0)
    middle = (own[0] + own[1]) / 2
    is_towards_east = not others or sum(sum(other) / 2 for other in others) / len(others) > middle
    return Joint("slide", (1.0 if is_towards_east else -1.0, 0.0, 0.0), 0.0, max(way, 0.0), 0.0)


def extent(gltf: GltfFile, node: Node) -> tuple[float, float]:
    """From where to where a leaf reaches along its opening."""
    corners = np.concatenate([primitive["positions"] for primitive in gltf.primitives(node.mesh)])
    along = corners @ node.local[0, :3] + node.local[0, 3]
    return float(along.min()), float(along.max())


def leaf_inertia(gltf: GltfFile, node: Node, low: np.ndarray, high: np.ndarray) -> Inertia:
    return box_inertia(max(leaf_mass(gltf, node.mesh), LEAST_MASS), low, high)


def without_fittings(colliders: list[Collider]) -> list[Collider]:
    """The shapes of a hinged leaf without its hinges, which reach from its body into the frame."""
    body = max(colliders, key=lambda collider: collider.volume)
    start = body.corners[:, 0].min() - CLEARANCE
    return [collider for collider in colliders if collider.corners[:, 0].min() >= start]


def box_inertia(mass: float, low: np.ndarray, high: np.ndarray, centre: np.ndarray | None = None) -> Inertia:
    """Of a mass that fills a box evenly; `centre` where it is known better."""
    squares = np.maximum(high - low, 0.002) ** 2
    return Inertia(mass, (low + high) / 2 if centre is None else centre, mass / 12 * (squares.sum() - squares))
