"""Files that are there whole or not at all: written under a temporary name, then renamed."""

from __future__ import annotations

import os
from pathlib import Path

from pxr import Sdf, UsdUtils


class WriteError(Exception):
    """A file that could not be written; the text says which."""


def unfinished(target: Path) -> Path:
    """A name that no other process uses; the ending tells USD the format."""
    return target.with_name(f".{target.stem}.{os.getpid()}{target.suffix}")


def write_layer(layer: Sdf.Layer, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    temporary = unfinished(target)
    try:
        if not layer.Export(str(temporary)):
            raise WriteError(f"cannot write {target}")
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)


def write_bytes(data: bytes, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    temporary = unfinished(target)
    try:
        temporary.write_bytes(data)
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)


def write_package(first: Path, target: Path) -> None:
    """A .usdz of a layer and everything that it refers to."""
    target.parent.mkdir(parents=True, exist_ok=True)
    temporary = unfinished(target)
    try:
        if not UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(first)), str(temporary)):
            raise WriteError(f"cannot pack {target}")
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)


def is_of_this_run(file: Path, started: float) -> bool:
    """Whether another floor of the run has written a shared file already."""
    try:
        return file.stat().st_mtime >= started
    except OSError:
        return False


def relative_path(target: Path, folder: Path) -> str:
    """How a layer in a folder names a file: with `/`, and anchored to the layer."""
    path = Path(os.path.relpath(target, folder)).as_posix()
    return path if path.startswith("../") else f"./{path}"
