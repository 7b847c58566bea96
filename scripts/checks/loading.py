"""What trimesh makes of a file."""

from __future__ import annotations

import math
from typing import Iterator

import numpy as np
import trimesh
from trimesh.resolvers import FilePathResolver

from gltf_file import GltfFile

from .report import Note

# Metres: trimesh and the file must agree on bounds to this.
BOUNDS_TOLERANCE = 1e-3


def check_trimesh(gltf: GltfFile) -> Iterator[Note]:
    """What trimesh sees against what the file says."""
    # Floors share geometry and images that lie beside their folders.
    resolver = FilePathResolver(str(gltf.path), allow_anywhere=True)
    scene = trimesh.load_scene(gltf.path, process=False, resolver=resolver)
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
