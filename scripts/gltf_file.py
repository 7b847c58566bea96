"""Reads one .glb or .gltf file: its document, its buffers as arrays, its nodes with their places.

Shared by validate.py and convert.py, which must see nodes as the file has them: most libraries split a mesh
with several materials into several nodes. Raises GltfError for everything that is wrong with a file.
"""

from __future__ import annotations

import base64
import itertools
import json
import struct
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from urllib.parse import unquote

import numpy as np

GLB_MAGIC = 0x46546C67
GLB_JSON_CHUNK = 0x4E4F534A
GLB_BINARY_CHUNK = 0x004E4942
COMPONENT_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
COMPONENT_COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT3": 9, "MAT4": 16}
TRIANGLES = 4


class GltfError(Exception):
    """A file that cannot be read; the text says why."""


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

    def __init__(self, path: Path):
        self.path = Path(path)
        self.document, self._binary_chunk = _read_document(self.path)
        self._buffers: dict[int, bytes] = {}
        self._meshes: dict[int, list[dict]] = {}

    @cached_property
    def nodes(self) -> list[Node]:
        """Every node reachable from the default scene, parents before children."""
        listed = self.document.get("nodes", [])
        scenes = self.document.get("scenes", [])
        if not scenes:
            raise GltfError("the file has no scene")
        roots = scenes[self.document.get("scene", 0)].get("nodes", [])
        stack = [(root, None) for root in reversed(roots)]
        found: list[Node] = []
        while stack:
            index, parent = stack.pop()
            if len(found) >= len(listed):
                raise GltfError("the node tree has a cycle")
            raw = listed[index]
            local = local_matrix(raw)
            world = local if parent is None else parent.world @ local
            node = Node(index, raw.get("name", ""), parent, raw.get("extras") or {}, raw.get("mesh"), local, world)
            found.append(node)
            stack.extend((child, node) for child in reversed(raw.get("children", [])))
        return found

    def primitives(self, mesh: int) -> list[dict]:
        """The primitives of a mesh: positions, normals (or None), coordinates by set, triangles, material (or None)."""
        if mesh not in self._meshes:
            raw = self.document["meshes"][mesh]["primitives"]
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
        normals = self.accessor(attributes["NORMAL"]) if "NORMAL" in attributes else None
        # The sets of a primitive count from 0 without gaps.
        names = itertools.takewhile(attributes.__contains__, (f"TEXCOORD_{number}" for number in itertools.count()))
        return {"positions": positions, "triangles": triangles, "material": primitive.get("material"),
                "normals": normals, "coordinates": [self.accessor(attributes[name]) for name in names]}

    def accessor(self, index: int) -> np.ndarray:
        """An accessor as an array of rows; normalised integers become numbers up to one."""
        accessor = self.document["accessors"][index]
        if "sparse" in accessor or "bufferView" not in accessor:
            raise GltfError(f"accessor {index} is sparse or empty, which nothing here writes")
        view = self.document["bufferViews"][accessor["bufferView"]]
        kind = np.dtype(COMPONENT_TYPES[accessor["componentType"]])
        width, count = COMPONENT_COUNTS[accessor["type"]], accessor["count"]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width * kind.itemsize)
        data = self.buffer(view["buffer"])
        if start + (count - 1) * stride + width * kind.itemsize > len(data):
            raise GltfError(f"accessor {index} reaches past the end of its buffer")
        rows = np.ndarray((count, width), kind, data, start, (stride, kind.itemsize))
        if accessor.get("normalized"):
            return np.maximum(rows / np.iinfo(kind).max, -1.0)
        return rows[:, 0] if width == 1 else rows

    def buffer(self, index: int) -> bytes:
        """The bytes of a buffer: the file's own chunk, a data URI, or an external file."""
        if index not in self._buffers:
            entry = self.document["buffers"][index]
            data = self._binary_chunk if "uri" not in entry else self._resource(entry["uri"])
            if data is None or len(data) < entry["byteLength"]:
                raise GltfError(f"buffer {index} is shorter than its {entry['byteLength']} bytes")
            self._buffers[index] = data
        return self._buffers[index]

    def image(self, index: int) -> tuple[bytes, str]:
        """The bytes of an image and the ending of its file name."""
        entry = self.document["images"][index]
        ending = {"image/png": ".png", "image/jpeg": ".jpg"}.get(entry.get("mimeType", ""))
        if "bufferView" in entry:
            view = self.document["bufferViews"][entry["bufferView"]]
            start = view.get("byteOffset", 0)
            return bytes(self.buffer(view["buffer"])[start:start + view["byteLength"]]), ending or ".png"
        return self._resource(entry["uri"]), ending or Path(unquote(entry["uri"])).suffix

    def _resource(self, uri: str) -> bytes:
        if uri.startswith("data:"):
            return base64.b64decode(uri.partition(",")[2])
        try:
            return (self.path.parent / unquote(uri)).read_bytes()
        except OSError as error:
            raise GltfError(f"cannot read {uri}: {error.strerror}") from error


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


def _read_document(path: Path) -> tuple[dict, bytes | None]:
    try:
        data = path.read_bytes()
        if path.suffix.lower() == ".glb":
            text, binary = _split_glb(data)
        else:
            text, binary = data, None
        document = json.loads(text)
    except OSError as error:
        raise GltfError(f"cannot read the file: {error.strerror}") from error
    except (ValueError, struct.error) as error:
        raise GltfError(f"not a glTF file: {error}") from error
    if not isinstance(document, dict):
        raise GltfError("not a glTF file: the document is no object")
    return document, binary


def _split_glb(data: bytes) -> tuple[bytes, bytes | None]:
    magic, version, length = struct.unpack_from("<3I", data)
    if magic != GLB_MAGIC or version != 2:
        raise ValueError("no binary glTF 2.0 header")
    if length != len(data):
        raise ValueError(f"the header says {length} bytes, the file has {len(data)}")
    chunks, offset = {}, 12
    while offset < length:
        size, kind = struct.unpack_from("<2I", data, offset)
        chunks.setdefault(kind, data[offset + 8:offset + 8 + size])
        offset += 8 + size
    if GLB_JSON_CHUNK not in chunks:
        raise ValueError("no JSON chunk")
    return chunks[GLB_JSON_CHUNK], chunks.get(GLB_BINARY_CHUNK)
