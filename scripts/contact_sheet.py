#!/usr/bin/env python3
"""Renders all models of a geometry set on one sheet: contact_sheet.py PROGRAM SET OUT.jpg [--looks N]

PROGRAM is examples/contact_sheet.rs, built with `cargo build --example contact_sheet`. Each model has a cell of its own,
with its looks beside each other at one scale and its name below. Needs scripts/requirements-render.txt.
Exit 0: written. 1: not. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.PICTURES, __name__)

from roomwright.blender.command_line import quiet_blender
from pictures.contact_grid import ACROSS, CELL, LABEL, group_cells

SETS = {"plain": "modern", "traditional": "traditional", "industrial": "industrial", "budget": "budget"}
LOOKS, SAMPLES = 3, 16
# White things show on it.
PAPER = (222, 226, 230, 255)


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
    with tempfile.TemporaryDirectory() as folder:
        models, picture = Path(folder, "models.glb"), Path(folder, "sheet.png")
        subprocess.run([program.resolve(), models, geometry, SETS[geometry], "all", str(looks)], check=True)
        with quiet_blender():
            names = _render(models, picture, samples, looks)
        _label(picture, names, out, looks)


def _render(models: Path, picture: Path, samples: int, looks: int) -> list[str]:
    from pictures.contact_stage import render_grid

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
