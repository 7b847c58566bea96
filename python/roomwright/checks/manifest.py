"""A manifest against its schema and the files beside it."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Iterator, NamedTuple

from ..resources import Reach, ResourceError, locate_path, read_file

from .report import Fault
from .schemas import file_record_schema, manifest_schema

SCENE_ENDINGS = {".glb", ".gltf"}
STAGE_ENDINGS = {".usd", ".usda", ".usdc", ".usdz"}


class Entry(NamedTuple):
    """A file as a manifest lists it, with its place in the manifest."""

    place: str
    path: str
    size: int  # bytes
    digest: str  # SHA-256, hexadecimal


def check_manifest(path: Path) -> list[Fault]:
    """The files that a manifest lists against those that are there."""
    return [Fault(str(path), "manifest", "", message) for message in complaints(path)]


def complaints(path: Path) -> Iterator[str]:
    try:
        document = json.loads(read_file(path))
        violations = manifest_schema().violations(document)
    except (ResourceError, ValueError, RecursionError) as error:
        yield f"cannot be read: {error}"
        return
    yield from (f"{violation}; hint: the manifest is as `roomwright bake` wrote it" for violation in violations)
    folder = path.parent.resolve()
    reach = Reach(folder, (folder,))
    listed = set()
    for entry in entries_of(document):
        listed.add(entry.path)
        yield from check_entry(entry, reach)
    beside = {file.relative_to(path.parent).as_posix() for file in scenes_in(path.parent)}
    yield from (f"{name} exists, but is not listed" for name in sorted(beside - listed))


def check_entry(entry: Entry, reach: Reach) -> Iterator[str]:
    try:
        file = locate_path(entry.path, reach)
        size = file.stat().st_size
        if size != entry.size:
            yield f"{entry.place}: {entry.path} has {size} bytes, not {entry.size}"
        elif hashlib.sha256(read_file(file)).hexdigest() != entry.digest:
            yield f"{entry.place}: {entry.path} has another hash than listed"
    except (ResourceError, OSError) as error:
        yield f"{entry.place}.path: {error}"


def entries_of(document: object) -> Iterator[Entry]:
    """The files that a manifest lists, without entries that cannot be read."""
    levels = [(f"{key}[{number}].files", _list_in(level, "files"))
              for key in ("levels", "former_levels") for number, level in enumerate(_list_in(document, key))]
    for place, values in [*levels, *((key, _list_in(document, key)) for key in ("library", "index", "former_files"))]:
        for number, value in enumerate(values):
            if file_record_schema().is_usable(value):
                yield Entry(f"{place}[{number}]", value["path"], value["bytes"], value["sha256"])


def _list_in(owner: object, key: str) -> list:
    found = owner.get(key) if isinstance(owner, dict) else None
    return found if isinstance(found, list) else []


def scenes_in(folder: Path) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.suffix.lower() in SCENE_ENDINGS)
