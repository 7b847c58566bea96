"""The check that a folder is a finished bake, before anything is written."""

from __future__ import annotations

import json
from pathlib import Path

from ..resources import ResourceError, read_file, shown

MANIFEST = "manifest.json"


def check_bake(folder: Path) -> None:
    """Raises FileNotFoundError, with the place and a hint, for a folder without a manifest or without its levels."""
    manifest = folder / MANIFEST
    if not manifest.is_file():
        raise FileNotFoundError(f"{folder} is no bake: it has no {MANIFEST}; "
                                f"hint: `roomwright bake PLANS --out {folder}` writes one")
    for path in level_files(manifest):
        if not (folder / path).is_file():
            raise FileNotFoundError(f"{manifest} lists {shown(path)}, which is not there; hint: bake again")


def level_files(manifest: Path) -> list[str]:
    """The paths of the levels' files."""
    try:
        levels = json.loads(read_file(manifest))["levels"]
        return [file["path"] for level in levels for file in level["files"] if isinstance(file["path"], str)]
    except ResourceError as error:
        raise FileNotFoundError(f"{manifest}: {error}") from error
    except (ValueError, LookupError, TypeError, RecursionError) as error:
        raise FileNotFoundError(f"{manifest} is no manifest: {type(error).__name__}: {error}; hint: bake again") from error
