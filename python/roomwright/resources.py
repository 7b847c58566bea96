"""Files that a scene names: the one place where a URI becomes a path.

Scenes come from anywhere, and what they name is read, copied and handed to other programs. A floor in
OUT/<building>/ may name files of the folder that was asked for (OUT, or else its own folder) and of the shared folders
beside its own: relative, without a link that leads out, and files that are neither pipes nor devices nor endless.
"""

from __future__ import annotations

import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path, PureWindowsPath
from urllib.parse import unquote

# The folders beside OUT/<building>/ that floors share (src/batch/mod.rs, usd/settings.py).
SHARED_FOLDERS = ("shared-textures", "shared-geometry", "shared-models")
# Bytes of a file: no .glb can hold more.
MOST_BYTES = 2**32
# Bytes of an image: 8192 pixels square without compression.
MOST_IMAGE_BYTES = 2**28
SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")
OUTSIDE = "; hint: keep the file in the folder of the floor, or name the folder that holds both on the command line"
# A pipe without a writer may not hold up its reader, and a link may not replace a file after it was judged.
OPEN_FLAGS = sum(getattr(os, name, 0) for name in ("O_RDONLY", "O_NONBLOCK", "O_NOFOLLOW", "O_CLOEXEC", "O_BINARY"))


class ResourceError(Exception):
    """A file that is named and cannot be had; the text says what is wrong with it."""


class ForbiddenError(ResourceError):
    """A file that may not be named, or is none: no reader may be sent there."""


@dataclass(frozen=True)
class Reach:
    """Where the files that one file names may be."""

    folder: Path  # that relative paths begin in
    roots: tuple[Path, ...]  # folders that hold what may be named; nothing in them is a link any more

    def holds(self, path: Path) -> bool:
        return any(path.is_relative_to(root) for root in self.roots)


def reach_of(file: Path, asked_for: Path | None = None) -> Reach:
    """The places that a file may name; `asked_for` is the folder of the command line that it was found in."""
    folder = Path(os.path.abspath(file)).parent.resolve()
    root = folder if asked_for is None else asked_for.resolve()
    return Reach(folder, (root, folder, *(folder.parent / name for name in SHARED_FOLDERS)))


def locate(uri: object, reach: Reach) -> Path:
    """The file of a URI, percent-decoded."""
    if isinstance(uri, str) and SCHEME.match(uri):
        raise ForbiddenError(f"{shown(uri)} is an absolute path{OUTSIDE}")
    return locate_path(unquote(uri, errors="surrogateescape") if isinstance(uri, str) else uri, reach, shown(uri))


def locate_path(path: object, reach: Reach, name: str = "") -> Path:
    """The file of a relative path, which messages call `name`; the file system is not asked about paths outside."""
    name = name or shown(path)
    if not isinstance(path, str):
        raise ForbiddenError(f"{name} is no text")
    if path.startswith("/") or PureWindowsPath(path).anchor:
        raise ForbiddenError(f"{name} is an absolute path{OUTSIDE}")
    if not path or "\\" in path or "\0" in path:
        raise ForbiddenError(f"{name} is no path; hint: folders and files with `/` between them")
    joined = Path(os.path.normpath(reach.folder / path))
    if not reach.holds(joined):
        raise ForbiddenError(f"{name} leads out of the folder{OUTSIDE}")
    return regular_file(joined, reach, name)


def regular_file(path: Path, reach: Reach | None, name: str) -> Path:
    """The file that a path means after all links, anywhere if there is no reach; `name` is what messages call it."""
    try:
        real = path.resolve(strict=True)
        found = real.stat()
    except (OSError, ValueError, RuntimeError) as error:
        raise ResourceError(f"{name} cannot be read: {reason(error)}") from error
    if reach is not None and not reach.holds(real):
        raise ForbiddenError(f"{name} is a link that leads out of the folder{OUTSIDE}")
    if not stat.S_ISREG(found.st_mode):
        raise ForbiddenError(f"{name} is no regular file; hint: folders, pipes and devices are not read")
    if found.st_size > MOST_BYTES:
        raise ForbiddenError(f"{name} has {found.st_size} bytes, and at most {MOST_BYTES} are read")
    return real


def read_file(path: Path, most: int = MOST_BYTES) -> bytes:
    """The bytes of a regular file, at most `most` of them; links are followed before it is opened."""
    try:
        with os.fdopen(os.open(os.path.realpath(path), OPEN_FLAGS), "rb") as file:
            found = os.fstat(file.fileno())
            if not stat.S_ISREG(found.st_mode):
                raise ForbiddenError("it is no regular file")
            if found.st_size > most:
                raise ForbiddenError(f"it has {found.st_size} bytes, and at most {most} are read")
            return file.read()
    except (OSError, ValueError) as error:
        raise ResourceError(f"cannot be read: {reason(error)}") from error


def reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def printable(text: str) -> str:
    """A text that ends no line, moves no cursor and can be written in any encoding that has its letters."""
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text)


def shown(value: object) -> str:
    """A value of a file in a message: on one line, and not longer than one."""
    text = repr(value) if isinstance(value, (str, int, float, bool)) or value is None else f"a {type(value).__name__}"
    return text if len(text) <= 120 else f"{text[:100]}... ({len(text)} characters)"
