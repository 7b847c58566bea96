#!/usr/bin/env python3
"""Validates baked floors and what convert.py made of them: validate.py [options] FOLDER|FILE...

For every .glb and .gltf:
  file         it is read, buffers are there, no path in it is absolute
  texture      its images are there
  names        every node has a name, and no two have the same
  extras       every node says what it is, with every field that its kind has; parents and counts agree
  geometry     each piece's mesh fills its box as `size` says, is closed, has no empty faces and no wrong normals
  containment  each piece lies inside its room and outside of its columns
  collision    no piece is inside another, measured on the triangles
  trimesh      trimesh loads it, with as many instances and the same bounds as the file itself says
  khronos      the Khronos validator reports no error and no warning
For every .usd, .usda, .usdc and .usdz:
  file         it opens, what it names is there, no path in it is absolute
  texture      the images of its materials are there
  usd          the validators that come with USD report nothing
For every manifest.json: each file listed is there with its bytes and hash, and no other floor lies beside it.

Needs scripts/requirements.txt, and for `khronos` also `npm ci` in scripts/.
Faults go to standard output as FILE: [CODE] NODE: MESSAGE (or as one JSON document with --json), progress to
standard error. Exit 0: no fault. 1: faults. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from itertools import chain
from pathlib import Path

from checks.contract import check_extras, check_names, check_paths
from checks.geometry import check_collisions, check_containment, check_pieces
from checks.khronos import check_khronos, is_installed
from checks.loading import check_trimesh
from checks.manifest import SCENE_ENDINGS, check_manifest, scenes_in
from checks.report import Fault, Note
from checks.stages import ENDINGS as STAGE_ENDINGS
from checks.stages import check_stage
from gltf_file import GltfError, GltfFile
from progress import Progress

CHECKS = (check_paths, check_names, check_extras, check_pieces, check_containment, check_collisions, check_trimesh)


def check_file(file: Path) -> tuple[list[Fault], Counter]:
    """Every check of one file but the Khronos validator's, with counts for the report."""
    if file.suffix.lower() in STAGE_ENDINGS:
        return check_stage(file)
    counts = Counter({"floors": 1, "nodes": 0, "rooms": 0, "furniture": 0})
    try:
        gltf = GltfFile(file)
        kinds = Counter(node.kind for node in gltf.nodes)
        counts.update(nodes=len(gltf.nodes), rooms=kinds["room"], furniture=kinds["furniture"])
        notes = list(chain.from_iterable(check(gltf) for check in CHECKS))
    except GltfError as error:
        notes = [Note("file", "", str(error))]
    except Exception as error:  # what a broken file can raise in other people's readers has no end
        notes = [Note("file", "", f"{type(error).__name__}: {error}")]
    return [Fault(str(file), *note) for note in notes], counts


def check_files(files: list[Path], jobs: int, with_khronos: bool) -> tuple[list[Fault], Counter]:
    faults: list[Fault] = []
    totals: Counter = Counter()
    progress = Progress("validate", len(files))
    floors = [file for file in files if file.suffix.lower() in SCENE_ENDINGS]
    with ProcessPoolExecutor(max_workers=max(1, min(jobs, len(files)))) as pool:
        shares = [floors[start::jobs] for start in range(min(jobs, len(floors)))] if with_khronos else []
        validators = [pool.submit(check_khronos, share) for share in shares]
        for found, counts in pool.map(check_file, files):
            faults += found
            totals.update(counts)
            progress.step(len(found))
        faults += chain.from_iterable(validator.result() for validator in validators)
    return faults, totals


def find_inputs(paths: list[Path]) -> tuple[list[Path], list[Path]]:
    """The files to judge and the manifests that the arguments name."""
    files, manifests = [], []
    for path in paths:
        if path.is_dir():
            files += scenes_in(path)
            files += sorted(file for file in path.rglob("*") if file.suffix.lower() in STAGE_ENDINGS)
            manifests += sorted(path.rglob("manifest.json"))
        elif not path.is_file():
            raise FileNotFoundError(f"{path} is not there")
        elif path.suffix.lower() in SCENE_ENDINGS | STAGE_ENDINGS:
            files.append(path)
        elif path.name.endswith(".json"):
            manifests.append(path)
        else:
            raise FileNotFoundError(f"{path} is no folder, .glb, .gltf, USD file or manifest")
    return files, manifests


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--no-khronos", action="store_true", help="leave the Khronos validator out")
    parser.add_argument("--json", action="store_true", help="write one JSON document instead of lines")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        files, manifests = find_inputs(options.paths)
    except OSError as error:
        print(f"validate: {error}", file=sys.stderr)
        return 2
    if not files:
        print("validate: no .glb, .gltf or USD file there", file=sys.stderr)
        return 2
    with_khronos = not options.no_khronos and any(file.suffix.lower() in SCENE_ENDINGS for file in files)
    if with_khronos and not is_installed():
        print("validate: the Khronos validator needs node and `npm ci` in scripts/ (or --no-khronos)", file=sys.stderr)
        return 2
    faults, totals = check_files(files, max(1, options.jobs), with_khronos)
    faults += chain.from_iterable(map(check_manifest, manifests))
    faults.sort()
    report(options.json, {"files": len(files), "manifests": len(manifests), **totals}, faults)
    return 1 if faults else 0


def report(as_json: bool, counts: dict[str, int], faults: list[Fault]) -> None:
    if as_json:
        print(json.dumps({**counts, "faults": [fault._asdict() for fault in faults]}, indent=1))
        return
    for fault in faults:
        print(fault)
    print(", ".join(f"{count} {name}" for name, count in counts.items()) + f": {len(faults)} faults")


if __name__ == "__main__":
    sys.exit(main())
