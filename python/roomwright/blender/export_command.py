"""Writes a level that was edited in Blender as a file that roomwright reads: `roomwright audit` judges it.

  python scripts/blender_export.py house.blend --level house/ground --out edited.glb
  blender --background --python scripts/blender_export.py -- house.blend --level house/ground --out edited.glb

The first line needs Blender's Python module: scripts/requirements-render.txt, or the extra `blender` of the package,
whose command is `roomwright-blender-export`. Exit 0: written. 1: the export failed, nothing is written. 2: nothing could
start.

In Blender's window the same is File > Export > Roomwright floor, after scripts/pack_blender_extension.py has made the
extension and Edit > Preferences > Get Extensions > Install from Disk has installed it.
"""

import argparse
import sys
from pathlib import Path

from ..environment import BLENDER, require
from .command_line import check_target, own_arguments, quiet_blender

require(BLENDER, __name__)


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("blend", type=Path, metavar="FILE.blend", help="a saved file with the level in its scene")
    parser.add_argument("--level", metavar="BUILDING/LEVEL", help="needed where there are several")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.glb", help="where to write")
    parser.add_argument("--force", action="store_true", help="replace a file that is there")
    options = parser.parse_args(arguments)
    check_target(parser, "--out", options.out, ".glb", options.force)
    return options


def main(arguments: list[str] | None = None) -> int:
    typed = parse(own_arguments() if arguments is None else arguments)
    if not typed.blend.is_file():
        print(f"{typed.blend}: no such file", file=sys.stderr)
        return 2
    # Arguments are judged before Blender's module is loaded, which takes seconds.
    import bpy

    from .extension.errors import ExportError
    from .extension.exporting import export_level

    try:
        typed.out.parent.mkdir(parents=True, exist_ok=True)
        with quiet_blender():
            bpy.ops.wm.open_mainfile(filepath=str(typed.blend.absolute()))
            notes = export_level(typed.out, typed.level)
    except (ExportError, RuntimeError, OSError) as error:
        print(f"{typed.blend}: {error}", file=sys.stderr)
        return 1
    for note in notes:
        print(note, file=sys.stderr)
    print(typed.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
