"""The commands of the package, by their names: `roomwright-validate` and its like, and what `scripts/` starts.

Each asks for the modules of its command first, and loads the command only then.
"""

from __future__ import annotations

import ast
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from .environment import BLENDER, CONVERSION, DRAWINGS, TOOLS, Environment, require_for_manual


def validate() -> int:
    return start("validate", TOOLS)


def convert() -> int:
    return start("convert", CONVERSION)


def dxf_to_plan() -> int:
    return start("dxf_to_plan", DRAWINGS)


def cluster() -> int:
    return start("cluster", None)


def blender_import() -> int:
    return start("blender.import_command", BLENDER)


def blender_export() -> int:
    return start("blender.export_command", BLENDER)


def start(name: str, environment: Environment | None) -> int:
    """Runs a module of the package, whose docstring is its manual, with the arguments of this program."""
    module = f"{__package__}.{name}"
    if environment is not None:
        require_for_manual(environment, manual_of(module))
    # Names of files and nodes may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    code: int = import_module(module).main()
    return code


def manual_of(module: str) -> str | None:
    """The docstring of a module that cannot be imported yet."""
    spec = find_spec(module)
    if spec is None or spec.origin is None:
        return None
    return ast.get_docstring(ast.parse(Path(spec.origin).read_text(encoding="utf-8")))
