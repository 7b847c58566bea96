"""Every object against its box, its room and its neighbours, measured on the meshes.

The program's audit judges the boxes and solids that classes declare. These checks do not use it: they measure the triangles
that people see.
"""

from __future__ import annotations

from itertools import groupby
from typing import Iterator

import numpy as np
import shapely

from ..gltf_file import GltfFile, Node

from .bodies import Part
from .health import complaints
from .overlap import overlap
from .pieces import Piece, pieces_of
from .report import Note

# Metres. A mesh lies in its box to a millimetre, and coordinates are single precision numbers.
SIZE_TOLERANCE = 0.0015
# A body may stick out of its room by 5 mm (the audit's `out_of_room`), plus the above.
ROOM_TOLERANCE = 0.0065
# Two bodies may be in each other by 1 mm (the audit's `collision_depth`), plus the above for each of them.
OVERLAP_TOLERANCE = 0.004
# Models may stand out of the shapes of their classes by 40 mm (cushions, seams, taps: src/model/agreement.rs), and
# shapes fit into each other where pieces belong together: a chair under its table, a cup on its basin.
GROUP_TOLERANCE = 0.04


def check_pieces(gltf: GltfFile) -> Iterator[Note]:
    sound: dict[int, list[str]] = {}
    for node in gltf.nodes:
        if node.kind == "furniture" and node.mesh is None:
            yield Note("geometry", node.name, "it has no mesh")
    for piece in pieces_of(gltf):
        yield from check_box(piece.node, piece.meshes.corners(piece.node.mesh))
        if piece.node.mesh not in sound:
            sound[piece.node.mesh] = list(complaints(gltf.primitives(piece.node.mesh)))
            yield from (Note("geometry", piece.node.name, message) for message in sound[piece.node.mesh])


def check_box(node: Node, corners: np.ndarray) -> Iterator[Note]:
    """The mesh's extents against `size` (width, depth, height), in the node's own frame with y up."""
    width, depth, height = node.extras["size"]
    low, high = corners.min(axis=0), corners.max(axis=0)
    size, found = np.array([width, height, depth]), high - low
    if np.abs(found - size).max() > SIZE_TOLERANCE:
        said = triple((width, depth, height))
        measured = triple(found[[0, 2, 1]])
        yield Note("geometry", node.name, f"the mesh measures {measured}, `size` is {said}")
    middle = (low + high) / 2 - (0.0, height / 2, 0.0)
    if np.abs(middle).max() > SIZE_TOLERANCE:
        yield Note("geometry", node.name, f"the origin is off the middle of the underside by {triple(middle)}")


# --- containment ---


def check_containment(gltf: GltfFile) -> Iterator[Note]:
    columns = column_nodes(gltf)
    for room, pieces in by_room(gltf):
        outline = shapely.Polygon(room.extras["outline"], room.extras["holes"])
        allowed = outline.buffer(ROOM_TOLERANCE, join_style="mitre")
        shapely.prepare(allowed)
        for piece in pieces:
            yield from check_inside(piece, allowed)
            for column in columns.get(room.index, []):
                yield from check_column(piece, column)


def check_inside(piece: Piece, allowed: shapely.Polygon) -> Iterator[Note]:
    """The mesh against outline, holes and height of its room, in the plan's frame."""
    room = piece.room
    # Nearly every box lies inside; only where one does not are the triangles asked.
    if not allowed.covers(footprint(piece.box)) and not allowed.covers(footprint(piece.corners)):
        outside = [footprint(part.corners).difference(allowed) for part in piece.parts]
        places = [shapely.get_coordinates(area)[0] for area in outside if not area.is_empty]
        if places:
            x, y = places[0]
            yield Note("containment", piece.node.name, f"{len(places)} parts of it reach out of {room.name}, one at "
                                                       f"({x:.3f}, {y:.3f})")
    low, high = piece.low[1], piece.high[1]
    if low < -ROOM_TOLERANCE or high > room.extras["height"] + ROOM_TOLERANCE:
        yield Note("containment", piece.node.name, f"it reaches from {low:.3f} to {high:.3f} m in a room of "
                                                   f"{room.extras['height']:.3f} m")


def check_column(piece: Piece, column: Node) -> Iterator[Note]:
    """An object on a low column is above the column, and not judged."""
    body = shapely.Polygon(column.extras["outline"]).buffer(-ROOM_TOLERANCE, join_style="mitre")
    top = column.extras["height"] - ROOM_TOLERANCE
    if piece.low[1] >= top or not body.intersects(footprint(piece.corners)):
        return
    if any(part.low[1] < top and body.intersects(footprint(part.corners)) for part in piece.parts):
        yield Note("containment", piece.node.name, f"it stands in {column.name}")


def footprint(corners: np.ndarray) -> shapely.Geometry:
    """The hull of some corners from above, in the plan's axes: x east, y north."""
    return shapely.MultiPoint(np.column_stack([corners[:, 0], -corners[:, 2]])).convex_hull


def column_nodes(gltf: GltfFile) -> dict[int, list[Node]]:
    """What stands in each room and says where, by the room's node: columns, and flights and wells, in which nothing may stand."""
    columns: dict[int, list[Node]] = {}
    for node in gltf.nodes:
        if node.kind == "part" and {"outline", "height"} <= node.extras.keys() and node.parent is not None:
            columns.setdefault(node.parent.index, []).append(node)
    return columns


# --- collisions ---


def check_collisions(gltf: GltfFile) -> Iterator[Note]:
    for _, pieces in by_room(gltf):
        for one, other in touching(pieces):
            if one.is_covering != other.is_covering:
                continue
            related = one.stands_on(other) or other.stands_on(one)
            tolerance = GROUP_TOLERANCE if related else OVERLAP_TOLERANCE
            depth = deepest(one, other, tolerance)
            if depth > tolerance:
                yield Note("collision", one.node.name, f"it is {depth * 1000:.0f} mm inside of {other.node.name}")


def by_room(gltf: GltfFile) -> Iterator[tuple[Node, list[Piece]]]:
    pieces = sorted(pieces_of(gltf), key=lambda piece: piece.room.index)
    for _, members in groupby(pieces, key=lambda piece: piece.room.index):
        members = list(members)
        yield members[0].room, members


def touching(pieces: list[Piece]) -> Iterator[tuple[Piece, Piece]]:
    """The pairs whose boxes overlap; the later one first."""
    lows, highs = np.stack([piece.low for piece in pieces]), np.stack([piece.high for piece in pieces])
    for number in range(1, len(pieces)):
        shared = np.minimum(highs[:number], highs[number]) - np.maximum(lows[:number], lows[number])
        for other in np.flatnonzero(shared.min(axis=1) > OVERLAP_TOLERANCE):
            yield pieces[number], pieces[other]


def deepest(one: Piece, other: Piece, tolerance: float) -> float:
    """Metres of the deepest overlap of their parts."""
    low, high = np.maximum(one.low, other.low), np.minimum(one.high, other.high)
    near, others = ([part for part in piece.parts if least_side(part, low, high) > tolerance] for piece in (one, other))
    return max((overlap(first, second, tolerance) for first in near for second in others), default=0.0)


def least_side(part: Part, low: np.ndarray, high: np.ndarray) -> float:
    """Of what a part's box and another box share."""
    return float((np.minimum(part.high, high) - np.maximum(part.low, low)).min())


def triple(values) -> str:
    return " x ".join(f"{value:.4f}" for value in values)
