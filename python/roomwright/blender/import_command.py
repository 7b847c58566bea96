"""Opens baked floors in Blender, sorted into collections, and saves them: a floor, a building or a whole bake.

  python scripts/blender_import.py BAKE... --save building.blend [--levels PATTERN] [--no-ceilings] [--asset-catalog]
  blender --background --python scripts/blender_import.py -- BAKE... --save building.blend

BAKE is a .glb or .gltf, a building's folder, or a bake with its manifest.json. The first line needs Blender's Python
module: scripts/requirements-render.txt, or the extra `blender` of the package, whose command is `roomwright-blender-import`.
Exit 0: saved. 1: a floor or the saving failed, nothing is written. 2: nothing could start.

In Blender's window the same is File > Import > Roomwright bake, after scripts/pack_blender_extension.py has made the
extension and Edit > Preferences > Get Extensions > Install from Disk has installed it.
"""

import argparse
import sys
import time
from contextlib import contextmanager
from pathlib import Path

from ..environment import BLENDER, require
from .command_line import check_target, own_arguments, quiet_blender

require(BLENDER, __name__)


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bakes", nargs="+", type=Path, metavar="BAKE", help="a file or a folder of baked floors")
    parser.add_argument("--save", type=Path, required=True, metavar="FILE.blend", help="where to save")
    parser.add_argument("--levels", action="append", default=[], metavar="PATTERN",
                        help="these only, as LEVEL, BUILDING/LEVEL or BUILDING, * for any; may be repeated")
    parser.add_argument("--no-ceilings", action="store_true", help="import ceilings hidden")
    parser.add_argument("--no-place", action="store_true", help="all levels at the origin")
    parser.add_argument("--asset-catalog", action="store_true",
                        help="furniture as assets, with blender_assets.cats.txt beside the saved file")
    parser.add_argument("--force", action="store_true", help="replace a file that is there")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    options = parser.parse_args(arguments)
    check_target(parser, "--save", options.save, ".blend", options.force)
    return options


def main(arguments: list[str] | None = None) -> int:
    typed = parse(own_arguments() if arguments is None else arguments)
    # Arguments are judged before Blender's module is loaded, which takes seconds.
    from .extension.errors import BakeError
    from .extension.floors import find_floors

    try:
        find_floors(typed.bakes, typed.levels)
        typed.save.parent.mkdir(parents=True, exist_ok=True)
    except (BakeError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    try:
        with quiet_blender():
            report = import_and_save(typed)
    except (BakeError, RuntimeError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    print(report)
    return 0


def import_and_save(typed: argparse.Namespace) -> str:
    """Imports into an empty file and saves it; a line about what is in it."""
    import bpy

    from .extension.assets import write_catalog
    from .extension.importing import import_bake
    from .extension.options import Options
    from .extension.whole_file import whole_file

    options = Options(tuple(typed.levels), not typed.no_ceilings, not typed.no_place, typed.asset_catalog)
    target = typed.save.absolute()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    times = [time.monotonic()]
    with progress_bar(typed.quiet) as progress:
        done = import_bake(typed.bakes, options, progress)
    times.append(time.monotonic())
    with whole_file(target) as partial:
        bpy.ops.wm.save_as_mainfile(filepath=str(partial), compress=True, copy=True)
    times.append(time.monotonic())
    if options.assets:
        write_catalog(target.parent)
    return (f"{typed.save}: {done.object_count} objects, {len(done.datablocks.meshes)} meshes, "
            f"{len(done.datablocks.materials)} materials; imported in {times[1] - times[0]:.1f} s, "
            f"saved in {times[2] - times[1]:.1f} s")


@contextmanager
def progress_bar(is_quiet: bool):
    """A function for import_bake that moves a bar on standard error, where that is a terminal."""
    try:
        from tqdm import tqdm
    except ImportError:  # in Blender's own Python
        yield lambda *_: None
        return
    with tqdm(desc="import", unit=" steps", disable=is_quiet or None) as bar:
        def progress(_step: int, steps: int, text: str) -> None:
            bar.total = steps
            bar.set_postfix_str(text, refresh=False)
            bar.update()

        yield progress


if __name__ == "__main__":
    sys.exit(main())
