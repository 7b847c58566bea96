#!/usr/bin/env python3
"""Renders the gallery: gallery.py [options]

The gallery has a room of each type and of each style as a dollhouse, sheets of all models, and a README.md that shows
them. It is baked with the release program, so build that before. Needs Python 3.11 and scripts/requirements-render.txt; see
scripts/README.md. Takes about 15 minutes on two cores. --only ID renders single pictures, --pages only writes the page.
Exit 0: all pictures are written. 1: some are not. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.PICTURES, __name__)

import contact_sheet
import render
from roomwright.gltf_document import GltfError
from pictures import gallery_plans
from pictures.floor_view import ViewError

ROOT = Path(__file__).resolve().parent.parent
SIZE = (480, 360)
SAMPLES = 12
COLUMNS = 3
HEAD = """# Gallery

Rendered from baked files by `scripts/gallery.py`; plans of the same room types are in the [catalogue](../catalogue.md).
"""


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "target" / "release" / "roomwright")
    parser.add_argument("--contact-program", type=Path, metavar="FILE",
                        help="examples/contact_sheet.rs, built; default: beside the program, in examples/")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "gallery", metavar="DIR")
    parser.add_argument("--only", action="append", default=[], metavar="ID", help="a room type, style or geometry set")
    parser.add_argument("--samples", type=int, default=SAMPLES, metavar="N")
    parser.add_argument("--pages", action="store_true", help="write README.md only")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse(arguments)
    try:
        catalog = read_catalog(options.program)
        options.out.mkdir(parents=True, exist_ok=True)
    except (OSError, subprocess.CalledProcessError, ValueError) as error:
        print(f"cannot start: {error}", file=sys.stderr)
        return 2
    is_whole = True
    if not options.pages:
        is_whole = render_rooms(catalog, options) & render_sheets(options)
    (options.out / "README.md").write_text(page(catalog, options.out), encoding="utf-8")
    return 0 if is_whole else 1


def read_catalog(program: Path) -> gallery_plans.Catalog:
    """Asks the program what there is."""
    def ask(part: str) -> dict:
        return json.loads(subprocess.run([program, "catalog", part, "--json"], check=True, capture_output=True).stdout)

    return gallery_plans.Catalog.read({part: ask(part) for part in ("rooms", "styles", "classes")})


def render_rooms(catalog: gallery_plans.Catalog, options: argparse.Namespace) -> bool:
    """Bakes and renders rooms and styles; whether all went well."""
    wanted = set(options.only)
    plans = [gallery_plans.rooms_plan(catalog, wanted), gallery_plans.styles_plan(catalog, wanted)]
    is_whole = True
    with tempfile.TemporaryDirectory() as folder:
        for plan in (one for one in plans if one["levels"]):
            path = Path(folder, f"{plan['id']}.json")
            path.write_text(json.dumps(plan))
            baked = Path(folder, "out")
            subprocess.run([options.program, "bake", path, "--out", baked, "--quiet", "--force"], check=False)
            for level in plan["levels"]:
                source = next(iter(sorted(baked.glob(f"{plan['id']}/{level['id']}.gl*"))), None)
                is_whole &= source is not None and take(source, options, f"{plan['id']}-{level['id']}")
    return is_whole


def take(source: Path, options: argparse.Namespace, name: str) -> bool:
    """One picture of one file."""
    taking = argparse.Namespace(out=options.out, view=["dollhouse"], room=None, size=SIZE, samples=options.samples,
                                engine="cycles", format="jpg", transparent=False)
    if not render.render_file(source, taking):
        return False
    (options.out / f"{name}-dollhouse.jpg").replace(options.out / f"{name}.jpg")
    return True


def render_sheets(options: argparse.Namespace) -> bool:
    """All models of each geometry set."""
    program = options.contact_program or options.program.parent / "examples" / "contact_sheet"
    is_whole = True
    for name in (one for one in contact_sheet.SETS if not options.only or one in options.only):
        try:
            contact_sheet.render_sheet(program, name, options.out / f"models-{name}.jpg", options.samples)
        except (OSError, subprocess.CalledProcessError, GltfError, ViewError, RuntimeError) as error:
            print(f"models of {name}: {error}", file=sys.stderr)
            is_whole = False
    return is_whole


def page(catalog: gallery_plans.Catalog, folder: Path) -> str:
    """README.md: tables of the pictures that are there."""
    files = sorted({one["file"].rsplit("/", 1)[-1].removesuffix(".yaml") for one in catalog.furnished()})
    text = HEAD + "\n## Room types\n"
    for file in files:
        members = [one for one in catalog.furnished() if one["file"].endswith(f"/{file}.yaml")]
        cells = [cell(folder, f"rooms-{one['id']}.jpg", one["label"], gallery_plans.room_style(one)) for one in members]
        text += f"\n### {file.capitalize()}\n\n" + table([one for one in cells if one])
    styles = [cell(folder, f"styles-{name}.jpg", one["label"], name) for name, one in catalog.styles.items()]
    text += "\n## Styles\n\n" + table([one for one in styles if one])
    sheets = [name for name in contact_sheet.SETS if (folder / f"models-{name}.jpg").is_file()]
    text += "\n## Models\n\nEach model of a geometry set, with some of its looks; not to one scale.\n"
    return text + "".join(f"\n### {name.capitalize()}\n\n![Models, {name}](models-{name}.jpg)\n" for name in sheets)


def cell(folder: Path, file: str, label: str, note: str) -> str:
    """A picture and its caption; nothing where it was not rendered."""
    return f"![{label}]({file})<br>{label}, `{note}`" if (folder / file).is_file() else ""


def table(cells: list[str]) -> str:
    rows = [cells[start:start + COLUMNS] for start in range(0, len(cells), COLUMNS)]
    lines = [f"| {' | '.join(row + [''] * (COLUMNS - len(row)))} |" for row in rows]
    return "\n".join(["| " * COLUMNS + "|", "|---" * COLUMNS + "|", *lines]) + "\n"


if __name__ == "__main__":
    sys.exit(main())
