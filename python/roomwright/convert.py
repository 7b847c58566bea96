"""Converts baked levels to USD, MJCF or URDF: roomwright-convert [options] FOLDER|FILE...

The same are `python -m roomwright.convert` and, in the project's folder, `python scripts/convert.py`.

Each .glb or .gltf becomes one .usdc (or .usda, or .usdz) beside it, or at the same relative place under --out:
  - nodes: the same tree under the default prim, with the same places. Names are made valid; displayName and
    customData keep the original name
  - extras: customData, and attributes `userProperties:`, which Blender reads. Numbers, texts and lists of one kind keep
    their type; seeds and the rest become text. Class, room and building become UsdSemantics labels
  - meshes: one Mesh for each node, with a subset for each material; a material is written once a level
  - models: assets in `shared-models`, once for all levels. --self-contained keeps them in each file, --instances
    marks them as instances
  - materials: UsdPreviewSurface, with textures once for all levels in `shared-textures`
  - lights: UsdLux with the same lumens. Door leaves: an operation `rotateY:swing` that opens them
  - material variants and levels of detail, if the file has them: variant sets `material` and `lod`
  - kinds: a level is an assembly, a room a group, objects in it components, objects on these subcomponents
  - units: metres, Y up (or Z with --up-axis Z)
A folder also gets a `building.usda` for each building, with its levels as payloads at their elevations, and a
`city.usda` of all buildings at their places. A .usdz holds one level with everything that it needs; buildings and the
city are not written for this format. Equal inputs give equal bytes. `converted.json` lists the written files. A later
run removes those that it does not write again (a level that left the bake, another format, unused models), unless
somebody changed them.

--format mjcf and --format urdf write levels for robot simulators instead (docs/simulation.md): a .xml or .urdf for each level,
in metres and kilograms, Z up, and their meshes in `shared-meshes`. Doors hinge or slide, shapes collide as boxes and convex
parts; --movable makes light pieces free bodies. MJCF also gets a `building.xml` for each building of several levels. A folder
must be a finished bake, with its manifest.

Needs the extra `usd` (scripts/requirements.txt). One line per written file goes to standard output, progress to
standard error where that is a terminal.
Exit 0: all written. 1: some failed. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import time
from pathlib import Path
from typing import NamedTuple

from .environment import CONVERSION, require

require(CONVERSION, __name__)

from pxr import Tf
from tqdm import tqdm

from .gltf_document import GltfError
from .gltf_file import GltfFile
from .resources import ResourceError, printable, read_file
from .simulation.bake import check_bake
from .simulation.meshes import MESH_FOLDER
from .simulation.movable import LIGHT
from .simulation.writing import FORMATS, convert_level, write_buildings
from .usd.assembly import write_assemblies
from .usd.floor import Written, convert_floor
from .usd.record import Asked, Entry, Removal, digest_of, path_from, renew
from .usd.settings import MODEL_FOLDER, TEXTURE_FOLDER, Settings
from .usd.writing import WriteError
from .workers import outcomes

SCENE_ENDINGS = {".glb", ".gltf"}
# Metres: cups, books and lamps are smaller, seats are not.
SMALL = 0.5
# The folders of files that levels share.
SHARED = (f"{MODEL_FOLDER}/", f"{TEXTURE_FOLDER}/", f"{MESH_FOLDER}/")
ENDINGS = {"usdc": ".usdc", "usda": ".usda", "usdz": ".usdz", "mjcf": ".xml", "urdf": ".urdf"}
# The options that say how USD files are written, as they are typed.
USD_OPTIONS = ("--up-axis", "--self-contained", "--lights", "--instances", "--point-instancer", "--physics")


class Job(NamedTuple):
    """One file to convert."""

    source: Path
    target: Path
    settings: Settings
    folder: Path | None = None  # of the command line, that the source was found in


def convert_file(job: Job) -> Written | str:
    """The written files, or the reason of a failure."""
    convert_one = convert_level if job.settings.ending in FORMATS else convert_floor
    try:
        return convert_one(GltfFile(job.source, job.folder), job.target, job.settings)
    except (GltfError, WriteError) as error:
        return str(error)
    except Exception as error:  # a broken file can raise anything, and may not stop the others
        return (f"a value in it is not of its kind, {type(error).__name__}: {error}; "
                "hint: validate.py names such places")


def jobs_of(path: Path, options: argparse.Namespace, started: float) -> list[Job]:
    """The files of one argument."""
    if path.is_dir():
        if ENDINGS[options.format] in FORMATS:
            check_bake(path)
        former = former_files(path)
        sources = sorted(file for file in path.rglob("*") if file.suffix.lower() in SCENE_ENDINGS and file not in former)
        folder = path
    elif path.exists() and path.suffix.lower() in SCENE_ENDINGS:
        sources, folder = [path], None
    else:
        raise FileNotFoundError(f"{path} is neither a folder nor a .glb or .gltf")
    base = folder or path.parent
    settings = Settings(
        root=options.out or base, ending=ENDINGS[options.format], up_axis=options.up_axis, started=started,
        copies_images=options.out is not None, is_self_contained=options.self_contained, has_physics=options.physics,
        lights_lamps=options.lights, has_instances=options.instances, instanced_below=options.point_instancer,
        movable_up_to=options.movable)
    return [Job(source, settings.root / source.relative_to(base).with_suffix(settings.ending), settings, folder)
            for source in sources]


def former_files(folder: Path) -> set[Path]:
    """The floors that manifests list apart, because no plan has their levels any more."""
    former = set()
    for manifest in sorted(folder.rglob("manifest.json")):
        try:
            levels = json.loads(read_file(manifest)).get("former_levels", [])
            former |= {manifest.parent / file["path"] for level in levels for file in level["files"]}
        except (ResourceError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
            continue  # `validate.py` says what is wrong with it
    gone = sorted(file for file in former if file.suffix.lower() in SCENE_ENDINGS and file.exists())
    for file in gone:
        print(f"convert: {printable(str(file))} is skipped: no plan has its level any more", file=sys.stderr)
    return former


def refuse_equal_targets(jobs: list[Job]) -> None:
    """Two sources may not be written into one file."""
    sources: dict[str, Path] = {}
    for job in jobs:
        other = sources.setdefault(os.path.realpath(job.target), job.source)
        if os.path.realpath(other) != os.path.realpath(job.source):
            raise FileExistsError(f"{other} and {job.source} would both become {job.target}")


def convert(jobs: list[Job], processes: int, is_quiet: bool) -> dict[Job, Written]:
    """Converts every file. Returns the written files of the jobs that succeeded."""
    written = {}
    # Without `disable`, tqdm would write into logs, too.
    with tqdm(total=len(jobs), desc="convert", unit=" files", disable=is_quiet or None) as progress:
        for job, outcome in zip(jobs, outcomes(convert_file, jobs, processes)):
            if isinstance(outcome, Written):
                written[job] = outcome
                tqdm.write(printable(str(job.target)))
            else:
                tqdm.write(f"convert: {printable(f'{job.source}: {outcome}')}", file=sys.stderr)
            progress.update()
    return written


def finish(jobs: list[Job], written: dict[Job, Written], folders: list[Path]) -> int:
    """The stages and the record of one output folder; 1 if that failed.

    `folders` are those of the command line.
    """
    settings = jobs[0].settings
    try:
        stages = []
        if folders and settings.ending != ".usdz":
            write_stages = write_buildings if settings.ending in FORMATS else write_assemblies
            stages = write_stages([written[job] for job in jobs if job in written], settings)
        for file in stages:
            print(printable(str(file)))
        around = Path(os.path.commonpath([os.path.abspath(folder) for folder in folders])) if folders else None
        report(renew(settings.root, entries_of(written, stages, around, settings), asked_of(jobs, written, folders)))
    except (WriteError, OSError, Tf.ErrorException) as error:
        print(f"convert: {printable(f'{settings.root}: {error}')}", file=sys.stderr)
        return 1
    return 0


def entries_of(written: dict[Job, Written], stages: list[Path], around: Path | None, settings: Settings) -> list[Entry]:
    """Everything that a run wrote, each with its source."""
    sources: dict[Path, Path | None] = {stage: around for stage in stages}
    for job, floor in written.items():
        sources |= {file: job.source if settings.is_self_contained else None for file in floor.shared}
        sources[floor.file] = job.source
    return [Entry(path_from(settings.root, file), digest_of(file), source and path_from(settings.root, source))
            for file, source in sources.items()]


def asked_of(jobs: list[Job], written: dict[Job, Written], folders: list[Path]) -> Asked:
    root = jobs[0].settings.root
    alone = [job.source for job in jobs if job.folder is None]
    failed = frozenset(path_from(root, job.source) for job in jobs if job not in written)
    return Asked(tuple(path_from(root, path) for path in [*folders, *alone]), failed)


def report(removal: Removal) -> None:
    """Reports the removed files by name, and the removed models, meshes and images, which are many, by their count."""
    shared = [path for path in removal.removed if path.startswith(SHARED)]
    for path in removal.removed:
        if path not in shared:
            print(f"convert: removed {printable(path)}, which an earlier run wrote and this one does not",
                  file=sys.stderr)
    if shared:
        print(f"convert: removed {len(shared)} models, meshes and images that nothing uses any more", file=sys.stderr)
    for path in removal.kept:
        print(f"convert: left {printable(path)}, which no run writes any more", file=sys.stderr)


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--out", type=Path, help="folder for the results (default: beside each source)")
    parser.add_argument("--format", choices=tuple(ENDINGS), default="usdc",
                        help="USD: binary, text, or a package of everything that the floor needs; for simulators: MJCF or "
                             "URDF")
    parser.add_argument("--movable", nargs="?", type=kilograms, const=LIGHT, metavar="KILOGRAMS",
                        help="MJCF and URDF: make pieces that stand free and weigh no more than this free bodies (default: "
                             f"{LIGHT:g})")
    parser.add_argument("--up-axis", choices=("Y", "Z"), default="Y")
    parser.add_argument("--self-contained", action="store_true", help="keep models and textures in each level's file")
    parser.add_argument("--lights", action="store_true",
                        help="add lights to the lamps of levels that were baked without lights (`bake --lights physical` "
                             "bakes lights)")
    parser.add_argument("--instances", action="store_true",
                        help="mark models as instanceable: renderers then keep each model once, and Blender imports each "
                             "as an empty and a collection")
    parser.add_argument("--point-instancer", nargs="?", type=float, const=SMALL, metavar="METRES",
                        help="put objects that are smaller than this in every direction, and carry nothing, into one "
                             f"PointInstancer for each room (default: {SMALL})")
    parser.add_argument("--physics", action="store_true",
                        help="add colliders, bodies with masses and hinges of doors (UsdPhysics). All furniture is then "
                             "a child of its room, because a body may not contain another body")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    options = parser.parse_args(arguments)
    refuse_foreign_options(parser, options)
    if options.physics and options.point_instancer is not None:
        parser.error("--physics and --point-instancer exclude each other: entries of an instancer cannot be bodies")
    return options


def kilograms(text: str) -> float:
    value = float(text)
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is no mass; hint: kilograms over 0, such as {LIGHT:g}")
    return value


def refuse_foreign_options(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Options of one family of formats mean nothing to the other."""
    if ENDINGS[options.format] not in FORMATS:
        if options.movable is not None:
            parser.error(f"--movable is for --format mjcf and urdf, not {options.format}; hint: --physics describes USD")
        return
    for option in USD_OPTIONS:
        key = option.removeprefix("--").replace("-", "_")
        if getattr(options, key) != parser.get_default(key):
            parser.error(f"{option} is for USD, not {options.format}, which is Z up and has joints and masses by itself")


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
        print("convert: there is no .glb or .gltf", file=sys.stderr)
        return 2
    written = convert(jobs, options.jobs, options.quiet)
    failed = len(jobs) - len(written)
    for settings in dict.fromkeys(job.settings for job in jobs):
        own = [job for job in jobs if job.settings == settings]
        folders = list(dict.fromkeys(job.folder for job in own if job.folder is not None))
        failed += finish(own, {job: written[job] for job in own if job in written}, folders)
    return 1 if failed else 0


if __name__ == "__main__":
    # Names of files may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(main())
