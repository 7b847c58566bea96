"""Surfaces as OBJ files that all levels of a run share: each surface once, named by its content."""

from __future__ import annotations

import hashlib
from pathlib import Path

from ..usd.naming import LONGEST_NAME, valid_name
from ..usd.settings import Settings
from ..usd.textures import HASH_LENGTH
from ..usd.writing import is_of_this_run, write_bytes

from .axes import numbers
from .bodies import Surface

MESH_FOLDER = "shared-meshes"
# The name of collision shapes; visual ones have the names of their models.
CONVEX = "convex"


class Meshes:
    """The mesh files of one level."""

    def __init__(self, settings: Settings):
        self.settings = settings
        self.folder = settings.root / MESH_FOLDER
        self.files: set[Path] = set()
        self.known: dict[tuple[str, int], tuple[Surface, str]] = {}

    def file_name(self, name: str, surface: Surface) -> str:
        """The name of a surface's file, which is written if this run has not done so yet."""
        # The surface is kept beside the name: another one may not get its identity while this one is in use.
        key = name, id(surface)
        if key not in self.known:
            self.known[key] = surface, self.write(name, surface)
        return self.known[key][1]

    def write(self, name: str, surface: Surface) -> str:
        data = obj_of(surface)
        digest = hashlib.sha256(data).hexdigest()[:HASH_LENGTH]
        file = self.folder / f"{valid_name(name)[:LONGEST_NAME]}.{digest}.obj"
        self.files.add(file)
        if not is_of_this_run(file, self.settings.started):
            write_bytes(data, file, self.settings.root)
        return file.name


def obj_of(surface: Surface) -> bytes:
    """Corners and triangles alone: colours are in the level's file, and simulators make normals of their own."""
    lines = [f"v {numbers(corner)}" for corner in surface.corners]
    lines += [f"f {a} {b} {c}" for a, b, c in (surface.triangles + 1).tolist()]
    return ("\n".join(lines) + "\n").encode()
