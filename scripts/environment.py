"""Checks that Python has the modules of a script before the script imports them.

If modules are missing, the script goes on in the project's environment, or names the command that sets this environment up.
Old Pythons must be able to read this file and the first lines of the scripts.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
LEAST_PYTHON = (3, 11)


class Environment(NamedTuple):
    """A folder with Python and modules in the project's folder."""

    folder: str
    modules: tuple[str, ...]
    command: str


TOOLS = Environment(".venv", ("numpy", "shapely", "trimesh", "pxr", "tqdm", "jsonschema", "PIL"),
                    "source scripts/set_up.sh && set_up_python")
PLANS = TOOLS._replace(modules=("numpy", "shapely", "tqdm", "yaml"))
PICTURES = Environment(".venv-render", ("numpy", "bpy", "PIL"),
                       "python3.11 -m venv .venv-render && "
                       ".venv-render/bin/pip install -r scripts/requirements-render.txt")
BLENDER = PICTURES._replace(modules=("bpy",))


def require(environment: Environment, name: str) -> None:
    """Ends the program with exit code 2 where modules are missing; does nothing for what is imported, by its `name`."""
    lacks = missing(environment)
    if name != "__main__" or not lacks:
        return
    manual = sys.modules["__main__"].__doc__
    if {"-h", "--help"} & set(sys.argv[1:]) and manual:
        print(manual)
        sys.exit(0)
    own = ROOT / environment.folder
    python = own / "bin" / "python"
    if python.is_file() and Path(sys.prefix).resolve() != own.resolve():
        os.execv(python, [str(python), *sys.argv])
    print(how_to_set_up(environment, lacks), file=sys.stderr)
    sys.exit(2)


def missing(environment: Environment) -> list[str]:
    """The modules that this Python lacks, and the version that it should have."""
    modules = [module for module in environment.modules if importlib.util.find_spec(module) is None]
    return modules if sys.version_info >= LEAST_PYTHON else ["Python {}.{}".format(*LEAST_PYTHON), *modules]


def how_to_set_up(environment: Environment, lacks: list[str]) -> str:
    script = Path(sys.argv[0]).name
    return (f"{script}: this Python, {sys.executable}, has no {', '.join(lacks)}. In the project's folder, in bash:\n"
            f"  {environment.command}\n"
            f"  {environment.folder}/bin/python scripts/{script} ...")
