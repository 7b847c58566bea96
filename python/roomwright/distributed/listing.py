"""The levels of a job, as `bake --list-levels` lists them, and the lists that its units are baked from."""

from __future__ import annotations

import hashlib
import json
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from .failure import Failure
from .inputs import Inputs
from .program import ALL_DONE, SOME_FAILED, run
from .store import Store

# Lists that are on their way to the store at the same time.
UPLOADS = 16


def room_count(levels: list[dict]) -> int:
    return sum(sum(level["rooms"].values()) for level in levels)


@dataclass(frozen=True)
class Division:
    """The levels of a job, and those of each unit."""

    listed: dict
    units: list[range]

    @cached_property
    def documents(self) -> dict[str, bytes]:
        """A document for each unit and one for all levels, by name."""
        def document(levels: list[dict]) -> bytes:
            return json.dumps({"program": self.listed["program"], "levels": levels}).encode()

        levels = self.listed["levels"]
        units = {f"{number}.json": document(levels[unit.start:unit.stop]) for number, unit in enumerate(self.units, 1)}
        return {**units, "levels.json": document(levels)}

    @property
    def sha256(self) -> str:
        digest = hashlib.sha256()
        for name, content in self.documents.items():
            digest.update(f"{name} {len(content)}\n".encode() + content)
        return digest.hexdigest()[:16]

    def put(self, store: Store, folder: str) -> None:
        with ThreadPoolExecutor(UPLOADS) as pool:
            list(pool.map(lambda item: store.write(f"{folder}/{item[0]}", item[1]), self.documents.items()))


def list_levels(program: Path, arguments: list[str], folder: Path | None = None) -> dict:
    """The levels of plans; faults of the plans are shown."""
    ran = run(program, "bake", *arguments, "--list-levels", folder=folder)
    if ran.code not in (ALL_DONE, SOME_FAILED) or not ran.answer.get("levels"):
        raise Failure(f"the levels of the plans could not be listed:\n{ran.errors}")
    if ran.errors and folder is None:
        print(ran.errors, file=sys.stderr, end="")
    return ran.answer


def check_packed(program: Path, listed: dict, inputs: Inputs, options: list[str], folder: Path) -> None:
    """Whether the plans as they are packed are those that the command line names: nothing that they refer to is missing."""
    packed = list_levels(program, [*inputs.arguments, *options], folder)
    if packed["levels"] != listed["levels"]:
        raise Failure("the plans refer to files that were not packed; name these files or their folder with --including")
