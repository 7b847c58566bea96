"""A small building of flats without faults, and a house, as `roomwright plan` would write them; tests break copies of them."""

from __future__ import annotations

import copy
from pathlib import Path

import yaml

WALL = 0.12


def rectangle(x: float, y: float, width: float, depth: float) -> list[list[float]]:
    """The inner faces of a cell whose outline runs in the middle of inner walls."""
    half = WALL / 2
    west, south, east, north = x + half, y + half, x + width - half, y + depth - half
    return [[west, south], [east, south], [east, north], [west, north]]


def room(id_: str, type_: str, cell: tuple, dwelling: str | None = None) -> dict:
    entry = {"id": id_, "type": type_, "height": 2.7, "outline": rectangle(*cell)}
    return entry | ({"dwelling": dwelling} if dwelling else {})


def opening(id_: str, kind: str, at: tuple, along: tuple, rooms: list[str], width: float = 0.9) -> dict:
    sill, head = (0.9, 2.2) if kind == "window" else (0, 2.05)
    return {"id": id_, "kind": kind, "at": list(at), "along": list(along), "rooms": rooms, "width": width, "sill": sill, "head": head}


# Two flats at stairs, 12 x 8 m:
#
#   8 +------+--------+------+
#     | bed  | stairs | bed  |
#   5 +-+----+        +--+---+
#     |b| hall        |b |   |  a hall of each flat joins the stairs
#   3 +-+----+--------+--+---+
#     | kitchen living | ...  |
#   0 +------+--------+------+
def flat(name: str, x: float, sign: int) -> tuple[list[dict], list[dict]]:
    """The flat west (sign 1) or east (sign -1) of the stairs; x is its outer wall."""
    def cell(along: float, y: float, width: float, depth: float) -> tuple:
        return (x + along if sign > 0 else x - along - width, y, width, depth)

    def at(along: float, y: float) -> tuple:
        return (x + sign * along, y)

    rooms = [
        room(f"{name}-living", "living_kitchen", cell(0, 0, 5, 3), name),
        room(f"{name}-hall", "corridor", cell(2, 3, 3, 2), name),
        room(f"{name}-bath", "bathroom", cell(0, 3, 2, 2), name),
        room(f"{name}-bedroom", "bedroom", cell(0, 5, 5, 3), name),
    ]
    openings = [
        opening(f"{name}-entrance", "door", at(5, 4), (0, 1), [f"{name}-hall", "stairs"]),
        opening(f"{name}-door-1", "door", at(3, 3), (1, 0), [f"{name}-living", f"{name}-hall"]),
        opening(f"{name}-door-2", "door", at(2, 4), (0, 1), [f"{name}-bath", f"{name}-hall"]),
        opening(f"{name}-door-3", "door", at(3, 5), (1, 0), [f"{name}-bedroom", f"{name}-hall"]),
        opening(f"{name}-window-1", "window", at(2.5, -0.09), (1, 0), [f"{name}-living"], 1.5),
        opening(f"{name}-window-2", "window", at(2.5, 8.09), (1, 0), [f"{name}-bedroom"], 1.5),
    ]
    return rooms, openings


def level(id_: str, number: int) -> dict:
    west, west_openings = flat("west", 0, 1)
    east, east_openings = flat("east", 12, -1)
    openings = west_openings + east_openings
    if number == 0:
        openings.append(opening("way-in", "door", (6, -0.09), (1, 0), ["stairs"], 1.0))
    rooms = [room("stairs", "stairs", (5, 0, 2, 8)), *west, *east]
    return {"id": id_, "elevation": 3.0 * number, "height": 3.0, "rooms": rooms, "openings": openings}


def flats(id_: str = "flats") -> dict:
    return {"version": 1, "id": id_, "walls": {"exterior": 0.3}, "levels": [level("ground", 0), level("upper", 1)]}


def shed(id_: str = "shed", width: float = 4.0) -> dict:
    """One storeroom with a door in the south."""
    rooms = [room("store", "storeroom", (0, 0, width, 3))]
    openings = [opening("door", "door", (2, -0.09), (1, 0), ["store"])]
    return {"version": 1, "id": id_, "walls": {"exterior": 0.3},
            "levels": [{"id": "ground", "elevation": 0, "height": 3, "rooms": rooms, "openings": openings}]}


def named(entries: list[dict], id_: str) -> dict:
    return next(entry for entry in entries if entry["id"] == id_)


def write_project(folder: Path, *placed: tuple[dict, tuple[float, float], float]) -> Path:
    """Writes plans with their positions and turns."""
    folder.mkdir(exist_ok=True)
    plans = []
    for plan, position, turn in placed:
        (folder / f"{plan['id']}.yaml").write_text(yaml.safe_dump(copy.deepcopy(plan)), encoding="utf-8")
        plans.append({"plan": f"{plan['id']}.yaml", "position": list(position), "turn": turn})
    (folder / "project.yaml").write_text(yaml.safe_dump({"version": 1, "project": {"seed": 1, "plans": plans}}), encoding="utf-8")
    return folder
