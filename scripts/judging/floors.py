"""Finished files as rooms with pieces: meshes for shapes, extras for what things are.

Nothing here or in the measures reads the findings that the extras carry; comparison.py does, after the judgement.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np
import shapely

from roomwright.gltf_file import GltfFile, Node

from .drawn import Drawn
from .pieces import Mesh, MeshShelf, Piece
from .roles import KITCHENS, SHARED_WAYS
from .shapes import Wall, straight_walls, walls_of


@dataclass(frozen=True)
class Side:
    """An opening in a wall of a room."""

    wall: Wall
    start: float  # metres along the wall
    end: float

    @property
    def middle(self) -> np.ndarray:
        return self.wall.at((self.start + self.end) / 2)

    def before(self, depth: float) -> shapely.Polygon:
        return self.wall.strip(self.start, self.end, depth)


@dataclass(frozen=True)
class Opening:
    id: str
    is_door: bool
    closure: str  # door, sliding, passage, open, window
    rooms: tuple[str, ...]
    sides: tuple[tuple[str, int, float, float], ...]  # room, wall, from, to
    width: float
    height: float
    sill: float
    swings: tuple[shapely.Polygon, ...]  # the sectors of its leaves


@dataclass(eq=False)
class Room:
    floor: Floor
    id: str
    kind: str  # its type
    style: str
    region: shapely.Polygon
    walls: list[Wall]
    height: float
    extras: dict
    pieces: list[Piece] = field(default_factory=list)
    # Columns, flights and wells: shape from above, height. Nothing stands there, and the floor beside them is what one walks on.
    columns: list[tuple[shapely.Polygon, float]] = field(default_factory=list)
    drawn: list[Drawn] = field(default_factory=list)
    walkable: dict[tuple[float, bool], list[shapely.Polygon]] = field(default_factory=dict)  # clear.py keeps it

    @property
    def area(self) -> float:
        return self.region.area

    def of(self, kinds: set[str]) -> list[Piece]:
        return [piece for piece in self.pieces if piece.kind in kinds]

    def openings(self, doors: bool) -> list[tuple[Opening, Side]]:
        """Its doors, passages and open boundaries, or its windows, each with its place in a wall."""
        found = []
        for opening in self.floor.openings:
            found += [(opening, Side(self.walls[wall], start, end)) for room, wall, start, end in opening.sides
                      if room == self.id and opening.is_door == doors and wall < len(self.walls)]
        return found

    @cached_property
    def straight_walls(self) -> list[list[Wall]]:
        return straight_walls(self.walls)

    @cached_property
    def standing(self) -> list[Piece]:
        return [piece for piece in self.pieces if piece.stands]


@dataclass(eq=False)
class Floor:
    building: str
    level: str
    seed: int
    openings: list[Opening] = field(default_factory=list)
    rooms: list[Room] = field(default_factory=list)

    @cached_property
    def flats(self) -> dict[str, int]:
        """A number for each room that a dwelling has; rooms of one dwelling share it."""
        links = [opening.rooms for opening in self.openings if opening.is_door and len(opening.rooms) == 2]
        kinds = {room.id: room.kind for room in self.rooms}
        inside = {room for room, kind in kinds.items() if kind not in SHARED_WAYS}
        shared = {room for pair in links for room, other in (pair, pair[::-1])
                  if kinds.get(room) == "corridor" and kinds.get(other) in ("stairs", "elevator")}
        flats: dict[str, int] = {}
        for group in joined(inside, links):
            # A corridor at the stairs that leads to several kitchens belongs to none of their dwellings.
            kitchens = sum(kinds[room] in KITCHENS for room in group)
            parts = joined(group - shared, links) if kitchens > 1 else [group]
            for part in parts:
                flats |= dict.fromkeys(part, len(flats))
        return flats


def joined(members: set[str], links: list[tuple[str, ...]]) -> list[set[str]]:
    """Members in groups that links hold together."""
    near: dict[str, list[str]] = {member: [] for member in sorted(members)}
    for one, other in links:
        if one in members and other in members:
            near[one].append(other)
            near[other].append(one)
    groups, seen = [], set()
    for first in near:
        if first in seen:
            continue
        group, stack = set(), [first]
        while stack:
            room = stack.pop()
            if room not in group:
                group.add(room)
                stack += near[room]
        seen |= group
        groups.append(group)
    return groups


# --- reading ---


def read_floor(path: Path, shelf: MeshShelf | None = None) -> Floor:
    """A finished file, with the meshes of a shelf.

    Raises GltfError for what is no glTF file, KeyError or ValueError for extras that lack something.
    """
    gltf, shelf = GltfFile(path), shelf or MeshShelf()
    level = next(node for node in gltf.nodes if node.kind == "level").extras
    floor = Floor(level["building"], level["level"], int(level["seed"]))
    rooms: dict[int, Room] = {}
    pieces: dict[int, Piece] = {}
    meshes: dict[int, Mesh] = {}
    for node in gltf.nodes:
        if node.kind == "opening":
            floor.openings.append(read_opening(node.extras))
        elif node.kind == "room":
            rooms[node.index] = read_room(floor, node.extras)
        elif node.kind == "furniture" and node.mesh is not None:
            mesh = meshes.get(node.mesh) or meshes.setdefault(node.mesh, shelf.mesh(gltf.primitives(node.mesh)))
            carrier = pieces.get(node.parent.index)
            piece = Piece(node.extras["id"], node.extras["class"], node.extras["parent"], node, mesh, carrier)
            pieces[node.index] = piece
            rooms[room_index(node)].pieces.append(piece)
        elif node.kind == "part" and {"outline", "height"} <= node.extras.keys():
            rooms[room_index(node)].columns.append((shapely.Polygon(node.extras["outline"]), node.extras["height"]))
    floor.rooms = list(rooms.values())
    return floor


def room_index(node: Node) -> int:
    while node.kind != "room":
        node = node.parent
    return node.index


def read_room(floor: Floor, extras: dict) -> Room:
    outline, holes = extras["outline"], extras["holes"]
    region = shapely.make_valid(shapely.Polygon(outline, holes))
    return Room(floor, extras["room"], extras["type"], extras["style"], region, walls_of(outline, holes),
                extras["height"], extras)


def read_opening(extras: dict) -> Opening:
    sides = tuple((side["room"], side["wall"], side["from"], side["to"]) for side in extras["sides"])
    swings = tuple(sector(leaf) for leaf in extras.get("leaves", []) if "hinge" in leaf)
    return Opening(extras["id"], extras["opening"] == "door", extras["closure"], tuple(extras["rooms"]), sides,
                   extras["width"], extras["height"], extras["sill"], swings)


def sector(leaf: dict) -> shapely.Polygon:
    """What a leaf sweeps."""
    hinge, closed, opened = (np.array(leaf[key], float) for key in ("hinge", "closed", "open"))
    first, last = closed - hinge, opened - hinge
    start = np.arctan2(first[1], first[0])
    turn = np.arctan2(first[0] * last[1] - first[1] * last[0], first @ last)
    angles = start + np.linspace(0.0, turn, 13)
    arc = hinge + np.hypot(*first) * np.column_stack([np.cos(angles), np.sin(angles)])
    return shapely.Polygon([hinge, *arc])
