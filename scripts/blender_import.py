#!/usr/bin/env python3
"""Opens what roomwright baked in Blender, one floor, a building or a whole bake, sorted into collections.

In Blender (4.2 or newer): Edit > Preferences > Add-ons > Install from Disk, this file; then File > Import >
Roomwright bake. Files and folders may be chosen; the sidebar of the 3D view (N) shows and hides parts.

Without a window:
  python scripts/blender_import.py BAKE... --save building.blend [--levels PATTERN] [--no-ceilings] [--asset-catalog]
  blender --background --python scripts/blender_import.py -- BAKE... --save building.blend
BAKE is a .glb or .gltf, a building's folder, or a bake with its manifest.json. The first needs Blender's Python
module, scripts/requirements-render.txt. Exit 0: saved. 1: a floor or the saving failed, nothing is written. 2: nothing
could start.

By a script: import_bake(path, Options(ceilings=False)). It is one long file because Blender installs one file.

Blender's own importer reads each mesh, material, image and light once, whatever floors it is in; the tree of nodes is built
here. (With floors imported whole, the importer looks through all objects for every mesh, and time grows with the
square of the floors.) When something fails, all that was made is removed again.
"""

import argparse
import fnmatch
import hashlib
import json
import logging
import math
import os
import re
import struct
import sys
import tempfile
import time
import uuid
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PureWindowsPath
from urllib.parse import quote, unquote

try:
    import bpy
    from bpy_extras.io_utils import ImportHelper
    from mathutils import Matrix, Quaternion

    # Lights shine along -Z in Blender, and a node's axes were turned.
    LIGHT_TURN = Quaternion((math.sqrt(0.5), math.sqrt(0.5), 0.0, 0.0))
except ImportError:  # outside of Blender, where only the reading below works
    bpy = None

bl_info = {
    "name": "Roomwright bake",
    "description": "Imports baked floors and buildings into collections that can be hidden part by part",
    "author": "Roomwright",
    "version": (1, 0, 0),
    "blender": (4, 2, 0),
    "location": "File > Import > Roomwright bake; 3D view > Sidebar > Roomwright",
    "category": "Import-Export",
}

# The folders beside OUT/<building>/ that floors share, and how absolute URIs begin (scripts/resources.py).
SHARED_FOLDERS = ("shared-textures", "shared-geometry", "shared-models")
SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")
# The sub-collections of rooms; those of doors and windows are the level's, because a door belongs to two rooms.
PARTS = ("shell", "ceiling", "doors and windows", "furniture", "lights")
# Custom property of collections: building, level, room or one of PARTS.
ROLE = "roomwright"
# Marks by which what the importer made is found again; they are removed afterwards.
NODE_MARK, MATERIAL_MARK, IMAGE_MARK = "roomwright_node", "roomwright_material", "roomwright-"
CATALOG_FILE = "blender_assets.cats.txt"
CATALOG_NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "https://roomwright/catalogue")
COMPONENT_SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
COMPONENT_COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
# What an import can make; what is new of these is removed when it fails.
KINDS = ("scenes", "collections", "objects", "meshes", "lights", "cameras", "materials", "images", "node_groups",
         "textures", "actions")


class BakeError(Exception):
    """Something that cannot be imported; the text says which file and why."""


@dataclass(frozen=True)
class Options:
    """How a bake is imported."""

    levels: tuple[str, ...] = ()  # patterns of level, building/level or building; none is all
    ceilings: bool = True         # False: hidden in the viewport and in renderings
    place: bool = True            # levels at their elevation, buildings at their site; False: all at the origin
    assets: bool = False          # furniture as assets, a catalogue for each class


@dataclass(frozen=True)
class Floor:
    """A file that can be imported, by what its level says about itself."""

    path: Path
    building: str
    level: str
    elevation: float
    position: tuple[float, float]
    turn: float

    @property
    def name(self) -> str:
        return f"{self.building}/{self.level}"


# ---------------------------------------------------------------------------------------------- which files


def find_floors(paths, patterns=()) -> list[Floor]:
    """The floors of files and folders: those of the patterns, by building, from the lowest up."""
    known, chosen = [], []
    for path in [Path(paths)] if isinstance(paths, (str, Path)) else [Path(path) for path in paths]:
        for file, name in _list_files(path):
            if name is None or _is_chosen(*name, patterns):
                floor = read_floor(file)
                name = (floor.building, floor.level)
                if _is_chosen(*name, patterns):
                    chosen.append(floor)
            known.append("/".join(name))
    if not chosen:
        shown = ", ".join(known[:8]) + (", ..." if len(known) > 8 else "")
        raise BakeError(f"no level matches {', '.join(patterns)}; there are {shown}")
    return sorted(chosen, key=lambda floor: (floor.building, floor.elevation, floor.level, floor.path))


def _is_chosen(building: str, level: str, patterns) -> bool:
    names = (level, f"{building}/{level}", building)
    return not patterns or any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns for name in names)


def _list_files(path: Path) -> list[tuple[Path, tuple[str, str] | None]]:
    """The files below a path; of a bake also their building and level, so that those not asked for stay closed."""
    if path.name == "manifest.json":
        path = path.parent
    if path.is_file():
        return [(path, None)]
    if not path.is_dir():
        raise BakeError(f"{path}: no such file or folder; `roomwright bake` writes into out/")
    manifest = path / "manifest.json"
    if manifest.is_file():
        try:
            levels = json.loads(manifest.read_bytes())["levels"]
            names = [(one["files"][0]["path"], (one["building"], one["level"])) for one in levels]
            if any(".." in Path(name).parts or Path(name).is_absolute() for name, _ in names):
                raise ValueError("a file of it lies elsewhere")
            return [(path / name, level) for name, level in names]
        except (ValueError, KeyError, TypeError, IndexError, OSError) as error:
            raise BakeError(f"{manifest}: is no manifest that roomwright wrote ({error!r})") from error
    files = sorted(one for one in path.rglob("*") if one.suffix.lower() in (".glb", ".gltf")
                   and not any(part.startswith(".") for part in one.relative_to(path).parts))
    if not files:
        raise BakeError(f"{path}: neither a manifest.json nor a .glb or .gltf is in it")
    return [(one, None) for one in files]


def read_floor(path: Path) -> Floor:
    """What a file's level says about itself."""
    for node in _read_json(path).get("nodes", []):
        extras = node.get("extras") or {}
        if isinstance(extras, dict) and extras.get("kind") == "level":
            try:
                site = extras.get("site") or {"position": (0.0, 0.0), "turn": 0.0}
                east, north = (float(metres) for metres in site["position"])
                return Floor(path, str(extras["building"]), str(extras["level"]), float(extras["elevation"]),
                             (east, north), float(site["turn"]))
            except (KeyError, TypeError, ValueError) as error:
                raise BakeError(f"{path}: node {node.get('name')!r} has extras that cannot be read: {error!r}") from error
    raise BakeError(f"{path}: is no file of roomwright: no node's extras say that it is a level\n"
                    "  hint: File > Import > glTF opens other files; exports need Include > Custom Properties")


def _read_json(path: Path) -> dict:
    """The document of a .glb or .gltf, without its buffers."""
    try:
        with path.open("rb") as file:
            head = file.read(20)
            if head[:4] == b"glTF":
                if len(head) < 20:
                    raise ValueError("it is cut off")
                text = file.read(struct.unpack("<I", head[12:16])[0])
            else:
                text = head + file.read()
        document = json.loads(text)
    except OSError as error:
        raise BakeError(f"{path}: cannot be read: {error.strerror}") from error
    except (ValueError, struct.error) as error:
        raise BakeError(f"{path}: is no glTF file, or is damaged: {error}") from error
    if not isinstance(document, dict) or "asset" not in document:
        raise BakeError(f"{path}: is no glTF file")
    return document


# ---------------------------------------------------------------------------------------- what is in a file


class Document:
    """One file: the keys by which its meshes and materials are known, and a copy without those that are known."""

    def __init__(self, path: Path, buffers: dict):
        self.path, self.json = path, _read_json(path)
        self._shared = buffers  # bytes of files that several floors use, by path
        self._digests: dict[int, bytes] = {}
        self.material_keys = [self._material_key(material) for material in self.json.get("materials", [])]
        self.mesh_keys = [self._mesh_key(mesh) for mesh in self.json.get("meshes", [])]

    def _resource(self, uri: str) -> Path:
        """The file of a URI: below the floor's folder or in the shared ones beside it, reached by no link that leads out, as
        scripts/resources.py has it, which an add-on of one file cannot call."""
        folder = Path(os.path.abspath(self.path)).parent.resolve()
        roots = (folder, *(folder.parent / name for name in SHARED_FOLDERS))
        path = unquote(uri, errors="surrogateescape") if isinstance(uri, str) else ""
        is_path = path and not (SCHEME.match(uri) or path.startswith("/") or PureWindowsPath(path).anchor
                                or "\\" in path or "\0" in path)
        joined = Path(os.path.normpath(folder / path)) if is_path else folder
        places = (joined, joined.resolve()) if any(joined.is_relative_to(root) for root in roots) else ()
        if joined == folder or not places or not any(places[1].is_relative_to(root) for root in roots):
            raise BakeError(f"{self.path}: names the file {uri!r:.120}, which is not in the folder of the floor\n"
                            "  hint: keep the file beside the floor")
        if joined.exists() and not joined.is_file():
            raise BakeError(f"{self.path}: names {uri!r:.120}, which is no regular file")
        return places[1]

    def _buffer(self, index: int) -> bytes:
        uri = self.json["buffers"][index].get("uri")
        if isinstance(uri, str) and uri.startswith("data:"):
            raise BakeError(f"{self.path}: has a buffer in its text, which nothing here writes; open it with "
                            "File > Import > glTF")
        path = self.path if uri is None else self._resource(uri)
        if path not in self._shared:
            data = path.read_bytes()
            if uri is None:  # the second chunk of the file itself
                start = 20 + struct.unpack("<I", data[12:16])[0] + 8
                return self._shared.setdefault(path, memoryview(data)[start:])
            self._shared[path] = memoryview(data)
        return self._shared[path]

    def forget(self) -> None:
        """Lets the file's own bytes go; those of shared files stay."""
        self._shared.pop(self.path, None)

    def _accessor_bytes(self, index: int) -> bytes:
        accessor = self.json["accessors"][index]
        if "sparse" in accessor or "bufferView" not in accessor:
            raise BakeError(f"{self.path}: accessor {index} is sparse or compressed; export without compression, or use "
                            "File > Import > glTF")
        view = self.json["bufferViews"][accessor["bufferView"]]
        size = COMPONENT_SIZES[accessor["componentType"]] * COMPONENT_COUNTS[accessor["type"]]
        length = view.get("byteStride", size) * (accessor["count"] - 1) + size
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        data = self._buffer(view["buffer"])[start:start + length]
        if len(data) < length:
            raise BakeError(f"{self.path}: is cut off: accessor {index} reaches past its end")
        return data

    def _accessor_digest(self, index: int) -> bytes:
        if index not in self._digests:
            accessor = self.json["accessors"][index]
            view = self.json["bufferViews"][accessor.get("bufferView", 0)]
            form = (accessor["componentType"], accessor["type"], accessor["count"], accessor.get("normalized"),
                    view.get("byteStride"))
            self._digests[index] = _digest(repr(form).encode(), self._accessor_bytes(index))
        return self._digests[index]

    def _mesh_key(self, mesh: dict) -> bytes:
        words = []
        for primitive in mesh["primitives"]:
            words.append(str(primitive.get("mode", 4)).encode())
            for name, index in sorted(primitive["attributes"].items()):
                words += [name.encode(), self._accessor_digest(index)]
            if "indices" in primitive:
                words.append(self._accessor_digest(primitive["indices"]))
            if "material" in primitive:
                words.append(self.material_keys[primitive["material"]])
            words.append(json.dumps(primitive.get("extensions"), sort_keys=True).encode())
        return _digest(*words)

    def _material_key(self, material: dict) -> bytes:
        return _digest(json.dumps(self._with_images(material), sort_keys=True).encode())

    def _with_images(self, value, key: str = ""):
        """A part of a material, its textures replaced by what they show."""
        if isinstance(value, list):
            return [self._with_images(one) for one in value]
        if not isinstance(value, dict):
            return value
        copy = {name: self._with_images(one, name) for name, one in value.items()}
        if key.endswith("Texture") and "index" in copy:
            texture = self.json["textures"][copy["index"]]
            sampler = self.json["samplers"][texture["sampler"]] if "sampler" in texture else None
            copy["index"] = [self.image_key(texture["source"]), sampler]
        return copy

    def image_key(self, index: int) -> str:
        """The path of an image, or the hash of one inside the file."""
        image = self.json["images"][index]
        if "bufferView" in image:
            view = self.json["bufferViews"][image["bufferView"]]
            start = view.get("byteOffset", 0)
            return _digest(self._buffer(view["buffer"])[start:start + view["byteLength"]]).hex()
        path = self._resource(image["uri"])
        if not path.is_file():
            raise BakeError(f"{self.path}: its texture {path} is missing\n"
                            "  hint: keep shared-textures/ beside the floor, or bake without --shared-textures")
        return str(path)

    @property
    def lights(self) -> list[dict]:
        return self.json.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])

    def unknown(self, known: "Known") -> tuple[list, dict, bytes]:
        """What is not known yet: its keys, and a document with a node for each, with its binary chunk."""
        packer, keys, nodes = _Packer(self), {}, []
        for index, key in enumerate(self.mesh_keys):
            if key not in known.meshes and key not in keys:
                packer.add(self.json["meshes"][index])
                nodes.append({"mesh": len(keys), "extras": {NODE_MARK: len(keys)}})
                keys[key] = len(keys)
        for index, light in enumerate(self.lights):
            if (key := light_key(light)) not in known.lights and key not in keys:
                nodes.append({"extensions": {"KHR_lights_punctual": {"light": index}}, "extras": {NODE_MARK: len(keys)}})
                keys[key] = len(keys)
        document = {key: value for key, value in self.json.items() if key in
                    ("asset", "textures", "samplers", "extensionsUsed", "extensions")}
        document |= {"scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
                     "meshes": packer.meshes, "materials": self._marked_materials(known.materials),
                     "images": [self._marked_image(image, index, packer) for index, image
                                in enumerate(self.json.get("images", []))],
                     "accessors": packer.accessors, "bufferViews": packer.views}
        if packer.binary:
            document["buffers"] = [{"byteLength": len(packer.binary)}]
        return list(keys), {key: value for key, value in document.items() if value != []}, bytes(packer.binary)

    def _marked_materials(self, known) -> list[dict]:
        marked = []
        for index, (material, key) in enumerate(zip(self.json.get("materials", []), self.material_keys)):
            whole = {} if key in known else material
            extras = (whole.get("extras") or {}) | {MATERIAL_MARK: index}
            marked.append(whole | {"name": material.get("name", ""), "extras": extras})
        return marked

    def _marked_image(self, image: dict, index: int, packer: "_Packer") -> dict:
        if "bufferView" not in image:
            return image | {"uri": quote(str(self._resource(image["uri"])))}
        view = self.json["bufferViews"][image["bufferView"]]
        start = view.get("byteOffset", 0)
        data = self._buffer(view["buffer"])[start:start + view["byteLength"]]
        return image | {"bufferView": packer.view(data), "name": f"{IMAGE_MARK}{index}"}


class _Packer:
    """Meshes that are still to be read, with their own accessors and bytes."""

    def __init__(self, source: Document):
        self._source, self._moved = source, {}
        self.binary, self.views = bytearray(), []
        self.accessors, self.meshes = [], []

    def add(self, mesh: dict) -> None:
        primitives = []
        for primitive in mesh["primitives"]:
            attributes = {name: self._accessor(index) for name, index in primitive["attributes"].items()}
            indices = {"indices": self._accessor(primitive["indices"])} if "indices" in primitive else {}
            primitives.append(primitive | {"attributes": attributes} | indices)
        self.meshes.append(mesh | {"primitives": primitives})

    def _accessor(self, index: int) -> int:
        if index not in self._moved:
            accessor = self._source.json["accessors"][index]
            stride = self._source.json["bufferViews"][accessor["bufferView"]].get("byteStride")
            view = self.view(self._source._accessor_bytes(index), stride)
            self.accessors.append(accessor | {"bufferView": view, "byteOffset": 0})
            self._moved[index] = len(self.accessors) - 1
        return self._moved[index]

    def view(self, data: bytes, stride: int | None = None) -> int:
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.views.append(view | ({"byteStride": stride} if stride else {}))
        self.binary += data
        return len(self.views) - 1


def _digest(*words: bytes) -> bytes:
    state = hashlib.blake2b(digest_size=16)
    for word in words:
        state.update(len(word).to_bytes(8, "little"))
        state.update(word)
    return state.digest()


def light_key(light: dict) -> str:
    return json.dumps(light, sort_keys=True)


def write_glb(path: Path, document: dict, binary: bytes) -> None:
    """Writes a .glb."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunk = struct.pack("<2I", len(binary), 0x004E4942) + binary if binary else b""
    head = struct.pack("<5I", 0x46546C67, 2, 20 + len(text) + len(chunk), len(text), 0x4E4F534A)
    path.write_bytes(head + text + chunk)


def shown_nodes(document: dict) -> list[int]:
    """The nodes of the document's scene, each once; others stand by, as coarser shapes do."""
    nodes, scenes = document.get("nodes", []), document.get("scenes", [])
    waiting = list(scenes[document.get("scene", 0)].get("nodes", [])) if scenes else list(range(len(nodes)))
    shown = dict.fromkeys(waiting)
    for one in waiting:  # grows as it goes
        for child in nodes[one].get("children", []):
            if child not in shown:
                shown[child] = None
                waiting.append(child)
    return sorted(shown)


def sort_nodes(nodes: list[dict]) -> list[tuple[str | None, str]]:
    """Of each node, the id of its room, if it is in one, and the part: one of PARTS, or level or room."""
    parents = {child: number for number, node in enumerate(nodes) for child in node.get("children", [])}
    sorted_nodes: list = [None] * len(nodes)
    for number in range(len(nodes)):
        chain = [number]  # up to an ancestor that is sorted; each node is visited once
        while chain[-1] in parents and sorted_nodes[parents[chain[-1]]] is None and len(chain) <= len(nodes):
            chain.append(parents[chain[-1]])
        for one in reversed(chain):
            above = sorted_nodes[parents[one]] if one in parents else None
            sorted_nodes[one] = sorted_nodes[one] or _sort(nodes[one].get("extras") or {}, above or (None, "level"))
    return sorted_nodes


def _sort(extras: dict, above: tuple[str | None, str]) -> tuple[str | None, str]:
    room, part = above
    kind = extras.get("kind")
    if kind == "room":
        return extras.get("room"), "room"
    if kind == "opening":
        return room, "doors and windows"
    if kind == "part" and part != "doors and windows":
        return room, "ceiling" if extras.get("part") == "ceiling" else "shell"
    if kind == "light":
        return room, "lights"
    # What has no extras and stands in a room was added by somebody: it belongs to the furniture.
    return room, "furniture" if kind == "furniture" or part in ("room", "shell", "ceiling") else part


# ------------------------------------------------------------------------------------------------ in Blender


class Known:
    """What has been read, by its content."""

    def __init__(self, scene):
        self.meshes, self.materials, self.images, self.lights = {}, {}, {}, {}
        self.buffers = {}  # bytes of files that several floors use, by path
        self.scene = scene  # the importer's own

    def read(self, document: Document) -> None:
        """What of a file is not known yet, through Blender's importer."""
        keys, reduced, binary = document.unknown(self)
        if not keys:
            return
        with tempfile.TemporaryDirectory(prefix="roomwright-") as folder:
            path = Path(folder) / "floor.glb"
            write_glb(path, reduced, binary)
            _import_gltf(path, document.path)
        carriers = list(self.scene.collection.all_objects)
        garbage, marked = set(carriers), set()
        for carrier in carriers:
            if carrier.type == "MESH":
                self._adopt_materials(document, carrier.data, marked, garbage)
            known = self.meshes if carrier.type == "MESH" else self.lights
            known[keys[carrier[NODE_MARK]]] = carrier.data
        for material in marked:
            del material[MATERIAL_MARK]
        bpy.data.batch_remove(garbage)

    def _adopt_materials(self, document: Document, mesh, marked: set, garbage: set) -> None:
        for slot, material in enumerate(mesh.materials):
            if material is None:
                continue
            known = self.materials.setdefault(document.material_keys[material[MATERIAL_MARK]], material)
            if known == material:
                marked.add(material)
                self._adopt_images(document, material, garbage)
            else:
                mesh.materials[slot] = known
                garbage.add(material)

    def _adopt_images(self, document: Document, material, garbage: set) -> None:
        """Images that lie inside files; those beside them are shared by Blender's importer itself."""
        for node in material.node_tree.nodes if material.node_tree else []:
            image = getattr(node, "image", None)
            if image is None or not image.name.startswith(IMAGE_MARK):
                continue
            index = int(image.name[len(IMAGE_MARK):].partition(".")[0])
            known = self.images.setdefault(document.image_key(index), image)
            if known == image:
                image.name = document.json["images"][index].get("name") or "image"
            else:
                node.image = known
                garbage.add(image)


class Import:
    """One import: what is read, and the collections and objects that it becomes."""

    def __init__(self, options: Options, scene):
        self.options, self.scene = options, scene
        self.known = Known(bpy.data.scenes.new("roomwright import"))
        self.unit = 1.0 / scene.unit_settings.scale_length
        self.known.scene.unit_settings.scale_length = scene.unit_settings.scale_length
        self.collections, self.models = {}, {}
        self.object_count = 0

    def create(self, documents: list[Document]) -> list[list]:
        """The objects of all nodes, still without anything.

        In the order of their names, in which Blender keeps them: it looks for the place of a new one from the end.
        """
        names, objects = [], []
        for number, document in enumerate(documents):
            nodes = document.json.get("nodes", [])
            with _faults_of(document.path):
                names += [(nodes[index].get("name") or "node", number, index) for index in shown_nodes(document.json)]
            objects.append([None] * len(nodes))
        for name, number, index in sorted(names, key=lambda one: (one[0].casefold(), *one)):
            document = documents[number]
            with _faults_of(document.path):
                data = self._data(document, document.json["nodes"][index])
            objects[number][index] = bpy.data.objects.new(name, data)
        self.object_count = len(names)
        return objects

    def build(self, floor: Floor, document: Document, objects: list) -> None:
        """Makes a floor's objects what their nodes are, in its collections."""
        nodes = document.json.get("nodes", [])
        for node, thing, (room, part) in zip(nodes, objects, sort_nodes(nodes)):
            if thing is None:
                continue
            if thing.data is None:
                thing.empty_display_size = 0.1
            _set_extras(thing, node.get("extras") or {})
            self._set_transform(thing, node)
            self._shelf(floor, room, part).objects.link(thing)
            if part == "furniture" and thing.type == "MESH" and "class" in thing:
                self.models.setdefault(thing.data, thing)
        for node, thing in zip(nodes, objects):
            for child in node.get("children", []) if thing else []:
                objects[child].parent = thing
        if self.options.place:
            self._place(floor, [thing for thing in objects if thing and thing.parent is None])

    def _data(self, document: Document, node: dict):
        light = node.get("extensions", {}).get("KHR_lights_punctual", {}).get("light")
        if light is not None:
            return self.known.lights[light_key(document.lights[light])]
        return self.known.meshes[document.mesh_keys[node["mesh"]]] if "mesh" in node else None

    def _set_transform(self, thing, node: dict) -> None:
        """Blender's axes from glTF's: x, y, z become x, -z, y, as its own importer does."""
        x, y, z = node.get("translation", (0.0, 0.0, 0.0))
        thing.location = (x * self.unit, -z * self.unit, y * self.unit)
        x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
        turn = Quaternion((w, x, -z, y))
        thing.rotation_mode = "QUATERNION"
        thing.rotation_quaternion = turn @ LIGHT_TURN if thing.type == "LIGHT" else turn
        x, y, z = node.get("scale", (1.0, 1.0, 1.0))
        thing.scale = (x, z, y)

    def _place(self, floor: Floor, roots: list) -> None:
        level = next(thing for thing in roots if thing.get("kind") == "level")
        place = Matrix.Rotation(floor.turn, 4, "Z")
        place.translation = [metres * self.unit for metres in (*floor.position, floor.elevation)]
        # A level that was exported from its place has that place in its node.
        move = place @ level.matrix_basis.inverted_safe()
        for thing in roots:
            thing.matrix_basis = move @ thing.matrix_basis

    def _shelf(self, floor: Floor, room: str | None, part: str):
        """The collection building / level / room / part."""
        key, name = (floor.building, floor.path), floor.name
        shelf = self._collection(key[:1], "building", floor.building)
        shelf = self._collection(key, "level", name, shelf)
        if room is not None:
            key, name = (*key, room), f"{name}/{room}"
            shelf = self._collection(key, "room", name, shelf)
        return self._collection((*key, part), part, f"{name} {part}", shelf) if part in PARTS else shelf

    def _collection(self, key: tuple, role: str, name: str, above=None):
        if key in self.collections:
            return self.collections[key]
        found = bpy.data.collections.get(name) if role == "building" else None
        if found is None or found.get(ROLE) != role:
            found = bpy.data.collections.new(name)
            found[ROLE] = role
        if above is not None:
            above.children.link(found)
        self.collections[key] = found
        return found

    def finish(self) -> None:
        """Shows the buildings, marks assets, removes what was only in the way."""
        for key, building in self.collections.items():
            if len(key) == 1 and building.name not in self.scene.collection.children:
                self.scene.collection.children.link(building)
        if not self.options.ceilings:
            ours = set(self.collections.values())
            _show([one for one in shelves("ceiling") if one.collection in ours], False)
        if self.options.assets:
            for mesh, model in self.models.items():
                _make_asset(mesh, model)
        bpy.data.scenes.remove(self.known.scene)


def _set_extras(thing, extras: dict) -> None:
    """Custom properties, as Blender's importer makes them: what they cannot hold becomes text."""
    for name, value in extras.items():
        try:
            thing[name] = value
        except (OverflowError, TypeError, ValueError):
            thing[name] = str(value)


def import_bake(paths, options: Options = Options(), progress=None) -> Import:
    """Imports floors into the active scene. `paths`: a path or several; `progress`: called with step, steps, what.

    Raises BakeError, and leaves everything as it was, if a file is missing, damaged or not roomwright's.
    """
    floors = find_floors(paths, options.levels)
    tell = progress or (lambda *_: None)
    before = {kind: {one.as_pointer() for one in getattr(bpy.data, kind)} for kind in KINDS}
    window, scene = bpy.context.window, bpy.context.scene
    try:
        work = Import(options, scene)
        # The importer works in a scene of its own, else Blender goes through all objects for each floor.
        window.scene = work.known.scene
        documents = []
        for step, floor in enumerate(floors, 1):
            with _faults_of(floor.path):
                documents.append(Document(floor.path, work.known.buffers))
                work.known.read(documents[-1])
                documents[-1].forget()
            tell(step, 2 * len(floors), f"read {floor.name}")
        created = work.create(documents)
        for step, (floor, document, objects) in enumerate(zip(floors, documents, created), 1 + len(floors)):
            with _faults_of(floor.path):
                work.build(floor, document, objects)
            tell(step, 2 * len(floors), f"built {floor.name}")
        window.scene = scene
        work.finish()
    except BaseException:
        window.scene = scene
        bpy.data.batch_remove([one for kind in KINDS for one in getattr(bpy.data, kind)
                               if one.as_pointer() not in before[kind]])
        raise
    return work


@contextmanager
def _faults_of(path: Path):
    """What a damaged file makes fail is told with its name."""
    try:
        yield
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, StopIteration, struct.error, OSError) as error:
        raise BakeError(f"{path}: cannot be read: {error!r}") from error


def _import_gltf(path: Path, source: Path) -> None:
    """Blender's importer, with its defaults, into the scene of the window."""
    wanted = {"import_select_created_objects": False, "import_scene_as_collection": False, "loglevel": 50}
    known = bpy.ops.import_scene.gltf.get_rna_type().properties.keys()
    silenced = logging.root.manager.disable
    logging.disable(logging.ERROR)  # it has a line for each mesh
    try:
        bpy.ops.import_scene.gltf(filepath=str(path), **{name: wanted[name] for name in wanted if name in known})
    except RuntimeError as error:
        raise BakeError(f"{source}: Blender cannot read it: {error}") from error
    finally:
        logging.disable(silenced)


def shelves(part: str) -> list:
    """The collections of one of PARTS as the active view layer has them."""
    found, waiting = [], [bpy.context.view_layer.layer_collection]
    while waiting:
        one = waiting.pop()
        waiting += one.children
        if one.collection.get(ROLE) == part:
            found.append(one)
    return found


def show_part(part: str, is_shown: bool) -> int:
    """Shows or hides one of PARTS in all levels, in the viewport and in renderings; how many collections that are."""
    found = shelves(part)
    _show(found, is_shown)
    return len(found)


def _show(found: list, is_shown: bool) -> None:
    # By the eye: what is disabled or excluded Blender does not place, and exports it from a wrong place.
    for one in found:
        one.hide_viewport = one.collection.hide_render = not is_shown


# ---------------------------------------------------------------------------------------------------- assets


def catalog_id(class_name: str) -> str:
    """The same id for the same class, in every file."""
    return str(uuid.uuid5(CATALOG_NAMESPACE, class_name))


def _make_asset(mesh, piece) -> None:
    """A piece of furniture without a place, to be dragged into a scene; it shares the mesh of those that stand."""
    model = bpy.data.objects.new(mesh.name, mesh)
    for name in ("kind", "class", "size", "variant"):
        if name in piece:
            model[name] = piece[name]
    model.asset_mark()
    model.asset_data.catalog_id = catalog_id(piece["class"])
    model.asset_data.tags.new(piece["class"])
    model.asset_data.description = " x ".join(f"{metres:.2f}" for metres in piece.get("size", ())) + " m"


def write_catalog(folder: Path) -> Path:
    """Writes the asset catalogue of all classes beside a .blend; what others wrote into it stays."""
    path = folder / CATALOG_FILE
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else [
        "# This is an Asset Catalog Definition file for Blender.", "", "VERSION 1", ""]
    classes = {thing["class"] for thing in bpy.data.objects if thing.asset_data is not None and "class" in thing}
    for name in sorted(classes):
        if not any(line.startswith(catalog_id(name)) for line in lines):
            lines.append(f"{catalog_id(name)}:Roomwright/{name}:{name}")
    with _whole(path) as partial:
        partial.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


@contextmanager
def _whole(path: Path):
    """A temporary name beside a path, which becomes the path when nothing fails."""
    partial = path.with_name(f".{os.getpid()}.{path.name}")
    try:
        yield partial
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


# ------------------------------------------------------------------------------------------------- the window

if bpy is not None:
    class IMPORT_SCENE_OT_roomwright(bpy.types.Operator, ImportHelper):
        """Import floors that roomwright baked: files, a building's folder, or a bake"""

        bl_idname, bl_label, bl_options = "import_scene.roomwright", "Import Roomwright bake", {"REGISTER", "UNDO"}

        filter_glob: bpy.props.StringProperty(default="*.glb;*.gltf;manifest.json", options={"HIDDEN"})
        directory: bpy.props.StringProperty(subtype="DIR_PATH", options={"HIDDEN", "SKIP_SAVE"})
        files: bpy.props.CollectionProperty(type=bpy.types.OperatorFileListElement, options={"HIDDEN", "SKIP_SAVE"})
        levels: bpy.props.StringProperty(
            name="Levels", description="Patterns of levels, separated by spaces: ground tower-001/1*; none is all")
        ceilings: bpy.props.BoolProperty(name="Ceilings", description="Show ceilings", default=True)
        place: bpy.props.BoolProperty(
            name="In place", description="Levels at their elevation, buildings at their site", default=True)
        assets: bpy.props.BoolProperty(
            name="Assets", description="Mark furniture as assets, with a catalogue for each class", default=False)

        def execute(self, context):
            names = [one.name for one in self.files if one.name]
            paths = [Path(self.directory) / name for name in names] or [Path(self.directory or self.filepath)]
            options = Options(tuple(self.levels.split()), self.ceilings, self.place, self.assets)
            manager = context.window_manager
            manager.progress_begin(0, 100)
            try:
                done = import_bake(paths, options, lambda step, steps, _: manager.progress_update(100 * step // steps))
                self._catalogue()
            except (BakeError, OSError) as error:
                self.report({"ERROR"}, str(error))
                return {"CANCELLED"}
            finally:
                manager.progress_end()
            self.report({"INFO"}, f"{done.object_count} objects with {len(done.known.meshes)} meshes")
            return {"FINISHED"}

        def _catalogue(self):
            if self.assets and bpy.data.filepath:
                write_catalog(Path(bpy.data.filepath).parent)
            elif self.assets:
                self.report({"WARNING"}, "save the file, then import again for the catalogue of the assets' classes")

    class ROOMWRIGHT_OT_show_part(bpy.types.Operator):
        """Show or hide this part in all levels, here and in renderings"""

        bl_idname, bl_label, bl_options = "roomwright.show_part", "Show part", {"REGISTER", "UNDO"}
        part: bpy.props.EnumProperty(items=[(part, part.capitalize(), "") for part in PARTS])

        def execute(self, _context):
            show_part(self.part, all(one.hide_viewport for one in shelves(self.part)))
            return {"FINISHED"}

    class ROOMWRIGHT_PT_parts(bpy.types.Panel):
        bl_label, bl_category, bl_space_type, bl_region_type = "Parts", "Roomwright", "VIEW_3D", "UI"

        def draw(self, _context):
            for part in PARTS:
                self.layout.operator("roomwright.show_part", text=part.capitalize(), icon="HIDE_OFF").part = part

    CLASSES = (IMPORT_SCENE_OT_roomwright, ROOMWRIGHT_OT_show_part, ROOMWRIGHT_PT_parts)


def _menu(menu, _context):
    menu.layout.operator("import_scene.roomwright", text="Roomwright bake (.glb / folder)")


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.TOPBAR_MT_file_import.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(_menu)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)


# ------------------------------------------------------------------------------------------ without a window


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bakes", nargs="+", type=Path, metavar="BAKE", help="a file or a folder of baked floors")
    parser.add_argument("--save", type=Path, required=True, metavar="FILE.blend", help="where to save")
    parser.add_argument("--levels", action="append", default=[], metavar="PATTERN",
                        help="these only, as LEVEL, BUILDING/LEVEL or BUILDING, * for any; may be repeated")
    parser.add_argument("--no-ceilings", action="store_true", help="hide ceilings; they are there all the same")
    parser.add_argument("--no-place", action="store_true", help="all levels at the origin")
    parser.add_argument("--asset-catalog", action="store_true", help=f"furniture as assets, with {CATALOG_FILE}")
    parser.add_argument("--force", action="store_true", help="replace a file that is there")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    options = parser.parse_args(arguments)
    if options.save.suffix != ".blend":
        parser.error(f"--save {options.save}: the name must end in .blend")
    if options.save.exists() and not options.force:
        parser.error(f"{options.save} is there already; --force replaces it")
    return options


def _without_blender() -> int:
    """Goes on where Blender's module is, or says how to set it up; an add-on never comes here."""
    import environment

    environment.require(environment.BLENDER, __name__)
    print(environment.how_to_set_up(environment.BLENDER, environment.missing(environment.BLENDER)), file=sys.stderr)
    return 2


def main(arguments: list[str] | None = None) -> int:
    options = parse(sys.argv[1:] if arguments is None else arguments)
    if bpy is None:
        return _without_blender()
    try:
        find_floors(options.bakes, options.levels)
        options.save.parent.mkdir(parents=True, exist_ok=True)
    except (BakeError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    chosen = Options(tuple(options.levels), not options.no_ceilings, not options.no_place, options.asset_catalog)
    try:
        with _quiet():
            bpy.ops.wm.read_factory_settings(use_empty=True)
            times = [time.monotonic()]
            done = import_bake(options.bakes, chosen, None if options.quiet else _teller())
            times.append(time.monotonic())
            with _whole(options.save.absolute()) as partial:
                bpy.ops.wm.save_as_mainfile(filepath=str(partial), compress=True, copy=True)
            times.append(time.monotonic())
            if options.asset_catalog:
                write_catalog(options.save.absolute().parent)
    except (BakeError, RuntimeError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{options.save}: {done.object_count} objects, {len(done.known.meshes)} meshes, {len(done.known.materials)} "
          f"materials; imported in {times[1] - times[0]:.1f} s, saved in {times[2] - times[1]:.1f} s")
    return 0


def _teller():
    """Tells of each step how long it took."""
    last = time.monotonic()

    def tell(step, steps, what):
        nonlocal last
        now = time.monotonic()
        print(f"{step}/{steps} {what} ({now - last:.1f} s)", file=sys.stderr)
        last = now
    return tell


@contextmanager
def _quiet():
    """Keeps Blender's own lines off standard output; it writes them past Python."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)


if __name__ == "__main__":
    sys.exit(main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else None))
