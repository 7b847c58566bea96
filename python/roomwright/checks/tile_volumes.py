"""Boxes of tilesets, and what they hold.

A box is its middle and three half axes (3D Tiles 1.1, section 7.3.4.1), in the frame of its tile: z up. glTF has y up; tiles are
turned about x by a quarter when they are shown (section 7.3.2.1).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..gltf_file import GltfFile, Node, local_matrix
from ..resources import Reach

# Metres. Writers round boxes to millimetres, outwards.
TOLERANCE = 1e-3
# Cosine of the angle of two axes of a box that counts as square.
SQUARE = 1e-6
SIGNS = np.array(list(itertools.product((-1.0, 1.0), repeat=3)))
INSTANCING = "EXT_mesh_gpu_instancing"


class Box(NamedTuple):
    """A box anywhere, turned anyhow."""

    middle: np.ndarray
    half_axes: np.ndarray  # one a row

    @classmethod
    def of(cls, numbers: list[float]) -> Box:
        rows = np.array(numbers, float).reshape(4, 3)
        return cls(rows[0], rows[1:])

    def corners(self) -> np.ndarray:
        return self.middle + SIGNS @ self.half_axes

    def is_square(self) -> bool:
        """Whether its axes are at right angles; an axis without length is at every angle."""
        lengths = np.linalg.norm(self.half_axes, axis=1)
        products = self.half_axes @ self.half_axes.T
        return all(abs(products[one, other]) <= SQUARE * lengths[one] * lengths[other]
                   for one, other in itertools.combinations(range(3), 2))

    def excess(self, points: np.ndarray) -> float:
        """Metres by which the farthest of some points is outside, along the axis where it is farthest; negative inside."""
        lengths = np.linalg.norm(self.half_axes, axis=1)
        known = lengths > 0.0
        if not known.any():
            return float(np.abs(points - self.middle).max())
        directions = self.half_axes[known] / lengths[known, None]
        return float((np.abs((points - self.middle) @ directions.T) - lengths[known]).max())


def placed(transform: list[float] | None, points: np.ndarray) -> np.ndarray:
    """Points of a tile's frame in that of its parent."""
    if transform is None:
        return points
    matrix = np.array(transform, float).reshape(4, 4).T
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def transform_fault(transform: list[float]) -> str | None:
    """Why a transform is none."""
    matrix = np.array(transform, float).reshape(4, 4).T
    if not np.array_equal(matrix[3], (0.0, 0.0, 0.0, 1.0)):
        return "its last row is not 0, 0, 0, 1"
    if not np.linalg.det(matrix[:3, :3]) > 0.0:
        return "it mirrors or flattens what it places"
    return None


class Content(NamedTuple):
    """What a tileset asks of a glTF file."""

    low: np.ndarray  # of all that is drawn, in the frame of the tile
    high: np.ndarray
    files: tuple[Path, ...]  # that it names


def content_of(asked: tuple[Path, Path]) -> Content:
    """The bounds of a file, and the files that it names; `asked`: the file, and the folder of its tileset."""
    file, folder = asked
    gltf = GltfFile(file, folder)
    corners = np.concatenate([part for node in gltf.nodes if node.mesh is not None for part in _extremes(gltf, node)])
    east, up, south = corners.T
    upright = np.stack([east, -south, up], axis=1)
    return Content(upright.min(axis=0), upright.max(axis=0), tuple(_named_files(gltf)))


def _extremes(gltf: GltfFile, node: Node) -> Iterator[np.ndarray]:
    """The lowest and highest corner of each instance of each primitive of a node."""
    places = [node.world @ place for place in instance_matrices(gltf, node)]
    for primitive in gltf.primitives(node.mesh):
        for matrix in places:
            corners = primitive["positions"] @ matrix[:3, :3].T + matrix[:3, 3]
            yield np.stack([corners.min(axis=0), corners.max(axis=0)])


def instance_matrices(gltf: GltfFile, node: Node) -> list[np.ndarray]:
    """The places of the instances of a node in its frame; one, if it is none of several."""
    instancing = gltf.entry("nodes", node.index).get("extensions", {}).get(INSTANCING)
    if instancing is None:
        return [np.identity(4)]
    names = {"TRANSLATION": "translation", "ROTATION": "rotation", "SCALE": "scale"}
    rows = {names[key]: gltf.accessor(index) for key, index in instancing["attributes"].items() if key in names}
    return [local_matrix(dict(zip(rows, values))) for values in zip(*rows.values())]


def _named_files(gltf: GltfFile) -> Iterator[Path]:
    images = (gltf.image_file(index) for index in range(len(gltf.document.get("images", []))))
    yield from {path for path in images if path is not None}


def reach_in(file: Path, folder: Path) -> Reach:
    """What a file of a tileset may name: whatever is in the folder of the tileset."""
    return Reach(file.resolve().parent, (folder.resolve(),))
