"""Bodies: in each other, outside of their room, in the air, over an edge. QUALITY §1."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from roomwright.checks.overlap import overlap

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece

# Metres. Coordinates are single precision numbers, and models fill their boxes to a millimetre: 1 mm of overlap and 1.5 mm
# of each of two models; 5 mm out of the room and 1.5 mm.
OVERLAP = 0.004
OUTSIDE = 0.0065
GAP = 0.01
# Pieces that belong together fit into each other: a chair under its table, a cup on its basin.
GROUP_OVERLAP = 0.04
# Share of what a piece stands with that may hang over an edge.
OVERHANG = 0.1


def judge_collision(room: Room) -> Answer | None:
    if not room.pieces:
        return None
    faults, deepest = [], 0.0
    for one, other in near_pairs(room.pieces):
        allowed = GROUP_OVERLAP if is_related(one, other) else OVERLAP
        depth = depth_of(one, other, allowed)
        if depth > allowed:
            deepest = max(deepest, depth)
            faults.append(Fault(f"{depth * 1000:.0f} mm in each other", (one.id, other.id), depth))
    return answer(faults, deepest)


def near_pairs(pieces: list[Piece]) -> Iterator[tuple[Piece, Piece]]:
    """Pairs whose boxes overlap; rugs only with rugs."""
    boxes = np.array([(*piece.footprint.bounds, *piece.heights) for piece in pieces])
    for number in range(1, len(pieces)):
        earlier, own = boxes[:number], boxes[number]
        shared = np.minimum(earlier[:, [2, 3, 5]], own[[2, 3, 5]]) - np.maximum(earlier[:, [0, 1, 4]], own[[0, 1, 4]])
        for other in np.flatnonzero(shared.min(axis=1) > OVERLAP):
            if pieces[other].is_covering == pieces[number].is_covering:
                yield pieces[number], pieces[other]


def is_related(one: Piece, other: Piece) -> bool:
    return one.parent == other.id or other.parent == one.id or carries(one, other) or carries(other, one)


def carries(carrier: Piece, piece: Piece | None) -> bool:
    while piece is not None:
        if piece.carrier is carrier:
            return True
        piece = piece.carrier
    return False


def depth_of(one: Piece, other: Piece, allowed: float) -> float:
    if not one.footprint.intersects(other.footprint):
        return 0.0
    return max((overlap(one.part(first), other.part(second), allowed) for first, second in meeting(one, other, allowed)),
               default=0.0)


def meeting(one: Piece, other: Piece, allowed: float) -> np.ndarray:
    """The parts of two pieces whose boxes overlap."""
    low = np.maximum(one.part_boxes[:, None, :3], other.part_boxes[None, :, :3])
    high = np.minimum(one.part_boxes[:, None, 3:], other.part_boxes[None, :, 3:])
    return np.argwhere((high - low).min(axis=2) > allowed)


def judge_outside(room: Room) -> Answer | None:
    if not room.pieces:
        return None
    allowed = room.region.buffer(OUTSIDE, join_style="mitre")
    shapely.prepare(allowed)
    faults = [fault for piece in room.pieces if (fault := outside(piece, allowed, room)) is not None]
    return answer(faults)


def outside(piece: Piece, allowed: shapely.Geometry, room: Room) -> Fault | None:
    if not allowed.covers(piece.footprint):
        beyond = shapely.difference(piece.layers[2], allowed)
        if shapely.area(beyond).max() > 1e-6:
            return Fault("it reaches out of the room", (piece.id,))
    if piece.low < -OUTSIDE or piece.high > room.height + OUTSIDE:
        return Fault(f"it reaches from {piece.low:.2f} to {piece.high:.2f} m in a room of {room.height:.2f} m", (piece.id,))
    if any(piece.low < top - OUTSIDE and piece.footprint.intersection(shape).area > 1e-4 for shape, top in room.columns):
        return Fault("it stands in a column", (piece.id,))
    return None


def judge_floating(room: Room) -> Answer | None:
    if not room.pieces:
        return None
    faults = []
    for piece in room.pieces:
        metres = gap_of(piece, room)
        if metres > GAP:
            faults.append(Fault(f"{metres * 100:.0f} cm from what it stands or hangs on", (piece.id,), metres))
    return answer(faults)


def gap_of(piece: Piece, room: Room) -> float:
    """Metres between a piece and the nearest thing that holds it."""
    if piece.carrier is not None:
        return min(gap_above(piece, piece.carrier), gap_beside(piece, [piece.carrier]))
    held = [abs(piece.low), abs(room.height - piece.high), room.region.boundary.distance(piece.footprint)]
    if min(held) <= GAP:
        return min(held)
    others = [other for other in room.pieces if other is not piece and other.carrier is not piece]
    over = [gap_above(piece, other) for other in others if other.footprint.intersects(piece.footprint)]
    return min([*held, *over, gap_beside(piece, others), *(shape.distance(piece.footprint) for shape, _ in room.columns)])


def gap_above(piece: Piece, other: Piece) -> float:
    """Metres between the underside of a piece and the faces of another below it."""
    heights, _, tree = other.tops
    below = heights[tree.query(piece.footprint, "intersects")]
    return float(np.abs(piece.low - below).min()) if len(below) else float("inf")


def gap_beside(piece: Piece, others: list[Piece]) -> float:
    """Metres to a piece at the same height that it may be fixed to."""
    level = [other for other in others if other.low < piece.high and other.high > piece.low]
    return min((other.footprint.distance(piece.footprint) for other in level), default=float("inf"))


def judge_unsupported(room: Room) -> Answer | None:
    carried = [piece for piece in room.pieces if piece.carrier is not None]
    if not carried:
        return None
    faults = []
    for piece in carried:
        hanging = overhang(piece, piece.carrier)
        if hanging > OVERHANG:
            faults.append(Fault(f"{hanging:.0%} of it is over the edge of {piece.carrier.id}", (piece.id,), hanging))
    return answer(faults)


def overhang(piece: Piece, carrier: Piece) -> float:
    """The share of what a piece stands with that has nothing of its carrier below; 0 for what hangs at its side."""
    heights, shapes, tree = carrier.tops
    hits = tree.query(piece.foot, "intersects")
    level = hits[np.abs(heights[hits] - piece.low) <= GAP + 0.01]
    if not len(level) or piece.foot.area < 1e-6:
        return 0.0
    # A hull, not the faces: laths and rims carry as well as boards.
    support = shapely.union_all(shapes[np.abs(heights - piece.low) <= GAP + 0.01]).convex_hull
    return 1.0 - piece.foot.intersection(support).area / piece.foot.area


MEASURES = [
    Measure("collision", "no two pieces are in each other", "m", "1 mm, and 1.5 mm of each model", "QUALITY §1; SceneEval",
            judge_collision, audit="collision"),
    Measure("out_of_room", "every piece is inside outline, floor and ceiling, and in no column, flight or well", "", "5 mm",
            "QUALITY §1", judge_outside, audit="out_of_room"),
    Measure("floating", "every piece touches what it stands or hangs on", "m", "≤ 1 cm", "QUALITY §1", judge_floating,
            audit="floating"),
    Measure("unsupported", "no piece hangs over the edge of what it stands on", "share", "≤ 10 %", "QUALITY §1",
            judge_unsupported, audit="unsupported"),
]
