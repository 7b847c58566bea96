"""The same file read by trimesh, an independent reader."""

from __future__ import annotations

import math
from io import BytesIO
from typing import Iterator

import numpy as np
import trimesh
from trimesh.resolvers import Resolver

from ..gltf_file import GltfFile
from ..resources import locate, read_file

from .report import Note

# Metres: trimesh and the file must agree on bounds to this.
BOUNDS_TOLERANCE = 1e-3


class OwnResolver(Resolver):
    """Gives trimesh what the file may name, which includes what floors share beside their folders."""

    def __init__(self, gltf: GltfFile):
        self.reach = gltf.reach

    def get(self, key: str) -> bytes:
        return read_file(locate(key, self.reach))

    def keys(self) -> tuple:
        return ()

    def write(self, name: str, data) -> None:
        raise NotImplementedError("nothing is written here")

    def namespaced(self, namespace: str) -> OwnResolver:
        raise NotImplementedError("a glTF file names files one by one")


def check_trimesh(gltf: GltfFile) -> Iterator[Note]:
    """Instances and bounds that trimesh reads, against those of the file."""
    # trimesh reads all arrays, and would believe lengths that no buffer has.
    for number in range(len(gltf.document.get("accessors", []))):
        gltf.accessor(number)
    data, kind = BytesIO(read_file(gltf.path)), gltf.path.suffix.lower()[1:]
    scene = trimesh.load_scene(data, file_type=kind, process=False, resolver=OwnResolver(gltf))
    expected = sum(len(gltf.primitives(node.mesh)) for node in gltf.nodes if node.mesh is not None)
    found = len(scene.graph.nodes_geometry)
    if found != expected:
        yield Note("trimesh", "", f"trimesh sees {found} pieces of geometry, the file has {expected}")
    missing = [node.name for node in gltf.nodes if node.name not in scene.graph.nodes]
    if missing:
        yield Note("trimesh", missing[0], f"trimesh misses {len(missing)} nodes")
    if expected:
        low, high = world_bounds(gltf)
        apart = np.abs(scene.bounds - [low, high]).max()
        if not apart <= BOUNDS_TOLERANCE:
            yield Note("trimesh", "", f"trimesh sees bounds that differ by {apart:.4f} m")


def world_bounds(gltf: GltfFile) -> tuple[np.ndarray, np.ndarray]:
    low, high = np.full(3, math.inf), np.full(3, -math.inf)
    for node in gltf.nodes:
        if node.mesh is None:
            continue
        for primitive in gltf.primitives(node.mesh):
            world = primitive["positions"] @ node.world[:3, :3].T + node.world[:3, 3]
            low, high = np.minimum(low, world.min(axis=0)), np.maximum(high, world.max(axis=0))
    return low, high
