"""Stairs between the levels of a building: they end at the floor above, which is open over them.

The levels are those that a manifest lists. Where a bake lacks the level above, nothing is measured.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import shapely

from ..gltf_document import GltfError
from ..gltf_file import GltfFile
from ..resources import Reach, ResourceError, locate_path, read_file
from ..workers import outcomes

from .manifest import SCENE_ENDINGS
from .report import Fault, Note
from .schemas import extras_schemas
from .stairs import BEFORE_DOOR, LEAST_AREA, NEAR, Solid, Stairs, StairsOfLevel, is_met, low_places, note, place_of
from .undersides import Undersides

# Metres within which a wall, a step or a handrail stands at an edge of a hole, and heights between which handrails of a
# balustrade reach.
AT_EDGE = 0.13
BALUSTRADE = (0.85, 0.96)
# Metres by which the end of stairs may miss the floor above: elevations have millimetres.
LEVEL_WITH = 0.005


class Storey(NamedTuple):
    """A level of a building."""

    file: Path
    elevation: float
    level: StairsOfLevel


def check_storeys(manifest: Path, jobs: int = 1) -> list[Fault]:
    """The stairs of all buildings of a manifest."""
    buildings = buildings_of(manifest)
    found = outcomes(check_building, buildings, jobs) if buildings else ()
    faults = [[Fault(str(manifest), "stairs", "", str(outcome))] if isinstance(outcome, Exception) else outcome
              for outcome in found]
    return list(chain.from_iterable(faults))


def buildings_of(manifest: Path) -> list[tuple[Path, list[Path]]]:
    """The folder, and for each building of several levels their files that are there; faults of a manifest are others' task."""
    folder = manifest.parent.resolve()
    reach = Reach(folder, (folder,))
    found: dict[str, list[Path]] = {}
    try:
        for level in json.loads(read_file(manifest))["levels"]:
            names = [file["path"] for file in level["files"] if Path(file["path"]).suffix.lower() in SCENE_ENDINGS]
            found.setdefault(level["building"], []).extend(locate_path(name, reach) for name in names[:1])
    except (ResourceError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return []
    return [(folder, files) for files in found.values() if len(files) > 1]


def check_building(building: tuple[Path, list[Path]]) -> list[Fault]:
    folder, files = building
    storeys = sorted((storey for file in files for storey in read_storey(file, folder)), key=lambda storey: storey.elevation)
    faults: list[Fault] = []
    for storey in storeys:
        for stairs in storey.level.stairs:
            if stairs.steps:
                faults += [Fault(str(storey.file), *found) for found in check_end(stairs, storey, storeys)]
        faults += [Fault(str(storey.file), *found) for found in check_holes(storey, storeys)]
    return faults


def read_storey(file: Path, folder: Path) -> Iterator[Storey]:
    """A level, if its file can be read."""
    try:
        gltf = GltfFile(file, folder)
        root = gltf.nodes[0]
        if root.kind == "level" and extras_schemas()["level"].is_usable(root.extras):
            yield Storey(file, root.extras["elevation"], StairsOfLevel(gltf))
    except GltfError:
        return


def check_end(stairs: Stairs, storey: Storey, storeys: list[Storey]) -> Iterator[Note]:
    """The end of a flight, and what is over it on the level above."""
    end = storey.elevation + stairs.height
    higher = [other for other in storeys if storey.elevation + LEVEL_WITH < other.elevation < end + LEVEL_WITH]
    above = [other for other in higher if abs(other.elevation - end) <= LEVEL_WITH]
    if higher and not above:
        yield note(stairs, f"it ends at {end:.3f} m, the floor of {higher[0].file.stem} is at {higher[0].elevation:.3f} m")
    for other in above:
        rooms = [room for room in other.level.rooms.values() if room.outline.intersects(stairs.outline)]
        floor = shapely.union_all([other.level.floor_area(room) for room in rooms])
        last = stairs.steps[-1]
        if not is_met(floor, last) and not any(other.level.is_at_doorway(room, last) for room in rooms):
            yield note(stairs, f"no floor of {other.file.stem} is at its last step at {place_of(last.tread)}")
        nodes = [node for room in rooms for node in (*other.level.parts_in(room), *other.level.furniture_in(room))]
        rise = (0.0, other.elevation - storey.elevation, 0.0)
        faces = [(f"{node.name} of {other.file.stem}", other.level.triangles(node) + rise) for node in nodes]
        yield from low_places(stairs, Undersides(faces))


def check_holes(storey: Storey, storeys: list[Storey]) -> Iterator[Note]:
    """The holes in the floors of stairs' rooms: steps come up there, and not before a door."""
    below = [stairs for other in storeys for stairs in other.level.stairs
             if stairs.steps and abs(other.elevation + stairs.height - storey.elevation) <= LEVEL_WITH]
    # The lowest level of a bake may have wells whose steps are on a level that it lacks.
    if storey is storeys[0]:
        return
    for stairs in storey.level.stairs:
        hole = stairs.room.outline.difference(storey.level.floor_area(stairs.room))
        flights = [flight for flight in below if flight.outline.intersects(hole)]
        left = hole.difference(shapely.union_all([flight.outline.buffer(NEAR) for flight in flights]))
        if left.area > LEAST_AREA:
            yield note(stairs, f"the floor has a hole at {place_of(left)}, and no steps come up there")
        ends = [flight.steps[-1] for flight in flights] + stairs.steps[:1]
        yield from check_edge(stairs, hole, ends)
        for doorway in storey.level.doorways(stairs.room):
            met = doorway.zone.intersection(hole)
            if met.area > LEAST_AREA and not any(doorway.is_end_of(step) for step in ends):
                yield note(stairs, f"the floor has a hole within {BEFORE_DOOR} m of {doorway.opening.name} at {place_of(met)}")


def check_edge(stairs: Stairs, hole: shapely.Geometry, ends: list[Solid]) -> Iterator[Note]:
    """A balustrade along the edge of a hole, but for where a wall stands and where stairs begin and end."""
    low, high = BALUSTRADE
    rails = [rail.shape for rail in stairs.rails if rail.bottom < high and rail.top > low]
    closed = [stairs.room.outline.boundary, *(step.tread for step in ends), *rails]
    # Without the slivers that rounding leaves along walls.
    edge = hole.buffer(-NEAR / 2).buffer(NEAR / 2).boundary
    left = edge.difference(shapely.union_all([shape.buffer(AT_EDGE) for shape in closed]))
    if left.length > AT_EDGE:
        yield note(stairs, f"{left.length:.2f} m of the edge of its well have no balustrade, at {place_of(left)}")
