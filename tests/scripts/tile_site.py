"""A small correct tileset, built by hand, that the tests of tiles break: one building on a second file, its level in two details."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from conftest import Floor

# What is drawn: a slab of 4 x 3 m and, as two instances, a box of 0.5 m, from 0.1 m below the floor to 0.5 m above it.
LEVEL_BOX = [2.0, 1.5, 0.2, 2.0, 0, 0, 0, 1.5, 0, 0, 0, 0.3]
QUARTER_TURN = [0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 10.0, 20.0, 0.0, 1.0]
RAISED = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0, 1.0]
COLUMNS = {"room": ["101", "101", "101"], "id": ["floor", "desk.1", "desk.2"]}


class Site:
    """A folder under construction: the documents of its tilesets, and one glTF file that stands for each detail."""

    def __init__(self):
        self.first, self.second = first_document(), second_document()
        self.tile = Tile()
        # Whatever else lies in the folder, by path.
        self.files = {"shared-textures/wood.png": b"\x89PNG\r\n\x1a\n and the rest", "manifest.json": b"{}"}

    def find(self, name: str) -> dict:
        """A tile of the second file: building, level, boxes, full."""
        tile = self.second["root"]
        for _ in range(["building", "level", "boxes", "full"].index(name)):
            tile = tile["children"][0]
        return tile

    def write(self, folder: Path) -> Path:
        """Writes everything, and gives the tileset."""
        for name in ("tileset", "house", "shared-textures"):
            (folder / name).mkdir(parents=True, exist_ok=True)
        for path, content in self.files.items():
            (folder / path).write_bytes(content)
        (folder / "tileset.json").write_text(json.dumps(self.first))
        (folder / "tileset" / "0.json").write_text(json.dumps(self.second))
        for detail in ("boxes", "full"):
            self.tile.write(folder / "house" / f"ground.{detail}.glb")
        return folder / "tileset.json"


def first_document() -> dict:
    # The building, turned by a quarter: 3 m from west to east, 4 m from south to north.
    box = [8.5, 22.0, 3.2, 1.5, 0, 0, 0, 2.0, 0, 0, 0, 0.3]
    quarter = {"boundingVolume": {"box": box}, "geometricError": 8.0, "content": {"uri": "tileset/0.json"}}
    root = {"boundingVolume": {"box": box}, "geometricError": 16.0, "refine": "ADD", "children": [quarter]}
    return {"asset": {"version": "1.1"}, "geometricError": 32.0, "root": root}


def second_document() -> dict:
    def tile(error: float, **more) -> dict:
        return {"boundingVolume": {"box": LEVEL_BOX}, "geometricError": error, **more}

    full = tile(0.0, content={"uri": "../house/ground.full.glb"})
    boxes = tile(0.3, content={"uri": "../house/ground.boxes.glb"}, children=[full])
    level = tile(1.0, refine="REPLACE", transform=RAISED, children=[boxes],
                 metadata={"class": "level", "properties": {"id": "ground"}})
    building = tile(4.0, refine="ADD", transform=QUARTER_TURN, children=[level])
    building["boundingVolume"] = {"box": [2.0, 1.5, 3.2, 2.0, 0, 0, 0, 1.5, 0, 0, 0, 0.3]}
    schema = {"id": "site", "classes": {"level": {"properties": {"id": {"type": "STRING", "required": True}}}}}
    return {"asset": {"version": "1.1"}, "geometricError": 8.0, "schema": schema, "root": building}


class Tile(Floor):
    """A slab with a number a corner, a box with a number an instance, and a table of three rows."""

    def __init__(self):
        super().__init__()
        # Instances first: views of four bytes a row leave the table where it must begin.
        slab, desk = self.box_mesh("slab", 4.0, 3.0, 0.1), self.box_mesh("desk", 0.5, 0.5, 0.5)
        places = np.array([[1.0, 0.0, -1.0], [3.0, 0.0, -2.0]], "<f4")
        self.instancing = {"attributes": {"TRANSLATION": self.accessor(places, "VEC3"), "_FEATURE_ID_0": self.numbers([1, 2])}}
        self.slab = self.document["meshes"][slab]["primitives"][0]
        self.slab["attributes"]["_FEATURE_ID_0"] = self.numbers([0] * 24)
        self.slab["extensions"] = {"EXT_mesh_features": features()}
        nodes = [{"name": "merged", "mesh": slab, "translation": [2.0, -0.1, -1.5]},
                 {"name": "desks", "mesh": desk, "extensions": {
                     "EXT_mesh_gpu_instancing": self.instancing, "EXT_instance_features": features()}}]
        self.document |= {"nodes": [{"children": [1, 2]}, *nodes], "images": [{"uri": "../shared-textures/wood.png"}]}
        self.document["extensionsUsed"] = [
            "EXT_instance_features", "EXT_mesh_features", "EXT_mesh_gpu_instancing", "EXT_structural_metadata"]
        self.document["extensionsRequired"] = ["EXT_mesh_gpu_instancing"]
        self.document["extensions"] = {"EXT_structural_metadata": self.metadata(COLUMNS)}

    @property
    def table(self) -> dict:
        return self.document["extensions"]["EXT_structural_metadata"]["propertyTables"][0]

    @property
    def described(self) -> dict:
        """The properties of the class of the table."""
        return self.document["extensions"]["EXT_structural_metadata"]["schema"]["classes"]["piece"]["properties"]

    def numbers(self, values: list[float]) -> int:
        """An accessor of numbers of features."""
        index = self.accessor(np.array(values, "<f4"), "SCALAR")
        self.document["accessors"][index]["componentType"] = 5126
        self.document["bufferViews"][-1]["target"] = 34962
        return index

    def metadata(self, columns: dict[str, list[str]]) -> dict:
        properties = {key: {"type": "STRING", "required": True} for key in columns}
        texts = {key: {"values": self.view("".join(rows).encode()), "stringOffsets": self.view(offsets_of(rows))}
                 for key, rows in columns.items()}
        return {"schema": {"id": "test", "classes": {"piece": {"properties": properties}}},
                "propertyTables": [{"class": "piece", "count": len(next(iter(columns.values()))), "properties": texts}]}

    def view(self, data: bytes) -> int:
        self.binary += b"\0" * (-len(self.binary) % 8)
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data + b"\0" * (-len(data) % 8)
        return len(self.document["bufferViews"]) - 1


def offsets_of(rows: list[str]) -> bytes:
    return np.cumsum([0, *(len(row.encode()) for row in rows)]).astype("<u4").tobytes()


def features(count: int = 3) -> dict:
    return {"featureIds": [{"featureCount": count, "attribute": 0, "propertyTable": 0}]}
