"""Stairs of a level, measured on the meshes: steps that rise evenly, room for heads above them, floor before doors.

storeys.py has what a flight has to do with the level above it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from ..gltf_file import GltfFile, Node

from .bodies import surfaces_of
from .contract import room_of
from .report import Note
from .schemas import extras_schemas
from .shell_parts import WALKABLE, RoomFloor
from .undersides import Undersides, area_above

# Metres: what is narrower is a handrail or a post, and no step.
NARROWEST_STEP = 0.1
# Metres of the highest rise, and by which the rises of a flight may differ: corners are rounded to millimetres.
HIGHEST_RISE = 0.21
EVEN = 0.005
# Metres over a tread that are open.
HEADROOM = 2.0
# Metres of a tread's edge that are not measured: handrails stand there, and pictures hang on the wall beside it.
EDGE = 0.06
# Metres of floor before a door, and metres from a doorway in which a flight begins or ends.
BEFORE_DOOR = 0.6
AT_DOOR = 0.15
# Square metres and metres that rounding leaves.
LEAST_AREA = 0.005
NEAR = 0.02
# Metres along which a step and a floor meet: nearly the width of the narrowest flight.
LEAST_MEETING = 0.6
# Metres up to which what has no steps may be high: the balustrade of a well.
BALUSTRADE = 1.2


@dataclass(eq=False)
class Solid:
    """A step, a landing, a post or a piece of a handrail, in the scene's frame: x east, y up, z south."""

    corners: np.ndarray
    triangles: np.ndarray

    @cached_property
    def volume(self) -> float:
        """Cubic metres; less than nothing where the faces look inwards."""
        ring = self.corners[self.triangles] - self.corners.mean(axis=0)
        return float(np.einsum("ij,ij->i", ring[:, 0], np.cross(ring[:, 1], ring[:, 2])).sum()) / 6.0

    @cached_property
    def shape(self) -> shapely.Geometry:
        """Its hull from above, in the plan's axes."""
        return shapely.MultiPoint(self.corners[:, [0, 2]] * (1, -1)).convex_hull

    @cached_property
    def bottom(self) -> float:
        return float(self.corners[:, 1].min())

    @cached_property
    def top(self) -> float:
        return float(self.corners[:, 1].max())

    @cached_property
    def tread(self) -> shapely.Polygon:
        """Its top in the plan's axes."""
        corners = self.corners[self.corners[:, 1] > self.top - 1e-3]
        return shapely.MultiPoint(corners[:, [0, 2]] * (1, -1)).convex_hull

    @cached_property
    def way(self) -> shapely.Geometry:
        """The tread without its edge."""
        return self.tread.buffer(-EDGE, join_style="mitre")


@dataclass(eq=False)
class Stairs:
    """The stairs of a room: a flight up, or only the balustrade of a well."""

    node: Node
    room: RoomFloor
    steps: list[Solid]  # the lowest first
    rails: list[Solid]  # with their posts

    @property
    def height(self) -> float:
        return self.node.extras["height"]

    @cached_property
    def outline(self) -> shapely.Polygon:
        return shapely.Polygon(self.node.extras["outline"])


class StairsOfLevel:
    """The stairs of a file, with what is around them."""

    def __init__(self, gltf: GltfFile):
        self.gltf = gltf
        self.parts = [node for node in self._usable("part") if node.parent is not None]
        self.rooms = {node.index: RoomFloor(node, []) for node in self._usable("room")}
        self.stairs = [self._stairs(node) for node in self.parts if node.extras["part"] == "stairs"
                       and {"outline", "height"} <= node.extras.keys() and node.parent.index in self.rooms]

    def _usable(self, kind: str) -> list[Node]:
        """The nodes of a kind whose extras can be read; of parts, those that show something."""
        schema = extras_schemas()[kind]
        return [node for node in self.gltf.nodes if node.kind == kind and (node.mesh is not None or kind != "part")
                and schema.is_usable(node.extras)]

    def _stairs(self, node: Node) -> Stairs:
        solids = [Solid(placed(corners, node), triangles) for primitive in self.gltf.primitives(node.mesh)
                  for corners, triangles in surfaces_of(primitive)]
        steps = sorted(filter(is_step, solids), key=lambda step: step.top)
        return Stairs(node, self.rooms[node.parent.index], steps, [solid for solid in solids if not is_step(solid)])

    def floor_area(self, room: RoomFloor) -> shapely.Geometry:
        """What one stands on in a room, in the plan's axes."""
        return shapely.union_all([area_above(self.triangles(node)) for node in self.parts_in(room, "floor")])

    def parts_in(self, room: RoomFloor, *kinds: str) -> list[Node]:
        return [node for node in self.parts if node.parent is room.node and (not kinds or node.extras["part"] in kinds)]

    def triangles(self, node: Node) -> np.ndarray:
        """The triangles of a node's mesh in the scene's frame, n x 3 x 3."""
        rings = [primitive["positions"].astype(float)[primitive["triangles"]] for primitive in self.gltf.primitives(node.mesh)]
        return placed(np.concatenate(rings), node)

    @cached_property
    def furniture(self) -> dict[int, list[Node]]:
        """By the nodes of rooms."""
        found: dict[int, list[Node]] = {}
        for node in self.gltf.nodes:
            room = room_of(node) if node.kind == "furniture" and node.mesh is not None else None
            if room is not None:
                found.setdefault(room.index, []).append(node)
        return found

    def furniture_in(self, room: RoomFloor) -> list[Node]:
        return self.furniture.get(room.node.index, [])

    @cached_property
    def openings(self) -> list[Node]:
        return self._usable("opening")

    def is_at_doorway(self, room: RoomFloor, step: Solid) -> bool:
        """Whether stairs begin or end at a step in a doorway of a room: the floor is behind it."""
        return any(doorway.is_end_of(step) for doorway in self.doorways(room))

    def doorways(self, room: RoomFloor) -> Iterator[Doorway]:
        """The ways in and out of a room."""
        for opening in self.openings:
            for side in opening.extras["sides"]:
                ends = room.ends_of(side) if side["room"] == room.node.extras["room"] else None
                if ends is not None and opening.extras["closure"] in WALKABLE and opening.extras["sill"] < EDGE:
                    yield Doorway(opening, room, *ends)


@dataclass(eq=False)
class Doorway:
    """A way into a room, as seen from there."""

    opening: Node
    room: RoomFloor
    start: np.ndarray
    end: np.ndarray

    @cached_property
    def zone(self) -> shapely.Geometry:
        """The floor before it."""
        along = (self.end - self.start) / max(np.linalg.norm(self.end - self.start), 1e-9)
        inward = np.array([-along[1], along[0]]) * BEFORE_DOOR
        return shapely.Polygon([self.start, self.end, self.end + inward, self.start + inward]).intersection(self.room.outline)

    def is_end_of(self, step: Solid) -> bool:
        """Whether stairs begin or end in it, at this step; not where a leaf opens over them."""
        leaves = [leaf["open"] for leaf in self.opening.extras.get("leaves", []) if "hinge" in leaf]
        if any(shapely.intersects_xy(self.room.outline.buffer(-NEAR), *place) for place in leaves):
            return False
        ring = shapely.get_coordinates(step.tread.exterior)
        return any(self.is_along(start, end) for start, end in zip(ring, ring[1:]))

    def is_along(self, start: np.ndarray, end: np.ndarray) -> bool:
        """Whether one steps through it over an edge of a tread."""
        along = (self.end - self.start) / max(np.linalg.norm(self.end - self.start), 1e-9)
        across = np.array([-along[1], along[0]])
        places, depths = ([(point - self.start) @ axis for point in (start, end)] for axis in (along, across))
        shared = min(max(places), (self.end - self.start) @ along) - max(min(places), 0.0)
        return shared >= LEAST_MEETING and np.abs(depths).max() <= AT_DOOR


def placed(corners: np.ndarray, node: Node) -> np.ndarray:
    """Corners of a node's mesh in the scene's frame."""
    return corners @ node.world[:3, :3].T + node.world[:3, 3]


def is_step(solid: Solid) -> bool:
    area = solid.shape.minimum_rotated_rectangle
    ring = shapely.get_coordinates(area)
    return area.geom_type == "Polygon" and bool(np.linalg.norm(np.diff(ring[:3], axis=0), axis=1).min() > NARROWEST_STEP)


def check_stairs(gltf: GltfFile) -> Iterator[Note]:
    level = StairsOfLevel(gltf)
    for stairs in level.stairs:
        inverted = sum(solid.volume < 0.0 for solid in stairs.steps + stairs.rails)
        if inverted:
            yield note(stairs, f"the faces of {inverted} of its steps, posts and handrails look inwards")
        if stairs.steps:
            yield from check_rises(stairs)
            yield from check_joints(stairs, level)
            yield from check_doors(stairs, level)
            yield from check_headroom(stairs, level)
        elif stairs.height > BALUSTRADE:
            yield note(stairs, f"it is {stairs.height:.3f} m high and has no steps")


def note(stairs: Stairs, message: str) -> Note:
    return Note("stairs", stairs.node.name, message)


def check_rises(stairs: Stairs) -> Iterator[Note]:
    """Steps as high as each other up to the floor above, which is the last one."""
    tops = [step.top for step in stairs.steps]
    # Landings of two pieces have one height.
    tops = [top for top, below in zip(tops, [0.0, *tops]) if top - below > EVEN]
    rises = np.diff([0.0, *tops, stairs.height])
    if rises.max() > HIGHEST_RISE + 1e-3:
        number = np.flatnonzero(rises > rises.max() - EVEN)[0] + 1
        yield note(stairs, f"step {number} of {len(rises)} is {rises.max() * 1000:.0f} mm high")
    if rises.max() - rises.min() > EVEN:
        yield note(stairs, f"its steps are from {rises.min() * 1000:.0f} to {rises.max() * 1000:.0f} mm high")


def check_joints(stairs: Stairs, level: StairsOfLevel) -> Iterator[Note]:
    """A way up without gaps: from the floor to the first step, and from step to step."""
    first = stairs.steps[0]
    if not is_met(level.floor_area(stairs.room), first) and not level.is_at_doorway(stairs.room, first):
        yield note(stairs, f"no floor is before its first step at {place_of(first.tread)}")
    for number, (step, above) in enumerate(zip(stairs.steps, stairs.steps[1:]), 2):
        gap = step.tread.distance(above.tread)
        if gap > NEAR:
            yield note(stairs, f"step {number} is {gap:.3f} m beside the one before it")


def is_met(floor: shapely.Geometry, step: Solid) -> bool:
    """Whether one steps over an edge of a step from a floor, or onto it."""
    return floor.buffer(NEAR, join_style="mitre").intersection(step.tread.exterior).length >= LEAST_MEETING


def check_doors(stairs: Stairs, level: StairsOfLevel) -> Iterator[Note]:
    for doorway in level.doorways(stairs.room):
        if doorway.is_end_of(stairs.steps[0]):
            continue
        low = [step for step in stairs.steps if step.bottom < HEADROOM]
        met = [step.tread.intersection(doorway.zone) for step in low]
        areas = [area for area in met if area.area > LEAST_AREA]
        if areas:
            yield note(stairs, f"{len(areas)} of its steps lie within {BEFORE_DOOR} m of {doorway.opening.name}, one at "
                               f"{place_of(areas[0])}")


def check_headroom(stairs: Stairs, level: StairsOfLevel) -> Iterator[Note]:
    """The slabs of all rooms, furniture of its own and other steps above each of the steps."""
    nodes = [node for node in level.parts if node.extras["part"] in ("ceiling", "floor")]
    nodes += level.furniture_in(stairs.room)
    faces = [(node.name, level.triangles(node)) for node in nodes]
    faces += [(other.node.name, step.corners[step.triangles]) for other in level.stairs for step in other.steps]
    yield from low_places(stairs, Undersides(faces))


def low_places(stairs: Stairs, undersides: Undersides) -> Iterator[Note]:
    """For each thing that is too low over some step, the step over which it is lowest."""
    lowest: dict[str, tuple[float, int, shapely.Geometry]] = {}
    for number, step in enumerate(stairs.steps, 1):
        for name, height, area in undersides.over(step.way, step.top):
            found = height - step.top, number, area
            if found[0] < HEADROOM - EVEN and (name not in lowest or found[:2] < lowest[name][:2]):
                lowest[name] = found
    for name, (clear, number, area) in lowest.items():
        yield note(stairs, f"{name} is {clear:.3f} m above step {number} at {place_of(area)}")


def place_of(area: shapely.Geometry) -> str:
    point = area.representative_point()
    return f"({point.x:.3f}, {point.y:.3f})"
