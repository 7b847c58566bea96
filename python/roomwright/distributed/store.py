"""Where results go: a folder, or a store of objects that fsspec names (s3://, gs://, az://).

Stores answer some requests with an error, and a machine may die during any of them. So every request is repeated, and every
file that was written is compared with what the store says of it: its length and, where the store knows it, its MD5. Two writers
of one name write the same bytes, so that the order does not matter.
"""

from __future__ import annotations

import base64
import hashlib
import os
import random
import re
import secrets
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, TypeVar

from .failure import Failure

Answer = TypeVar("Answer")

# One request in twenty may fail: that all of so many do happens once in 10^10 requests.
ATTEMPTS = 8
# Seconds before the second attempt; each further pause is twice as long, up to the longest.
FIRST_PAUSE = 0.2
LONGEST_PAUSE = 10.0


class Known(NamedTuple):
    """What is known of a file's content; a store may not know the MD5."""

    size: int
    md5: str | None

    def is_content_of(self, other: Known) -> bool:
        """Whether both may be the same content."""
        return self.size == other.size and (None in (self.md5, other.md5) or self.md5 == other.md5)


class Found(NamedTuple):
    """A file of the store."""

    name: str
    size: int
    written: float


def repeated(action: Callable[[], Answer]) -> Answer:
    """The answer of a request that may fail for a while."""
    for attempt in range(1, ATTEMPTS + 1):
        try:
            return action()
        except FileNotFoundError:
            raise
        # Each library of a store has errors of its own.
        except Exception as error:
            if attempt == ATTEMPTS:
                raise Failure(f"the store failed {ATTEMPTS} times: {type(error).__name__}: {error}") from error
            # Machines that failed together do not come back together.
            time.sleep(min(LONGEST_PAUSE, FIRST_PAUSE * 2 ** (attempt - 1)) * random.uniform(0.5, 1.5))
    raise AssertionError("the last attempt returns or raises")


class Store:
    """Files by names with `/`; the requests that a kind of store must answer are at the end."""

    def read(self, name: str) -> bytes | None:
        """The content of a file; None if there is none."""
        try:
            return repeated(lambda: self._read(name))
        except FileNotFoundError:
            return None

    def has(self, name: str) -> bool:
        """Whether there is a file."""
        return self._known_of(name) is not None

    def holds(self, path: Path, name: str) -> bool:
        """Whether a file is there with the content of one of this machine."""
        found = self._known_of(name)
        return found is not None and found.is_content_of(self._expected(path))

    def write(self, name: str, content: bytes) -> None:
        """Writes a file, whole or not at all."""
        expected = Known(len(content), hashlib.md5(content, usedforsecurity=False).hexdigest() if self.knows_md5 else None)
        repeated(lambda: self._checked(name, expected, lambda: self._write(name, content)))

    def put(self, path: Path, name: str) -> None:
        """Writes a file of this machine."""
        expected = self._expected(path)
        repeated(lambda: self._checked(name, expected, lambda: self._put(path, name)))

    def take(self, path: Path, name: str) -> None:
        """Writes a file of this machine that nobody changes or reads after it: the store may keep it instead of a copy."""
        expected = self._expected(path)
        repeated(lambda: self._checked(name, expected, lambda: self._take(path, name)))

    def create(self, name: str, content: bytes) -> bytes:
        """Writes a file unless there is one. The content that is there afterwards: this, or that of another writer."""
        def once() -> bytes:
            try:
                self._create(name, content)
            except FileExistsError:
                pass
            return self._read(name)
        return repeated(once)

    def list(self, folder: str) -> list[Found]:
        """The files in a folder, by name."""
        try:
            return sorted(repeated(lambda: self._list(folder)))
        except FileNotFoundError:
            return []

    # Whether the store says the MD5 of files.
    knows_md5 = False

    def _take(self, path: Path, name: str) -> None:
        self._put(path, name)

    def _known_of(self, name: str) -> Known | None:
        try:
            return repeated(lambda: self._known(name))
        except FileNotFoundError:
            return None

    def _expected(self, path: Path) -> Known:
        return Known(path.stat().st_size, digest(path, "md5") if self.knows_md5 else None)

    def _checked(self, name: str, expected: Known, action: Callable[[], None]) -> None:
        action()
        try:
            found = self._known(name)
        except FileNotFoundError as error:
            # Not the answer to a question: what was just written has to be there.
            raise OSError(f"{name} is not in the store after it was sent") from error
        if found.is_content_of(expected):
            return
        # Tags of objects that the store encrypts by a key of its owner look like an MD5 and are none: the content decides.
        if found.size == expected.size and hashlib.md5(self._read(name), usedforsecurity=False).hexdigest() == expected.md5:
            self.knows_md5 = False
            return
        raise OSError(f"{name} arrived damaged in the store: {found} instead of {expected}")


class Folder(Store):
    """A folder that all machines see, or the only machine."""

    def __init__(self, root: Path):
        self.root = root

    def _path(self, name: str) -> Path:
        return self.root / name

    def _read(self, name: str) -> bytes:
        return self._path(name).read_bytes()

    def _known(self, name: str) -> Known:
        return Known(self._path(name).stat().st_size, None)

    def _temporary(self, name: str) -> Path:
        path = self._path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        return path.with_name(f".{path.name[:100]}.{secrets.token_hex(8)}")

    def _write(self, name: str, content: bytes) -> None:
        temporary = self._temporary(name)
        temporary.write_bytes(content)
        os.replace(temporary, self._path(name))

    def _put(self, path: Path, name: str) -> None:
        temporary = self._temporary(name)
        with path.open("rb") as source, temporary.open("wb") as target:
            while block := source.read(1 << 20):
                target.write(block)
        os.replace(temporary, self._path(name))

    def _take(self, path: Path, name: str) -> None:
        temporary = self._temporary(name)
        try:
            os.link(path, temporary)
        except OSError:
            # Another disk, or one without links.
            return self._put(path, name)
        os.replace(temporary, self._path(name))
        # Two names of one file: to rename one to the other does nothing.
        temporary.unlink(missing_ok=True)

    def _create(self, name: str, content: bytes) -> None:
        temporary = self._temporary(name)
        temporary.write_bytes(content)
        try:
            # A link is made only where nothing is; to replace would take another writer's place.
            os.link(temporary, self._path(name))
        finally:
            temporary.unlink()

    def _list(self, folder: str) -> list[Found]:
        found = []
        for entry in os.scandir(self._path(folder)):
            if entry.is_file() and not entry.name.startswith("."):
                status = entry.stat()
                found.append(Found(f"{folder}/{entry.name}", status.st_size, status.st_mtime))
        return found


class Objects(Store):
    """A store that fsspec reads and writes."""

    knows_md5 = True

    def __init__(self, url: str):
        try:
            import fsspec
            self.system, self.root = fsspec.core.url_to_fs(url.rstrip("/"))
        except (ImportError, ValueError) as error:
            raise Failure(f"{url} needs a module that is not there ({error}):\n"
                          "  python -m pip install -r scripts/requirements-cluster.txt, or 'roomwright[cluster]'") from error
        # Listings that are kept would hide what other machines wrote.
        self.system.use_listings_cache = False

    def _path(self, name: str) -> str:
        return f"{self.root}/{name}"

    def _fresh(self) -> None:
        self.system.invalidate_cache()

    def _read(self, name: str) -> bytes:
        return self.system.cat_file(self._path(name))

    def _known(self, name: str) -> Known:
        self._fresh()
        said = self.system.info(self._path(name))
        return Known(said["size"], said_md5(said))

    def _write(self, name: str, content: bytes) -> None:
        self.system.pipe_file(self._path(name), content)

    def _put(self, path: Path, name: str) -> None:
        self.system.put_file(str(path), self._path(name))

    def _create(self, name: str, content: bytes) -> None:
        self.system.pipe_file(self._path(name), content, mode="create")

    def _list(self, folder: str) -> list[Found]:
        self._fresh()
        found = []
        for entry in self.system.ls(self._path(folder), detail=True):
            if entry["type"] == "file":
                written = entry.get("LastModified") or entry.get("updated") or entry.get("mtime") or 0.0
                seconds = written.timestamp() if hasattr(written, "timestamp") else float(written)
                found.append(Found(f"{folder}/{entry['name'].rsplit('/', 1)[-1]}", entry["size"], seconds))
        return found


def digest(path: Path, algorithm: str) -> str:
    """The hash of a file, which may be larger than the memory."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, lambda: hashlib.new(algorithm, usedforsecurity=False)).hexdigest()


def said_md5(said: dict) -> str | None:
    """The MD5 of an object, if the store says it: Google's `md5Hash`, Azure's `content_md5`, or the `ETag` of S3.

    An ETag is the MD5 of objects that were sent in one piece; the tags of others have a hyphen.
    """
    if encoded := said.get("md5Hash") or (said.get("content_settings") or {}).get("content_md5"):
        return base64.b64decode(encoded).hex() if isinstance(encoded, str) else bytes(encoded).hex()
    tag = str(said.get("ETag", "")).strip('"')
    return tag if re.fullmatch("[0-9a-f]{32}", tag) else None


def open_store(url: str) -> Store:
    """The store of a URL, or a folder."""
    if "://" not in url or url.startswith("file://"):
        return Folder(Path(url.removeprefix("file://")).resolve())
    return Objects(url)
