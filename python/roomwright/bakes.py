"""A finished bake: its manifest, and its levels as data."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from .gltf_document import GltfError
from .level_file import LevelError, read_level
from .records import Level, Placement, Room
from .resources import Reach, ResourceError, locate_path, read_file

MANIFEST = "manifest.json"
# The version of manifests that this package reads (src/batch/).
VERSION = 1
SCENE_ENDINGS = (".glb", ".gltf")


class BakeError(Exception):
    """A folder or file that is no bake; the text has the place, the fact and a hint."""


@dataclass(frozen=True)
class Bake:
    """A folder that `roomwright bake` wrote. Levels are read when they are first asked for."""

    folder: Path
    manifest: dict[str, Any]  # as configs/schema/manifest.schema.json says
    warnings: str = ""  # what the program reported while it baked

    @classmethod
    def open(cls, folder: str | os.PathLike[str], warnings: str = "") -> Bake:
        """The bake in a folder. Raises BakeError."""
        path = Path(folder, MANIFEST)
        try:
            manifest = json.loads(read_file(path))
        except (OSError, ResourceError) as error:
            raise BakeError(f"{path}: {error}; hint: name the folder that `roomwright bake --out` wrote") from error
        except (ValueError, RecursionError) as error:
            raise BakeError(f"{path}: no JSON: {error}") from error
        version = manifest.get("manifest") if isinstance(manifest, dict) else None
        if version != VERSION or not isinstance(manifest.get("levels"), list):
            raise BakeError(f"{path}: no manifest of version {VERSION}, but {str(version)[:60]}; hint: bake again with the program "
                            "of this package")
        return cls(Path(folder), manifest, warnings)

    @cached_property
    def levels(self) -> tuple[Level, ...]:
        """The levels, in the order of the manifest. Raises BakeError."""
        return tuple(self._read(record) for record in self.manifest["levels"])

    @property
    def rooms(self) -> Iterator[Room]:
        return (room for level in self.levels for room in level.rooms)

    @property
    def placements(self) -> Iterator[Placement]:
        """The furniture of all rooms."""
        return (placement for level in self.levels for placement in level.placements)

    def level(self, name: str) -> Level:
        """The level with a name such as `house/ground`. Raises KeyError."""
        found = {level.name: level for level in self.levels}
        if name not in found:
            raise KeyError(f"{name} is no level of {self.folder}; hint: its levels are {', '.join(found)}")
        return found[name]

    def _read(self, record: dict[str, Any]) -> Level:
        try:
            files = [entry["path"] for entry in record["files"]]
            scene = next((path for path in files if path.endswith(SCENE_ENDINGS)), None)
        except (LookupError, TypeError, AttributeError) as error:
            raise BakeError(f"{self.folder / MANIFEST}: a level without files, {type(error).__name__}: {error}") from error
        if scene is None:
            raise BakeError(f"{self.folder}: the level {record.get('level')} has no .glb or .gltf; "
                            "hint: bake without --format tiles")
        root = self.folder.resolve()
        try:
            # A manifest sends nobody out of its folder.
            locate_path(scene, Reach(root, (root,)))
            return read_level(self.folder / scene, self.folder)
        except (LevelError, GltfError, ResourceError) as error:
            raise BakeError(f"{self.folder / scene}: {error}") from error
