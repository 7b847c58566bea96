"""Validates baked levels and the USD files of convert.py: roomwright-validate [options] FOLDER|FILE...

The same are `python -m roomwright.validate` and, in the project's folder, `python scripts/validate.py`.

For every .glb and .gltf:
  file         the file can be read, and its buffers exist
  path         the file names only files of its own folder, of the FOLDER that it was found in and of the shared folders
               beside its own; by relative paths, without a link that leads out; no pipe or device
  texture      the images exist
  names        every node has a name of its own
  extras       the extras of every node are as configs/schema/extras.schema.json says; names, parents and counts agree
  geometry     each object's mesh fills its `size`, is closed, has no empty faces and no wrong normals
  containment  each object lies inside its room and outside of the room's columns and stairs
  collision    no object overlaps another, measured on the triangles
  shell        no wall, column, frame or leaf reaches more than 1 cm into a room, a doorway or furniture, and walls stand at
               the edges of the floors
  stairs       the steps of a flight are equally high, at most 21 cm, up to its `height`, and without gaps; none lies within
               60 cm of a door; 2 m above each are open; steps and handrails are not inside out
  trimesh      trimesh loads the file with the same count of instances and the same bounds
  khronos      the Khronos validator reports no error and no warning
A .glb of a tileset, or one without extras that names its pieces by features, is judged by `file`, `path`, `texture`, `khronos` and
  features     numbers of corners and instances are rows of a table, and the table is as EXT_structural_metadata says
For every tileset.json:
  tiles        it and those that it leads to are as 3D Tiles 1.1 says; boxes lie in the box of the tile above and hold what is
               drawn in them, errors fall from tile to tile, each URI leads to a file of the folder, and each file is used
For every .usd, .usda, .usdc and .usdz:
  file         the file opens, and the files that it names exist
  path         the file names no absolute path, nothing outside of the FOLDER that it was found in, and no pipe or device
  texture      the images of the materials exist
  usd          the validators of USD report nothing
For every manifest.json:
  manifest     it is as configs/schema/manifest.schema.json says, each listed file exists with its size and hash, and no
               other level is in the folder
  stairs       in a building of several levels, each flight ends at a floor of the level above, which is open over it; in the
               floors are no other holes, none within 60 cm of a door, and none without a balustrade

Needs the extra `validate` (scripts/requirements.txt), and for `khronos` also Node and `npm ci` in roomwright/khronos/.
Faults go to standard output as FILE: [CODE] NODE: MESSAGE (or as one JSON document with --json), progress to
standard error where that is a terminal. Exit 0: no fault. 1: faults. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from .environment import IS_PROJECT, TOOLS, require

require(TOOLS, __name__)

import numpy as np
from tqdm import tqdm

from .checks.contract import PATH, check_extras, check_names, check_paths, note_of
from .checks.features import check_features, is_tile
from .checks.geometry import check_collisions, check_containment, check_pieces
from .checks.khronos import FOLDER as KHRONOS_FOLDER
from .checks.khronos import check_khronos, is_installed
from .checks.loading import check_trimesh
from .checks.manifest import SCENE_ENDINGS, STAGE_ENDINGS, check_manifest, scenes_in
from .checks.report import Fault, Note
from .checks.schemas import FOLDER as SCHEMA_FOLDER
from .checks.shell import check_shell
from .checks.stairs import check_stairs
from .checks.storeys import check_storeys
from .checks.tileset import NAME as TILESET_NAME
from .checks.tileset import check_tileset, tilesets_in
from .gltf_document import GltfError
from .gltf_file import GltfFile
from .workers import outcomes

CHECKS = (check_names, check_extras, check_pieces, check_containment, check_collisions, check_shell, check_stairs)


class Input(NamedTuple):
    """A file to judge, and the folder of the command line that it was found in."""

    file: Path
    folder: Path | None = None


def check_file(file: Path, folder: Path | None = None) -> tuple[list[Fault], Counter]:
    """Every check of one file but the Khronos validator's, with counts for the report."""
    if file.suffix.lower() in STAGE_ENDINGS:
        # USD takes two fifths of the time in which this program starts, in every process, and floors need none of it.
        from .checks.stages import check_stage

        return check_stage(file, folder)
    counts = Counter({"floors": 1, "nodes": 0, "rooms": 0, "furniture": 0})
    notes: list[Note] = []
    # Places that are no numbers are faults, not lines on standard error.
    np.seterr(all="ignore")
    try:
        gltf = GltfFile(file, folder)
        notes += check_paths(gltf)
        kinds = Counter(node.kind for node in gltf.nodes)
        counts.update(nodes=len(gltf.nodes), rooms=kinds["room"], furniture=kinds["furniture"])
        # Other readers are not sent after what a floor may not name, nor do they know tiles.
        readers = () if any(note.code == PATH for note in notes) else (check_trimesh,)
        for check in (check_features,) if is_tile(gltf) else (*CHECKS, *readers):
            notes += guarded(check, gltf)
    except Exception as error:
        notes.append(stopped(error))
    return [Fault(str(file), *note) for note in dict.fromkeys(notes)], counts


def guarded(check: Callable, gltf: GltfFile) -> Iterator[Note]:
    """The findings of a check, up to where nonsense in the file stops it."""
    try:
        yield from check(gltf)
    except Exception as error:
        yield stopped(error)


def stopped(error: Exception) -> Note:
    """The exception that ended a check, as a fault: a broken file can make other libraries raise anything."""
    if isinstance(error, GltfError):
        return note_of(error)
    return Note("file", "", f"a value in it is not of its kind, {type(error).__name__}: {error}; "
                            "hint: the faults of the Khronos validator name such places")


def check_input(judged: Input) -> tuple[list[Fault], Counter]:
    return check_file(*judged)


def check_files(inputs: list[Input], jobs: int, with_khronos: bool, is_quiet: bool) -> tuple[list[Fault], Counter]:
    faults: list[Fault] = []
    totals: Counter = Counter()
    # Without `disable`, tqdm would write into logs, too.
    with tqdm(total=len(inputs), desc="validate", unit=" files", disable=is_quiet or None) as progress:
        for judged, outcome in zip(inputs, outcomes(check_input, inputs, jobs)):
            if isinstance(outcome, Exception):
                outcome = [Fault(str(judged.file), PATH, "", str(outcome))], Counter()
            found, counts = outcome
            faults += found
            totals.update(counts)
            progress.set_postfix(faults=len(faults), refresh=False)
            progress.update()
    if with_khronos:
        unsafe = {fault.file for fault in faults if fault.code == PATH}
        floors = [judged.file for judged in inputs
                  if judged.file.suffix.lower() in SCENE_ENDINGS and str(judged.file) not in unsafe]
        shares = [floors[start::jobs] for start in range(min(jobs, len(floors)))]
        for share, outcome in zip(shares, outcomes(check_khronos, shares, jobs) if shares else ()):
            faults += [Fault(str(share[0]), "khronos", "", str(outcome))] if isinstance(outcome, Exception) else outcome
    return faults, totals


def find_inputs(paths: list[Path]) -> tuple[list[Input], list[Path], list[Path]]:
    """The files to judge, the manifests and the tilesets that the arguments name."""
    files, manifests, tilesets = [], [], []
    for path in paths:
        if path.is_dir():
            files += [Input(file, path) for file in scenes_in(path)]
            files += [Input(file, path) for file in sorted(path.rglob("*")) if file.suffix.lower() in STAGE_ENDINGS]
            manifests += sorted(path.rglob("manifest.json"))
            tilesets += tilesets_in(path)
        elif not path.exists():
            raise FileNotFoundError(f"{path} is not there")
        elif path.suffix.lower() in SCENE_ENDINGS | STAGE_ENDINGS:
            files.append(Input(path))
        elif path.name == TILESET_NAME:
            tilesets.append(path)
        elif path.name.endswith(".json"):
            manifests.append(path)
        else:
            raise FileNotFoundError(f"{path} is neither a folder nor a .glb, .gltf, USD file, manifest or tileset")
    return files, manifests, tilesets


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--no-khronos", action="store_true", help="skip the Khronos validator")
    parser.add_argument("--json", action="store_true", help="write one JSON document instead of lines")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        files, manifests, tilesets = find_inputs(options.paths)
    except OSError as error:
        print(f"validate: {error}", file=sys.stderr)
        return 2
    if not files and not manifests and not tilesets:
        print("validate: there is no manifest and no .glb, .gltf or USD file", file=sys.stderr)
        return 2
    if not SCHEMA_FOLDER.is_dir():
        print(f"validate: {SCHEMA_FOLDER} is missing; hint: install the package again, or run the script in the project's folder",
              file=sys.stderr)
        return 2
    with_khronos = not options.no_khronos and any(judged.file.suffix.lower() in SCENE_ENDINGS for judged in files)
    if with_khronos and not is_installed():
        place, line = ((", in bash, in the project's folder", "source scripts/set_up.sh && set_up_validator") if IS_PROJECT
                       else ("", f"npm ci --prefix '{KHRONOS_FOLDER}'"))
        print(f"validate: the Khronos validator is not set up. With Node 20 or newer, run{place}:\n"
              f"  {line}\n"
              "or skip it with --no-khronos", file=sys.stderr)
        return 2
    faults, totals = check_files(files, max(1, options.jobs), with_khronos, options.quiet)
    faults += chain.from_iterable(map(check_manifest, manifests))
    faults += chain.from_iterable(check_storeys(manifest, max(1, options.jobs)) for manifest in manifests)
    faults += chain.from_iterable(check_tileset(tileset, max(1, options.jobs)) for tileset in tilesets)
    faults.sort()
    report(options.json, {"files": len(files), "manifests": len(manifests), "tilesets": len(tilesets), **totals}, faults)
    return 1 if faults else 0


def report(as_json: bool, counts: dict[str, int], faults: list[Fault]) -> None:
    if as_json:
        print(json.dumps({**counts, "faults": [fault._asdict() for fault in faults]}, indent=1))
        return
    for fault in faults:
        print(fault)
    print(", ".join(f"{count} {name}" for name, count in counts.items()) + f": {len(faults)} faults")


if __name__ == "__main__":
    # Names of files and nodes may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(main())
