"""The facts of a level that its building's stage needs: names, elevation and the building's place."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..gltf_document import GltfError
from ..gltf_file import Node
from ..resources import shown


@dataclass(frozen=True)
class Level:
    """A level as its node's extras describe it."""

    building: str
    name: str
    elevation: float  # metres over the site
    position: tuple[float, float]  # of the building: metres east and north
    turn: float  # of the building: radians counter-clockwise


def level_of(node: Node) -> Level | None:
    """The level of a floor's root; nothing for scenes of other kinds."""
    if node.kind != "level":
        return None
    site = node.extras.get("site") or {}
    if type(site) is not dict or type(site.get("position", [])) is not list:
        raise GltfError(f"{node.name}: its site {shown(site)} has no position of two numbers")
    east, north = (*site.get("position", []), 0.0, 0.0)[:2]
    elevation = number(node.name, "elevation", node.extras.get("elevation"))
    position = number(node.name, "site.position", east), number(node.name, "site.position", north)
    turn = number(node.name, "site.turn", site.get("turn", 0.0))
    return Level(text(node, "building"), text(node, "level"), elevation, position, turn)


def text(node: Node, key: str) -> str:
    value = node.extras.get(key)
    if type(value) is not str:
        raise GltfError(f"{node.name}: its {key} {shown(value)} is no text")
    return value


def number(name: str, key: str, value: object) -> float:
    if type(value) not in (int, float) or not math.isfinite(value):
        raise GltfError(f"{name}: its {key} {shown(value)} is no number")
    return float(value)
