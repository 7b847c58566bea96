#!/usr/bin/env python3
"""Renders baked levels: render.py [options] FILE...

Views, `--view` once for each:
  top        from above, without ceilings, the walls cut at 1.2 m and the cuts dark; north is up
  dollhouse  from above and the side, over the near walls (default)
  eye        from 1.6 m in a free corner or a door, with a wide lens, of the largest room or of `--room`
Each picture is DIR/BUILDING-LEVEL[-ROOM]-VIEW.png, or .jpg with `--format jpg`.

The same file gives the same cameras. Needs Python 3.11 and scripts/requirements-render.txt; see scripts/README.md.
Exit 0: all pictures are written. 1: some are not; standard error has the reasons. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import re
import sys
import time
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.PICTURES, __name__)

from roomwright.blender.command_line import quiet_blender
from roomwright.gltf_document import GltfError
from roomwright.gltf_file import GltfFile
from pictures.cameras import choose
from pictures.floor_view import Level, ViewError, read_level

VIEWS = ("top", "dollhouse", "eye")


def picture_size(text: str) -> tuple[int, int]:
    """WxH in pixels."""
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    if match is None or not all(16 <= int(side) <= 16384 for side in match.groups()):
        raise argparse.ArgumentTypeError(f"{text!r} is no size like 960x720, each side from 16 to 16384")
    return int(match[1]), int(match[2])


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE", help="a .glb or .gltf that roomwright baked")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder of the pictures")
    parser.add_argument("--view", action="append", choices=VIEWS, help="default: dollhouse")
    parser.add_argument("--room", action="append", metavar="ID", help="this room only; may be repeated")
    parser.add_argument("--size", type=picture_size, default=(960, 720), metavar="WxH", help="default: 960x720")
    parser.add_argument("--samples", type=int, default=64, metavar="N", help="per pixel; default: 64, denoised")
    parser.add_argument("--engine", choices=("cycles", "eevee", "workbench"), default="cycles")
    parser.add_argument("--format", choices=("png", "jpg"), default="png")
    parser.add_argument("--transparent", action="store_true", help="keep the background transparent (png only)")
    options = parser.parse_args(arguments)
    if options.samples < 1:
        parser.error("--samples must be 1 or more")
    if options.transparent and options.format == "jpg":
        parser.error("--transparent needs --format png")
    return options


def main(arguments: list[str] | None = None) -> int:
    options = parse(arguments)
    missing = [str(path) for path in options.files if not path.is_file()]
    if missing:
        return _stop(f"no such file: {', '.join(missing)}")
    if lacks := environment.missing(environment.PICTURES):
        return _stop(environment.how_to_set_up(environment.PICTURES, lacks))
    try:
        options.out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        return _stop(f"cannot write into {options.out}: {error.strerror}")
    return int(any([not render_file(path, options) for path in options.files]))


def _stop(reason: str) -> int:
    print(reason, file=sys.stderr)
    return 2


def render_file(path: Path, options: argparse.Namespace) -> bool:
    """Takes all pictures of one file; whether that went well."""
    try:
        level = read_level(GltfFile(path))
        rooms = [level.room(name) for name in options.room] if options.room else [None]
        _render_rooms(path, level, rooms, options)
    except (GltfError, ViewError, RuntimeError, OSError) as error:
        print(f"{path}: {error}", file=sys.stderr)
        return False
    return True


def _render_rooms(path: Path, level: Level, rooms: list, options: argparse.Namespace) -> None:
    from pictures.quality import Quality
    from pictures.stage import Stage

    width, height = options.size
    quality = Quality(width, height, options.samples, options.engine)
    with quiet_blender():
        stage = Stage(path, level)
    if len(level.rooms) == 1:
        rooms = level.rooms
    for room in rooms:
        for view in dict.fromkeys(options.view or ["dollhouse"]):
            started = time.monotonic()
            target = options.out / picture_name(level, options.room and room, view, options.format)
            with quiet_blender():
                stage.take(choose(level, room, view, width / height), room, quality, target.with_suffix(".png"))
            finish(target, options.transparent)
            print(f"{target} ({time.monotonic() - started:.1f} s)", file=sys.stderr)


def picture_name(level: Level, room, view: str, ending: str) -> str:
    """BUILDING-LEVEL[-ROOM]-VIEW, with nothing in it that a file system forbids."""
    words = [level.building, level.name, *([room.name] if room else []), view]
    return re.sub(r"[^\w.-]+", "_", "-".join(words)) + f".{ending}"


def finish(target: Path, is_transparent: bool) -> None:
    """Puts white behind a picture and writes it as its ending says."""
    from PIL import Image

    if is_transparent:
        return
    source = target.with_suffix(".png")
    with Image.open(source) as picture:
        cover = picture.convert("RGBA")
    paper = Image.new("RGBA", cover.size, (255, 255, 255, 255))
    paper.alpha_composite(cover)
    paper.convert("RGB").save(target, **({"quality": 85, "optimize": True} if target.suffix == ".jpg" else {}))
    if source != target:
        source.unlink()


if __name__ == "__main__":
    sys.exit(main())
