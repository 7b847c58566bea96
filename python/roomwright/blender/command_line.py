"""Shared by the commands that run in Blender or in a Python with Blender's module."""

import os
import sys
from contextlib import contextmanager
from pathlib import Path


def own_arguments() -> list[str]:
    """The arguments after the script's name; under `blender --python SCRIPT -- ...` those after the `--`."""
    return sys.argv[sys.argv.index("--") + 1 if "--" in sys.argv else 1:]


def check_target(parser, option: str, path: Path, ending: str, is_forced: bool) -> None:
    """Ends the program with exit code 2 for a file of another kind, or one that may not be replaced."""
    if path.suffix != ending:
        parser.error(f"{option} {path}: the name must end in {ending}")
    if path.exists() and not is_forced:
        parser.error(f"{path} is there already; --force replaces it")


@contextmanager
def quiet_blender():
    """Keeps Blender's own lines off standard output; Blender writes them past Python."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
