"""The contract of the output: paths, names, and the extras of every node."""

from __future__ import annotations

import re
from collections import Counter
from functools import lru_cache
from typing import Iterator

import shapely

from ..gltf_document import GltfError, ImageError, OutsideError
from ..gltf_file import GltfFile, Node
from ..resources import shown

from .report import Note
from .schemas import extras_schemas

# The code of faults that keep other readers away from a file.
PATH = "path"
SIDES = {"front", "back", "left", "right", "above", "below"}
ROOM_PART = re.compile(r"floor|ceiling|wall\.\d+|column\.\d+|(door|window):.+")


def check_paths(gltf: GltfFile) -> Iterator[Note]:
    """Buffers and images are there, and lie where a floor may name them."""
    # A missing image is a fault by itself: everything else of the floor is judged without it.
    for kind, read in (("buffers", gltf.buffer), ("images", gltf.image)):
        for number in range(len(gltf.document.get(kind, []))):
            try:
                read(number)
            except GltfError as error:
                yield note_of(error)


def note_of(error: GltfError) -> Note:
    """A file that cannot be read, as a fault."""
    code = PATH if isinstance(error, OutsideError) else "texture" if isinstance(error, ImageError) else "file"
    return Note(code, "", str(error))


def check_names(gltf: GltfFile) -> Iterator[Note]:
    for name, count in Counter(node.name for node in gltf.nodes).items():
        if not name:
            yield Note("names", "", f"{count} nodes have no name")
        elif count > 1:
            yield Note("names", name, f"{count} nodes have this name")


def check_extras(gltf: GltfFile) -> Iterator[Note]:
    """Extras against their schema; those that fit, also against the other nodes."""
    schemas = extras_schemas()
    for node in gltf.nodes:
        if not isinstance(node.kind, str) or node.kind not in schemas:
            yield Note("extras", node.name, f"kind: {shown(node.extras.get('kind'))} is not one of {', '.join(schemas)}")
            continue
        violations = schemas[node.kind].violations(node.extras)
        yield from (Note("extras", node.name, str(violation)) for violation in violations)
        if all(violation.is_surplus for violation in violations):
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
        yield Note("extras", node.name, f"`placed` is {extras['placed']}, but {pieces} objects are below the room")
    outline = shapely.Polygon(extras["outline"], extras["holes"])
    if not outline.is_valid or outline.area <= 0.0:
        yield Note("extras", node.name, f"its outline is no area: {shapely.is_valid_reason(outline)}")


def check_part(_: GltfFile, node: Node) -> Iterator[Note]:
    if node.parent is None or node.parent.kind not in ("room", "opening"):
        yield Note("extras", node.name, "a part belongs to a room or an opening")


def check_furniture(gltf: GltfFile, node: Node) -> Iterator[Note]:
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
    parents = named_parents(gltf, node)
    if not parents and not ROOM_PART.fullmatch(extras["parent"]):
        yield Note("extras", node.name, f"`parent` is {extras['parent']!r}, which is not in its room")
    if node.parent.kind == "furniture" and all(node.parent is not parent for parent in parents):
        yield Note("extras", node.name, f"`parent` is {extras['parent']!r}, but the node is below "
                                        f"{node.parent.name!r}")


def named_parents(gltf: GltfFile, node: Node) -> list[Node]:
    """The piece of its room that a piece was arranged by, as its extras name it, the one that this one names, and so on."""
    pieces, room = pieces_by_id(gltf), room_of(node)
    found: list[Node] = []
    parent = pieces.get((id(room), text_of(node, "parent")))
    while parent is not None and not any(parent is other for other in [node, *found]):
        found.append(parent)
        parent = pieces.get((id(room), text_of(parent, "parent")))
    return found


@lru_cache(maxsize=1)
def pieces_by_id(gltf: GltfFile) -> dict[tuple[int, str], Node]:
    """The pieces of a file by their room's node and their id."""
    pieces = [node for node in gltf.nodes if node.kind == "furniture" and text_of(node, "id")]
    return {(id(room_of(node)), text_of(node, "id")): node for node in pieces}


def check_light(_: GltfFile, node: Node) -> Iterator[Note]:
    if node.parent is None or node.parent.kind != "furniture":
        yield Note("extras", node.name, "a light belongs to a lamp")


KIND_CHECKS = {"level": check_level, "opening": check_opening, "room": check_room, "part": check_part,
               "furniture": check_furniture, "light": check_light}


@lru_cache(maxsize=1)
def piece_counts(gltf: GltfFile) -> Counter:
    """How many pieces each room of a file holds; rooms without any are there too."""
    counts = Counter({text_of(node, "room"): 0 for node in gltf.nodes if node.kind == "room"})
    rooms = (room_of(node) for node in gltf.nodes if node.kind == "furniture")
    counts.update(text_of(room, "room") for room in rooms if room is not None)
    return counts


def text_of(node: Node, key: str) -> str:
    """A text of a node's extras; empty where there is none, which is a fault of that node alone."""
    value = node.extras.get(key)
    return value if isinstance(value, str) else ""


def room_of(node: Node) -> Node | None:
    """The room that a node belongs to."""
    while node is not None and node.kind != "room":
        node = node.parent
    return node
