"""What the openings of a level are drawn of: an inserted block, or entities that touch each other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ezdxf.entities.arc import Arc
from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.ellipse import Ellipse
from ezdxf.entities.lwpolyline import LWPolyline
from ezdxf.entities.polyline import Polyline
from shapely import MultiLineString, MultiPoint, STRtree, union_all
from shapely.geometry.base import BaseGeometry

from .drawing import Drawn, parts_of
from .faults import Place, Report
from .shapes import MARKS, Point, Scale, ShapeError, shapes_of

# Metres between entities of one opening.
TOUCHING = 0.02

# The swing of a leaf. In a block that is stretched to the width of its door, a circle is an ellipse.
Swing = Arc | Ellipse


@dataclass(frozen=True)
class Group:
    """What one or more openings are drawn of."""

    lines: tuple[tuple[Point, ...], ...]
    arcs: tuple[tuple[Swing, Place], ...]
    place: Place

    @property
    def points(self) -> list[Point]:
        return [point for line in self.lines for point in line]

    def area(self) -> BaseGeometry:
        """Where others belong to it. The swing of a leaf is none: leaves of several doors swing across the same floor."""
        points = MultiPoint(self.points)
        if not self.arcs:
            return points.convex_hull
        lines = [line for line in self.lines if len(line) > 1]
        return MultiLineString(lines) if lines else points


def groups_of(found: Iterable[Drawn], scale: Scale, report: Report) -> list[Group]:
    """Each block by itself, other entities joined where they touch."""
    singles: list[Group] = []
    blocks: list[Group] = []
    for drawn in found:
        group = group_of(drawn, scale)
        if isinstance(group, str):
            report.error(drawn.place(), group)
        elif group is not None:
            (blocks if drawn.entity.dxftype() == "INSERT" else singles).append(group)
    return blocks + joined(singles)


def group_of(drawn: Drawn, scale: Scale) -> Group | str | None:
    """What an entity is drawn of; None for texts and the like, a reason for what has no shape."""
    lines: list[tuple[Point, ...]] = []
    arcs: list[tuple[Swing, Place]] = []
    reason = None
    parts = parts_of(drawn)
    for part in parts:
        try:
            lines += [shape.line() for shape in shapes_of(part, scale)]
            arcs += [(arc, drawn.place()) for arc in arcs_of(part.entity)]
        except ShapeError as error:
            reason = str(error) if part.entity.dxftype() not in MARKS else reason
    if lines:
        return Group(tuple(lines), tuple(arcs), drawn.place(scale.drawn_at(lines[0][0])))
    return None if reason is None and parts else reason or "the block is empty"


def arcs_of(part: DXFGraphic) -> list[Swing]:
    """An arc, or the arcs of a polyline with bulges."""
    if isinstance(part, (Arc, Ellipse)):
        return [part]
    if isinstance(part, (LWPolyline, Polyline)) and part.has_arc:
        return [piece for piece in part.virtual_entities() if isinstance(piece, Arc)]
    return []


def joined(groups: list[Group]) -> list[Group]:
    """Groups that touch become one, in the order of their first."""
    if not groups:
        return []
    areas = [group.area().buffer(TOUCHING / 2) for group in groups]
    union = union_all(areas)
    tree = STRtree(list(getattr(union, "geoms", [union])))
    members: dict[int, list[Group]] = {}
    for group, area in zip(groups, areas):
        members.setdefault(int(tree.nearest(area.representative_point())), []).append(group)
    return [Group(tuple(line for group in each for line in group.lines), tuple(arc for group in each for arc in group.arcs),
                  each[0].place) for each in members.values()]
