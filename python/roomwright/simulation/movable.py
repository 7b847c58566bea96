"""The pieces that are free bodies, and their masses.

A piece is free if it stands on the floor or on another piece, is mounted to nothing, and weighs no more than the limit. The
pieces on a free piece are free as well; a piece that carries one that is not stays where it is.
"""

from __future__ import annotations

import numpy as np

from ..gltf_file import GltfFile, Node
from ..usd.physics import HANGING, furniture_mass, is_fixed

from .bodies import Collider, Inertia
from .doors import box_inertia

# Kilograms that a person moves without thinking: chairs, small tables, lamps, plants in pots.
LIGHT = 20.0
LEAST_MASS = 0.02


def movable_pieces(gltf: GltfFile, heaviest: float) -> set[int]:
    """The numbers of the nodes of free pieces."""
    pieces = [node for node in gltf.nodes if node.kind == "furniture"]
    free = {node.index for node in pieces if node.mesh is not None and is_free_by_itself(node, heaviest)}
    # Children come after their parents in the list.
    for node in reversed(pieces):
        if node.index not in free and node.parent is not None:
            free.discard(node.parent.index)
    return free


def is_free_by_itself(node: Node, heaviest: float) -> bool:
    if is_fixed(node) or furniture_mass(node) > heaviest:
        return False
    if node.parent is not None and node.parent.kind == "furniture":
        return node.extras.get("side") == "above"
    return abs(node.world[1, 3]) <= HANGING


def piece_inertia(node: Node, colliders: list[Collider]) -> Inertia:
    """The mass by the volume of the box, its centre by the volumes of the parts, its inertia that of the box."""
    corners = np.concatenate([collider.corners for collider in colliders])
    volumes = np.array([collider.volume for collider in colliders])
    centres = np.stack([collider.centre for collider in colliders])
    centre = volumes @ centres / volumes.sum()
    return box_inertia(max(furniture_mass(node), LEAST_MASS), corners.min(axis=0), corners.max(axis=0), centre)
