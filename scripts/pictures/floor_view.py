"""A baked level as pictures need it: rooms, boxes of furniture and openings, in plan metres.

Plan coordinates: x east, y north, z up from the level's floor; the same axes as Blender's after its import.
Needs numpy only; render.py and its tests share it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from roomwright.gltf_file import GltfFile, Node

# The plan's axes from glTF's: x, y, z become x, -z, y.
AXES = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


class ViewError(Exception):
    """A picture that cannot be taken; the text says why."""


@dataclass(frozen=True)
class Room:
    """One room: its outline runs counter-clockwise along the inner faces of its walls."""

    name: str
    type: str
    style: str
    outline: np.ndarray  # n x 2
    holes: tuple[np.ndarray, ...]
    height: float

    def wall_edges(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """The edges of the outline; edge n belongs to the part wall.n."""
        return list(zip(self.outline, np.roll(self.outline, -1, axis=0)))

    def outward(self, edge: int) -> np.ndarray:
        """Unit normal of an edge, away from the room."""
        start, end = self.wall_edges()[edge]
        along = (end - start) / np.linalg.norm(end - start)
        return np.array([along[1], -along[0]])

    def middle(self) -> np.ndarray:
        return (self.outline.min(axis=0) + self.outline.max(axis=0)) / 2


@dataclass(frozen=True)
class Box:
    """The box of one piece of furniture."""

    room: str
    name: str
    parent: str
    corners: np.ndarray  # 4 x 2, around its footprint
    low: float
    high: float


@dataclass(frozen=True)
class Opening:
    """A door or window: where it meets each room's wall."""

    node: str
    kind: str
    sides: tuple[dict, ...]
    width: float
    height: float
    sill: float
    leaves: tuple[tuple[np.ndarray, np.ndarray], ...]  # hinge and tip of each open leaf


@dataclass
class Level:
    """A level of a building."""

    building: str
    name: str
    rooms: list[Room] = field(default_factory=list)
    boxes: list[Box] = field(default_factory=list)
    openings: list[Opening] = field(default_factory=list)

    def room(self, name: str) -> Room:
        """The room of that id."""
        for room in self.rooms:
            if room.name == name:
                return room
        known = ", ".join(sorted(room.name for room in self.rooms)) or "none"
        raise ViewError(f"no room {name!r}; rooms of {self.building}/{self.name}: {known}")

    def boxes_of(self, room: Room) -> list[Box]:
        return [box for box in self.boxes if box.room == room.name]

    def openings_of(self, room: Room) -> list[tuple[Opening, dict]]:
        """Openings in the walls of a room, each with its side in that room."""
        return [(opening, side) for opening in self.openings for side in opening.sides if side["room"] == room.name]


def read_level(file: GltfFile) -> Level:
    """Reads the extras of a file that roomwright baked."""
    level = None
    for node in file.nodes:
        if node.kind == "level":
            level = Level(node.extras["building"], node.extras["level"])
        elif level is not None:
            _add(level, node)
    if level is None or not level.rooms:
        raise ViewError("no room in it; is it a level that roomwright baked?")
    return level


def _add(level: Level, node: Node) -> None:
    extras = node.extras
    if node.kind == "room":
        holes = tuple(np.array(hole, float) for hole in extras.get("holes", []))
        level.rooms.append(Room(extras["room"], extras["type"], extras["style"], np.array(extras["outline"], float),
                                holes, float(extras["height"])))
    elif node.kind == "opening":
        leaves = tuple((np.array(leaf["hinge"], float), np.array(leaf["open"], float))
                       for leaf in extras.get("leaves", []))
        level.openings.append(Opening(node.name, extras["opening"], tuple(extras["sides"]), extras["width"],
                                      extras["height"], extras["sill"], leaves))
    elif node.kind == "furniture":
        level.boxes.append(_box(node))


def _box(node: Node) -> Box:
    width, depth, height = node.extras["size"]
    corners = [(x, y, z, 1.0) for y in (0.0, height)
               for x, z in ((-width / 2, -depth / 2), (width / 2, -depth / 2),
                            (width / 2, depth / 2), (-width / 2, depth / 2))]
    placed = (np.array(corners) @ node.world.T)[:, :3] @ AXES.T
    return Box(room_of(node), node.name, node.extras["parent"], placed[:4, :2], placed[:, 2].min(), placed[:, 2].max())


def room_of(node: Node | None) -> str:
    """The id of the room that a node is in, or nothing."""
    while node is not None:
        if node.kind == "room":
            return node.extras["room"]
        node = node.parent
    return ""


def is_inside(points: np.ndarray, room: Room) -> np.ndarray:
    """Which points lie on the floor of a room."""
    inside = _in_ring(points, room.outline)
    for hole in room.holes:
        inside &= ~_in_ring(points, hole)
    return inside


def _in_ring(points: np.ndarray, ring: np.ndarray) -> np.ndarray:
    x, y = points[:, :1], points[:, 1:]
    (ax, ay), (bx, by) = ring.T, np.roll(ring, -1, axis=0).T
    spans = (ay > y) != (by > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        cross = ax + (y - ay) * (bx - ax) / (by - ay)
    return (np.where(spans, x < cross, False).sum(axis=1) % 2).astype(bool)


def distances(point: np.ndarray, ring: np.ndarray) -> float:
    """Metres from a point to the nearest edge of a ring."""
    start, along = ring, np.roll(ring, -1, axis=0) - ring
    share = np.clip(((point - start) * along).sum(axis=1) / np.maximum((along ** 2).sum(axis=1), 1e-12), 0.0, 1.0)
    return float(np.linalg.norm(start + along * share[:, None] - point, axis=1).min())
