"""The plans and configuration of a job as one archive, whose bytes depend on their content only."""

from __future__ import annotations

import gzip
import hashlib
import io
import os
import tarfile
from pathlib import Path
from typing import NamedTuple

from .failure import Failure


class Inputs(NamedTuple):
    """What the machines unpack, and the arguments of `bake` that name it there."""

    archive: bytes
    arguments: list[str]

    @property
    def sha256(self) -> str:
        return hashlib.sha256(self.archive).hexdigest()


def beside(plan: Path) -> list[Path]:
    """A plan with the files that belong to it: its edits, and the parts of a drawing."""
    edits = plan.with_name(f"{plan.stem}.edits.yaml")
    return [plan, *([edits] if edits.is_file() else [])]


def files_of(path: Path, without: Path | None = None) -> list[Path]:
    """A file, or those in a folder; nothing that is hidden or below `without`."""
    if path.is_file():
        return beside(path)
    if path.is_dir():
        return sorted(found for found in path.rglob("*") if found.is_file() and is_input(found.relative_to(path))
                      and not (without is not None and found.is_relative_to(without)))
    raise Failure(f"{path}: no such file or folder")


def is_input(path: Path) -> bool:
    """Readers pass over hidden files and folders."""
    return not any(part.startswith(".") for part in path.parts)


def pack(plans: list[str], catalogs: list[str], edits: list[str], others: list[str], without: Path | None = None) -> Inputs:
    """Packs plans, folders of configuration, edits and other files that plans name, all at their places to each other."""
    named = {flag: [Path(path).resolve() for path in paths]
             for flag, paths in (("", plans), ("--catalog", catalogs), ("--edits", edits), ("other", others))}
    paths = [path for group in named.values() for path in group]
    if not paths:
        raise Failure("name plans, folders or projects")
    root = Path(os.path.commonpath([path if path.is_dir() else path.parent for path in paths]))
    place = lambda path: path.relative_to(root).as_posix()  # noqa: E731
    arguments = [place(path) for path in named[""]]
    for flag in ("--catalog", "--edits"):
        for path in named[flag]:
            arguments += [flag, place(path)]
    contents = {place(file): file for path in paths for file in files_of(path, without)}
    return Inputs(archive(contents), arguments)


def archive(contents: dict[str, Path]) -> bytes:
    """A compressed tar file without times, owners and rights."""
    packed = io.BytesIO()
    with gzip.GzipFile(fileobj=packed, mode="wb", mtime=0) as stream, tarfile.open(fileobj=stream, mode="w") as tar:
        for name, path in sorted(contents.items()):
            member = tarfile.TarInfo(name)
            content = path.read_bytes()
            member.size = len(content)
            tar.addfile(member, io.BytesIO(content))
    return packed.getvalue()


def unpack(packed: bytes, folder: Path) -> None:
    """Unpacks an archive; names that lead out of the folder are refused."""
    with tarfile.open(fileobj=io.BytesIO(packed), mode="r:gz") as tar:
        tar.extractall(folder, filter="data")
