"""Valid and unique names of prims and files."""

from __future__ import annotations

from pxr import Tf

# Characters of a file's name before its hash: file systems take 255 bytes.
LONGEST_NAME = 120


class Names:
    """Valid names, unique among the children of one prim."""

    def __init__(self, taken: set[str] | None = None):
        self.taken = set(taken or ())

    def take(self, original: str) -> str:
        base = valid_name(original)
        name, number = base, 2
        while name in self.taken:
            name, number = f"{base}_{number}", number + 1
        self.taken.add(name)
        return name


def valid_name(original: str) -> str:
    return Tf.MakeValidIdentifier(original) if original else "unnamed"


def coordinate_name(number: int) -> str:
    """The primvar of a set of texture coordinates: the usual name for the first, numbered for the others."""
    return f"st{number or ''}"
