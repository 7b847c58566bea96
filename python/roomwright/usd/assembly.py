"""Stages of buildings and of a city, which open without loading their levels.

`<building>/building.usda` has a prim for each level at its elevation, with the level as payload; `city.usda` has a prim for
each building at its place, with the building as payload. Boxes (`extentsHint`) at the prims show a viewer where everything
is before it loads anything. Elevations and places are those in the extras of the levels.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from pxr import Gf, Kind, Sdf, Vt

from .floor import Written
from .level import Level
from .naming import Names, valid_name
from .physics import write_scene
from .placing import turn_up
from .settings import Settings
from .specs import Types, attribute, new_prim, transform_order
from .writing import relative_path, write_layer

BUILDING_FILE = "building.usda"
CITY_FILE = "city.usda"
ELEVATION = "xformOp:translate:elevation"
POSITION = "xformOp:translate:site"
TURN = "xformOp:rotate{}:site"
Box = tuple[np.ndarray, np.ndarray]


@dataclass(frozen=True)
class Building:
    """The floors of one building, lowest first."""

    name: str
    file: Path
    floors: list[Written]

    @property
    def level(self) -> Level:
        """The level that says where the building stands."""
        return self.floors[0].level


def write_assemblies(floors: list[Written], settings: Settings) -> list[Path]:
    """The stages of all buildings, and of the city if there is more than one building."""
    buildings = find_buildings(floors)
    for building in buildings:
        write_building(building, settings)
    files = [building.file for building in buildings]
    if len(buildings) > 1:
        files.append(write_city(buildings, settings))
    return files


def find_buildings(floors: list[Written]) -> list[Building]:
    """The levels by folder and building, in the order of their paths."""
    groups: dict[tuple[Path, str], list[Written]] = {}
    for floor in floors:
        if floor.level is not None:
            groups.setdefault((floor.file.parent, floor.level.building), []).append(floor)
    folders = [folder for folder, _ in groups]
    buildings = []
    for (folder, name), members in sorted(groups.items()):
        # The program gives each building a folder of its own; levels that were moved together by hand share one.
        file = BUILDING_FILE if folders.count(folder) == 1 else f"{valid_name(name)}.{BUILDING_FILE}"
        members.sort(key=lambda floor: (floor.level.elevation, floor.level.name))
        buildings.append(Building(name, folder / file, members))
    return buildings


def write_building(building: Building, settings: Settings) -> None:
    layer, root = new_stage(building.name, settings)
    root.SetInfo("customData", {"kind": "building", "building": building.name})
    names = Names()
    with Sdf.ChangeBlock():
        for floor in building.floors:
            prim = new_prim(root, names.take(floor.level.name), "Xform")
            prim.kind = Kind.Tokens.assembly
            payload(prim, floor.file, building.file.parent)
            elevation = floor.level.elevation
            up = (0.0, 0.0, elevation) if settings.up_axis == "Z" else (0.0, elevation, 0.0)
            attribute(prim, ELEVATION, Types.Double3, Gf.Vec3d(*up))
            # The floor's own operation is repeated, because an order that is stated here hides the floor's.
            turned = [turn_up(prim)] if settings.up_axis == "Z" else []
            transform_order(prim, [ELEVATION, *turned])
            hint(prim, floor_box(floor))
        hint(root, turned_box(building_box(building), settings))
    write_layer(layer, building.file, settings.root)


def write_city(buildings: list[Building], settings: Settings) -> Path:
    file = settings.root / CITY_FILE
    layer, root = new_stage("city", settings)
    names = Names()
    with Sdf.ChangeBlock():
        for building in buildings:
            prim = new_prim(root, names.take(building.name), "Xform")
            prim.kind = Kind.Tokens.assembly
            payload(prim, building.file, file.parent)
            place_building(prim, building, settings.up_axis)
            hint(prim, turned_box(building_box(building), settings))
    write_layer(layer, file, settings.root)
    return file


def place_building(prim: Sdf.PrimSpec, building: Building, up_axis: str) -> None:
    """The plan's axes are x east and y north: north is -Z where Y is up, and turns are counter-clockwise in both."""
    (east, north), turn = building.level.position, building.level.turn
    place = Gf.Vec3d(east, north, 0.0) if up_axis == "Z" else Gf.Vec3d(east, 0.0, -north)
    attribute(prim, POSITION, Types.Double3, place)
    operation = TURN.format(up_axis)
    attribute(prim, operation, Types.Double, math.degrees(turn))
    transform_order(prim, [POSITION, operation])


def new_stage(name: str, settings: Settings) -> tuple[Sdf.Layer, Sdf.PrimSpec]:
    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.pseudoRoot.SetInfo("metersPerUnit", 1.0)
    layer.pseudoRoot.SetInfo("upAxis", settings.up_axis)
    root = new_prim(layer.pseudoRoot, valid_name(name), "Xform")
    root.kind = Kind.Tokens.assembly
    root.SetInfo("displayName", name)
    layer.defaultPrim = root.name
    if settings.has_physics:
        write_scene(layer, settings.up_axis)
    return layer, root


def payload(prim: Sdf.PrimSpec, file: Path, folder: Path) -> None:
    prim.payloadList.prependedItems = [Sdf.Payload(relative_path(file, folder))]


# --- boxes ---


def hint(prim: Sdf.PrimSpec, box: Box | None) -> None:
    """The box of what is below a prim, in the prim's own frame."""
    if box is not None:
        corners = Vt.Vec3fArray([Gf.Vec3f(*corner.tolist()) for corner in box])
        attribute(prim, "extentsHint", Types.Float3Array, corners)


def floor_box(floor: Written) -> Box | None:
    return None if floor.bounds is None else (np.array(floor.bounds[0]), np.array(floor.bounds[1]))


def building_box(building: Building) -> Box | None:
    """Around the floors at their elevations, Y up."""
    boxes = [(box, floor.level.elevation) for floor in building.floors if (box := floor_box(floor)) is not None]
    if not boxes:
        return None
    lifted = [np.stack(box) + [0.0, elevation, 0.0] for box, elevation in boxes]
    return np.min([box[0] for box in lifted], axis=0), np.max([box[1] for box in lifted], axis=0)


def turned_box(box: Box | None, settings: Settings) -> Box | None:
    """A box of a Y-up tree in the stage's axes."""
    if box is None or settings.up_axis == "Y":
        return box
    (x, y, z), (far_x, far_y, far_z) = box
    return np.array([x, -far_z, y]), np.array([far_x, -z, far_y])
