"""Walls and columns of a level: those that stand in a room are in the way of furniture, and rooms between which none is drawn are
open to each other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from shapely import LineString, Polygon, STRtree, union_all
from shapely.geometry.base import BaseGeometry
from shapely.ops import linemerge

from .drawing import Drawn, parts_of
from .faults import Place, Report
from .openings import Opening, ends_of, halfway, unit
from .rooms import Room
from .shapes import CURVES, Point, Scale, ShapeError, shapes_of

# Metres that walls may reach into rooms: both are drawn by hand.
DRAWN_INSIDE = 0.05
# Square metres of the smallest body that furniture has to mind.
LEAST_BODY = 0.01
# Metres across a railing that is drawn as a line.
RAILING = 0.05
# Metres between outlines that share an edge.
SHARED = 0.02
# Metres of the shortest boundary that one walks through.
LEAST_BOUNDARY = 0.5
# Metres that a boundary may bend and still be straight.
STRAIGHT = 0.02


@dataclass
class Walls:
    """What is drawn of walls or columns, in metres: areas of closed outlines and hatches, and all lines."""

    bodies: list[Polygon] = field(default_factory=list)
    lines: list[LineString] = field(default_factory=list)

    def without_contours(self, rooms: list[Room]) -> Walls:
        """Without areas around rooms: these are contours, of the building or of the walls around a room."""
        tree = STRtree([room.polygon.representative_point() for room in rooms])
        return Walls([body for body in self.bodies if not len(tree.query(body, predicate="contains"))], self.lines)


def walls_of(found: Iterable[Drawn], scale: Scale, report: Report) -> Walls:
    """The walls or columns of entities, those in blocks among them. Texts and the like are left out, what is broken is reported."""
    walls = Walls()
    for drawn in found:
        for part in parts_of(drawn):
            try:
                shapes = shapes_of(part, scale)
            except ShapeError as error:
                if part.entity.dxftype() in (*CURVES, "HATCH"):
                    report.error(drawn.place(), str(error))
                continue
            outlines = [shape for shape in shapes if shape.is_closed and len(shape.points) > 2]
            walls.bodies += areas_of([valid(Polygon(shape.points)) for shape in outlines])
            walls.lines += [LineString(ends) for shape in shapes if len(ends := shape.line()) > 1]
    return walls


def valid(polygon: Polygon) -> BaseGeometry:
    return polygon if polygon.is_valid else polygon.buffer(0)


def areas_of(outlines: list[BaseGeometry]) -> list[Polygon]:
    """The areas of one entity: a hatch within a hatch is a hole."""
    if not outlines:
        return []
    area = outlines[0]
    for outline in outlines[1:]:
        area = area.symmetric_difference(outline)
    return [piece for piece in getattr(area, "geoms", [area]) if isinstance(piece, Polygon) and piece.area >= LEAST_BODY]


def obstacles(bodies: list[Polygon], rooms: list[Room], margin: float) -> list[list[Point]]:
    """The outlines of bodies where they stand in rooms, more than a margin in metres from the walls."""
    tree = STRtree(bodies)
    outlines = []
    for room in rooms:
        inside = room.polygon.buffer(-margin) if margin else room.polygon
        near = [bodies[index] for index in sorted(int(found) for found in tree.query(inside, predicate="intersects"))]
        if not near:
            continue
        shared = union_all(near).intersection(inside)
        for piece in getattr(shared, "geoms", [shared]):
            # The native format has no obstacles with holes.
            if isinstance(piece, Polygon) and piece.area >= LEAST_BODY and not piece.interiors:
                outlines.append([(float(x), float(y)) for x, y in piece.exterior.coords[:-1]])
    return outlines


def strips(railings: Walls) -> list[list[Point]]:
    """The outlines of railings: areas as they are drawn, lines as wide as a railing is."""
    lines = [line.buffer(RAILING / 2, cap_style="flat", join_style="mitre") for line in railings.lines if not line.is_ring]
    return [[(float(x), float(y)) for x, y in outline.exterior.coords[:-1]] for outline in [*railings.bodies, *lines]
            if isinstance(outline, Polygon) and not outline.is_empty]


def open_boundaries(rooms: list[Room], walls: Walls, openings: list[Opening]) -> list[Opening]:
    """Where two rooms share an edge on which neither a wall nor an opening is drawn."""
    tree = STRtree([room.polygon for room in rooms])
    drawn_walls = [*walls.bodies, *walls.lines]
    wall_tree = STRtree(drawn_walls)
    drawn_openings = [LineString(ends_of(opening)).buffer(2 * SHARED) for opening in openings]
    opening_tree = STRtree(drawn_openings)
    found = []
    for index, room in enumerate(rooms):
        for other in sorted(int(each) for each in tree.query(room.polygon, predicate="dwithin", distance=SHARED)):
            if other <= index:
                continue
            shared = room.polygon.boundary.intersection(rooms[other].polygon.buffer(SHARED))
            closed = [drawn_walls[each].buffer(SHARED) for each in wall_tree.query(shared, predicate="dwithin", distance=SHARED)]
            closed += [drawn_openings[each] for each in opening_tree.query(shared, predicate="intersects")]
            rest = shared.difference(union_all(closed)) if closed else shared
            found += [boundary_of(line, room, rooms[other]) for line in straight_lines(rest)]
    return found


def straight_lines(shared: BaseGeometry) -> list[tuple[Point, Point]]:
    """The ends of the straight stretches of lines that are long enough to walk through."""
    lines = [line for line in getattr(shared, "geoms", [shared]) if isinstance(line, LineString) and not line.is_empty]
    merged = linemerge(lines) if lines else None
    if merged is None:
        return []
    found = []
    for line in getattr(merged, "geoms", [merged]):
        corners = list(line.simplify(STRAIGHT).coords)
        found += [(start, end) for start, end in zip(corners, corners[1:]) if LineString((start, end)).length >= LEAST_BOUNDARY]
    return found


def boundary_of(line: tuple[Point, Point], room: Room, other: Room) -> Opening:
    width = LineString(line).length
    place = Place(room.place.layer, room.place.handle, room.place.kind)
    return Opening("open_boundary", halfway(*line), unit(*line), float(width), place, rooms=(room.id, other.id))
