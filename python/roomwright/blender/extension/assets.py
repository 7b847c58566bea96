"""Furniture in Blender's asset browser, with a catalogue for each class."""

import uuid
from pathlib import Path

import bpy

from .whole_file import whole_file

CATALOG_FILE = "blender_assets.cats.txt"
CATALOG_NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "https://roomwright/catalogue")
COPIED = ("kind", "class", "size", "variant")


def catalog_id(class_name: str) -> str:
    """The id of a class's catalogue, the same in every file."""
    return str(uuid.uuid5(CATALOG_NAMESPACE, class_name))


def make_asset(mesh, piece) -> None:
    """Makes a model without a place, to be dragged into a scene; it shares the mesh of the placed pieces."""
    model = bpy.data.objects.new(mesh.name, mesh)
    for name in COPIED:
        if name in piece:
            model[name] = piece[name]
    model.asset_mark()
    model.asset_data.catalog_id = catalog_id(piece["class"])
    model.asset_data.tags.new(piece["class"])
    model.asset_data.description = " x ".join(f"{metres:.2f}" for metres in piece.get("size", ())) + " m"


def write_catalog(folder: Path) -> Path:
    """Writes the catalogue of all classes beside a .blend; entries of others in the file stay."""
    path = folder / CATALOG_FILE
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else [
        "# This is an Asset Catalog Definition file for Blender.", "", "VERSION 1", ""]
    classes = {thing["class"] for thing in bpy.data.objects if thing.asset_data is not None and "class" in thing}
    for name in sorted(classes):
        if not any(line.startswith(catalog_id(name)) for line in lines):
            lines.append(f"{catalog_id(name)}:Roomwright/{name}:{name}")
    with whole_file(path) as partial:
        partial.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path
