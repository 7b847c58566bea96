"""Splines that general code for curves reads otherwise than the programs that wrote them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import islice

from ezdxf.entities.spline import Spline
from shapely import LineString
from shapely import Point as Location

Corner = tuple[float, float]

# Pieces that a stretch between knots is divided into first, and how often each may be halved: 2 to this power edges a stretch.
FIRST_PIECES, MOST_HALVINGS = 4, 12


def polygon_of(spline: Spline, chord_error: float) -> list[Corner] | None:
    """The corners of a polygon that was exported as a spline of degree 2: its control points are corner, middle, corner, and so on.

    Such splines are straight between their corners only if their knots are double; exporters write other knots, and mean the polygon.
    Lengths are units of the drawing.
    """
    controls = [(float(x), float(y)) for x, y, _ in spline.control_points]
    if spline.dxf.degree != 2 or len(controls) < 5 or len(controls) % 2 == 0:
        return None
    middles = zip(controls[:-2:2], controls[1::2], controls[2::2])
    is_polygon = all(math.dist(middle, ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)) <= chord_error
                     for start, middle, end in middles)
    return controls[::2] if is_polygon else None


def periodic_points(spline: Spline, chord_error: float, most: int) -> list[Corner] | None:
    """Points along a closed spline whose knots do not end in its control points, within a chord error; None for other splines.

    Such a curve runs over the inner knots alone (L. Piegl and W. Tiller, The NURBS Book, 1997, on unclamped knot vectors).
    """
    count, degree, knots = len(spline.control_points), spline.dxf.degree, list(spline.knots)
    if not spline.closed or len(knots) != count + degree + 1 or knots[0] == knots[degree]:
        return None
    curve = spline.construction_tool()

    def at(parameter: float) -> Corner:
        point = curve.point(parameter)
        return (point.x, point.y)

    inner = [knot for knot, following in zip(knots[degree:count], knots[degree + 1:count + 1]) if following > knot] + [knots[count]]
    points = [at(inner[0])]
    points += islice((point for low, high in zip(inner, inner[1:]) for point in stretch(at, low, high, chord_error)), most)
    return points


def stretch(at: Callable[[float], Corner], low: float, high: float, chord_error: float) -> Iterator[Corner]:
    """The points after the first between two parameters."""
    steps = [low + (high - low) * step / FIRST_PIECES for step in range(FIRST_PIECES + 1)]
    for start, end in zip(steps, steps[1:]):
        yield from halves(at, (start, at(start)), (end, at(end)), chord_error, MOST_HALVINGS)


def halves(at: Callable[[float], Corner], start: tuple[float, Corner], end: tuple[float, Corner], chord_error: float,
           left: int) -> Iterator[Corner]:
    middle = (start[0] + end[0]) / 2
    point = at(middle)
    if left == 0 or LineString((start[1], end[1])).distance(Location(point)) <= chord_error:
        yield end[1]
        return
    yield from halves(at, start, (middle, point), chord_error, left - 1)
    yield from halves(at, (middle, point), end, chord_error, left - 1)
