"""Makes a native plan of DXF drawings by a map of their layers: roomwright-dxf-to-plan PLAN.dxf... --layers MAP.yaml --out PLAN.yaml

The same are `python -m roomwright.dxf_to_plan` and, in the project's folder, `python scripts/dxf_to_plan.py`.

Each drawing is a level of one building, the lowest first. The layer map says by globs which layers hold what:
  - rooms: closed polylines, splines, circles or ellipses around each room
  - room_names: texts in these outlines, those in attributes of blocks among them
  - doors: blocks, or what is drawn of each; an arc is the swing of a leaf
  - windows: blocks, or what is drawn of each
  - walls: where none is drawn between rooms that share an edge, these are open to each other; walls in a room are obstacles
  - columns: closed outlines, which are obstacles
  - railings: outlines and lines, along which rooms have railings instead of walls
Nothing is recognised: without outlines of rooms nothing is read. docs/importing.md has a layer map that works.

--list-layers lists the layers of drawings with what they hold, to write a map from.

Needs the extra `dxf` (scripts/requirements.txt). Faults go to standard error, all of them, with layer, handle and place.
Exit 0: all read. 1: the plan is written without the parts that the errors name. 2: nothing is written.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .environment import DRAWINGS, require

require(DRAWINGS, __name__)

from .dxf.drawing import damaged, layers_of, open_drawing
from .dxf.faults import Report, UnreadableError, lines_of
from .dxf.layer_map import UNITS, LayerMap, read_layer_map
from .dxf.level import Level, read_level
from .dxf.plan_file import plan_text, write_whole
from .resources import printable

# Metres that an edge may be apart from its curve.
CHORD_ERROR = 0.01
CHORD_ERRORS = (0.0005, 1.0)
# Drawings of one building.
MOST_LEVELS = 1_000


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drawings", nargs="+", type=Path, metavar="PLAN.dxf", help="drawings of the levels, lowest first")
    parser.add_argument("--layers", type=Path, metavar="MAP.yaml", help="the layer map")
    parser.add_argument("--out", type=Path, metavar="PLAN.yaml", help="the plan to write (default: standard output)")
    parser.add_argument("--unit", choices=tuple(UNITS), help="unit of the drawings (default: as the layer map, else $INSUNITS says)")
    parser.add_argument("--chord-error", type=metres, default=CHORD_ERROR, metavar="METRES",
                        help=f"how far edges may be from their curves (default: {CHORD_ERROR:g})")
    parser.add_argument("--force", action="store_true", help="overwrite the file of --out")
    parser.add_argument("--list-layers", action="store_true", help="list the layers of the drawings, and write nothing")
    options = parser.parse_args(arguments)
    if options.layers is None and not options.list_layers:
        parser.error("--layers names no layer map; hint: --list-layers lists the layers to write one from")
    if len(options.drawings) > MOST_LEVELS:
        parser.error(f"a building has at most {MOST_LEVELS} levels")
    return options


def metres(text: str) -> float:
    value = float(text)
    if not CHORD_ERRORS[0] <= value <= CHORD_ERRORS[1]:
        raise argparse.ArgumentTypeError(f"{text} is no chord error; hint: metres, from {CHORD_ERRORS[0]:g} to {CHORD_ERRORS[1]:g}")
    return value


def list_layers(drawings: list[Path]) -> None:
    """One line for each layer. Raises UnreadableError."""
    for path in drawings:
        print(printable(f"# {path}"))
        for layer, kinds in sorted(layers_of(open_drawing(path)).items()):
            counts = ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items()))
            print(printable(f"{layer}: {counts}"))


def read_levels(options: argparse.Namespace, layer_map: LayerMap) -> tuple[list[Level], list[Report], list[str]]:
    """The levels that could be read, the reports of all drawings, and why the others could not be read."""
    levels, reports, unreadable = [], [], []
    for path in options.drawings:
        report = Report(str(path))
        reports.append(report)
        try:
            levels.append(read_level(path, layer_map, options.chord_error, report))
        except UnreadableError as error:
            unreadable.append(str(error))
        except Exception as error:  # a damaged drawing can raise anything, and may not hide the faults of the others
            unreadable.append(damaged(path, f"a value in it is not of its kind, {type(error).__name__}: {error}"))
    return levels, reports, unreadable


def say(lines: list[str]) -> None:
    for line in lines:
        print("\n".join(printable(part) for part in line.split("\n")), file=sys.stderr)


def make_plan(options: argparse.Namespace) -> int:
    """Reads everything, then writes the plan. Raises UnreadableError and OSError."""
    if options.out is not None and options.out.exists() and not options.force:
        raise UnreadableError(f"{options.out}: is there already; hint: --force overwrites it")
    if options.out is not None and not options.out.parent.is_dir():
        raise UnreadableError(f"{options.out.parent}: is no folder; hint: make it first")
    layer_map, map_report = read_layer_map(options.layers)
    if map_report.errors:
        say(lines_of([map_report]))
        return 2
    layer_map.unit = options.unit or layer_map.unit
    levels, reports, unreadable = read_levels(options, layer_map)
    say(unreadable + lines_of(reports))
    if unreadable:
        return 2
    text = plan_text(levels, layer_map, options.chord_error)
    if options.out is None:
        sys.stdout.write(text)
    else:
        write_whole(options.out, text)
        rooms, openings = (sum(len(part) for part in parts) for parts in
                           ([level.rooms for level in levels], [level.openings for level in levels]))
        print(printable(f"{options.out}: {len(levels)} levels, {rooms} rooms, {openings} openings"), file=sys.stderr)
    return 1 if any(report.errors for report in reports) else 0


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        if options.list_layers:
            list_layers(options.drawings)
            return 0
        return make_plan(options)
    except UnreadableError as error:
        say([str(error)])
    except OSError as error:
        say([f"dxf_to_plan: {error}"])
    return 2


if __name__ == "__main__":
    # Names of layers may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    sys.exit(main())
