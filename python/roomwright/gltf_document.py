"""The document of a .glb or .gltf file, bounded in size and depth, and what can be wrong with such a file."""

from __future__ import annotations

import itertools
import json
import struct
from pathlib import Path
from typing import Any

from .resources import ForbiddenError, Reach, ResourceError, read_file, regular_file

GLB_MAGIC = 0x46546C67
GLB_JSON_CHUNK = 0x4E4F534A
GLB_BINARY_CHUNK = 0x004E4942
# Lists and objects in each other: floors have 10, and Python stops at some 1,000.
MOST_NESTING = 64


class GltfError(Exception):
    """A file that cannot be read; the text says why."""


class OutsideError(GltfError):
    """A file that may not be named, or is none: no reader may be sent there."""


class ImageError(GltfError):
    """An image that is not there, or none; the rest of the file is no worse for it."""


def read_document(path: Path, reach: Reach | None) -> tuple[dict[str, Any], bytes | None]:
    """The document of a .glb or .gltf, and the binary chunk of a .glb. Raises GltfError.

    With a reach, the file may not be a link that leads out of it.
    """
    try:
        # A file that somebody names may be a link; one that was found in a folder stays there.
        data = read_file(regular_file(path, reach, "the file"))
        text, binary = _split_glb(data) if path.suffix.lower() == ".glb" else (data, None)
        document = json.loads(text, parse_constant=_no_number)
    except ForbiddenError as error:
        raise OutsideError(str(error)) from error
    except ResourceError as error:
        raise GltfError(str(error)) from error
    except (ValueError, RecursionError, struct.error) as error:
        raise GltfError(f"not a glTF file: {error}") from error
    if not isinstance(document, dict):
        raise GltfError("not a glTF file: the document is no object")
    if nesting(document) > MOST_NESTING:
        raise GltfError(f"not a glTF file: more than {MOST_NESTING} lists and objects are in each other")
    return document, binary


def _no_number(text: str) -> None:
    raise ValueError(f"{text} is no number of JSON")


def nesting(value: object) -> int:
    """How deep lists and objects are in each other, counted up to `MOST_NESTING` and one."""
    depth = 0
    layer: list[Any] = [value]
    while layer and depth <= MOST_NESTING:
        depth += 1
        inner = (part.values() if type(part) is dict else part for part in layer if type(part) in (dict, list))
        layer = list(itertools.chain.from_iterable(inner))
    return depth


def _split_glb(data: bytes) -> tuple[bytes, bytes | None]:
    if len(data) < 12:
        raise ValueError(f"it has {len(data)} bytes, fewer than the header of a .glb")
    magic, version, length = struct.unpack_from("<3I", data)
    if magic != GLB_MAGIC or version != 2:
        raise ValueError("no binary glTF 2.0 header")
    if length != len(data):
        raise ValueError(f"the header says {length} bytes, the file has {len(data)}")
    chunks: dict[int, bytes] = {}
    offset = 12
    while offset < length:
        head = data[offset:offset + 8]
        size, kind = struct.unpack("<2I", head) if len(head) == 8 else (length, 0)
        if offset + 8 + size > length:
            raise ValueError(f"the chunk at byte {offset} reaches past the end of the file")
        chunks.setdefault(kind, data[offset + 8:offset + 8 + size])
        offset += 8 + size
    if GLB_JSON_CHUNK not in chunks:
        raise ValueError("no JSON chunk")
    return chunks[GLB_JSON_CHUNK], chunks.get(GLB_BINARY_CHUNK)
