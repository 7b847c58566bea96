"""Which source file uses which: by `use` lines and paths that begin with `crate`, `super` or `self`.

A name that a file only hands on (`pub use`) is the business of the file that defines it. Tests are left out: they may use
anything.
"""

from __future__ import annotations

import re
from pathlib import Path

USE = re.compile(r"(pub(?:\([^)]*\))?\s+)?use\s+([^;]+);")
PATH = re.compile(r"\b(?:crate|super)(?:::\w+)+")
TESTS = re.compile(r"#\[cfg\(test\)\]\s*(?:pub(?:\([^)]*\))?\s+)?mod \w+ \{")


def expand(tree: str) -> list[str]:
    """The paths of a use tree: `a::{b, c::{d, e}}` names three."""
    head, brace, inner = tree.strip().partition("{")
    if not brace:
        return [head.split(" as ")[0].strip()]
    parts, depth, start = [], 0, 0
    inner = inner.rsplit("}", 1)[0] + ","
    for index, letter in enumerate(inner):
        depth += (letter == "{") - (letter == "}")
        if letter == "," and depth == 0:
            parts.append(inner[start:index])
            start = index + 1
    return [head.strip() + path for part in parts if part.strip() for path in expand(part)]


class SourceGraph:
    """The files of a source folder by module path, and what each uses."""

    def __init__(self, root: Path):
        self.files = {self._module(root, path): path for path in sorted(root.rglob("*.rs"))}
        self.texts = {module: self._without_tests(path) for module, path in self.files.items()}
        self.handed_on = {module: self._paths_of(module, is_public=True) for module in self.files}
        self.uses = {module: self._used_by(module) for module in self.files}

    @staticmethod
    def _module(root: Path, path: Path) -> tuple[str, ...]:
        parts = path.relative_to(root).with_suffix("").parts
        return parts[:-1] if parts[-1] in ("mod", "lib", "main") else parts

    @staticmethod
    def _without_tests(path: Path) -> str:
        text = re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
        found = TESTS.search(text)
        return text[: found.start()] if found else text

    def _absolute(self, module: tuple[str, ...], path: str) -> tuple[str, ...]:
        parts, at = path.split("::"), module
        if parts[0] == "crate":
            return tuple(parts[1:])
        while parts and parts[0] in ("super", "self"):
            at = at[:-1] if parts[0] == "super" else at
            parts = parts[1:]
        return at + tuple(parts)

    def _paths_of(self, module: tuple[str, ...], is_public: bool) -> list[tuple[str, ...]]:
        trees = [tree for public, tree in USE.findall(self.texts[module]) if bool(public) == is_public]
        return [self._absolute(module, path) for tree in trees for path in expand(tree)]

    def _defining(self, path: tuple[str, ...], seen: frozenset = frozenset()) -> tuple[str, ...] | None:
        """The file that defines a name, past those that hand it on."""
        for length in range(len(path), -1, -1):
            module, rest = path[:length], path[length:]
            if module not in self.files:
                continue
            for handed in self.handed_on[module] if rest else []:
                if handed[-1:] == rest[:1] and handed[:-1] != module and (module, rest[0]) not in seen:
                    return self._defining(handed + rest[1:], seen | {(module, rest[0])})
            return module
        return None

    def _used_by(self, module: tuple[str, ...]) -> set[tuple[str, ...]]:
        paths = self._paths_of(module, is_public=False)
        code = USE.sub("", self.texts[module])
        paths += [self._absolute(module, path) for path in PATH.findall(code)]
        found = {self._defining(path) for path in paths}
        return {other for other in found if other and other != module}

    def circles(self, folder: tuple[str, ...]) -> list[list[str]]:
        """The files of a folder that use themselves through others, each group sorted."""
        inside = {module for module in self.files if module[: len(folder)] == folder}
        reached = {module: self._reached(module, inside) for module in inside}
        groups = {
            frozenset(other for other in reached[module] if module in reached[other])
            for module in inside
            if module in reached[module]
        }
        return sorted(sorted("::".join(module) for module in group) for group in groups)

    def _reached(self, start: tuple[str, ...], inside: set) -> set:
        found, waiting = set(), [start]
        while waiting:
            for other in self.uses[waiting.pop()] & inside - found:
                found.add(other)
                waiting.append(other)
        return found
