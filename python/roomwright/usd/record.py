"""The record of the files that convert.py wrote into a folder. By it, a later run removes files that it no longer writes.

`converted.json` lists every file with its hash and, if it was made from one source, with that source. A run removes the
listed files whose source is among its inputs and which it did not write: a level that left the bake, a level in another
format, a city of one building. Models and images have many sources; they are removed by a run whose inputs cover everything
in the record. A file that was changed by hand stays, and so does every file that is not in the record or is reached through
a link.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from ..resources import Reach, ResourceError, locate_path, read_file

from .writing import write_bytes

RECORD_FILE = "converted.json"
VERSION = 1


@dataclass(frozen=True, order=True)
class Entry:
    """A file of the record."""

    path: str  # from the folder, with `/`
    digest: str  # SHA-256, hexadecimal
    source: str | None = None  # from the folder too: the floor's file, a stage's folder; none for what floors share


@dataclass(frozen=True)
class Asked:
    """The inputs of a run, as paths from the folder that it writes into."""

    sources: tuple[str, ...]  # files and folders, and the folder around all folders
    failed: frozenset[str] = frozenset()  # files of which an earlier result stays

    def covers(self, source: str) -> bool:
        return source not in self.failed and any(is_below(source, asked) for asked in self.sources)


def is_below(source: str, asked: str) -> bool:
    if asked == ".":
        return not source.startswith("../")
    return source == asked or source.startswith(f"{asked}/")


@dataclass
class Removal:
    """The files that were removed, and those that stay although no run writes them any more, with the reason."""

    removed: list[str]
    kept: list[str]


def path_from(root: Path, path: Path) -> str:
    """How the record of a folder names a file or a folder, links followed."""
    real = os.path.realpath(path)
    try:
        return Path(os.path.relpath(real, os.path.realpath(root))).as_posix()
    except ValueError:  # on another drive
        return Path(real).as_posix()


def renew(root: Path, written: Iterable[Entry], asked: Asked) -> Removal:
    """Removes the files that the run no longer writes, and writes the record anew."""
    new = {entry.path: entry for entry in written}
    old = {entry.path: entry for entry in read_record(root) if entry.path not in new}
    stale = stale_of(list(old.values()), asked)
    removal = Removal([], [])
    for entry in stale:
        remove(root, entry, removal)
    kept = [entry for entry in old.values() if entry not in stale]
    write_record(root, [*new.values(), *kept])
    return removal


def stale_of(entries: list[Entry], asked: Asked) -> list[Entry]:
    """The files that a run would have written if its inputs still had them; `entries` are those that it did not write."""
    floors = [entry for entry in entries if entry.source is not None]
    stale = [entry for entry in floors if asked.covers(entry.source)]
    shared = [entry for entry in entries if entry.source is None]
    return [*stale, *shared] if len(stale) == len(floors) else stale


def remove(root: Path, entry: Entry, removal: Removal) -> None:
    """Removes a file, unless it was changed, and folders that are empty then."""
    real_root = root.resolve()
    file = real_root / entry.path
    try:
        found = locate_path(entry.path, Reach(real_root, (real_root,)))
        if found != file:
            removal.kept.append(f"{entry.path}: it is reached through a link")
        elif digest_of(file) != entry.digest:
            removal.kept.append(f"{entry.path}: it was changed since it was written")
        else:
            file.unlink()
            remove_empty(file.parent, real_root)
            removal.removed.append(entry.path)
    except ResourceError:
        # It was removed by hand, or the record is not one of convert.py.
        return


def remove_empty(folder: Path, root: Path) -> None:
    while folder != root:
        try:
            folder.rmdir()
        except OSError:
            return
        folder = folder.parent


# --- the file ---


def read_record(root: Path) -> list[Entry]:
    """The entries of a folder's record; none if the record is missing or cannot be read."""
    try:
        document = json.loads(read_file(root / RECORD_FILE))
        listed = document["files"] if document["converted"] == VERSION else []
        return [entry for entry in (Entry(**value) for value in listed) if is_well_formed(entry)]
    except (ResourceError, ValueError, KeyError, TypeError, RecursionError):
        return []


def is_well_formed(entry: Entry) -> bool:
    return all(isinstance(text, str) for text in (entry.path, entry.digest, entry.source or ""))


def write_record(root: Path, entries: list[Entry]) -> None:
    lines = [json.dumps({key: value for key, value in vars(entry).items() if value is not None})
             for entry in sorted(entries, key=lambda entry: entry.path)]
    text = f'{{"converted": {VERSION}, "files": [\n' + ",\n".join(lines) + "\n]}\n"
    write_bytes(text.encode(), root / RECORD_FILE, root)


def digest_of(file: Path) -> str:
    return hashlib.sha256(read_file(file)).hexdigest()
