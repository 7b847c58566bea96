"""Hand-made rooms for the judge: boxes of named classes at given places."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from conftest import FACES, Floor, furniture
from judging.floors import Room, read_floor

TURNS = {"south": 0.0, "east": np.pi / 2, "north": np.pi, "west": -np.pi / 2}


class Judged:
    """A level under construction, in the plan's axes: x east, y north."""

    def __init__(self):
        self.floor = Floor()
        self.level = self.floor.node("house/ground", {"kind": "level", "building": "house", "level": "ground", "elevation": 0.0,
                                                      "height": 3.0, "seed": 1, "generator": "test"})
        self.rooms: dict[str, int] = {}
        self.counts: dict[str, int] = {}

    def room(self, name: str, kind: str, width: float, depth: float, west: float = 0.0, **extras) -> Judged:
        """A rectangle from (west, 0); its walls: 0 south, 1 east, 2 north, 3 west."""
        outline = [[west, 0.0], [west + width, 0.0], [west + width, depth], [west, depth]]
        said = {"kind": "room", "room": name, "type": kind, "style": "default", "seed": "7", "outline": outline, "holes": [],
                "height": 2.5, "requested": 0, "placed": 0, "removed": [], "grade": "none", "findings": []}
        self.rooms[name] = self.floor.node(f"room:{name}", said | extras, self.level)
        return self

    def piece(self, kind: str, x: float, y: float, facing: str, size: tuple[float, float, float], lift: float = 0.0,
              room: str = "101", on: str | None = None, mesh: int | None = None) -> Judged:
        """A piece with the middle of its underside at (x, y), its front to a side of the world."""
        self.counts[kind] = number = self.counts.get(kind, 0) + 1
        mesh = self.floor.box_mesh(f"{kind}.{number}", *size, faces=FACES) if mesh is None else mesh
        extras = furniture(kind, number, on or "floor", "above", size)
        at, turn, parent = (x, lift, -y), TURNS[facing], self.rooms[room]
        if on is not None:
            carrier = self.floor.find(f"{on}@{room}")
            parent = self.floor.document["nodes"].index(carrier)
            at, turn = relative(carrier, at, turn)
        self.floor.node(f"{kind}.{number}@{room}", extras, parent, mesh, at=at, turn=turn)
        return self

    def opening(self, name: str, kind: str, closure: str, sides: list[tuple[str, int, float, float]], sill: float = 0.0,
                height: float = 2.0, leaf: tuple | None = None) -> Judged:
        """A door or window; `leaf` is hinge, closed and open point of one leaf."""
        extras = {"kind": "opening", "opening": kind, "closure": closure, "id": name, "rooms": [side[0] for side in sides],
                  "sides": [dict(zip(("room", "wall", "from", "to"), side)) for side in sides],
                  "width": sides[0][3] - sides[0][2], "height": height, "sill": sill}
        if leaf is not None:
            extras["leaves"] = [dict(zip(("hinge", "closed", "open"), leaf))]
        self.floor.node(f"{kind}:{name}", extras, self.level)
        return self

    def read(self, folder: Path, room: str = "101") -> Room:
        floor = read_floor(self.write(folder))
        return next(found for found in floor.rooms if found.id == room)

    def write(self, folder: Path) -> Path:
        return self.floor.write(folder / "ground.glb")


def relative(carrier: dict, at: tuple[float, float, float], turn: float) -> tuple[tuple[float, float, float], float]:
    """A place in the frame of a node below a room."""
    rotation = carrier.get("rotation", (0.0, 0.0, 0.0, 1.0))
    own = 2 * float(np.arctan2(rotation[1], rotation[3]))
    x, y, z = np.array(at) - carrier.get("translation", (0.0, 0.0, 0.0))
    cos, sin = np.cos(own), np.sin(own)
    return (float(cos * x - sin * z), float(y), float(sin * x + cos * z)), turn - own


def house(kind: str, width: float = 4.0, depth: float = 4.0, **extras) -> Judged:
    """A level of one room."""
    return Judged().room("101", kind, width, depth, **extras)
