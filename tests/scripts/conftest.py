"""A small correct floor, built by hand, that the tests of the scripts break or convert."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import struct
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "scripts")]

# Blender's Python has none of what convert.py and validate.py need: their tests are left out there.
TOOLS = ("pxr", "shapely", "trimesh", "tqdm", "jsonschema", "PIL")
LACKS = [module for module in TOOLS if importlib.util.find_spec(module) is None]
NEED_TOOLS = ["test_convert.py", "test_hostile_files.py", "test_judge*.py", "test_pairs.py", "test_readers.py", "test_simulation*.py",
              "test_usd_*.py", "test_validate*.py"]
PLAN_TOOLS = ("shapely", "tqdm", "yaml")
LACKS_OF_PLANS = [module for module in PLAN_TOOLS if importlib.util.find_spec(module) is None]
DRAWING_TOOLS = ("ezdxf", "shapely", "yaml")
LACKS_OF_DRAWINGS = [module for module in DRAWING_TOOLS if importlib.util.find_spec(module) is None]
collect_ignore_glob = [*(NEED_TOOLS if LACKS else []), *(["test_check_plans.py", "test_plan_statistics.py"] if LACKS_OF_PLANS else []),
                       *(["test_dxf_*.py"] if LACKS_OF_DRAWINGS else [])]


def pytest_report_header() -> str:
    lacks = sorted({*LACKS, *LACKS_OF_PLANS, *LACKS_OF_DRAWINGS})
    left_out = f"left out, for {', '.join(lacks)} is not installed: {', '.join(collect_ignore_glob)}"
    return left_out if lacks else "all tests of scripts"


# Corners of a unit box's faces, counter-clockwise seen from outside, with the faces' normals.
FACES = [
    ((0, 0, 1), [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]),
    ((0, 0, -1), [(1, 0, 0), (0, 0, 0), (0, 1, 0), (1, 1, 0)]),
    ((1, 0, 0), [(1, 0, 1), (1, 0, 0), (1, 1, 0), (1, 1, 1)]),
    ((-1, 0, 0), [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)]),
    ((0, 1, 0), [(0, 1, 1), (1, 1, 1), (1, 1, 0), (0, 1, 0)]),
    ((0, -1, 0), [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]),
]


class Floor:
    """A floor under construction: a document and its binary chunk."""

    def __init__(self):
        self.binary = b""
        self.document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [], "meshes": [], "accessors": [], "bufferViews": [],
            "materials": [material("modern.wood", (0.5, 0.3, 0.1, 1.0)), glass()],
        }

    def node(self, name: str, extras: dict, parent: int | None = None, mesh: int | None = None,
             at=(0, 0, 0), turn: float = 0.0) -> int:
        """Adds a node; `at` in the parent's frame (y up), `turn` in radians around y."""
        node = {"name": name, "extras": extras}
        if any(at):
            node["translation"] = list(at)
        if turn:
            node["rotation"] = [0.0, float(np.sin(turn / 2)), 0.0, float(np.cos(turn / 2))]
        if mesh is not None:
            node["mesh"] = mesh
        nodes = self.document["nodes"]
        nodes.append(node)
        if parent is not None:
            nodes[parent].setdefault("children", []).append(len(nodes) - 1)
        return len(nodes) - 1

    def find(self, name: str) -> dict:
        return next(node for node in self.document["nodes"] if node["name"] == name)

    def box_mesh(self, name: str, width: float, depth: float, height: float, parts: int = 1, faces=FACES) -> int:
        """A box over the middle of its underside, stacked from `parts` boxes of alternating material."""
        primitives = []
        for part in range(parts):
            low, high = height * part / parts, height * (part + 1) / parts
            corners = np.array([corner for _, face in faces for corner in face], float)
            positions = (corners - (0.5, 0, 0.5)) * (width, high - low, depth) + (0, low, 0)
            normals = np.repeat([normal for normal, _ in faces], 4, axis=0)
            first = np.arange(len(faces))[:, None] * 4
            triangles = (first + [0, 1, 2, 0, 2, 3]).reshape(-1)
            primitives.append({
                "attributes": {"POSITION": self.accessor(positions.astype("<f4"), "VEC3"),
                               "NORMAL": self.accessor(normals.astype("<f4"), "VEC3")},
                "indices": self.accessor(triangles.astype("<u2"), "SCALAR"), "material": part % 2,
            })
        self.document["meshes"].append({"name": name, "primitives": primitives})
        return len(self.document["meshes"]) - 1

    def accessor(self, rows: np.ndarray, kind: str) -> int:
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": rows.nbytes,
                "target": 34963 if kind == "SCALAR" else 34962}
        entry = {"bufferView": len(self.document["bufferViews"]), "count": len(rows), "type": kind,
                 "componentType": 5123 if kind == "SCALAR" else 5126}
        if kind == "VEC3":
            entry |= {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()}
        self.binary += rows.tobytes() + b"\0" * (-rows.nbytes % 4)
        self.document["bufferViews"].append(view)
        self.document["accessors"].append(entry)
        return len(self.document["accessors"]) - 1

    def write(self, path: Path) -> Path:
        """Writes a .glb, or a .gltf with its .bin beside it."""
        document = dict(self.document)
        if path.suffix == ".gltf":
            (path.parent / "floor.bin").write_bytes(self.binary)
            document["buffers"] = [{"uri": "floor.bin", "byteLength": len(self.binary)}]
            path.write_text(json.dumps(document))
            return path
        document["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        length = 12 + 8 + len(text) + 8 + len(self.binary)
        path.write_bytes(struct.pack("<5I", 0x46546C67, 2, length, len(text), 0x4E4F534A) + text
                         + struct.pack("<2I", len(self.binary), 0x004E4942) + self.binary)
        return path


def material(name: str, color) -> dict:
    return {"name": name, "pbrMetallicRoughness": {"baseColorFactor": list(color), "metallicFactor": 0.0,
                                                   "roughnessFactor": 0.6}}


def glass() -> dict:
    return material("modern.glass", (1.0, 1.0, 1.0, 0.4)) | {"alphaMode": "BLEND"}


def furniture(class_: str, number: int, parent: str, side: str, size) -> dict:
    return {"kind": "furniture", "class": class_, "id": f"{class_}.{number}", "parent": parent, "side": side,
            "size": list(size), "variant": 0}


def build_floor() -> Floor:
    """One room of 4 x 3 m with a door, two desks that share a mesh, one of them turned, and a lamp on it."""
    floor = Floor()
    outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]
    level = floor.node("house/ground", {"kind": "level", "building": "house", "level": "ground", "elevation": 0.0,
                                        "height": 3.0, "seed": 18446744073709551615, "generator": "test"})
    floor.node("door:d1", {"kind": "opening", "opening": "door", "closure": "passage", "id": "d1",
                           "rooms": ["101"], "sides": [{"room": "101", "wall": 0, "from": 1.0, "to": 1.9}],
                           "width": 0.9, "height": 2.0, "sill": 0.0}, level)
    room = floor.node("room:101", {"kind": "room", "room": "101", "type": "office", "style": "default", "seed": "7",
                                   "outline": outline, "holes": [], "height": 2.5, "requested": 4, "placed": 3,
                                   "removed": [{"class": "chair", "reason": "no place", "required": False}], "grade": "none",
                                   "findings": []}, level)
    slab = floor.box_mesh("floor@101", 4.0, 3.0, 0.1)
    floor.node("floor@101", {"kind": "part", "part": "floor", "id": "floor", "tags": []}, room, slab, at=(2.0, -0.1, -1.5))
    desk = floor.box_mesh("desk.0", 1.6, 0.8, 0.74, parts=2)
    lamp = floor.box_mesh("lamp.0", 0.2, 0.2, 0.3)
    size = (1.6, 0.8, 0.74)
    floor.node("desk.1@101", furniture("desk", 1, "wall.0", "front", size), room, desk, at=(1.0, 0.0, -0.4))
    second = floor.node("desk.2@101", furniture("desk", 2, "floor", "above", size), room, desk,
                        at=(3.0, 0.0, -2.0), turn=np.pi / 2)
    floor.node("lamp.1@101", furniture("lamp", 1, "desk.2", "above", (0.2, 0.2, 0.3)), second, lamp,
               at=(0.5, 0.74, 0.1), turn=0.3)
    return floor


def write_manifest(folder: Path) -> Path:
    """A manifest of the floors in a folder."""
    def entry(path: Path) -> dict:
        return {"path": path.relative_to(folder).as_posix(), "bytes": path.stat().st_size,
                "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}

    def level(path: Path) -> dict:
        return {"building": "house", "level": path.stem, "inputs": "", "seed": 1, "files": [entry(path)],
                "site": {"position": [0.0, 0.0], "turn": 0.0}, "totals": totals, "classes": {}, "rooms": []}

    names = ("rooms", "requested", "placed", "removed", "none", "minor", "failed")
    totals = dict.fromkeys(names, 0)
    levels = [level(path) for path in sorted(folder.rglob("*.glb"))]
    path = folder / "manifest.json"
    path.write_text(json.dumps({"manifest": 1, "program": "test", "levels": levels, "library": [], "totals": totals}))
    return path


@pytest.fixture
def floor() -> Floor:
    return build_floor()


@pytest.fixture
def baked() -> Path:
    """A folder that the program itself baked; scripts/test.sh names it."""
    folder = os.environ.get("ROOMWRIGHT_BAKED")
    if not folder:
        pytest.skip("ROOMWRIGHT_BAKED names no folder of baked floors")
    return Path(folder)
