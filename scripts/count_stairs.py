#!/usr/bin/env python3
"""Counts the stairs of baked levels by what leads up in them: count_stairs.py DIR

Prints a Markdown table: rooms of stairs with steps up, with the end of steps from below, and without either. Levels of
buildings that have no other level are left out. Exit 0: all levels were read. 1: some were not; standard error has the
reasons. 2: there is no level.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

import in_project

from roomwright.gltf_document import GltfError
from roomwright.gltf_file import GltfFile

ROOM_TYPE = "stairs"
PART = "stairs"
# Metres from floor to floor from which on a part is steps; balustrades are lower.
LEAST_RISE = 0.99


def kinds(path: Path) -> Counter[str]:
    """How many rooms of stairs of a level are of each kind."""
    found: Counter[str] = Counter()
    nodes = GltfFile(path).nodes
    parts = {node.parent.index: node for node in nodes if node.parent is not None and node.extras.get("part") == PART}
    for room in nodes:
        if room.kind == "room" and room.extras["type"] == ROOM_TYPE:
            part = parts.get(room.index)
            rises = part is not None and part.extras["height"] > LEAST_RISE
            found["with steps up" if rises else "without" if part is None else "where steps end"] += 1
    return found


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, metavar="DIR", help="what roomwright baked")
    folder = parser.parse_args(arguments).folder
    levels = sorted(folder.rglob("*.glb"))
    if not levels:
        print("count_stairs: no floors there", file=sys.stderr)
        return 2
    in_building = Counter(path.parent for path in levels)
    found: Counter[str] = Counter()
    is_whole = True
    for path in levels:
        if in_building[path.parent] < 2:
            continue
        try:
            found += kinds(path)
        except GltfError as error:
            print(f"{path}: {error}", file=sys.stderr)
            is_whole = False
    print("| stairs | rooms | share |\n|---|---|---|")
    for kind, count in found.most_common():
        print(f"| {kind} | {count:,} | {count / found.total():.1%} |")
    return 0 if is_whole else 1


if __name__ == "__main__":
    sys.exit(main())
