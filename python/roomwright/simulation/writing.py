"""The files of a level and of a building: meshes first, so that no file ever names one that is not there."""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from ..gltf_file import GltfFile
from ..usd.assembly import find_buildings
from ..usd.floor import Written
from ..usd.level import level_of
from ..usd.settings import Settings
from ..usd.writing import write_bytes

from . import mjcf, urdf
from .level import read_level
from .meshes import MESH_FOLDER, Meshes

FORMATS = {".xml": mjcf, ".urdf": urdf}


def convert_level(gltf: GltfFile, target: Path, settings: Settings) -> Written:
    """Converts one file; raises what readers and writers raise."""
    model = read_level(gltf, settings.movable_up_to)
    meshes = Meshes(settings)
    mesh_folder = Path(os.path.relpath(settings.root / MESH_FOLDER, target.parent)).as_posix()
    document = FORMATS[target.suffix].level_document(model, meshes, mesh_folder)
    write_bytes(mjcf.text_of(document), target, settings.root)
    return Written(target, level_of(gltf.nodes[0]), None, tuple(sorted(meshes.files)))


def write_buildings(floors: list[Written], settings: Settings) -> list[Path]:
    """A file for each building of several levels, in MJCF."""
    files = []
    for building in find_buildings(floors):
        if settings.ending == ".xml" and len(building.floors) > 1:
            file = building.file.with_suffix(".xml")
            if any(floor.file == file for floor in building.floors):  # a level of this name
                file = file.with_name(f"all.{file.name}")
            levels = [(ElementTree.parse(floor.file).getroot(), floor.level.elevation) for floor in building.floors]
            write_bytes(mjcf.text_of(mjcf.building_document(building.name, levels)), file, settings.root)
            files.append(file)
    return files
