"""The objects of a level with their rooms and meshes, for everything that is measured."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..gltf_file import GltfFile, Node

from .bodies import Part, parts_of
from .contract import named_parents, room_of
from .schemas import extras_schemas

# Metres of height up to which what lies on the floor is floor (`COVERING_HEIGHT` in src/catalog/class.rs), and a millimetre.
COVERING_HEIGHT = 0.021


@dataclass
class Meshes:
    """The meshes of a file: their corners, and their parts on request."""

    gltf: GltfFile

    def __post_init__(self):
        self.known: dict[int, np.ndarray] = {}
        self.split: dict[int, list[Part]] = {}

    def corners(self, mesh: int) -> np.ndarray:
        if mesh not in self.known:
            primitives = self.gltf.primitives(mesh)
            self.known[mesh] = np.concatenate([primitive["positions"] for primitive in primitives]).astype(float)
        return self.known[mesh]

    def parts(self, mesh: int) -> list[Part]:
        if mesh not in self.split:
            self.split[mesh] = parts_of(self.gltf.primitives(mesh))
        return self.split[mesh]


@dataclass(eq=False)
class Piece:
    """A piece of furniture where it stands, in the scene's frame: x east, y up, z south."""

    node: Node
    room: Node
    meshes: Meshes

    @cached_property
    def corners(self) -> np.ndarray:
        return self.meshes.corners(self.node.mesh) @ self.node.world[:3, :3].T + self.node.world[:3, 3]

    @cached_property
    def box(self) -> np.ndarray:
        """The corners of the mesh's own box."""
        own = self.meshes.corners(self.node.mesh)
        sides = np.stack([own.min(axis=0), own.max(axis=0)])
        corners = np.stack(np.meshgrid(*sides.T), axis=-1).reshape(-1, 3)
        return corners @ self.node.world[:3, :3].T + self.node.world[:3, 3]

    @cached_property
    def low(self) -> np.ndarray:
        return self.corners.min(axis=0)

    @cached_property
    def high(self) -> np.ndarray:
        return self.corners.max(axis=0)

    @cached_property
    def parts(self) -> list[Part]:
        return [part.placed(self.node.world) for part in self.meshes.parts(self.node.mesh)]

    @property
    def is_covering(self) -> bool:
        """Whether it lies on the floor of its room so flat that others stand on it: a rug."""
        return self.node.parent is self.room and self.high[1] - self.room.world[1, 3] <= COVERING_HEIGHT

    def stands_on(self, other: Piece) -> bool:
        """Whether it belongs to another piece, directly or over others."""
        above = self.node.parent
        while above is not None and above is not other.node:
            above = above.parent
        arranged_by = named_parents(self.meshes.gltf, self.node)
        return above is not None or any(other.node is parent for parent in arranged_by)


def pieces_of(gltf: GltfFile) -> list[Piece]:
    """Every piece with a mesh that belongs to a room."""
    meshes = Meshes(gltf)
    schema = extras_schemas()["furniture"]
    rooms = ((node, room_of(node)) for node in gltf.nodes if node.kind == "furniture" and node.mesh is not None)
    return [Piece(node, room, meshes) for node, room in rooms if room is not None and schema.is_usable(node.extras)]
