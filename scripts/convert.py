#!/usr/bin/env python3
"""Converts baked floors to USD: convert.py [options] FOLDER|FILE...

Each .glb or .gltf becomes one .usdc (or .usda, or .usdz) beside it, or at the same relative place under --out:
  - the same tree of nodes under the default prim, with the same places; names made valid, the original name
    in displayName and in customData;
  - the node's extras as customData (numbers, texts and lists of one kind as such, seeds and the rest as text),
    what it is as UsdSemantics labels;
  - models as instances of assets, which stand once for all floors in `shared-models`; --self-contained keeps them in
    each file, as prototypes;
  - materials as UsdPreviewSurface, with textures that stand once in `shared-textures`;
  - lamps as UsdLux with the same lumens; door leaves with an operation `rotateY:swing` that opens them;
  - material variants and levels of detail, where the file has them, as variant sets `material` and `lod`;
  - kinds: level assembly, room group, everything in it component, and what stands on it subcomponent;
  - metres, Y up (or Z with --up-axis Z).
A folder also gets a `building.usda` for each building, with its floors as payloads at their elevations, and a
`city.usda` of all buildings at their places. A .usdz holds one floor with everything in it, and there are no stages
of them. Equal inputs give equal bytes.

Needs scripts/requirements.txt. Progress goes to standard error, one line per written file to standard output.
Exit 0: all written. 1: some failed. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path
from typing import NamedTuple

import environment

environment.require(environment.TOOLS, __name__)

from pxr import Tf

from gltf_file import GltfError, GltfFile
from progress import Progress
from resources import printable
from usd.assembly import write_assemblies
from usd.floor import Written, convert_floor
from usd.settings import Settings
from usd.writing import WriteError
from workers import outcomes

SCENE_ENDINGS = {".glb", ".gltf"}
# Metres: cups, books and lamps are smaller, seats are not.
SMALL = 0.5


class Job(NamedTuple):
    """One file to convert."""

    source: Path
    target: Path
    settings: Settings
    folder: Path | None = None  # of the command line, that the source was found in


def convert_file(job: Job) -> Written | str:
    """What was written, or what went wrong."""
    try:
        return convert_floor(GltfFile(job.source, job.folder), job.target, job.settings)
    except (GltfError, WriteError) as error:
        return str(error)
    except Exception as error:  # a broken file can raise anything, and may not stop the others
        return (f"a value in it is not of its kind, {type(error).__name__}: {error}; "
                "hint: `python scripts/validate.py` names such places")


def jobs_of(path: Path, options: argparse.Namespace, started: float) -> list[Job]:
    """The files of one argument."""
    if path.is_dir():
        sources, folder = sorted(file for file in path.rglob("*") if file.suffix.lower() in SCENE_ENDINGS), path
    elif path.exists() and path.suffix.lower() in SCENE_ENDINGS:
        sources, folder = [path], None
    else:
        raise FileNotFoundError(f"{path} is no folder, .glb or .gltf")
    base = folder or path.parent
    settings = Settings(
        root=options.out or base, ending=f".{options.format}", up_axis=options.up_axis,
        copies_images=options.out is not None, is_self_contained=options.self_contained,
        has_physics=options.physics, instanced_below=options.point_instancer, started=started)
    return [Job(source, settings.root / source.relative_to(base).with_suffix(settings.ending), settings, folder)
            for source in sources]


def refuse_equal_targets(jobs: list[Job]) -> None:
    """Two sources may not be written into one file."""
    sources: dict[str, Path] = {}
    for job in jobs:
        other = sources.setdefault(os.path.realpath(job.target), job.source)
        if os.path.realpath(other) != os.path.realpath(job.source):
            raise FileExistsError(f"{other} and {job.source} would both become {job.target}")


def convert(jobs: list[Job], processes: int) -> tuple[list[Written], int]:
    """Converts every file; what was written, and how many failed."""
    written, failed, progress = [], 0, Progress("convert", len(jobs))
    for job, outcome in zip(jobs, outcomes(convert_file, jobs, processes)):
        progress.clear()
        if isinstance(outcome, Written):
            written.append(outcome)
            print(printable(str(job.target)))
        else:
            failed += 1
            print(f"convert: {printable(f'{job.source}: {outcome}')}", file=sys.stderr)
        progress.step(not isinstance(outcome, Written))
    return written, failed


def assemble(jobs: list[Job], written: list[Written]) -> int:
    """The stages of buildings and cities of each folder; how many folders failed."""
    failed = 0
    by_file = {floor.file: floor for floor in written}
    for settings in dict.fromkeys(job.settings for job in jobs):
        floors = [by_file[job.target] for job in jobs if job.settings == settings and job.target in by_file]
        try:
            for file in write_assemblies(floors, settings):
                print(printable(str(file)))
        except (WriteError, OSError, Tf.ErrorException) as error:
            failed += 1
            print(f"convert: {printable(f'{settings.root}: {error}')}", file=sys.stderr)
    return failed


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--out", type=Path, help="folder for the results (default: beside each source)")
    parser.add_argument("--format", choices=("usdc", "usda", "usdz"), default="usdc",
                        help="binary, text, or a package of everything that the floor needs")
    parser.add_argument("--up-axis", choices=("Y", "Z"), default="Y")
    parser.add_argument("--self-contained", action="store_true", help="keep models and textures with each floor")
    parser.add_argument("--point-instancer", nargs="?", type=float, const=SMALL, metavar="METRES",
                        help="put what is smaller than this in every direction, and has nothing on it, into one "
                             f"PointInstancer a room (default: {SMALL})")
    parser.add_argument("--physics", action="store_true",
                        help="colliders, bodies with masses, hinges of doors (UsdPhysics); furniture then stands in "
                             "its room, not below what it stands on, because bodies have no bodies in them")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    options = parser.parse_args(arguments)
    if options.physics and options.point_instancer is not None:
        parser.error("--physics and --point-instancer exclude each other: entries of an instancer are no bodies")
    return options


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    # File times may be kept in seconds.
    started = float(int(time.time()))
    try:
        jobs = [job for path in options.paths for job in jobs_of(path, options, started)]
        refuse_equal_targets(jobs)
    except OSError as error:
        print(f"convert: {error}", file=sys.stderr)
        return 2
    if not jobs:
        print("convert: no .glb or .gltf there", file=sys.stderr)
        return 2
    written, failed = convert(jobs, options.jobs)
    folders = {path for path in options.paths if path.is_dir()}
    if folders and options.format != "usdz":
        failed += assemble(jobs, written)
    return 1 if failed else 0


if __name__ == "__main__":
    # Names of files may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(main())
