"""One level of a plan, from one drawing."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from .drawing import Drawn, Sorting, file_name, layers_of, open_drawing, unit_of
from .faults import Report, UnreadableError
from .layer_map import LayerMap
from .openings import Opening, Rooms, at_walls, openings_of
from .panes import joined_panes
from .rooms import Room, labels_of, name_rooms, rooms_of, types_of
from .shapes import Point, Scale
from .walls import DRAWN_INSIDE, obstacles, open_boundaries, strips, walls_of


@dataclass
class Level:
    """Rooms, openings and columns in metres, in the frame of the drawing."""

    source: Path
    unit: float  # metres of a unit of the drawing
    rooms: list[Room]
    types: dict[str, str]  # room type by the id of a room
    openings: list[Opening] = field(default_factory=list)
    columns: list[list[Point]] = field(default_factory=list)
    railings: list[list[Point]] = field(default_factory=list)

    @property
    def id(self) -> str:
        """The name of the file without letters that no id may have (src/plan/read/native/ids.rs)."""
        name = "".join("-" if letter in '/\\:*?"<>|' or not letter.isprintable() else letter for letter in file_name(self.source))
        return name.strip().strip(".")[:60] or "level"


def read_level(path: Path, layer_map: LayerMap, chord_error: float, report: Report) -> Level:
    """Reads a drawing. Raises UnreadableError if it has no room; other faults go into the report."""
    document = open_drawing(path)
    scale = Scale(unit_of(document, path, layer_map.unit), chord_error)
    roles = layer_map.check_against(layers_of(document), report)
    sorting = Sorting(document, roles, report)
    found = sorting.sort()
    rooms = rooms_of(found.get("rooms", []), scale, report)
    if not rooms:
        raise UnreadableError(f"{path}: has no room: no closed outline on the layers of the role rooms, "
                              f"{', '.join(layer_map.layers.get('rooms', []))}\n"
                              "  hint: --list-layers lists the layers; draw a closed polyline around each room, for walls are not turned "
                              "into rooms")
    name_rooms(rooms, labels_of([*found.get("room_names", []), *found["rooms"]], scale), report)
    level = Level(path, scale.metres, rooms, types_of(rooms, layer_map.room_types, report))
    among = Rooms(rooms)
    for role in ("doors", "windows"):
        level.openings += at_walls(joined_panes(openings_of(found.get(role, []), role, among, scale, report)), among, report)
    add_walls(level, found, scale, layer_map, report)
    sorting.refuse_overspent()
    return level


def add_walls(level: Level, found: dict[str, list[Drawn]], scale: Scale, layer_map: LayerMap, report: Report) -> None:
    """Adds columns, railings, walls that stand in rooms, and open boundaries."""
    columns = walls_of(found.get("columns", []), scale, report)
    level.columns = obstacles(columns.bodies, level.rooms, 0.0)
    level.railings = strips(walls_of(found.get("railings", []), scale, report))
    if "walls" not in found:
        return
    walls = walls_of(found["walls"], scale, report).without_contours(level.rooms)
    # Where outlines are the middle of walls, all walls reach into rooms.
    if layer_map.outlines == "inner":
        level.columns += obstacles(walls.bodies, level.rooms, DRAWN_INSIDE)
    level.openings += open_boundaries(level.rooms, walls, level.openings)
