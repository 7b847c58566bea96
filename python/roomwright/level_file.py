"""Reads a level from its .glb or .gltf, by the extras of its nodes and without its meshes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from .gltf_document import read_document
from .poses import Pose
from .records import Level, Placement, Point, Removal, Room
from .resources import reach_of


class LevelError(Exception):
    """A file that holds no level; the text says why."""


class Found(NamedTuple):
    """A node of the tree, with the room and the piece of furniture that it belongs to."""

    extras: dict[str, Any]
    pose: Pose
    room: str
    carrier: str | None


def read_level(file: Path, folder: Path) -> Level:
    """The level of a file in the folder of a bake. Raises LevelError and GltfError."""
    document, _ = read_document(file, reach_of(file, folder))
    try:
        found = list(nodes_of(document))
        levels = [node.extras for node in found if node.extras.get("kind") == "level"]
        if len(levels) != 1:
            raise LevelError(f"it has {len(levels)} nodes of the kind `level` in place of one")
        return level_of(levels[0], file, found)
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        raise LevelError(f"its nodes are not those of a level, {type(error).__name__}: {error}; "
                         "hint: roomwright-validate names the faults of a file") from error


def nodes_of(document: dict[str, Any]) -> Iterator[Found]:
    """The nodes of the first scene, parents before children, in the order of the file."""
    nodes = document["nodes"]
    waiting = [(index, Pose(), "", None) for index in reversed(document["scenes"][0]["nodes"])]
    seen: set[int] = set()
    while waiting:
        index, above, room, carrier = waiting.pop()
        if index in seen:
            raise ValueError(f"node {index} has two parents")
        seen.add(index)
        node = nodes[index]
        extras = node.get("extras", {})
        pose = above.child(node)
        room = extras["room"] if extras.get("kind") == "room" else room
        yield Found(extras, pose, room, carrier)
        carrier = extras["id"] if extras.get("kind") == "furniture" else carrier
        waiting += [(child, pose, room, carrier) for child in reversed(node.get("children", []))]


def level_of(extras: dict[str, Any], file: Path, found: list[Found]) -> Level:
    furniture: dict[str, list[Placement]] = {}
    for node in found:
        if node.extras.get("kind") == "furniture":
            furniture.setdefault(node.room, []).append(placement_of(node))
    rooms = [node.extras for node in found if node.extras.get("kind") == "room"]
    return Level(extras["building"], extras["level"], file, float(extras["elevation"]), float(extras["height"]),
                 tuple(room_of(room, furniture.get(room["room"], [])) for room in rooms))


def room_of(extras: dict[str, Any], placements: list[Placement]) -> Room:
    score = extras.get("score")
    removed = tuple(Removal(entry["class"], entry["reason"], bool(entry.get("required", False))) for entry in extras["removed"])
    return Room(extras["room"], extras["type"], extras["style"], int(extras["seed"]), points_of(extras["outline"]),
                tuple(points_of(hole) for hole in extras["holes"]), float(extras["height"]), extras["requested"], removed,
                extras.get("grade", ""), None if score is None else float(score), tuple(extras.get("findings", [])),
                tuple(placements))


def placement_of(node: Found) -> Placement:
    extras, pose = node.extras, node.pose.in_plan()
    width, depth, height = map(float, extras["size"])
    return Placement(extras["class"], extras["id"], node.room, extras["parent"], extras["side"], node.carrier, pose.position,
                     pose.rotation, (width, depth, height), extras["variant"])


def points_of(listed: list[list[float]]) -> tuple[Point, ...]:
    return tuple((float(x), float(y)) for x, y in listed)
