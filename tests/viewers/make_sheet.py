#!/usr/bin/env python3
"""Puts pictures of one view side by side, each under its name: make_sheet.py SHEET.jpg NAME=PICTURE... Needs Pillow.

Pictures are cut to no other form: all must have that of the first.
"""

from __future__ import annotations

import sys
from pathlib import Path

from PIL import Image, ImageDraw

COLUMNS, WIDTH, LABEL_HEIGHT = 3, 480, 20
QUALITY = 85


def main(arguments: list[str]) -> int:
    if len(arguments) < 2 or not all("=" in pair for pair in arguments[1:]):
        print(__doc__, file=sys.stderr)
        return 2
    pictures = [(name, Image.open(path).convert("RGB")) for name, _, path in (pair.partition("=") for pair in arguments[1:])]
    first = pictures[0][1]
    height = round(WIDTH * first.height / first.width)
    rows = -(-len(pictures) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * WIDTH, rows * (height + LABEL_HEIGHT)), "white")
    pen = ImageDraw.Draw(sheet)
    for place, (name, picture) in enumerate(pictures):
        left, top = place % COLUMNS * WIDTH, place // COLUMNS * (height + LABEL_HEIGHT)
        pen.text((left + 6, top + 3), name, fill="black", font_size=13)
        sheet.paste(picture.resize((WIDTH, height), Image.Resampling.LANCZOS), (left, top + LABEL_HEIGHT))
    sheet.save(Path(arguments[0]), quality=QUALITY, optimize=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
