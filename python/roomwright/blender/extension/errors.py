"""Faults that the user can mend; each text names the file or the level, and the reason."""

import struct
from contextlib import contextmanager
from pathlib import Path

# Exceptions of code that trusts a document, if the document is damaged.
DAMAGE = (KeyError, IndexError, TypeError, ValueError, AttributeError, StopIteration, struct.error, OSError)


class BakeError(Exception):
    """A file that cannot be imported."""


class ExportError(Exception):
    """A level that cannot be exported."""


@contextmanager
def damage_of(path: Path):
    """Turns an exception that a damaged file causes into a BakeError with the file's name."""
    try:
        yield
    except DAMAGE as error:
        raise BakeError(f"{path}: cannot be read: {error!r}") from error
