"""Levels of a house for the tests of Blender's import and export, and what a person does with them in Blender."""

from __future__ import annotations

import importlib.util
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, Floor, build_floor

HAS_BLENDER = importlib.util.find_spec("bpy") is not None
if HAS_BLENDER:
    import bpy
    from roomwright.blender.extension.importing import KINDS

needs_blender = pytest.mark.skipif(not HAS_BLENDER, reason="bpy is not installed (scripts/requirements-render.txt)")
PROGRAM = os.environ.get("ROOMWRIGHT_PROGRAM") or next(
    (str(path) for path in (ROOT / "target" / kind / "roomwright" for kind in ("release", "debug")) if path.is_file()),
    shutil.which("roomwright"))
# One red pixel.
PNG = bytes.fromhex("89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c49444154789c63f8"
                    "cfc0000003010100c9fe92ef0000000049454e44ae426082")


def storey(level: str, elevation: float, site: dict | None = None) -> Floor:
    """The small floor with a ceiling and a light, as a level of the house."""
    floor = build_floor()
    node = floor.find("house/ground")
    node["name"] = f"house/{level}"
    node["extras"] |= {"level": level, "elevation": elevation} | ({"site": site} if site else {})
    number = {node["name"]: index for index, node in enumerate(floor.document["nodes"])}
    slab = floor.box_mesh("ceiling@101", 4.0, 3.0, 0.1, parts=2)
    floor.node("ceiling@101", {"kind": "part", "part": "ceiling", "id": "ceiling", "tags": []}, number["room:101"], slab,
               at=(2.0, 2.5, -1.5))
    frame = floor.box_mesh("frame@door:d1", 0.9, 0.1, 2.0)
    floor.node("frame@door:d1", {"kind": "part", "part": "frame", "id": "frame", "tags": []}, number["door:d1"], frame)
    floor.document["extensionsUsed"] = ["KHR_lights_punctual"]
    floor.document["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "point", "name": "800 lm", "intensity": 63.7, "color": [1.0, 0.5, 0.1]}]}}
    light = floor.node("light.lamp.1@101", {"kind": "light", "lumens": 800.0, "kelvin": 2700.0}, number["lamp.1@101"],
                       at=(0.0, 0.32, 0.0))
    floor.document["nodes"][light]["extensions"] = {"KHR_lights_punctual": {"light": 0}}
    return floor


def write_bake(folder: Path) -> Path:
    """A bake of two levels, the upper turned and moved with its building."""
    building = folder / "out" / "house"
    building.mkdir(parents=True)
    storey("upper", 3.0, {"position": [10.0, 20.0], "turn": 0.5}).write(building / "a.glb")
    storey("ground", 0.0).write(building / "b.glb")
    return building.parent


def world_matrices() -> dict:
    bpy.context.view_layer.update()
    return {thing.name: np.array(thing.matrix_world) for thing in bpy.data.objects}


def census() -> dict:
    """The names of everything that an import can make."""
    return {kind: sorted(one.name for one in getattr(bpy.data, kind)) for kind in KINDS}


def select(*things) -> None:
    bpy.ops.object.select_all(action="DESELECT")
    for thing in things:
        thing.select_set(True)
    bpy.context.view_layer.objects.active = things[0]


def duplicate(name: str, linked: bool):
    """As Alt+D or Shift+D do, with all below it."""
    thing = bpy.data.objects[name]
    select(thing, *thing.children_recursive)
    bpy.ops.object.duplicate(linked=linked)
    return next(one for one in bpy.context.selected_objects if one.parent not in bpy.context.selected_objects)


def delete(*things) -> None:
    select(*things)
    bpy.ops.object.delete()
