#!/usr/bin/env python3
"""Validates baked floors: validate.py [options] FOLDER|FILE...

For every .glb and .gltf:
  file       it is read, buffers and images are there, no path in it is absolute or leaves its folder's tree
  names      every node has a name, and no two have the same
  extras     every node says what it is, with every field that its kind has; parents and counts agree
  geometry   each piece's mesh fills its box as `size` says, is closed, and lies inside its room
  trimesh    trimesh loads it, with as many instances and the same bounds as the file itself says
  khronos    the Khronos validator reports no error and no warning
For every manifest.json: each file listed is there with its bytes and hash, and no other floor lies beside it.

Needs scripts/requirements.txt, and for the last check of a file `npm ci` in scripts/.
Faults go to standard output as FILE: [CODE] NODE: MESSAGE (or as one JSON document with --json), progress to
standard error. Exit 0: no fault. 1: faults. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import math
import os
import re
import shutil
import subprocess
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import lru_cache
from itertools import chain
from pathlib import Path
from typing import Iterator, NamedTuple

import numpy as np
import shapely
import trimesh

from gltf_file import GltfError, GltfFile, Node

# Metres. A mesh lies in its box to a millimetre, and coordinates are single precision numbers.
SIZE_TOLERANCE = 0.0015
# A body may stick out of its room by 5 mm (the audit's figure), plus the above.
ROOM_TOLERANCE = 0.0065
# Corners closer than this are one corner when asking whether a mesh is closed.
WELD = 1e-5
# trimesh and the file must agree on bounds to this.
BOUNDS_TOLERANCE = 1e-3

FIELDS = {
    "level": {"building", "level", "elevation", "height", "seed", "generator"},
    "opening": {"opening", "closure", "id", "rooms", "sides", "width", "height", "sill"},
    "room": {"room", "type", "style", "seed", "outline", "holes", "height", "requested", "placed", "removed",
             "grade", "findings"},
    "part": {"part", "tags"},
    "furniture": {"class", "id", "parent", "side", "size", "variant"},
    "light": {"lumens", "kelvin"},
}
SIDES = {"front", "back", "left", "right", "above", "below"}
ROOM_PART = re.compile(r"floor|ceiling|wall\.\d+|column\.\d+|(door|window):.+")
SCENE_ENDINGS = {".glb", ".gltf"}
HERE = Path(__file__).resolve().parent


class Fault(NamedTuple):
    """One thing that is wrong; sorts by file."""

    file: str
    code: str
    node: str
    message: str

    def __str__(self) -> str:
        return f"{self.file}: [{self.code}] {self.node + ': ' if self.node else ''}{self.message}"


class Note(NamedTuple):
    """A fault before it has a file."""

    code: str
    node: str
    message: str


# --- file -----------------------------------------------------------------------------------------------


def check_paths(gltf: GltfFile) -> Iterator[Note]:
    for kind in ("buffers", "images"):
        for number, entry in enumerate(gltf.document.get(kind, [])):
            uri = entry.get("uri", "data:")
            if uri.startswith("data:"):
                continue
            if uri.startswith(("/", "\\")) or re.match(r"[A-Za-z][A-Za-z0-9+.-]*:", uri):
                yield Note("file", "", f"{kind}[{number}] has the absolute path {uri!r}")
            elif kind == "buffers":
                gltf.buffer(number)
            else:
                gltf.image(number)


def check_names(gltf: GltfFile) -> Iterator[Note]:
    for name, count in Counter(node.name for node in gltf.nodes).items():
        if not name:
            yield Note("names", "", f"{count} nodes have no name")
        elif count > 1:
            yield Note("names", name, f"{count} nodes have this name")


# --- extras ---------------------------------------------------------------------------------------------


def check_extras(gltf: GltfFile) -> Iterator[Note]:
    for node in gltf.nodes:
        if node.kind not in FIELDS:
            yield Note("extras", node.name, f"its kind is {node.extras.get('kind')!r}")
            continue
        for field in sorted(FIELDS[node.kind] - node.extras.keys()):
            yield Note("extras", node.name, f"the field {field!r} is missing")
        if FIELDS[node.kind] <= node.extras.keys():
            yield from KIND_CHECKS[node.kind](gltf, node)


def check_level(gltf: GltfFile, node: Node) -> Iterator[Note]:
    expected = f"{node.extras['building']}/{node.extras['level']}"
    if node.parent is not None or sum(other.parent is None for other in gltf.nodes) > 1:
        yield Note("extras", node.name, "a level is the only root of its scene")
    if node.name != expected:
        yield Note("extras", node.name, f"the name of the level is not {expected!r}")


def check_opening(gltf: GltfFile, node: Node) -> Iterator[Note]:
    rooms = piece_counts(gltf)
    if not node.name.startswith(f"{node.extras['opening']}:"):
        yield Note("extras", node.name, f"the name of a {node.extras['opening']} does not begin with its kind")
    for room in node.extras["rooms"]:
        if room not in rooms:
            yield Note("extras", node.name, f"it names the room {room!r}, which is not on this level")


def check_room(gltf: GltfFile, node: Node) -> Iterator[Note]:
    extras = node.extras
    if node.name != f"room:{extras['room']}":
        yield Note("extras", node.name, f"the name of the room is not 'room:{extras['room']}'")
    pieces = piece_counts(gltf)[extras["room"]]
    if pieces != extras["placed"]:
        yield Note("extras", node.name, f"{extras['placed']} pieces are said to be placed, {pieces} are there")
    outline = shapely.Polygon(extras["outline"], extras["holes"])
    if not outline.is_valid or outline.area <= 0.0:
        yield Note("extras", node.name, f"its outline is no area: {shapely.is_valid_reason(outline)}")


def check_part(_: GltfFile, node: Node) -> Iterator[Note]:
    if node.parent is None or node.parent.kind not in ("room", "opening"):
        yield Note("extras", node.name, "a part belongs to a room or an opening")


def check_furniture(_: GltfFile, node: Node) -> Iterator[Note]:
    extras, room = node.extras, room_of(node)
    if room is None:
        yield Note("extras", node.name, "a piece of furniture belongs to a room")
        return
    if node.name != f"{extras['id']}@{room.extras.get('room')}":
        yield Note("extras", node.name, f"the name is not that of {extras['id']!r} in its room")
    if not re.fullmatch(re.escape(extras["class"]) + r"\.\d+", extras["id"]):
        yield Note("extras", node.name, f"the id {extras['id']!r} is no number of {extras['class']!r}")
    if extras["side"] not in SIDES:
        yield Note("extras", node.name, f"{extras['side']!r} is no side")
    above = node.parent.extras.get("id") if node.parent.kind == "furniture" else None
    stands_on_part = above is None and ROOM_PART.fullmatch(extras["parent"])
    if not stands_on_part and extras["parent"] != above:
        yield Note("extras", node.name, f"its parent is said to be {extras['parent']!r}, but it hangs "
                                        f"under {node.parent.name!r}")


def check_light(_: GltfFile, node: Node) -> Iterator[Note]:
    if node.parent is None or node.parent.kind != "furniture":
        yield Note("extras", node.name, "a light belongs to a lamp")


KIND_CHECKS = {"level": check_level, "opening": check_opening, "room": check_room, "part": check_part,
               "furniture": check_furniture, "light": check_light}


@lru_cache(maxsize=1)
def piece_counts(gltf: GltfFile) -> Counter:
    """How many pieces each room of a file holds; rooms without any are there too."""
    counts = Counter({node.extras.get("room"): 0 for node in gltf.nodes if node.kind == "room"})
    rooms = (room_of(node) for node in gltf.nodes if node.kind == "furniture")
    counts.update(room.extras.get("room") for room in rooms if room is not None)
    return counts


def room_of(node: Node) -> Node | None:
    """The room that a node belongs to."""
    while node is not None and node.kind != "room":
        node = node.parent
    return node


# --- geometry -------------------------------------------------------------------------------------------


def check_geometry(gltf: GltfFile) -> Iterator[Note]:
    """Every piece against its box and its room."""
    closed: dict[int, str] = {}
    areas: dict[int, object] = {}
    for node in gltf.nodes:
        room = room_of(node)
        if node.kind != "furniture" or room is None or not FIELDS["furniture"] <= node.extras.keys():
            continue
        if node.mesh is None:
            yield Note("geometry", node.name, "it has no mesh")
            continue
        primitives = gltf.primitives(node.mesh)
        corners = np.concatenate([primitive["positions"] for primitive in primitives]).astype(float)
        yield from check_box(node, corners)
        if room.index not in areas:
            outline = shapely.Polygon(room.extras["outline"], room.extras["holes"])
            areas[room.index] = shapely.prepared.prep(outline.buffer(ROOM_TOLERANCE, join_style="mitre"))
        yield from check_inside(node, room, areas[room.index], corners)
        if node.mesh not in closed:
            closed[node.mesh] = open_edges(primitives)
            if closed[node.mesh]:
                yield Note("geometry", node.name, closed[node.mesh])


def check_box(node: Node, corners: np.ndarray) -> Iterator[Note]:
    """The mesh's extents against `size` (width, depth, height), in the node's own frame with y up."""
    width, depth, height = node.extras["size"]
    low, high = corners.min(axis=0), corners.max(axis=0)
    size, found = np.array([width, height, depth]), high - low
    if np.abs(found - size).max() > SIZE_TOLERANCE:
        yield Note("geometry", node.name,
                   f"the mesh measures {triple(found[[0, 2, 1]])}, its size is said to be {triple((width, depth, height))}")
    middle = (low + high) / 2 - (0.0, height / 2, 0.0)
    if np.abs(middle).max() > SIZE_TOLERANCE:
        yield Note("geometry", node.name, f"the origin is off the middle of the underside by {triple(middle)}")


def check_inside(node: Node, room: Node, area, corners: np.ndarray) -> Iterator[Note]:
    """The mesh's corners against outline and height of its room, in the plan's frame."""
    world = corners @ node.world[:3, :3].T + node.world[:3, 3]
    hull = shapely.MultiPoint(np.column_stack([world[:, 0], -world[:, 2]])).convex_hull
    plan_points = np.unique(shapely.get_coordinates(hull), axis=0)
    outside = ~shapely.contains_xy(area.context, plan_points[:, 0], plan_points[:, 1])
    if outside.any():
        x, y = plan_points[outside][0]
        yield Note("geometry", node.name, f"{outside.sum()} corners lie outside {room.name}, one at "
                                          f"({x:.3f}, {y:.3f})")
    low, high = world[:, 1].min(), world[:, 1].max()
    if low < -ROOM_TOLERANCE or high > room.extras["height"] + ROOM_TOLERANCE:
        yield Note("geometry", node.name, f"it reaches from {low:.3f} to {high:.3f} m in a room of "
                                          f"{room.extras['height']:.3f} m")


def open_edges(primitives: list[dict]) -> str:
    """Why a mesh is not closed, or an empty text.

    Closed means: after joining corners at the same place, every edge is walked as often one way as the
    other, so the surface has no rim. Parts that touch along an edge are fine, single sheets are not. Each
    part of one material is asked first, since a rim may be filled by another part only in the whole mesh.
    """
    if all(rim_length(*weld([primitive])) == 0 for primitive in primitives):
        return ""
    rim = rim_length(*weld(primitives))
    return f"the mesh is not closed: {rim} edges have a side missing" if rim else ""


def weld(primitives: list[dict]) -> tuple[np.ndarray, int]:
    """The triangles of some primitives with corners at the same place joined, and the number of corners."""
    offsets = np.cumsum([0] + [len(primitive["positions"]) for primitive in primitives])
    corners = np.concatenate([primitive["positions"] for primitive in primitives])
    triangles = np.concatenate([primitive["triangles"] + offset for primitive, offset in zip(primitives, offsets)])
    _, joined = np.unique(np.round(corners / WELD).astype(np.int64), axis=0, return_inverse=True)
    return joined.reshape(-1)[triangles], len(corners)


def rim_length(triangles: np.ndarray, corner_count: int) -> int:
    """How many edges are walked more often one way than the other."""
    start = triangles.reshape(-1)
    end = np.roll(triangles, -1, axis=1).reshape(-1)
    edges = np.minimum(start, end) * corner_count + np.maximum(start, end)
    ways = np.where(start < end, 1, -1) * (start != end)
    _, which = np.unique(edges, return_inverse=True)
    return int(np.count_nonzero(np.bincount(which.reshape(-1), weights=ways)))


# --- trimesh --------------------------------------------------------------------------------------------


def check_trimesh(gltf: GltfFile) -> Iterator[Note]:
    """What trimesh sees against what the file says."""
    scene = trimesh.load_scene(gltf.path, process=False)
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


# --- manifest -------------------------------------------------------------------------------------------


def check_manifest(path: Path) -> list[Fault]:
    """The files that a manifest lists against those that are there."""
    def fault(message: str) -> Fault:
        return Fault(str(path), "manifest", "", message)

    try:
        document = json.loads(path.read_bytes())
        listed = {entry["path"]: entry for entry in manifest_files(document)}
    except (OSError, ValueError, KeyError, TypeError) as error:
        return [fault(f"cannot be read: {error!r}")]
    faults = []
    for name, entry in sorted(listed.items()):
        file = path.parent / name
        if Path(name).is_absolute() or ".." in Path(name).parts:
            faults.append(fault(f"the path {name!r} leaves the folder"))
        elif not file.is_file():
            faults.append(fault(f"{name} is listed and not there"))
        elif file.stat().st_size != entry["bytes"]:
            faults.append(fault(f"{name} has {file.stat().st_size} bytes, not {entry['bytes']}"))
        elif hashlib.sha256(file.read_bytes()).hexdigest() != entry["sha256"]:
            faults.append(fault(f"{name} has another hash than listed"))
    beside = {file.relative_to(path.parent).as_posix() for file in scenes_in(path.parent)}
    faults += [fault(f"{name} is there and not listed") for name in sorted(beside - listed.keys())]
    return faults


def manifest_files(document: dict) -> Iterator[dict]:
    """Every entry with a path, bytes and a hash."""
    for level in document["levels"]:
        yield from level["files"]
    yield from document.get("library", [])


# --- Khronos --------------------------------------------------------------------------------------------


def check_khronos(files: list[Path]) -> list[Fault]:
    """Runs the Khronos validator over some files."""
    command = ["node", str(HERE / "validate_gltf.mjs"), "-"]
    listed = "".join(f"{file.resolve()}\n" for file in files)
    done = subprocess.run(command, input=listed, capture_output=True, text=True, check=False)
    reports = [json.loads(line) for line in done.stdout.splitlines()]
    if len(reports) != len(files):
        return [Fault(str(files[0]), "khronos", "", f"the validator did not run: {done.stderr.strip()[-300:]}")]
    faults = []
    for file, report in zip(files, reports):
        for message in report["messages"]:
            if message["severity"] in ("error", "warning"):
                faults.append(Fault(str(file), "khronos", message["pointer"],
                                    f"{message['severity']} {message['code']}: {message['message']}"))
        if report["errors"] + report["warnings"] and not report["messages"]:
            faults.append(Fault(str(file), "khronos", "", "errors without a message"))
    return faults


# --- running --------------------------------------------------------------------------------------------

CHECKS = (check_paths, check_names, check_extras, check_geometry, check_trimesh)


def check_file(file: Path) -> tuple[list[Fault], dict]:
    """Every check of one file but the Khronos validator's, with counts for the report."""
    counts = {"nodes": 0, "rooms": 0, "furniture": 0}
    try:
        gltf = GltfFile(file)
        kinds = Counter(node.kind for node in gltf.nodes)
        counts = {"nodes": len(gltf.nodes), "rooms": kinds["room"], "furniture": kinds["furniture"]}
        # A folder of shared geometry holds meshes that nothing places.
        notes = list(chain.from_iterable(check(gltf) for check in CHECKS))
    except GltfError as error:
        notes = [Note("file", "", str(error))]
    except Exception as error:  # what a broken file can raise in other people's readers has no end
        notes = [Note("file", "", f"{type(error).__name__}: {error}")]
    return [Fault(str(file), *note) for note in notes], counts


def check_files(files: list[Path], jobs: int, with_khronos: bool) -> tuple[list[Fault], Counter]:
    faults: list[Fault] = []
    totals: Counter = Counter()
    with ProcessPoolExecutor(max_workers=jobs) as pool:
        shares = [files[start::jobs] for start in range(min(jobs, len(files)))] if with_khronos else []
        validators = [pool.submit(check_khronos, share) for share in shares]
        for number, (found, counts) in enumerate(pool.map(check_file, files), start=1):
            faults += found
            totals.update(counts)
            progress(number, len(files), len(faults))
        faults += chain.from_iterable(validator.result() for validator in validators)
    return faults, totals


def progress(done: int, of: int, faults: int) -> None:
    step = max(1, of // 20)
    if done % step == 0 or done == of:
        print(f"validate: {done} of {of} files, {faults} faults", file=sys.stderr, flush=True)


def scenes_in(folder: Path) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.suffix.lower() in SCENE_ENDINGS)


def find_inputs(paths: list[Path]) -> tuple[list[Path], list[Path]]:
    """The scenes and the manifests that the arguments name."""
    scenes, manifests = [], []
    for path in paths:
        if path.is_dir():
            scenes += scenes_in(path)
            manifests += sorted(path.rglob("manifest.json"))
        elif path.suffix.lower() in SCENE_ENDINGS:
            scenes.append(path)
        elif path.name.endswith(".json"):
            manifests.append(path)
        else:
            raise FileNotFoundError(f"{path} is no folder, .glb, .gltf or manifest")
    return scenes, manifests


def triple(values) -> str:
    return " x ".join(f"{value:.4f}" for value in values)


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--no-khronos", action="store_true", help="leave the Khronos validator out")
    parser.add_argument("--json", action="store_true", help="write one JSON document instead of lines")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    with_khronos = not options.no_khronos
    try:
        scenes, manifests = find_inputs(options.paths)
    except OSError as error:
        print(f"validate: {error}", file=sys.stderr)
        return 2
    if not scenes:
        print("validate: no .glb or .gltf there", file=sys.stderr)
        return 2
    if with_khronos and (shutil.which("node") is None or not (HERE / "node_modules" / "gltf-validator").is_dir()):
        print("validate: the Khronos validator needs node and `npm ci` in scripts/ (or --no-khronos)", file=sys.stderr)
        return 2
    faults, totals = check_files(scenes, max(1, options.jobs), with_khronos)
    faults += chain.from_iterable(map(check_manifest, manifests))
    faults.sort()
    report(options.json, scenes, manifests, totals, faults)
    return 1 if faults else 0


def report(as_json: bool, scenes: list[Path], manifests: list[Path], totals: Counter, faults: list[Fault]) -> None:
    counts = {"files": len(scenes), "manifests": len(manifests), **totals}
    if as_json:
        print(json.dumps({**counts, "faults": [fault._asdict() for fault in faults]}, indent=1))
        return
    for fault in faults:
        print(fault)
    print(", ".join(f"{count} {name}" for name, count in counts.items()) + f": {len(faults)} faults")


if __name__ == "__main__":
    sys.exit(main())
