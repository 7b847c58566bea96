"""Reads one .glb or .gltf file: its document, its buffers as arrays, its nodes with their places.

Shared by validate.py, judge.py and convert.py, which must see nodes as the file has them: most libraries split a mesh
with several materials into several nodes. Raises GltfError for everything that is wrong with a file, and reads no file
but those that resources.py lets it name.
"""

from __future__ import annotations

import base64
import itertools
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from urllib.parse import unquote

import numpy as np

from .gltf_document import GltfError, ImageError, OutsideError, read_document
from .resources import MOST_BYTES, MOST_IMAGE_BYTES, ForbiddenError, ResourceError, locate, reach_of, read_file, shown

COMPONENT_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
COMPONENT_COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT3": 9, "MAT4": 16}
TRIANGLES = 4
# Bytes of all arrays of a file together, each as often as something reads it: a floor of 10,000 pieces has a hundredth.
MOST_ARRAY_BYTES = 2**31
# The first bytes of image files, and the endings of their names.
IMAGE_ENDINGS = {b"\x89PNG\r\n\x1a\n": ".png", b"\xff\xd8\xff": ".jpg", b"RIFF": ".webp"}


@dataclass(frozen=True)
class Node:
    """One node of the tree, in document order of a walk from the roots."""

    index: int
    name: str
    parent: Node | None
    extras: dict
    mesh: int | None
    local: np.ndarray  # 4 x 4, in the parent's frame
    world: np.ndarray  # 4 x 4

    @property
    def kind(self) -> str:
        return self.extras.get("kind", "")


class GltfFile:
    """One file; arrays are read when they are asked for."""

    def __init__(self, path: Path, asked_for: Path | None = None):
        """`asked_for` is the folder of the command line that the file was found in, if it was."""
        self.path = Path(path)
        self.reach = reach_of(self.path, asked_for)
        self.document, self._binary_chunk = read_document(self.path, None if asked_for is None else self.reach)
        self._buffers: dict[int, bytes] = {}
        self._meshes: dict[int, list[dict]] = {}
        self._array_bytes = 0

    def entry(self, kind: str, index: object) -> dict:
        """An entry of one of the document's lists."""
        listed = self.document.get(kind, [])
        if type(index) is not int or type(listed) is not list or not 0 <= index < len(listed):
            raise GltfError(f"{kind}[{shown(index)}] is not there")
        if type(listed[index]) is not dict:
            raise GltfError(f"{kind}[{index}]: {shown(listed[index])} is no object")
        return listed[index]

    def name_of(self, kind: str, index: object) -> str:
        """The name of an entry, or an empty text."""
        name = self.entry(kind, index).get("name")
        return name if type(name) is str else ""

    @cached_property
    def nodes(self) -> list[Node]:
        """Every node reachable from the default scene, parents before children."""
        count = len(self.document.get("nodes", []))
        if not self.document.get("scenes"):
            raise GltfError("the file has no scene")
        roots = self.entry("scenes", self.document.get("scene", 0)).get("nodes", [])
        stack = [(root, None) for root in reversed(roots)]
        found: list[Node] = []
        while stack:
            index, parent = stack.pop()
            node = self._node(index, parent)
            if len(found) >= count:
                raise GltfError("the node tree has a cycle")
            found.append(node)
            stack.extend((child, node) for child in reversed(self.entry("nodes", index).get("children", [])))
        return found

    def _node(self, index: object, parent: Node | None) -> Node:
        raw = self.entry("nodes", index)
        name, extras, mesh = raw.get("name", ""), raw.get("extras") or {}, raw.get("mesh")
        if type(name) is not str or type(extras) is not dict:
            raise GltfError(f"nodes[{index}]: its name is no text or its extras are no object")
        if mesh is not None:
            self.entry("meshes", mesh)
        local = local_matrix(raw)
        world = local if parent is None else parent.world @ local
        if not np.isfinite(world).all():
            raise GltfError(f"nodes[{index}]: its place is no place")
        return Node(index, name, parent, extras, mesh, local, world)

    def primitives(self, mesh: int) -> list[dict]:
        """The primitives of a mesh: positions, normals (or None), coordinates by set, triangles, material (or None)."""
        if mesh not in self._meshes:
            raw = self.entry("meshes", mesh).get("primitives")
            if type(raw) is not list or not raw:
                raise GltfError(f"meshes[{mesh}] has no primitives")
            self._meshes[mesh] = [self._primitive(primitive) for primitive in raw]
        return self._meshes[mesh]

    def _primitive(self, primitive: dict) -> dict:
        if primitive.get("mode", TRIANGLES) != TRIANGLES:
            raise GltfError(f"a primitive is no list of triangles but of mode {primitive['mode']}")
        attributes = primitive["attributes"]
        positions = self.accessor(attributes["POSITION"])
        if "indices" in primitive:
            triangles = self.accessor(primitive["indices"]).reshape(-1, 3).astype(np.int64)
        else:
            triangles = np.arange(len(positions)).reshape(-1, 3)
        if positions.shape[1:] != (3,) or not np.isfinite(positions).all():
            raise GltfError("corners of a primitive are no places")
        if triangles.min() < 0 or triangles.max() >= len(positions):
            raise GltfError("a triangle of a primitive names a corner that is not there")
        normals = self.accessor(attributes["NORMAL"]) if "NORMAL" in attributes else None
        # The sets of a primitive count from 0 without gaps.
        names = itertools.takewhile(attributes.__contains__, (f"TEXCOORD_{number}" for number in itertools.count()))
        return {"positions": positions, "triangles": triangles, "material": primitive.get("material"),
                "normals": normals, "coordinates": [self.accessor(attributes[name]) for name in names]}

    def accessor(self, index: int) -> np.ndarray:
        """An accessor as an array of rows; normalised integers become numbers up to one."""
        accessor = self.entry("accessors", index)
        if "sparse" in accessor or "bufferView" not in accessor:
            raise GltfError(f"accessors[{index}] is sparse or empty, which roomwright does not write")
        view = self.entry("bufferViews", accessor["bufferView"])
        kind = np.dtype(COMPONENT_TYPES[accessor["componentType"]])
        width, count = COMPONENT_COUNTS[accessor["type"]], accessor["count"]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width * kind.itemsize)
        data = self.buffer(view["buffer"])
        # Rows that lie on each other would make much of little.
        if count < 1 or start < 0 or stride < width * kind.itemsize:
            raise GltfError(f"accessors[{index}] has no rows, or such as lie on each other or before its buffer")
        if start + (count - 1) * stride + width * kind.itemsize > len(data):
            raise GltfError(f"accessors[{index}] reaches past the end of its buffer")
        self._array_bytes += count * width * kind.itemsize
        if self._array_bytes > MOST_ARRAY_BYTES:
            raise GltfError(f"its arrays, as often as they are used, have more than {MOST_ARRAY_BYTES} bytes")
        rows = np.ndarray((count, width), kind, data, start, (stride, kind.itemsize))
        if accessor.get("normalized"):
            return np.maximum(rows / np.iinfo(kind).max, -1.0)
        return rows[:, 0] if width == 1 else rows

    def buffer(self, index: int) -> bytes:
        """The bytes of a buffer: the file's own chunk, a data URI, or an external file."""
        if index not in self._buffers:
            entry = self.entry("buffers", index)
            if "uri" in entry:
                data = self._resource(f"buffers[{index}].uri", entry["uri"])
            else:
                data = self._binary_chunk
            if data is None or len(data) < entry["byteLength"]:
                raise GltfError(f"buffers[{index}] is shorter than its {entry['byteLength']} bytes")
            self._buffers[index] = data
        return self._buffers[index]

    def image(self, index: int) -> tuple[bytes, str]:
        """The bytes of an image, and the ending that files with such bytes have."""
        entry = self.entry("images", index)
        if "bufferView" in entry:
            view = self.entry("bufferViews", entry["bufferView"])
            start = view.get("byteOffset", 0)
            data = bytes(self.buffer(view["buffer"])[start:start + view["byteLength"]])
        else:
            data = self._resource(f"images[{index}].uri", entry.get("uri"), MOST_IMAGE_BYTES, ImageError)
        for beginning, ending in IMAGE_ENDINGS.items():
            if data.startswith(beginning):
                return data, ending
        raise ImageError(f"images[{index}] is neither PNG nor JPEG nor WebP")

    def image_file(self, index: int) -> Path | None:
        """The file of an image that has one of its own, by the links that lead to it."""
        uri = self.entry("images", index).get("uri", "data:")
        if is_data(uri):
            return None
        self._located(f"images[{index}].uri", uri, ImageError)
        return Path(os.path.normpath(self.path.parent / unquote(uri)))

    def _resource(self, place: str, uri: object, most: int = MOST_BYTES, fault: type[GltfError] = GltfError) -> bytes:
        try:
            if is_data(uri):
                return base64.b64decode(uri.partition(",")[2])
            return read_file(self._located(place, uri, fault), most)
        except ForbiddenError as error:
            raise OutsideError(f"{place}: {shown(uri)}: {error}") from error
        except (ResourceError, ValueError) as error:
            raise fault(f"{place}: {shown(uri)}: {error}") from error

    def _located(self, place: str, uri: object, fault: type[GltfError]) -> Path:
        try:
            return locate(uri, self.reach)
        except ForbiddenError as error:
            raise OutsideError(f"{place}: {error}") from error
        except ResourceError as error:
            raise fault(f"{place}: {error}") from error


def is_data(uri: object) -> bool:
    """Whether a URI holds its bytes itself."""
    return isinstance(uri, str) and uri.startswith("data:")


def local_matrix(node: dict) -> np.ndarray:
    """A node's place in its parent's frame."""
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    matrix = np.identity(4)
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, :3] *= node.get("scale", (1.0, 1.0, 1.0))
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix
