"""Writes levels as a plan in the native format (configs/plans/README.md)."""

from __future__ import annotations

import json
import math
import os
import tempfile
from pathlib import Path

from .layer_map import LayerMap
from .level import Level
from .openings import Opening
from .rooms import Room, distinct_ids
from .shapes import Point

# Metres from the drawing's origin within which a plan keeps its coordinates, and the grid on which the origin of others lies, so that
# a plan that grows keeps those that it has.
NEAR_ORIGIN, ORIGIN_GRID = 10_000.0, 1_000.0
# Decimals of metres and of directions: a tenth of a millimetre.
DECIMALS = 4


def plan_text(levels: list[Level], layer_map: LayerMap, chord_error: float) -> str:
    """The plan as YAML; the same drawings give the same text."""
    origin = origin_of(levels)
    named = ", ".join(level.source.name for level in levels)
    lines = [
        f"# Made by dxf_to_plan.py of {comment(named)}.",
        f"# Metres; [0, 0] is ({number(origin[0] / levels[0].unit)}, {number(origin[1] / levels[0].unit)}) of the drawing, "
        f"a unit of which is {levels[0].unit:g} m. Curves are edges within {chord_error:g} m.",
        "version: 1",
    ]
    if layer_map.outlines != "inner":
        lines.append(f"outlines: {layer_map.outlines}")
    lines.append("levels:")
    for level, level_id in zip(levels, distinct_ids([level.id for level in levels])):
        lines += level_lines(level, level_id, layer_map, origin)
    return "\n".join(lines) + "\n"


def origin_of(levels: list[Level]) -> Point:
    """The origin of the plan, in metres in the frame of the drawings: theirs, or the corner of the grid south-west of far rooms."""
    bounds = [room.polygon.bounds for level in levels for room in level.rooms]
    if all(abs(value) <= NEAR_ORIGIN for bound in bounds for value in bound):
        return (0.0, 0.0)
    west, south = min(bound[0] for bound in bounds), min(bound[1] for bound in bounds)
    return (math.floor(west / ORIGIN_GRID) * ORIGIN_GRID, math.floor(south / ORIGIN_GRID) * ORIGIN_GRID)


def level_lines(level: Level, level_id: str, layer_map: LayerMap, origin: Point) -> list[str]:
    lines = [f"- id: {json.dumps(level_id, ensure_ascii=False)}"]
    if layer_map.level_height is not None:
        lines.append(f"  height: {number(layer_map.level_height)}")
    lines.append("  rooms:")
    lines += [f"  - {flow(room_entry(room, level.types[room.id], origin))}" for room in level.rooms]
    if level.openings:
        lines.append("  openings:")
        entry_ids = distinct_ids([f"{opening.kind}-{opening.place.handle}" for opening in level.openings])
        lines += [f"  - {flow(opening_entry(opening, entry_id, origin))}" for opening, entry_id in zip(level.openings, entry_ids)]
    if level.columns:
        lines.append("  columns:")
        lines += [f"  - {flow({'outline': moved(outline, origin)})}" for outline in level.columns]
    if level.railings:
        lines.append("  railings:")
        lines += [f"  - {json.dumps(moved(outline, origin))}" for outline in level.railings]
    return lines


def room_entry(room: Room, room_type: str, origin: Point) -> dict[str, object]:
    entry: dict[str, object] = {"id": room.id}
    if room.name:
        entry["name"] = room.name
    entry |= {"type": room_type, "outline": moved(list(room.polygon.exterior.coords[:-1]), origin)}
    if room.polygon.interiors:
        entry["holes"] = [moved(list(ring.coords[:-1]), origin) for ring in room.polygon.interiors]
    return entry


def opening_entry(opening: Opening, opening_id: str, origin: Point) -> dict[str, object]:
    entry: dict[str, object] = {"id": opening_id, "kind": opening.kind, "at": moved([opening.middle], origin)[0],
                                "along": [round(value, DECIMALS) + 0.0 for value in opening.along],
                                "width": round(opening.width, DECIMALS)}
    said = {"rooms": list(opening.rooms) or None, "leaves": opening.leaves if opening.leaves == 2 else None,
            "hinge": opening.hinge, "opens_into": opening.opens_into,
            "swing": None if opening.swing is None or abs(opening.swing - 90) < 1 else round(opening.swing)}
    return entry | {key: value for key, value in said.items() if value is not None}


def moved(points: list[Point], origin: Point) -> list[list[float]]:
    return [[round(x - origin[0], DECIMALS) + 0.0, round(y - origin[1], DECIMALS) + 0.0] for x, y in points]


def flow(entry: dict[str, object]) -> str:
    """A map on one line. Keys are plain words; values are JSON, which YAML reads as it is."""
    return "{" + ", ".join(f"{key}: {json.dumps(value, ensure_ascii=False)}" for key, value in entry.items()) + "}"


def number(value: float) -> str:
    return f"{round(value, DECIMALS) + 0.0:.10g}"


def comment(text: str) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def write_whole(path: Path, text: str) -> None:
    """Writes a file under a temporary name beside its place, and renames it."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        os.chmod(temporary, 0o666 & ~umask())
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
