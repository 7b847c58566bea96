"""Scripts and the Python package are files that a newcomer can read one after the other: short, and without circles of imports."""

from __future__ import annotations

import ast
from pathlib import Path

from conftest import ROOT

# What imports are relative to.
FOLDERS = (ROOT / "scripts", ROOT / "python")
FILES = sorted(path for folder in FOLDERS for path in folder.rglob("*.py") if "node_modules" not in path.parts)
MOST_LINES = 300


def place_of(path: Path) -> Path:
    return next(path.relative_to(folder) for folder in FOLDERS if path.is_relative_to(folder))


def module_of(path: Path) -> tuple[str, ...]:
    parts = place_of(path).with_suffix("").parts
    return parts[:-1] if parts[-1] == "__init__" else parts


def imports_of(path: Path) -> set[tuple[str, ...]]:
    """The files of both folders that a file imports when it is imported itself."""
    package = place_of(path).parent.parts
    found = set()
    for statement in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(statement, ast.Import):
            found |= {tuple(alias.name.split(".")) for alias in statement.names}
        elif isinstance(statement, ast.ImportFrom):
            above = package[:len(package) - statement.level + 1] if statement.level else ()
            base = (*above, *(statement.module or "").split(".")) if statement.module else above
            found |= {base} | {(*base, alias.name) for alias in statement.names}
    return found & {module_of(file) for file in FILES}


def test_scripts_are_short():
    lines = {path.relative_to(ROOT).as_posix(): len(path.read_text(encoding="utf-8").splitlines()) for path in FILES}
    assert {name: count for name, count in lines.items() if count > MOST_LINES} == {}


def test_no_script_imports_itself_through_others():
    graph = {module_of(path): imports_of(path) - {module_of(path)} for path in FILES}
    assert len(graph) > 60 and graph["render",] >= {("roomwright", "gltf_file"), ("pictures", "cameras")}
    assert graph["roomwright", "gltf_file"] >= {("roomwright", "gltf_document")}
    while leaves := [module for module, used in graph.items() if not used & graph.keys()]:
        for module in leaves:
            del graph[module]
    assert graph == {}
