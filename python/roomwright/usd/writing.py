"""Files that are written whole or not at all, below a root: under a temporary name, then renamed."""

from __future__ import annotations

import os
import stat
import struct
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pxr import Sdf, UsdUtils


# The first moment that a zip archive can name, as the bytes of time and date of its entries.
FIRST_MOMENT = b"\x00\x00\x21\x00"
# Bytes from the beginning of an entry's own header, and of its line in the directory, to its time; of that line's fixed part,
# and where in it the lengths of what follows are.
TIME_IN_HEADER = 10
TIME_IN_DIRECTORY = 12
DIRECTORY_LINE = 46
LENGTHS = slice(28, 34)


class WriteError(Exception):
    """A file that could not be written; the text says which."""


def write_layer(layer: Sdf.Layer, target: Path, root: Path) -> None:
    with unfinished(target, root) as temporary:
        if not layer.Export(str(temporary)):
            raise WriteError(f"cannot write {target}")


def write_bytes(data: bytes, target: Path, root: Path) -> None:
    with unfinished(target, root) as temporary:
        temporary.write_bytes(data)


def write_package(first: Path, target: Path, root: Path) -> None:
    """A .usdz of a layer and everything that it refers to."""
    with unfinished(target, root) as temporary:
        if not UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(first)), str(temporary)):
            raise WriteError(f"cannot pack {target}")
        forget_times(temporary)


def forget_times(package: Path) -> None:
    """Gives all entries of a zip archive one time: USD writes when they were packed, and equal levels would differ."""
    with zipfile.ZipFile(package) as archive:
        headers = [entry.header_offset for entry in archive.infolist()]
        line = archive.start_dir
    with package.open("r+b") as file:
        for header in headers:
            file.seek(header + TIME_IN_HEADER)
            file.write(FIRST_MOMENT)
            file.seek(line)
            lengths = struct.unpack("<3H", file.read(DIRECTORY_LINE)[LENGTHS])  # name, extra field, comment
            file.seek(line + TIME_IN_DIRECTORY)
            file.write(FIRST_MOMENT)
            line += DIRECTORY_LINE + sum(lengths)


@contextmanager
def unfinished(target: Path, root: Path) -> Iterator[Path]:
    """A temporary name that no other process uses, for the target; its ending names the format for USD."""
    # Sources are not always their users' own: a folder beside them may be a link to anywhere.
    folder = Path(os.path.realpath(target.parent))
    if not folder.is_relative_to(os.path.realpath(root)):
        raise WriteError(f"cannot write {target}: a folder in its path is a link out of {root}")
    folder.mkdir(parents=True, exist_ok=True)
    temporary = target.with_name(f".{target.stem}.{os.getpid()}{target.suffix}")
    temporary.unlink(missing_ok=True)
    try:
        yield temporary
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)


def is_of_this_run(file: Path, started: float) -> bool:
    """Whether another floor of the run has written a shared file already."""
    try:
        found = file.lstat()
    except OSError:
        return False
    return stat.S_ISREG(found.st_mode) and found.st_mtime >= started


def relative_path(target: Path, folder: Path) -> str:
    """How a layer in a folder names a file: with `/`, and anchored to the layer."""
    path = Path(os.path.relpath(target, folder)).as_posix()
    return path if path.startswith("../") else f"./{path}"
