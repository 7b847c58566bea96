"""The shell of a level as it was built: parts of walls, columns, frames and leaves, the floors of rooms, and doorways.

Every part is cut at the middle of each of its storeys: between two heights of its corners, parts of the shell are upright
prisms. The outline of the cut says how far the part reaches.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from ..gltf_file import GltfFile, Node

from .bodies import Part
from .pieces import Meshes
from .schemas import extras_schemas

# Metres that a part may reach into a room, a doorway or a piece of furniture, where the room does not say so itself.
LIMIT = 0.01
# Metres that skirting boards and plates of sockets stand out of walls, and the height up to which a part is one of these.
FITTING_DEPTH = 0.016
FITTING_HEIGHT = 0.1
# Metres beside an opening, and into the room, in which its frame (`FRAME_WIDTH` in src/plan/building.rs), its sill and its
# handles stand.
FRAME_WIDTH = 0.06
FRAME_DEPTH = 0.045
# Metres of height between corners that make a storey of a part.
LEAST_STOREY = 0.002
WALKABLE = {"door", "sliding", "passage", "open"}


@dataclass(eq=False)
class ShellPart:
    """A closed surface of the shell where it stands."""

    node: Node
    # The room or opening that it belongs to.
    owner: Node
    part: Part

    @property
    def is_fitting(self) -> bool:
        return self.owner.kind == "room" and self.part.high[1] - self.part.low[1] < FITTING_HEIGHT

    @cached_property
    def cuts(self) -> list[tuple[float, np.ndarray]]:
        """The contour at the middle of each storey: its height, and n segments of two points in the plan's axes."""
        ring = self.part.corners[self.part.triangles]
        low, high = ring[:, :, 1].min(axis=1), ring[:, :, 1].max(axis=1)
        levels = np.unique(np.round(self.part.corners[:, 1], 4))
        middles = (levels[1:] + levels[:-1])[np.diff(levels) > LEAST_STOREY] / 2
        return [(float(height), contour(ring[(low < height) & (high > height)], height)) for height in middles]

    @cached_property
    def box(self) -> shapely.Geometry:
        low, high = self.part.low, self.part.high
        return shapely.box(low[0], -high[2], high[0], -low[2])


def contour(ring: np.ndarray, height: float) -> np.ndarray:
    """Where triangles cross a height: one segment each, in the plan's axes (x east, y north)."""
    above = ring[:, :, 1] > height
    # The corner that is alone on its side, then the two others.
    lone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    rows = np.arange(len(ring))
    single = ring[rows, lone]
    ends = []
    for step in (1, 2):
        other = ring[rows, (lone + step) % 3]
        share = (height - single[:, 1]) / (other[:, 1] - single[:, 1])
        point = single + (other - single) * share[:, None]
        ends.append(point[:, [0, 2]] * (1, -1))
    return np.stack(ends, axis=1)


@dataclass(eq=False)
class RoomFloor:
    """The free floor of a room in the plan's axes."""

    node: Node
    columns: list[Node]

    @cached_property
    def outline(self) -> shapely.Polygon:
        return shapely.Polygon(self.node.extras["outline"], self.node.extras["holes"])

    @cached_property
    def free(self) -> shapely.Geometry:
        """The floor that no wall may enter."""
        return self.inner(LIMIT)

    @cached_property
    def free_of_fittings(self) -> shapely.Geometry:
        """The floor that no skirting board may enter."""
        return self.inner(FITTING_DEPTH)

    def inner(self, depth: float) -> shapely.Geometry:
        """The floor from a distance from the walls on, without the room's columns."""
        inner = self.outline.buffer(-depth, join_style="mitre")
        if self.columns:
            inner = inner.difference(self.column_area)
        shapely.prepare(inner)
        return inner

    @cached_property
    def column_area(self) -> shapely.Geometry:
        outlines = [shapely.Polygon(column.extras["outline"]) for column in self.columns]
        return shapely.union_all([outline.buffer(LIMIT, join_style="mitre") for outline in outlines])

    @cached_property
    def borders(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Start and end of each wall, by number; the walls of holes follow those of the outline."""
        rings = [np.array(self.node.extras["outline"], float)]
        found = [(ring[i], ring[(i + 1) % len(ring)]) for ring in rings for i in range(len(ring))]
        for hole in (np.array(hole, float) for hole in self.node.extras["holes"]):
            found += [(hole[(i + 1) % len(hole)], hole[i]) for i in range(len(hole))]
        return found

    def ends_of(self, side: dict) -> tuple[np.ndarray, np.ndarray] | None:
        """Where an opening begins and ends on one of the walls; none if there is no such wall."""
        if side["wall"] >= len(self.borders):
            return None
        start, end = self.borders[side["wall"]]
        along = (end - start) / max(np.linalg.norm(end - start), 1e-9)
        return start + along * side["from"], start + along * side["to"]


class Shell:
    """The shell of a level: its parts, rooms and openings."""

    def __init__(self, gltf: GltfFile):
        schemas = extras_schemas()
        usable = {kind: [node for node in gltf.nodes if node.kind == kind and schemas[kind].is_usable(node.extras)]
                  for kind in ("room", "opening", "part")}
        self.gltf = gltf
        self.openings: list[Node] = usable["opening"]
        self.by_room: dict[str, RoomFloor] = {}
        for node in usable["room"]:
            # Stairs say where they are, too, but no wall may stand in a flight or in a well.
            columns = [part for part in usable["part"] if part.parent is node and part.extras["part"] != "stairs"
                       and {"outline", "height"} <= part.extras.keys()]
            self.by_room[node.extras["room"]] = RoomFloor(node, columns)
        self.rooms = list(self.by_room.values())
        self.parts = self._parts(usable["part"])

    def _parts(self, nodes: list[Node]) -> list[ShellPart]:
        meshes = Meshes(self.gltf)
        found = []
        for node in nodes:
            # Floors and ceilings are the room's own borders; stairs are where people walk.
            is_own = node.extras["part"] in ("floor", "ceiling", "stairs")
            if node.mesh is None or is_own or node.parent is None or node.parent.kind not in ("room", "opening"):
                continue
            found += [ShellPart(node, node.parent, part.placed(node.world)) for part in meshes.parts(node.mesh)]
        return found

    @cached_property
    def room_tree(self) -> shapely.STRtree:
        return shapely.STRtree([room.outline for room in self.rooms])

    def rooms_near(self, part: ShellPart) -> list[RoomFloor]:
        return [self.rooms[number] for number in sorted(self.room_tree.query(part.box))]

    @cached_property
    def doorways(self) -> list[Doorway]:
        found = (doorway_of(opening, self) for opening in self.openings)
        return [doorway for doorway in found if doorway is not None]

    @cached_property
    def doorway_tree(self) -> shapely.STRtree:
        return shapely.STRtree([doorway.area for doorway in self.doorways])

    @cached_property
    def frame_strips(self) -> dict[tuple[str, int], shapely.Geometry]:
        """Of each opening in each of its rooms, where its frame may stand: by the room's id and the opening's node."""
        found = {}
        for opening in self.openings:
            for side in opening.extras["sides"]:
                ends = self.ends_of(side)
                if ends is not None:
                    found[side["room"], opening.index] = strip(*ends, FRAME_WIDTH + LIMIT, FRAME_DEPTH)
        return found

    @cached_property
    def holes(self) -> dict[tuple[str, int], list[tuple[float, float]]]:
        """The openings of each side of each room, in metres from its start."""
        found: dict[tuple[str, int], list[tuple[float, float]]] = {}
        for opening in self.openings:
            for side in opening.extras["sides"]:
                found.setdefault((side["room"], side["wall"]), []).append((side["from"], side["to"]))
        return found

    @cached_property
    def wall_tree(self) -> shapely.STRtree:
        """The contours of all walls and railings, at all heights; skirting boards close nothing."""
        walls = [part for part in self.parts if part.owner.kind == "room" and part.part.high[1] > FITTING_HEIGHT]
        cuts = [segments for part in walls for _, segments in part.cuts if len(segments)]
        return shapely.STRtree(shapely.linestrings(np.concatenate(cuts)) if cuts else [])

    def is_walled(self, room: RoomFloor) -> bool:
        """Whether the file shows the room's walls at all."""
        return any(part.owner is room.node for part in self.parts)

    def ends_of(self, side: dict) -> tuple[np.ndarray, np.ndarray] | None:
        """Where an opening begins and ends on the wall of a room; none if the room or wall is not in the file."""
        room = self.by_room.get(side["room"])
        return None if room is None else room.ends_of(side)


def strip(start: np.ndarray, end: np.ndarray, margin: float, depth: float) -> shapely.Polygon:
    """A rectangle along a stretch of wall, on both sides of its face."""
    along = (end - start) / max(np.linalg.norm(end - start), 1e-9)
    across = np.array([-along[1], along[0]]) * depth
    low, high = start - along * margin, end + along * margin
    return shapely.Polygon([low - across, high - across, high + across, low + across])


@dataclass(eq=False)
class Doorway:
    """The way through a wall, narrower by the limit at each side."""

    node: Node
    area: shapely.Polygon
    top: float


def doorway_of(opening: Node, level: Shell) -> Doorway | None:
    """The way between the faces of the two rooms that an opening joins; none where no wall lies between them."""
    extras = opening.extras
    ends = [level.ends_of(side) for side in extras["sides"]]
    if extras["closure"] not in WALKABLE or len(ends) != 2 or any(end is None for end in ends):
        return None
    (start, end), (other_end, other_start) = ends
    length = np.linalg.norm(end - start)
    along = (end - start) / max(length, 1e-9)
    across = np.array([-along[1], along[0]])
    low = max(0.0, (other_start - start) @ along) + LIMIT
    high = min(length, (other_end - start) @ along) - LIMIT
    depths = sorted([0.0, float(((other_start + other_end) / 2 - start) @ across)])
    if high <= low or depths[1] - depths[0] <= 2 * LIMIT:
        return None
    corners = [(low, depths[0]), (high, depths[0]), (high, depths[1]), (low, depths[1])]
    area = shapely.Polygon([start + along * u + across * v for u, v in corners])
    return Doorway(opening, area, extras.get("sill", 0.0) + extras["height"])
