"""Documents of .glb and .gltf files, read and written without their meaning."""

import json
import struct
from pathlib import Path

from .errors import BakeError

MAGIC, JSON_CHUNK, BINARY_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942
# Bytes of the file's header and of the first chunk's header, before the document's text.
HEAD = 20


def read_document(path: Path) -> dict:
    """The document of a .glb or .gltf, without its buffers. Raises BakeError."""
    try:
        document = json.loads(_read_text(path))
    except OSError as error:
        raise BakeError(f"{path}: cannot be read: {error.strerror}") from error
    except (ValueError, struct.error) as error:
        raise BakeError(f"{path}: is no glTF file, or is damaged: {error}") from error
    if not isinstance(document, dict) or "asset" not in document:
        raise BakeError(f"{path}: is no glTF file")
    return document


def _read_text(path: Path) -> bytes:
    with path.open("rb") as file:
        head = file.read(HEAD)
        if head[:4] != b"glTF":
            return head + file.read()
        if len(head) < HEAD:
            raise ValueError("it is cut off")
        return file.read(_text_length(head))


def _text_length(data: bytes) -> int:
    return struct.unpack("<I", data[12:16])[0]


def binary_chunk(data: bytes) -> memoryview:
    """The bytes of a .glb's second chunk."""
    return memoryview(data)[HEAD + _text_length(data) + 8:]


def write_glb(path: Path, document: dict, binary: bytes) -> None:
    """Writes a .glb of a document and the bytes of its first buffer."""
    binary += b"\0" * (-len(binary) % 4)
    _write(path, json.dumps(document), struct.pack("<2I", len(binary), BINARY_CHUNK) + binary if binary else b"")


def rewrite_document(path: Path, change) -> None:
    """Lets `change` modify the document of a .glb; its other chunks stay as they are."""
    data = path.read_bytes()
    end = HEAD + _text_length(data)
    document = json.loads(data[HEAD:end])
    change(document)
    _write(path, json.dumps(document, separators=(",", ":")), data[end:])


def _write(path: Path, document: str, chunks: bytes) -> None:
    text = document.encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<5I", MAGIC, 2, HEAD + len(text) + len(chunks), len(text), JSON_CHUNK)
    path.write_bytes(head + text + chunks)
