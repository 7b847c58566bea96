#!/usr/bin/env python3
"""Renders all models of a geometry set on one sheet: contact_sheet.py PROGRAM SET OUT.jpg [--looks N]

PROGRAM is examples/contact_sheet.rs, built with `cargo build --example contact_sheet`. Each model stands in a cell of
its own, several looks beside each other at one scale, with its name below. Needs scripts/requirements-render.txt.
Exit 0: written. 1: not. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import environment

environment.require(environment.PICTURES, __name__)

SETS = {"plain": "modern", "traditional": "traditional", "industrial": "industrial", "budget": "budget"}
LOOKS, SAMPLES = 3, 16
# Cells for looks in a row of the sheet, pixels of a cell, pixels below it for the name.
ACROSS, CELL, LABEL = 18, 84, 14
# White things show on it.
PAPER = (222, 226, 230, 255)
# Share of a cell that a model fills.
FILLED = 0.92


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("set", choices=SETS)
    parser.add_argument("out", type=Path)
    parser.add_argument("--looks", type=int, default=LOOKS, choices=range(1, ACROSS + 1), metavar="N")
    parser.add_argument("--samples", type=int, default=SAMPLES, metavar="N")
    options = parser.parse_args(arguments)
    if lacks := environment.missing(environment.PICTURES):
        print(environment.how_to_set_up(environment.PICTURES, lacks), file=sys.stderr)
        return 2
    try:
        render_sheet(options.program, options.set, options.out, options.samples, options.looks)
    except (OSError, subprocess.CalledProcessError, RuntimeError) as error:
        print(f"{options.out}: {error}", file=sys.stderr)
        return 1
    return 0


def render_sheet(program: Path, geometry: str, out: Path, samples: int = SAMPLES, looks: int = LOOKS) -> None:
    """Builds the models, renders them in a grid, writes their names below."""
    import render
    with tempfile.TemporaryDirectory() as folder:
        models, picture = Path(folder, "models.glb"), Path(folder, "sheet.png")
        subprocess.run([program.resolve(), models, geometry, SETS[geometry], "all", str(looks)], check=True)
        with render.quiet():
            names = _render(models, picture, samples, looks)
        _label(picture, names, out, looks)


def group_cells(count: int, looks: int) -> list[tuple[int, int]]:
    """Column and row of each model's first look; a model's looks stay in one row."""
    in_row = max(1, ACROSS // looks)
    return [(index % in_row * looks, index // in_row) for index in range(count)]


def names_of(nodes: list[str]) -> list[str]:
    """The models among nodes called item-NAME-LOOK, in their order."""
    found = (re.fullmatch(r"item-(.+)-\d+", name) for name in nodes)
    return list(dict.fromkeys(match[1] for match in found if match))


def _render(models: Path, picture: Path, samples: int, looks: int) -> list[str]:
    from contact_stage import render_grid

    return render_grid(models, picture, samples, looks)


def _label(picture: Path, names: list[str], out: Path, looks: int) -> None:
    from PIL import Image, ImageDraw, ImageFont

    with Image.open(picture) as image:
        drawn = image.convert("RGBA")
    paper = Image.new("RGBA", drawn.size, PAPER)
    paper.alpha_composite(drawn)
    pen, font = ImageDraw.Draw(paper), ImageFont.load_default(size=11)
    for name, (column, row) in zip(names, group_cells(len(names), looks)):
        middle = (column + looks / 2) * CELL
        pen.text((middle, (row + 1) * (CELL + LABEL) - LABEL / 2), name.replace("_", " "), fill=(60, 60, 60), font=font,
                 anchor="mm")
    paper.convert("RGB").save(out, quality=80, optimize=True)


if __name__ == "__main__":
    sys.exit(main())
