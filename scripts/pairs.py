#!/usr/bin/env python3
"""Writes a page of pairs: rooms as Roomwright furnished them beside the same rooms as their architects drew them.

    pairs.py FOLDER|FILE... --drawn FOLDER --out pairs.html [--rooms 40] [--kind kitchen] [--blind]

Baked levels are compared with the drawings below --drawn: archilyse's, with kitchens, toilets, basins, tubs and showers, and
furnished IFC files. The rooms are drawn at random, the same for the same --seed. --blind shows both in one style, fixtures
only, on sides that chance chooses, with the key at the end: for people who say which room they would rather have.

The page holds the drawings of the plans, whose licences are those of the plans. Needs scripts/requirements.txt. Exit 0: the
page is written. 2: there is nothing to compare.
"""

from __future__ import annotations

import argparse
import random
import sys
from html import escape
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.TOOLS, __name__)

from roomwright.checks.manifest import scenes_in
from judging.floors import Room, read_floor
from judging.judgement import attach
from judging.sketch import drawn_shapes, fixture_shapes, own_shapes, room_shapes, svg

STYLE = """body{font:15px sans-serif;margin:2em}section{margin:0 0 2em;break-inside:avoid}figure{display:inline-block;
margin:0 2em 0 0;vertical-align:top}figcaption{color:#555}"""


def compared_rooms(files: list[Path], drawn: Path, kinds: list[str]) -> list[Room]:
    """Rooms with both furniture and a drawing, of the kinds asked for."""
    rooms: list[Room] = []
    for file in files:
        floor = read_floor(file)
        attach(floor, drawn)
        rooms += [room for room in floor.rooms if room.drawn and fixture_shapes(room) and (not kinds or room.kind in kinds)]
    return rooms


def page(rooms: list[Room], chance: random.Random, is_blind: bool) -> str:
    sections, key = [], []
    for number, room in enumerate(rooms, 1):
        ours = svg(room, room_shapes(room) + (fixture_shapes(room) if is_blind else own_shapes(room)))
        theirs = svg(room, room_shapes(room) + drawn_shapes(room.drawn))
        sides = [("ours", ours), ("the architect's", theirs)]
        if is_blind:
            chance.shuffle(sides)
            key.append(f"{number}: {sides[0][0]} on the left")
        sections.append(section(number, room, sides, is_blind))
    ending = f"<details><summary>Key</summary><p>{'<br>'.join(map(escape, key))}</p></details>" if is_blind else ""
    return (f'<!doctype html><meta charset="utf-8"><title>Pairs</title><style>{STYLE}</style><h1>{len(rooms)} pairs</h1>'
            f"{''.join(sections)}{ending}")


def section(number: int, room: Room, sides: list[tuple[str, str]], is_blind: bool) -> str:
    captions = ("left", "right") if is_blind else [name for name, _ in sides]
    figures = "".join(f"<figure>{picture}<figcaption>{escape(caption)}</figcaption></figure>"
                      for caption, (_, picture) in zip(captions, sides))
    place = f"{room.floor.building}/{room.floor.level}/{room.id}, seed {room.floor.seed}"
    return f"<section><h2>{number}. {escape(room.kind)}, {room.area:.1f} m²</h2><p>{escape(place)}</p>{figures}</section>"


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--drawn", type=Path, required=True, metavar="FOLDER", help="folder with the plans' drawings")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE", help="the page to write")
    parser.add_argument("--rooms", type=int, default=40, metavar="N", help="pairs at most (default: 40)")
    parser.add_argument("--kind", action="append", default=[], metavar="TYPE", help="rooms of this type only; may be repeated")
    parser.add_argument("--seed", type=int, default=1, help="of the choice of rooms and sides (default: 1)")
    parser.add_argument("--blind", action="store_true", help="do not say which is whose")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    files = [file for path in options.paths for file in (scenes_in(path) if path.is_dir() else [path])]
    rooms = compared_rooms(files, options.drawn, options.kind)
    if not rooms:
        print("pairs: no baked room has a drawing of its architect's", file=sys.stderr)
        return 2
    chance = random.Random(options.seed)
    chosen = chance.sample(rooms, min(options.rooms, len(rooms)))
    options.out.write_text(page(chosen, chance, options.blind), encoding="utf-8")
    print(f"{len(chosen)} of {len(rooms)} rooms: {options.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
