"""The outlines of entities as corners in metres: arcs, bulges, ellipses and splines become edges.

No corner or edge lies further than the chord error from the curve: one half is taken when the curve is divided, the other when
corners that stand in a straight edge are taken out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice

from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.hatch import Hatch
from ezdxf.entities.lwpolyline import LWPolyline
from ezdxf.entities.polyline import Polyline
from ezdxf.entities.spline import Spline
from ezdxf.path import Path, from_hatch, make_path
from shapely import LineString
from shapely import Point as Location

from .drawing import Drawn
from .faults import Place
from .splines import periodic_points, polygon_of

Point = tuple[float, float]

CURVES = ("LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE")
# What explains a drawing, and is no part of a plan.
MARKS = ("TEXT", "MTEXT", "ATTDEF", "ATTRIB", "POINT", "DIMENSION", "LEADER")
CLOSED_ALWAYS = ("CIRCLE",)
# Metres of the farthest coordinate from the drawing's origin: national grids reach to some ten million.
FARTHEST = 1e8
# Metres of the largest outline: a curve of this size becomes some thousand edges.
LARGEST = 20_000.0
# Corners of one outline that the program takes (src/plan/limits.rs), and those that are looked at to find them.
MOST_CORNERS, MOST_POINTS = 4_096, 100_000
# Control points of a curve.
MOST_CONTROLS = 20_000
# Pieces that a part of a curve is divided into before the chord error is looked at: one would take the middle of an S for straight.
LEAST_SEGMENTS = 4
# Metres between the ends of an outline that is drawn to be closed.
CLOSED_GAP = 0.01


class ShapeError(Exception):
    """An entity has no outline; the text says why."""


@dataclass(frozen=True)
class Scale:
    """Lengths of a drawing in metres."""

    metres: float  # of a unit
    chord_error: float  # metres

    def point(self, x: float, y: float) -> Point:
        return (x * self.metres, y * self.metres)

    def drawn_at(self, point: Point) -> Point:
        """A point in metres, in units of the drawing."""
        return (point[0] / self.metres, point[1] / self.metres)


@dataclass(frozen=True)
class Shape:
    """Corners of an entity, in metres in the frame of the drawing; the last of a closed one is not the first again."""

    points: tuple[Point, ...]
    is_closed: bool
    place: Place
    gap: float = 0.0  # metres between the ends of an open one

    def line(self) -> tuple[Point, ...]:
        """The corners along the line, the first of a closed one at its end again."""
        return (*self.points, self.points[0]) if self.is_closed else self.points


def shapes_of(drawn: Drawn, scale: Scale) -> list[Shape]:
    """The shapes of a curve or a hatch. Raises ShapeError."""
    shapes = []
    for path in paths_of(drawn.entity):
        if not drawn.budget.spend(len(path)):
            raise ShapeError("the drawing asks for too much work")
        shapes.append(shape_of(path, drawn, scale))
    return shapes


def shape_of(path: Path, drawn: Drawn, scale: Scale) -> Shape:
    points = flattened(path, scale)
    if isinstance(drawn.entity, Spline):
        points = points_of_spline(drawn.entity, scale) or points
    gap = math.dist(points[0], points[-1])
    is_closed = gap <= CLOSED_GAP or is_flagged_closed(drawn.entity)
    place = drawn.place(scale.drawn_at(points[0]))
    if is_closed:
        ring = points[:-1] if gap <= CLOSED_GAP else points
        return Shape(tuple(straightened(ring, scale.chord_error / 2)), True, place)
    return Shape(tuple(points), False, place, gap)


def is_flagged_closed(entity: DXFGraphic) -> bool:
    if entity.dxftype() in CLOSED_ALWAYS or isinstance(entity, Hatch):
        return True
    return entity.dxftype() in ("LWPOLYLINE", "POLYLINE", "SPLINE") and bool(getattr(entity, "closed", None)
                                                                            or getattr(entity, "is_closed", False))


def paths_of(entity: DXFGraphic) -> list[Path]:
    """Raises ShapeError for what has no outline, or none that is a number."""
    size = len(entity) if isinstance(entity, (LWPolyline, Polyline)) else entity.control_point_count() if isinstance(entity, Spline) else 0
    if size > MOST_CONTROLS:
        raise ShapeError(f"it has {size} points, of which {MOST_CONTROLS} are read")
    try:
        if isinstance(entity, Hatch):
            paths = list(islice(from_hatch(entity), MOST_CORNERS))
        elif entity.dxftype() in CURVES:
            paths = [make_path(entity)]
        else:
            raise ShapeError(f"a {entity.dxftype()} has no outline")
    except ShapeError:
        raise
    except Exception as error:  # values of a damaged entity can raise anything
        raise ShapeError(f"its values make no curve ({type(error).__name__}: {str(error)[:80]})") from None
    return [path for path in paths if len(path)]


def flattened(path: Path, scale: Scale) -> list[Point]:
    """The corners of a path. Raises ShapeError for one that is too far, too large or too long."""
    controls = list(islice(path.control_vertices(), MOST_CONTROLS + 1))
    if len(controls) > MOST_CONTROLS:
        raise ShapeError(f"it has more than {MOST_CONTROLS} control points")
    points = [scale.point(control.x, control.y) for control in controls]
    if not all(abs(value) <= FARTHEST for point in points for value in point):
        raise ShapeError(f"a coordinate is no number, or farther than {FARTHEST:g} m from the origin")
    low, high = bounds_of(points)
    if max(high[0] - low[0], high[1] - low[1]) > LARGEST:
        raise ShapeError(f"it is larger than {LARGEST:g} m; hint: is the unit right? --unit names another")
    if not path.has_curves:
        return points
    distance = scale.chord_error / 2 / scale.metres
    flat = [scale.point(vertex.x, vertex.y) for vertex in islice(path.flattening(distance, segments=LEAST_SEGMENTS), MOST_POINTS + 1)]
    if len(flat) > MOST_POINTS:
        raise ShapeError(f"it would have more than {MOST_POINTS} corners; hint: a larger --chord-error")
    return flat


def points_of_spline(spline: Spline, scale: Scale) -> list[Point] | None:
    """The points of a spline that `make_path` reads in another way; None for usual ones."""
    error = scale.chord_error / 2 / scale.metres
    points = polygon_of(spline, 2 * error) or periodic_points(spline, error, MOST_POINTS)
    return points and [scale.point(*point) for point in points]


def bounds_of(points: Iterable[Point]) -> tuple[Point, Point]:
    columns = list(zip(*points))
    return (min(columns[0]), min(columns[1])), (max(columns[0]), max(columns[1]))


def straightened(ring: list[Point], tolerance: float) -> list[Point]:
    """A ring without corners that stand in straight edges, its first corner among them."""
    line = LineString([*ring, ring[0]]).simplify(tolerance)
    corners = [(float(x), float(y)) for x, y in line.coords[:-1]]
    if len(corners) > 3 and LineString([corners[-1], corners[1]]).distance(Location(corners[0])) <= tolerance:
        corners = corners[1:]
    return corners
