"""Runs the command roomwright."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

from .failure import Failure

ROOT = Path(__file__).resolve().parents[2]
# The last lines of a failed run that a report repeats.
KEPT_CHARACTERS = 2000

ALL_DONE, SOME_FAILED = 0, 1


class Ran(NamedTuple):
    """How a run ended; `code` is negative if a signal ended it."""

    code: int
    answer: dict
    errors: str


def find_program(named: str | None) -> Path:
    """The program that was named, that of the variable ROOMWRIGHT_PROGRAM, that of the PATH, or the one built here."""
    candidates = [named, os.environ.get("ROOMWRIGHT_PROGRAM"), shutil.which("roomwright"),
                  str(ROOT / "target" / "release" / "roomwright")]
    for candidate in candidates:
        if candidate and Path(candidate).is_file():
            return Path(candidate).resolve()
    raise Failure("there is no program roomwright: run `cargo install --path .`, or name it with --program")


def run(program: Path, *arguments: str, folder: Path | None = None) -> Ran:
    """Runs a command with --json."""
    done = subprocess.run([str(program), "--json", *arguments], cwd=folder, capture_output=True, text=True)
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        answer = {}
    return Ran(done.returncode, answer, done.stderr[-KEPT_CHARACTERS:])
