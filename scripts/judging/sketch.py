"""Rooms from above, as SVG: outline, openings, pieces, and what the architect drew."""

from __future__ import annotations

from html import escape
from typing import NamedTuple

import shapely

from .drawn import Drawn
from .floors import Room
from .pieces import Piece
from .roles import BASINS, BEDS, COFFEE_TABLES, KITCHEN_UNITS, SOFAS, TABLES, TOILETS, WARDROBES
from .shapes import pieces_of_area, rectangle

# Pixels a metre, and metres of margin.
SCALE = 60
MARGIN = 0.4
INK, FLOOR, PIECE, TOP, GLASS, DOOR, THEIRS = "#333", "#fbfaf7", "#d9e2ec", "#eef2f6", "#7fb2e5", "#c98", "#f0d9b5"
# Metres: what is smaller is not drawn.
SMALL = 0.12
# Metres between units that are one block.
JOINT = 0.01
# What architects draw, by their words; furniture where a room's drawing has some.
FIXTURES = {"kitchen": KITCHEN_UNITS, "toilet": TOILETS, "sink": BASINS, "bathtub": {"bathtub", "sit_bath"},
            "shower": {"shower", "small_shower"}}
FURNITURE = {"sofa": SOFAS, "bed": BEDS, "table": TABLES | COFFEE_TABLES, "wardrobe": WARDROBES}


class Shape(NamedTuple):
    """A shape with its colours, and a word on it."""

    geometry: shapely.Geometry
    fill: str
    stroke: str = INK
    word: str = ""


def room_shapes(room: Room) -> list[Shape]:
    """The empty room with its openings."""
    shapes = [Shape(room.region, FLOOR)]
    shapes += [Shape(column, INK) for column, _ in room.columns]
    for doors, colour in ((True, DOOR), (False, GLASS)):
        for opening, side in room.openings(doors):
            hole = rectangle(side.wall.at(side.start), side.wall.at(side.end), -side.wall.inward * 0.12)
            shapes.append(Shape(hole, colour, colour))
            shapes += [Shape(swing.intersection(room.region), "none", colour) for swing in opening.swings]
    return shapes


def own_shapes(room: Room) -> list[Shape]:
    """The pieces of a room, lower ones first, with a mark at their fronts."""
    shapes = []
    for piece in sorted(room.pieces, key=lambda piece: piece.high):
        if min(piece.size) >= SMALL and piece.low < 1.2:
            word = piece.kind.replace("_", " ") if piece.carrier is None and piece.size[0] > 0.3 else ""
            shapes.append(Shape(piece.footprint, PIECE if piece.carrier is None else TOP, word=word))
            shapes += [front_mark(piece)] if piece.carrier is None and not piece.is_covering else []
    return shapes


def front_mark(piece: Piece) -> Shape:
    start, end, outward = piece.side("front")
    return Shape(rectangle(start, end, -outward * 0.04), INK, "none")


def fixture_shapes(room: Room) -> list[Shape]:
    """The pieces that architects draw, too, in their style: boxes, and units that touch as one block."""
    shapes = []
    is_furnished = any(drawn.name in FURNITURE for drawn in room.drawn)
    for word, kinds in (FIXTURES | FURNITURE if is_furnished else FIXTURES).items():
        pieces = [piece for piece in room.of(kinds) if piece.carrier is None and piece.low < 1.0]
        boxes = [piece.zone("back", -float(piece.size[1])) for piece in pieces]
        whole = shapely.union_all(boxes).buffer(JOINT, join_style="mitre").buffer(-JOINT, join_style="mitre")
        shapes += [Shape(block, THEIRS, word=word) for block in pieces_of_area(whole)]
    return shapes


def drawn_shapes(drawn: list[Drawn]) -> list[Shape]:
    return [Shape(fixture.shape, THEIRS, word=fixture.name) for fixture in drawn]


def svg(room: Room, shapes: list[Shape]) -> str:
    west, south, east, north = room.region.buffer(MARGIN).bounds
    width, height = (east - west) * SCALE, (north - south) * SCALE
    body = "".join(drawing_of(shape, west, north) for shape in shapes)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
            f'viewBox="0 0 {width:.0f} {height:.0f}">{body}</svg>')


def drawing_of(shape: Shape, west: float, north: float) -> str:
    def at(x: float, y: float) -> str:
        return f"{(x - west) * SCALE:.1f} {(north - y) * SCALE:.1f}"

    rings = [ring for part in pieces_of_area(shape.geometry) for ring in (part.exterior, *part.interiors)]
    path = "".join("M" + "L".join(at(x, y) for x, y in ring.coords) + "Z" for ring in rings)
    drawn = f'<path d="{path}" fill="{shape.fill}" stroke="{shape.stroke}" fill-rule="evenodd"/>'
    if not shape.word or shape.geometry.is_empty:
        return drawn
    x, y = at(*shape.geometry.centroid.coords[0]).split()
    return drawn + f'<text x="{x}" y="{y}" font-size="9" text-anchor="middle" fill="{INK}">{escape(shape.word)}</text>'
