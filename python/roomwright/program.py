"""Finds the program `roomwright` and runs it."""

from __future__ import annotations

import os
import shutil
import sysconfig
from pathlib import Path

from .environment import ROOT

VARIABLE = "ROOMWRIGHT_PROGRAM"
NAME = "roomwright.exe" if os.name == "nt" else "roomwright"


class ProgramError(Exception):
    """The program is not there, or ended with an error; the text is the program's own."""

    def __init__(self, message: str, code: int | None = None):
        super().__init__(message)
        self.code = code  # how the program ended; None if it is not there


def find_program(named: str | os.PathLike[str] | None = None) -> Path:
    """The program that was named, else the first of these: beside this package, ROOMWRIGHT_PROGRAM, on the PATH, built here.

    Raises ProgramError.
    """
    candidates = [named] if named else [
        *(Path(folder, NAME) for folder in script_folders()), os.environ.get(VARIABLE), shutil.which("roomwright"),
        ROOT / "target" / "release" / NAME]
    for candidate in candidates:
        if candidate and Path(candidate).is_file():
            return Path(candidate).resolve()
    if named:
        raise ProgramError(f"{named} is no program; hint: name the file of the command roomwright")
    raise ProgramError("there is no program roomwright; hint: install the package with its wheel, run `cargo install --locked --path .` in "
                       f"the project's folder, or name the program in {VARIABLE}")


def script_folders() -> list[str]:
    """Where pip puts the programs of packages: in this environment, and in the user's own folder."""
    schemes = [sysconfig.get_default_scheme(), sysconfig.get_preferred_scheme("user")]
    return [sysconfig.get_path("scripts", scheme) for scheme in schemes]
