"""Checks that Python has the modules of a command before the command imports them.

If modules are missing in the project's folder, the command goes on in the project's environment, or names the line that sets
this environment up; an installed package names the extra that it lacks. Old Pythons must be able to read this file and what
comes before it.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
# Only the project's folder has this file, at this place.
IS_PROJECT = (ROOT / "scripts" / "set_up.sh").is_file()
LEAST_PYTHON = (3, 11)


class Environment(NamedTuple):
    """A folder with Python and modules in the project's folder, and the extra that installs the same beside the package."""

    folder: str
    modules: tuple[str, ...]
    command: str
    extra: str = ""


TOOLS = Environment(".venv", ("numpy", "shapely", "trimesh", "pxr", "tqdm", "jsonschema", "PIL"),
                    "source scripts/set_up.sh && set_up_python", "validate")
CONVERSION = TOOLS._replace(modules=("numpy", "shapely", "pxr", "tqdm", "jsonschema", "PIL"), extra="usd")
DRAWINGS = TOOLS._replace(modules=("numpy", "shapely", "ezdxf", "yaml"), extra="dxf")
PLANS = TOOLS._replace(modules=("numpy", "shapely", "tqdm", "yaml"))
PICTURES = Environment(".venv-render", ("numpy", "bpy", "PIL"),
                       "python3.11 -m venv .venv-render && "
                       ".venv-render/bin/pip install -r scripts/requirements-render.txt", "blender")
BLENDER = PICTURES._replace(modules=("bpy",))


def require(environment: Environment, name: str) -> None:
    """Ends the program with exit code 2 where modules are missing; does nothing for what is imported, by its `name`."""
    if name == "__main__":
        require_for_manual(environment, sys.modules["__main__"].__doc__)


def require_for_manual(environment: Environment, manual: str | None) -> None:
    """The same, for a program with this manual, which it prints without its modules."""
    lacks = missing(environment)
    if not lacks:
        return
    if {"-h", "--help"} & set(sys.argv[1:]) and manual:
        print(manual)
        sys.exit(0)
    if IS_PROJECT:
        go_on_in_project(environment)
    print(how_to_set_up(environment, lacks), file=sys.stderr)
    sys.exit(2)


def go_on_in_project(environment: Environment) -> None:
    """Becomes the same program in the project's environment, where that is set up."""
    own = ROOT / environment.folder
    python = own / "bin" / "python"
    if not python.is_file() or Path(sys.prefix).resolve() == own.resolve():
        return
    module = getattr(sys.modules["__main__"], "__spec__", None)
    started = [sys.argv[0]] if module is None else ["-m", module.name]
    os.execv(python, [str(python), *started, *sys.argv[1:]])


def missing(environment: Environment) -> list[str]:
    """The modules that this Python lacks, and the version that it should have."""
    modules = [module for module in environment.modules if importlib.util.find_spec(module) is None]
    return modules if sys.version_info >= LEAST_PYTHON else ["Python {}.{}".format(*LEAST_PYTHON), *modules]


def how_to_set_up(environment: Environment, lacks: list[str]) -> str:
    script = Path(sys.argv[0]).name
    fact = f"{script}: this Python, {sys.executable}, has no {', '.join(lacks)}. "
    if not IS_PROJECT:
        return f"{fact}To install them:\n  {sys.executable} -m pip install \"roomwright[{environment.extra}]\""
    return (f"{fact}In the project's folder, in bash:\n"
            f"  {environment.command}\n"
            f"  {environment.folder}/bin/python scripts/{script} ...")
