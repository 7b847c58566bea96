"""Runs `roomwright bake`."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterable

from .bakes import Bake
from .program import ProgramError, find_program

PathLike = str | os.PathLike[str]
Option = str | int | float | bool | os.PathLike[str] | None


def bake(plans: PathLike | Iterable[PathLike], out: PathLike, *, seed: int | None = None, style: str | None = None,
         program: PathLike | None = None, **options: Option | Iterable[Option]) -> Bake:
    """Furnishes plans, writes their levels into the folder `out`, and opens them.

    `options` are those of `roomwright bake`, with `_` for `-`: `textures="none"` is `--textures none`, `shared_library=True` is
    `--shared-library`, and a list repeats an option. None and False leave it out.

    Raises ProgramError with the program's own message and exit code: 1 if some levels failed and the others are written
    (`Bake.open` reads them), 2 if nothing was.
    """
    paths = [plans] if isinstance(plans, (str, os.PathLike)) else list(plans)
    named = {"seed": seed, "style": style, "out": out, **options}
    typed = [word for name, value in named.items() for word in words_of(name, value)]
    # After `--`, no plan is taken for an option.
    command = [str(find_program(program)), "bake", "--progress", "none", *typed, "--", *(os.fspath(path) for path in paths)]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="backslashreplace")
    if done.returncode != 0:
        raise ProgramError(done.stderr.strip() or f"{command[0]} ended with {done.returncode} and no message", done.returncode)
    return Bake.open(out, done.stderr.strip())


def words_of(name: str, value: Option | Iterable[Option]) -> list[str]:
    """An option as it is typed."""
    flag = f"--{name.replace('_', '-')}"
    if value is None or value is False:
        return []
    if value is True:
        return [flag]
    if isinstance(value, (str, int, float, os.PathLike)):
        # In one word, so that a negative number is no option.
        return [f"{flag}={os.fspath(value) if isinstance(value, os.PathLike) else value}"]
    return [word for part in value for word in words_of(name, part)]
