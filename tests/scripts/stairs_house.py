"""A house of two levels with a straight flight, built by hand, for the tests of stairs."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from conftest import Floor, furniture

# Metres of the room, east and north, of the storey and of its ceiling; the flight's sides in the plan.
WIDTH, DEPTH, STOREY, CEILING = 3.0, 5.0, 2.8, 2.5
WEST, EAST, FOOT, GOING, RISES = 0.0, 1.0, 1.0, 0.24, 14
HEAD = FOOT + GOING * (RISES - 1)
WAIST = 0.14
LEVEL = {"ground": 0.0, "upper": STOREY}
BOX = np.array([[0, 3, 2], [0, 2, 1], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6],
                [3, 0, 4], [3, 4, 7]])


def block(low, high) -> np.ndarray:
    """The corners of a box between two places: x east, y north, z up."""
    return sloped(low, high, low[2], low[2])


def sloped(low, high, front: float, back: float) -> np.ndarray:
    """A box whose underside is at one height in the south and at another in the north."""
    ring = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    return np.array([(*place, under) for place, under in zip(ring, (front, front, back, back))]
                    + [(*place, high[2]) for place in ring], float)


def steps(rise: float = STOREY / RISES, west: float = WEST) -> list[np.ndarray]:
    """Steps as the program makes them: the underside of each meets the next one's along an edge."""
    found = []
    for number in range(1, RISES):
        top, south = rise * number, FOOT + GOING * (number - 1)
        low, high = (west, south, 0.0), (west + EAST - WEST, south + GOING, top)
        found.append(sloped(low, high, top - rise - WAIST, top - WAIST))
    return found


def around(south: float = FOOT, north: float = HEAD, east: float = EAST) -> list[tuple[float, float, float, float]]:
    """What is left of the floor around a hole at the western wall: west, south, east, north."""
    found = [(0.0, 0.0, WIDTH, south), (east, south, WIDTH, north), (0.0, north, WIDTH, DEPTH)]
    return [area for area in found if area[1] < area[3] and area[0] < area[2]]


WHOLE = [(0.0, 0.0, WIDTH, DEPTH)]


class Storey:
    """One level with a room of stairs and a door in its southern wall."""

    def __init__(self, level: str, elevation: float | None = None):
        self.floor = Floor()
        elevation = LEVEL[level] if elevation is None else elevation
        self.root = self.floor.node(f"house/{level}", {"kind": "level", "building": "house", "level": level, "seed": 1,
                                                       "elevation": elevation, "height": STOREY, "generator": "test"})
        self.room = self.floor.node("room:hall", {
            "kind": "room", "room": "hall", "type": "stairs", "style": "default", "seed": "7", "holes": [], "height": CEILING,
            "outline": [[0.0, 0.0], [WIDTH, 0.0], [WIDTH, DEPTH], [0.0, DEPTH]], "requested": 0, "placed": 0, "removed": [],
            "grade": "none", "findings": []}, self.root)
        self.door("south", 0, 1.0, 2.0)

    def door(self, name: str, wall: int, start: float, end: float) -> None:
        self.floor.node(f"door:{name}", {
            "kind": "opening", "opening": "door", "closure": "passage", "id": name, "rooms": ["hall"],
            "sides": [{"room": "hall", "wall": wall, "from": start, "to": end}], "width": end - start, "height": 2.0,
            "sill": 0.0}, self.root)

    def part(self, kind: str, bodies: list[np.ndarray], **extras) -> None:
        """A part of the room, whose bodies are given by eight corners each."""
        extras = {"kind": "part", "part": kind, "id": kind, "tags": [], **extras}
        self.floor.node(f"{kind}@hall", extras, self.room, self.mesh(f"{kind}@hall", bodies))

    def mesh(self, name: str, bodies: list[np.ndarray]) -> int:
        rings = np.concatenate([body[BOX] for body in bodies])[:, :, [0, 2, 1]] * (1, 1, -1)
        normals = np.cross(rings[:, 1] - rings[:, 0], rings[:, 2] - rings[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        attributes = {"POSITION": self.floor.accessor(rings.reshape(-1, 3).astype("<f4"), "VEC3"),
                      "NORMAL": self.floor.accessor(np.repeat(normals, 3, axis=0).astype("<f4"), "VEC3")}
        indices = self.floor.accessor(np.arange(rings.size // 3).astype("<u2"), "SCALAR")
        primitive = {"attributes": attributes, "indices": indices, "material": 0}
        self.floor.document["meshes"].append({"name": name, "primitives": [primitive]})
        return len(self.floor.document["meshes"]) - 1

    def slab(self, kind: str, areas, bottom: float, top: float) -> None:
        self.part(kind, [block((west, south, bottom), (east, north, top)) for west, south, east, north in areas])

    def stairs(self, bodies: list[np.ndarray], height: float) -> None:
        outline = [[WEST, FOOT], [EAST, FOOT], [EAST, HEAD], [WEST, HEAD]]
        self.part("stairs", bodies, outline=outline, height=height)

    def lamp(self, place: tuple[float, float, float]) -> None:
        """A box of 0.2 m."""
        size = (0.2, 0.2, 0.2)
        mesh = self.floor.box_mesh("lamp", *size)
        self.floor.node("lamp.1@hall", furniture("lamp", 1, "ceiling", "below", size), self.room, mesh,
                        at=(place[0], place[2], -place[1]))

    def write(self, path: Path) -> Path:
        return self.floor.write(path)


def ground(bodies: list[np.ndarray] | None = None, height: float = STOREY, ceiling=None, floor=WHOLE) -> Storey:
    storey = Storey("ground")
    storey.slab("floor", floor, -0.02, 0.0)
    storey.slab("ceiling", around() if ceiling is None else ceiling, CEILING, STOREY - 0.02)
    storey.stairs(steps() if bodies is None else bodies, height)
    return storey


def balustrade() -> list[np.ndarray]:
    """East and south of the hole; walls are in the west, and the flight ends in the north."""
    return [block((EAST - 0.05, FOOT, -0.02), (EAST - 0.01, HEAD, 0.95)), block((WEST, FOOT, -0.02), (EAST, FOOT + 0.04, 0.95))]


def upper(floor=None, elevation: float = STOREY, rails=None) -> Storey:
    storey = Storey("upper", elevation)
    storey.slab("floor", around() if floor is None else floor, -0.02, 0.0)
    storey.slab("ceiling", WHOLE, CEILING, STOREY - 0.02)
    storey.stairs(balustrade() if rails is None else rails, 0.95)
    return storey


def write_house(folder: Path, *storeys: Storey) -> Path:
    """A bake of some levels; its manifest names their files."""
    levels = []
    for number, storey in enumerate(storeys):
        storey.write(folder / f"{number}.glb")
        levels.append({"building": "house", "level": str(number), "files": [{"path": f"{number}.glb"}]})
    manifest = folder / "manifest.json"
    manifest.write_text(json.dumps({"levels": levels}))
    return manifest
