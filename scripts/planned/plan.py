"""Reads native plans and projects as `roomwright plan` and `roomwright import` write them; metres, x east, y north."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import yaml
from shapely import affinity
from shapely.geometry import Polygon

from .roles import OUTSIDE

# LibYAML's parser is ten times faster, and is not in every build of PyYAML.
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
PROJECT = "project.yaml"
USUAL_EXTERIOR = 0.3
WAYS = ("door", "sliding_door", "passage", "open_boundary")


@dataclass
class Room:
    id: str
    type: str
    dwelling: str | None
    # The inner faces of its walls.
    shape: Polygon


@dataclass
class Opening:
    id: str
    kind: str
    # The middle of the opening, in the middle of its wall.
    at: tuple[float, float]
    along: tuple[float, float]
    width: float
    sill: float
    head: float
    # One room only: the other side is the open air.
    rooms: tuple[str, ...]

    @property
    def is_way(self) -> bool:
        return self.kind in WAYS

    @property
    def is_outer(self) -> bool:
        return len(self.rooms) == 1


@dataclass
class Level:
    id: str
    elevation: float
    height: float
    rooms: dict[str, Room]
    openings: list[Opening]

    @property
    def indoor(self) -> list[Room]:
        """The rooms within the outer walls."""
        return [room for room in self.rooms.values() if room.type not in OUTSIDE]


@dataclass
class Building:
    id: str
    exterior: float
    levels: list[Level]


@dataclass
class Placed:
    """A plan of a project: its frame is turned counter-clockwise by degrees, then moved."""

    file: Path
    position: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    # The folder that it was written into: buildings of another stand elsewhere.
    site: str = ""

    def on_site(self, shape):
        turned = affinity.rotate(shape, self.turn, origin=(0, 0))
        return affinity.translate(turned, *self.position)

    def direction(self, along: tuple[float, float]) -> tuple[float, float]:
        cosine, sine = math.cos(math.radians(self.turn)), math.sin(math.radians(self.turn))
        return along[0] * cosine - along[1] * sine, along[0] * sine + along[1] * cosine


def read_yaml(path: Path) -> dict:
    with path.open("rb") as file:
        return yaml.load(file, LOADER)


def plans_in(folder: Path) -> list[Placed]:
    """The plans of a folder: as its project places them, else all of its files, each on its own."""
    project = folder / PROJECT
    if not project.is_file():
        return [Placed(file, site=str(file)) for file in sorted(folder.rglob("*.yaml"))]
    entries = read_yaml(project)["project"]["plans"]
    return [Placed(folder / entry["plan"], tuple(entry["position"]), entry["turn"], str(folder)) for entry in entries]


def read_plan(path: Path) -> Building:
    plan = read_yaml(path)
    exterior = (plan.get("walls") or {}).get("exterior", USUAL_EXTERIOR)
    levels = [level_of(level, number) for number, level in enumerate(plan["levels"])]
    return Building(str(plan.get("id", path.stem)), exterior, levels)


def level_of(level: dict, number: int) -> Level:
    if "place" in level or level.get("repeat", 1) != 1 or "elevation" not in level:
        raise ValueError("a plan with prototypes, or written by hand: `roomwright import` writes it out")
    rooms = [room_of(room) for room in level.get("rooms") or []]
    openings = [opening_of(opening, index) for index, opening in enumerate(level.get("openings") or [])]
    return Level(str(level.get("id", number)), level["elevation"], level["height"], {room.id: room for room in rooms}, openings)


def room_of(room: dict) -> Room:
    dwelling = room.get("dwelling")
    shape = Polygon(room["outline"], room.get("holes") or [])
    return Room(str(room["id"]), room["type"], None if dwelling is None else str(dwelling), shape)


def opening_of(opening: dict, index: int) -> Opening:
    rooms = tuple(str(room) for room in opening["rooms"])
    return Opening(str(opening.get("id", index)), opening["kind"], tuple(opening["at"]), tuple(opening["along"]),
                   opening["width"], opening["sill"], opening["head"], rooms)
