"""Furniture that architects drew in IFC files: its boxes, in the plan's axes and metres.

A small reader of STEP files, for furniture in metres whose shape is points: faces and outlines. It composes the placements of
products and of the shapes that they share, and takes the box around the points.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from .drawn import Drawn

ENTITY = re.compile(r"^#(\d+)\s*=\s*([A-Z0-9_]+)\s*\((.*)\);\s*$", re.MULTILINE)
REFERENCE = re.compile(r"#(\d+)")
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:E[-+]?\d+)?", re.IGNORECASE)
FURNITURE = {"IFCFURNISHINGELEMENT", "IFCFURNITURE", "IFCFLOWTERMINAL", "IFCSANITARYTERMINAL"}
# What a name says that a piece is, as archilyse's drawings call it; the first word that is in the name counts.
WORDS = [("toilet", "toilet"), ("vanity", "sink"), ("basin", "sink"), ("bathtub", "bathtub"), ("shower", "shower"),
         ("base cabinet", "kitchen"), ("cooker", "kitchen"), ("tall cabinet", "wardrobe"), ("sofa", "sofa"), ("bed", "bed"),
         ("table", "table")]
# Metres above its storey from which a piece hangs.
STANDING = 1.0

Entity = tuple[str, str]  # its kind, and its attributes as text


class Step:
    """The entities of a STEP file by number."""

    def __init__(self, text: str):
        self.entities: dict[int, Entity] = {int(number): (kind, rest) for number, kind, rest in ENTITY.findall(text)}

    def of(self, kinds: set[str]) -> list[int]:
        return [number for number, (kind, _) in self.entities.items() if kind in kinds]

    def refers(self, number: int) -> list[int]:
        return [int(found) for found in REFERENCE.findall(self.entities[number][1])]

    def numbers(self, number: int) -> list[float]:
        return [float(found) for found in NUMBER.findall(self.entities[number][1])]

    def axes(self, number: int) -> np.ndarray:
        """The matrix of an IfcAxis2Placement3D: point, z axis and x axis, of which the last two may be missing."""
        point, *directions = self.refers(number)
        matrix = np.identity(4)
        matrix[:3, 3] = self.numbers(point)
        if len(directions) == 2:
            z, x = (np.array(self.numbers(direction)) for direction in directions)
            matrix[:3, 0], matrix[:3, 1], matrix[:3, 2] = x, np.cross(z, x), z
        return matrix

    def placement(self, number: int) -> np.ndarray:
        """The matrix of an IfcLocalPlacement, in the world: its parent, if it has one, and its own axes."""
        *parent, own = self.refers(number)
        return (self.placement(parent[0]) if parent else np.identity(4)) @ self.axes(own)

    def points(self, number: int) -> np.ndarray:
        """The corners of a shape in its own frame, of the shapes that it shares where they are."""
        kind = self.entities[number][0]
        if kind == "IFCCARTESIANPOINT":
            point = self.numbers(number)
            return np.array([point]) if len(point) == 3 else np.empty((0, 3))
        if kind == "IFCEXTRUDEDAREASOLID" or kind.startswith("IFCGEOMETRICREPRESENTATION"):
            return np.empty((0, 3))
        if kind == "IFCMAPPEDITEM":
            source, target = self.refers(number)
            return self.points(self.refers(source)[-1]) + self.numbers(self.refers(target)[-1])[:3]
        if kind == "IFCAXIS2PLACEMENT3D":
            return np.empty((0, 3))
        found = [self.points(other) for other in self.refers(number)]
        return np.concatenate(found) if found else np.empty((0, 3))


def read_ifc(path: Path) -> dict[tuple[str, str], list[Drawn]]:
    """The furniture of a file by building and level, as the importer names them."""
    step = Step(path.read_text(encoding="latin-1"))
    storeys = storeys_of(step)
    found: dict[tuple[str, str], list[Drawn]] = {}
    for number in step.of(FURNITURE):
        piece = piece_of(step, number, storeys)
        if piece is not None:
            found.setdefault((path.stem, piece[0]), []).append(piece[1])
    return found


def storeys_of(step: Step) -> list[tuple[float, str]]:
    """Elevation and id of each storey, from below."""
    storeys = []
    for number in step.of({"IFCBUILDINGSTOREY"}):
        rest = step.entities[number][1]
        storeys.append((float(rest.rpartition(",")[2]), rest.split("'")[3].lower().replace(" ", "_")))
    return sorted(storeys)


def piece_of(step: Step, number: int, storeys: list[tuple[float, str]]) -> tuple[str, Drawn] | None:
    """The storey and the box of a product, if it stands and its name tells what it is."""
    name = step.entities[number][1].split("'")[3].lower()
    kind = next((kind for word, kind in WORDS if word in name), None)
    *_, placement, shape = step.refers(number)
    corners = step.points(shape)
    if kind is None or not len(corners):
        return None
    matrix = step.placement(placement)
    low, high = corners.min(axis=0), corners.max(axis=0)
    bottom = matrix[2, 3] + low[2]
    below = [entry for entry in storeys if entry[0] <= bottom + STANDING / 2]
    if not below or bottom - below[-1][0] > STANDING:
        return None
    center = (matrix @ np.append((low + high) / 2, 1.0))[:2]
    axis = matrix[:2, 0] / max(np.hypot(*matrix[:2, 0]), 1e-9)
    return below[-1][1], Drawn(kind, center, axis, (float(high[0] - low[0]), float(high[1] - low[1])))
