"""`blender_export.py`: from its arguments to a written floor."""

import argparse
import sys
from pathlib import Path

from .command_line import check_target, own_arguments, quiet_blender


def parse(arguments: list[str], manual: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=manual, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("blend", type=Path, metavar="FILE.blend", help="a saved file with the level in its scene")
    parser.add_argument("--level", metavar="BUILDING/LEVEL", help="needed where there are several")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.glb", help="where to write")
    parser.add_argument("--force", action="store_true", help="replace a file that is there")
    options = parser.parse_args(arguments)
    check_target(parser, "--out", options.out, ".glb", options.force)
    return options


def main(arguments: list[str] | None = None, manual: str = "") -> int:
    typed = parse(own_arguments() if arguments is None else arguments, manual)
    if not typed.blend.is_file():
        print(f"{typed.blend}: no such file", file=sys.stderr)
        return 2
    # Arguments are judged before Blender's module is loaded, which takes seconds.
    import bpy

    from .roomwright.errors import ExportError
    from .roomwright.exporting import export_level

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
