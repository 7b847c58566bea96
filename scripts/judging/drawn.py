"""Fixtures that architects drew: the items of archilyse's drawings, in the plan's axes and metres.

The drawings are no part of the project; the folder that holds them is an argument.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import shapely

SITE_FILE = "react_planner_projects.json"
LEVEL_OF_SINGLE = "floor_0"
CENTIMETRE = 0.01
# What the drawings call a fixture, and what it is for.
USES = {"toilet": "toilet", "sink": "basin", "bathtub": "bath", "shower": "bath", "kitchen": "kitchen"}


@dataclass(frozen=True)
class Drawn:
    name: str  # as the drawing calls it
    center: np.ndarray
    axis: np.ndarray  # unit vector along its own x
    size: tuple[float, float]  # along its own x and y

    @property
    def use(self) -> str:
        """What it is for; empty for furniture that is no fixture."""
        return USES.get(self.name, "")

    @property
    def shape(self) -> shapely.Polygon:
        across = np.array([-self.axis[1], self.axis[0]])
        x, y = self.axis * self.size[0] / 2, across * self.size[1] / 2
        return shapely.Polygon([self.center - x - y, self.center + x - y, self.center + x + y, self.center - x + y])

    def backs(self) -> list[tuple[np.ndarray, np.ndarray, float]]:
        """The sides that may be its back, for a drawing fixes an axis and no front: middle, unit vector out, metres."""
        across = np.array([-self.axis[1], self.axis[0]])
        width, depth = self.size
        ends = [(self.center + way * width / 2, way, depth) for way in (self.axis, -self.axis)]
        sides = [(self.center + way * depth / 2, way, width) for way in (across, -across)]
        if self.name == "shower":
            return ends + sides
        if self.name == "toilet":
            return ends
        return sides if self.name == "sink" or width >= depth else ends


def read_drawn(folder: Path) -> dict[tuple[str, str], list[Drawn]]:
    """The fixtures of all drawings below a folder, by building and level as the importer names them."""
    found: dict[tuple[str, str], list[Drawn]] = {}
    for projects in sorted(folder.rglob(SITE_FILE)):
        drawings = {project["plan_id"]: project["data"] for project in read(projects)}
        for floor in read(projects.with_name("floors.json")):
            if floor["plan_id"] in drawings:
                place = projects.parent.name, f"floor_{floor['floor_number']}"
                found[place] = fixtures_of(drawings[floor["plan_id"]])
    for path in sorted(folder.rglob("plan_*.json")):
        document = read(path)
        if isinstance(document, dict) and "layers" in document:
            found[path.stem, LEVEL_OF_SINGLE] = fixtures_of(document)
    return found


def read(path: Path):
    return json.loads(path.read_text(encoding="utf-8"))


def fixtures_of(drawing: dict) -> list[Drawn]:
    metres = np.sqrt(drawing["scale"]) * CENTIMETRE  # of a pixel: `scale` is square centimetres per square pixel
    items = drawing["layers"]["layer-1"]["items"].values()
    return [fixture_of(item, metres) for item in items if item["type"] in USES]


def fixture_of(item: dict, metres: float) -> Drawn:
    turn = np.radians(item["rotation"])
    size = tuple(item["properties"][key]["value"] * CENTIMETRE for key in ("width", "length"))
    return Drawn(item["type"], np.array([item["x"], item["y"]]) * metres, np.array([np.cos(turn), np.sin(turn)]), size)
