"""Faults of files."""

from __future__ import annotations

from typing import NamedTuple

from ..resources import printable


class Fault(NamedTuple):
    """One thing that is wrong; sorts by file."""

    file: str
    code: str
    node: str
    message: str

    def __str__(self) -> str:
        return printable(f"{self.file}: [{self.code}] {self.node + ': ' if self.node else ''}{self.message}")


class Note(NamedTuple):
    """A fault before it has a file."""

    code: str
    node: str
    message: str
