#!/usr/bin/env python3
"""Counts the nodes, draw calls and triangles of baked levels: count_draw_calls.py DIR [--before DIR]

Prints a Markdown table with a row for each level and a row of sums. A draw call is a primitive of a node. Further columns
are drawn triangles, lights, images, and megabytes of the file. With --before, the figure of the level of the same name in
another folder follows each figure. Exit 0: all levels were read. 1: some were not; standard error has the reasons. 2: there
is no level.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import astuple, dataclass, fields
from pathlib import Path

import in_project

from roomwright.gltf_document import GltfError
from roomwright.gltf_file import GltfFile

HEADINGS = ("floor", "nodes", "draw calls", "triangles", "lights", "images", "MB")
LIGHTS = "KHR_lights_punctual"


@dataclass(frozen=True)
class Load:
    """The work of a viewer for one level."""

    nodes: int = 0
    draw_calls: int = 0
    triangles: int = 0
    lights: int = 0
    images: int = 0
    bytes: int = 0

    def __add__(self, other: Load) -> Load:
        return Load(*(one + another for one, another in zip(astuple(self), astuple(other))))

    def cells(self) -> list[str]:
        counts = [f"{getattr(self, field.name):,}" for field in fields(self)[:-1]]
        return [*counts, f"{self.bytes / 1e6:.1f}"]


def load_of(path: Path) -> Load:
    """Counts of one file. Raises GltfError."""
    gltf = GltfFile(path)
    sizes = {mesh: [triangle_count(gltf, one) for one in gltf.entry("meshes", mesh)["primitives"]]
             for mesh in {node.mesh for node in gltf.nodes if node.mesh is not None}}
    shown = [sizes[node.mesh] for node in gltf.nodes if node.mesh is not None]
    lights = [node for node in gltf.nodes if LIGHTS in gltf.entry("nodes", node.index).get("extensions", {})]
    return Load(len(gltf.nodes), sum(map(len, shown)), sum(map(sum, shown)), len(lights),
                len(gltf.document.get("images", [])), path.stat().st_size)


def triangle_count(gltf: GltfFile, primitive: dict) -> int:
    corners = primitive.get("indices", primitive["attributes"]["POSITION"])
    return gltf.entry("accessors", corners)["count"] // 3


def loads_of(folder: Path) -> tuple[dict[str, Load], list[str]]:
    """Floors of a folder by their names, and what is wrong with the others."""
    found, faults = {}, []
    for path in sorted(folder.rglob("*.glb")):
        try:
            found[path.relative_to(folder).with_suffix("").as_posix()] = load_of(path)
        except GltfError as error:
            faults.append(f"{path}: {error}")
    return found, faults


def table(after: dict[str, Load], before: dict[str, Load] | None) -> list[str]:
    """The lines of the table; floors that only one folder has are left out of a comparison."""
    names = [name for name in after if before is None or name in before]
    rows = [(name, after[name], before and before[name]) for name in names]
    total = sum((after[name] for name in names), Load())
    rows.append(("all", total, before and sum((before[name] for name in names), Load())))
    lines = [HEADINGS, ["---"] * len(HEADINGS)]
    for name, now, was in rows:
        pairs = zip(now.cells(), was.cells() if was else now.cells())
        lines.append([name, *(f"{old} → {new}" if was else new for new, old in pairs)])
    return [f"| {' | '.join(line)} |" for line in lines]


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, metavar="DIR", help="what roomwright baked")
    parser.add_argument("--before", type=Path, metavar="DIR", help="another bake of the same floors")
    options = parser.parse_args(arguments)
    after, faults = loads_of(options.folder)
    before, older_faults = loads_of(options.before) if options.before else (None, [])
    print("\n".join(faults + older_faults), file=sys.stderr, end="\n" if faults or older_faults else "")
    if not after or before == {}:
        print("count_draw_calls: no floors there", file=sys.stderr)
        return 2
    print("\n".join(table(after, before)))
    return int(bool(faults or older_faults))


if __name__ == "__main__":
    sys.exit(main())
