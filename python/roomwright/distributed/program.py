"""Runs the command roomwright."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import NamedTuple

from ..program import ProgramError
from ..program import find_program as find
from .failure import Failure

# The last lines of a failed run that a report repeats.
KEPT_CHARACTERS = 2000

ALL_DONE, SOME_FAILED = 0, 1


class Ran(NamedTuple):
    """How a run ended; `code` is negative if a signal ended it."""

    code: int
    answer: dict
    errors: str


def find_program(named: str | None) -> Path:
    """The program that was named, or the one that this machine has."""
    try:
        return find(named)
    except ProgramError as error:
        raise Failure(f"{error}, or with --program") from error


def run(program: Path, *arguments: str, folder: Path | None = None) -> Ran:
    """Runs a command with --json."""
    done = subprocess.run([str(program), "--json", *arguments], cwd=folder, capture_output=True, text=True)
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        answer = {}
    return Ran(done.returncode, answer, done.stderr[-KEPT_CHARACTERS:])
