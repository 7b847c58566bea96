"""A manifest against the files beside it."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Iterator, NamedTuple

from resources import Reach, ResourceError, locate_path, read_file, shown

from .report import Fault

SCENE_ENDINGS = {".glb", ".gltf"}
KINDS = {list: "a list", str: "text", int: "a number", dict: "an object"}


class Entry(NamedTuple):
    """A file as a manifest lists it, with its place in the manifest."""

    place: str
    path: str
    size: int  # bytes
    digest: str  # SHA-256, hexadecimal


class WrongType(Exception):
    """A value that is not what a manifest has at its place."""


def check_manifest(path: Path) -> list[Fault]:
    """The files that a manifest lists against those that are there."""
    return [Fault(str(path), "manifest", "", message) for message in complaints(path)]


def complaints(path: Path) -> Iterator[str]:
    try:
        document = json.loads(read_file(path))
        files = list(listed_files(document))
    except (ResourceError, ValueError, RecursionError, WrongType) as error:
        yield f"cannot be read: {error}"
        return
    folder = path.parent.resolve()
    reach = Reach(folder, (folder,))
    listed = set()
    for place, value in files:
        try:
            entry = entry_of(place, value)
        except WrongType as error:
            yield str(error)
            continue
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


def listed_files(document: object) -> Iterator[tuple[str, object]]:
    """Place and value of every entry with a path, bytes and a hash."""
    for number, level in enumerate(field(document, "levels", list, "")):
        place = f"levels[{number}]"
        for file, value in enumerate(field(level, "files", list, place)):
            yield f"{place}.files[{file}]", value
    if "library" in document:
        for number, value in enumerate(field(document, "library", list, "")):
            yield f"library[{number}]", value


def entry_of(place: str, value: object) -> Entry:
    return Entry(place, field(value, "path", str, place), field(value, "bytes", int, place),
                 field(value, "sha256", str, place))


def field(owner: object, key: str, kind: type, place: str):
    """A field of an object, of the type that manifests have there."""
    if type(owner) is not dict:
        raise WrongType(f"{place or 'the document'}: {shown(owner)} is no object; "
                        "hint: the manifest is as `roomwright bake` wrote it")
    if type(owner.get(key)) is not kind:
        found = f"{shown(owner[key])} is not {KINDS[kind]}" if key in owner else "it is missing"
        raise WrongType(f"{place}{'.' if place else ''}{key}: {found}; "
                        "hint: the manifest is as `roomwright bake` wrote it")
    return owner[key]


def scenes_in(folder: Path) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.suffix.lower() in SCENE_ENDINGS)
