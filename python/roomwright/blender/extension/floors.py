"""Which floors are in the files and folders that the user chose."""

import fnmatch
import json
from dataclasses import dataclass
from pathlib import Path

from .errors import BakeError
from .glb import read_document

SCENE_ENDINGS = (".glb", ".gltf")


@dataclass(frozen=True)
class Floor:
    """A file that can be imported, with the facts that its level node carries."""

    path: Path
    building: str
    level: str
    elevation: float               # metres
    position: tuple[float, float]  # of the building on its site: metres to the east, to the north
    turn: float                    # of the building: radians, counter-clockwise from above

    @property
    def name(self) -> str:
        return f"{self.building}/{self.level}"


def find_floors(paths, patterns=()) -> list[Floor]:
    """The floors of a path or several that match one of the patterns, by building, from the lowest up.

    A pattern is LEVEL, BUILDING/LEVEL or BUILDING, with * for any text; no pattern is all. Raises BakeError.
    """
    known, chosen = [], []
    for path in [Path(paths)] if isinstance(paths, (str, Path)) else [Path(path) for path in paths]:
        for file, name in _list_files(path):
            if name is None or _is_chosen(*name, patterns):
                floor = read_floor(file)
                name = (floor.building, floor.level)
                if _is_chosen(*name, patterns):
                    chosen.append(floor)
            known.append("/".join(name))
    if not chosen:
        shown = ", ".join(known[:8]) + (", ..." if len(known) > 8 else "")
        raise BakeError(f"no level matches {', '.join(patterns)}; there are {shown}")
    return sorted(chosen, key=lambda floor: (floor.building, floor.elevation, floor.level, floor.path))


def read_floor(path: Path) -> Floor:
    """The facts that a file's level node carries. Raises BakeError."""
    for node in read_document(path).get("nodes", []):
        extras = node.get("extras") or {}
        if isinstance(extras, dict) and extras.get("kind") == "level":
            try:
                return _floor_of(path, extras)
            except (KeyError, TypeError, ValueError) as error:
                raise BakeError(f"{path}: node {node.get('name')!r} has extras that cannot be read: {error!r}") from error
    raise BakeError(f"{path}: is no file of roomwright: no node's extras say that it is a level\n"
                    "  hint: File > Import > glTF opens other files; exports need Include > Custom Properties")


def _floor_of(path: Path, extras: dict) -> Floor:
    site = extras.get("site") or {"position": (0.0, 0.0), "turn": 0.0}
    east, north = (float(metres) for metres in site["position"])
    return Floor(path, str(extras["building"]), str(extras["level"]), float(extras["elevation"]), (east, north),
                 float(site["turn"]))


def _is_chosen(building: str, level: str, patterns) -> bool:
    names = (level, f"{building}/{level}", building)
    return not patterns or any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns for name in names)


def _list_files(path: Path) -> list[tuple[Path, tuple[str, str] | None]]:
    """The files below a path; of a bake also their building and level, so that the other files stay closed."""
    if path.name == "manifest.json":
        path = path.parent
    if path.is_file():
        return [(path, None)]
    if not path.is_dir():
        raise BakeError(f"{path}: no such file or folder; `roomwright bake` writes into out/")
    manifest = path / "manifest.json"
    if manifest.is_file():
        return _listed_files(manifest)
    files = sorted(one for one in path.rglob("*") if one.suffix.lower() in SCENE_ENDINGS
                   and not any(part.startswith(".") for part in one.relative_to(path).parts))
    if not files:
        raise BakeError(f"{path}: neither a manifest.json nor a .glb or .gltf is in it")
    return [(one, None) for one in files]


def _listed_files(manifest: Path) -> list[tuple[Path, tuple[str, str]]]:
    try:
        levels = json.loads(manifest.read_bytes())["levels"]
        names = [(one["files"][0]["path"], (one["building"], one["level"])) for one in levels]
        if any(".." in Path(name).parts or Path(name).is_absolute() for name, _ in names):
            raise ValueError("a file of it lies elsewhere")
        return [(manifest.parent / name, level) for name, level in names]
    except (ValueError, KeyError, TypeError, IndexError, OSError) as error:
        raise BakeError(f"{manifest}: is no manifest that roomwright wrote ({error!r})") from error
