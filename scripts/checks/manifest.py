"""A manifest against the files beside it."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Iterator

from .report import Fault

SCENE_ENDINGS = {".glb", ".gltf"}


def check_manifest(path: Path) -> list[Fault]:
    """The files that a manifest lists against those that are there."""
    def fault(message: str) -> Fault:
        return Fault(str(path), "manifest", "", message)

    try:
        document = json.loads(path.read_bytes())
        listed = {entry["path"]: entry for entry in manifest_files(document)}
    except (OSError, ValueError, KeyError, TypeError) as error:
        return [fault(f"cannot be read: {error!r}")]
    faults = []
    for name, entry in sorted(listed.items()):
        file = path.parent / name
        if Path(name).is_absolute() or ".." in Path(name).parts:
            faults.append(fault(f"the path {name!r} leaves the folder"))
        elif not file.is_file():
            faults.append(fault(f"{name} is listed and not there"))
        elif file.stat().st_size != entry["bytes"]:
            faults.append(fault(f"{name} has {file.stat().st_size} bytes, not {entry['bytes']}"))
        elif hashlib.sha256(file.read_bytes()).hexdigest() != entry["sha256"]:
            faults.append(fault(f"{name} has another hash than listed"))
    beside = {file.relative_to(path.parent).as_posix() for file in scenes_in(path.parent)}
    faults += [fault(f"{name} is there and not listed") for name in sorted(beside - listed.keys())]
    return faults


def manifest_files(document: dict) -> Iterator[dict]:
    """Every entry with a path, bytes and a hash."""
    for level in document["levels"]:
        yield from level["files"]
    yield from document.get("library", [])


def scenes_in(folder: Path) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.suffix.lower() in SCENE_ENDINGS)
