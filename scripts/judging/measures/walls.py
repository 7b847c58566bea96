"""Bare walls, and halls by their width."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import HALLS, HOME_ROOMS, SLIM_KINDS, STAIRS
from ..shapes import Wall, width_of

# Metres of a wall without anything.
BARE = 3.0
# Metres before a wall within which a piece is at it.
AT_WALL = 0.35
# Metres of wall that are no wall: corners are drawn with such edges.
LEAST = 0.05
# Metres of a hall's width from which on it is a room that wants furniture, and below which nothing stands in it.
WIDE_HALL = 1.6
NARROW_HALL = 1.2
# Metres that figures of meshes are off.
ROUNDING = 0.002
ROOM_HALL = 2.4
# Metres that a line across a hall may run at most, and shares of a piece's width where such lines begin.
ACROSS = 30.0
LINES = np.linspace(-0.45, 0.45, 5)
# Square metres of the smallest hall, and of the smallest piece: not an umbrella stand.
LEAST_HALL = 2.0
LEAST_PIECE = 0.1


def judge_bare(room: Room) -> Answer | None:
    return bare_walls(room) if room.kind in HOME_ROOMS else None


def judge_bare_hall(room: Room) -> Answer | None:
    return bare_walls(room) if room.kind in HALLS else None


def bare_walls(room: Room) -> Answer:
    faults, longest = [], 0.0
    for walls in room.straight_walls:
        metres = longest_bare(room, walls)
        longest = max(longest, metres)
        if metres > BARE:
            numbers = ", ".join(str(wall.number) for wall in walls)
            faults.append(Fault(f"{metres:.1f} m of wall {numbers} are bare", (), metres))
    return answer(faults, longest)


def longest_bare(room: Room, walls: list[Wall]) -> float:
    """The longest stretch of a straight wall with nothing at it."""
    along = walls[0].along
    solid = [tuple(sorted((float(wall.start @ along), float(wall.end @ along)))) for wall in walls]
    taken = gaps_between(solid)
    for wall in walls:
        taken += openings_in(room, wall, along) + [span for piece in room.pieces
                                                   if (span := span_at(piece, wall, along)) is not None]
    low, high = min(start for start, _ in solid), max(end for _, end in solid)
    return longest_gap(low, high, taken)


def gaps_between(spans: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Where the edges of a straight wall leave out a stretch: a niche or a passage."""
    spans = sorted(spans)
    return [(end, start) for (_, end), (start, _) in zip(spans, spans[1:]) if start - end > LEAST]


def openings_in(room: Room, wall: Wall, along: np.ndarray) -> list[tuple[float, float]]:
    sides = [side for doors in (True, False) for _, side in room.openings(doors) if side.wall is wall]
    ends = [(float(wall.at(side.start) @ along), float(wall.at(side.end) @ along)) for side in sides]
    return [(min(pair), max(pair)) for pair in ends]


def span_at(piece: Piece, wall: Wall, along: np.ndarray) -> tuple[float, float] | None:
    """The stretch of a wall that a piece is at."""
    if piece.is_covering or piece.carrier is not None:
        return None
    points = np.asarray(piece.footprint.convex_hull.exterior.coords) if piece.footprint.geom_type == "Polygon" else None
    if points is None or not -0.05 < ((points - wall.start) @ wall.inward).min() < AT_WALL:
        return None
    low, high = (points @ along).min(), (points @ along).max()
    ends = sorted((float(wall.start @ along), float(wall.end @ along)))
    return (float(low), float(high)) if high > ends[0] and low < ends[1] else None


def longest_gap(low: float, high: float, taken: list[tuple[float, float]]) -> float:
    longest, reached = 0.0, low
    for start, end in sorted(taken):
        longest = max(longest, min(start, high) - reached)
        reached = max(reached, end)
    return max(longest, high - reached)


def judge_halls(least: float, most: float, fewest: int) -> Callable[[Room], Answer | None]:
    """Halls of some widths, by the number of pieces that stand in them; the value is the share of the floor that they take."""
    def judge(room: Room) -> Answer | None:
        width = width_of(room.region)
        if room.kind not in HALLS or room.area < LEAST_HALL or not least <= width < most:
            return None
        standing = standing_in(room)
        filled = sum(piece.footprint.area for piece in standing) / room.area
        if len(standing) >= fewest:
            return answer([], filled)
        ids = tuple(piece.id for piece in standing)
        return answer([Fault(f"{len(standing) or 'no'} pieces stand in a hall {width:.2f} m wide", ids, width)], filled)

    return judge


def judge_narrow(room: Room) -> Answer | None:
    """Halls with arms and niches have no one width: it counts where something stands."""
    if room.kind not in HALLS or room.area < LEAST_HALL:
        return None
    widths = [(width_at(room, piece), piece) for piece in standing_in(room)]
    narrow = [Fault(f"it stands where the hall is {width:.2f} m wide", (piece.id,), width)
              for width, piece in widths if width < NARROW_HALL - ROUNDING]
    return answer(narrow, min((width for width, _ in widths), default=None))


def standing_in(room: Room) -> list[Piece]:
    return [piece for piece in room.standing if piece.footprint.area > LEAST_PIECE]


def width_at(room: Room, piece: Piece) -> float:
    """Metres across the hall before a piece, with its own depth: the median of some lines."""
    across = from_wall(room, piece) if piece.kind in SLIM_KINDS else piece.front
    along, width = np.array([across[1], -across[0]]), float(piece.size[0])
    return float(np.median([line_across(room, piece.center + along * width * share, across) for share in LINES]))


def from_wall(room: Room, piece: Piece) -> np.ndarray:
    """Plants have no front: what is before them is away from the nearest wall."""
    walls = [wall for wall in room.walls if wall.length > LEAST]
    nearest = min(walls, key=lambda wall: shapely.LineString([wall.start, wall.end]).distance(piece.footprint))
    return nearest.inward


def line_across(room: Room, point: np.ndarray, direction: np.ndarray) -> float:
    line = shapely.LineString([point - direction * ACROSS, point + direction * ACROSS])
    parts = shapely.get_parts(line.intersection(room.region))
    here = [part for part in parts.tolist() if part.distance(shapely.Point(point)) < LEAST]
    if any(part.distance(side) < LEAST for part in here for side in open_sides(room)):
        return float("inf")
    return max((part.length for part in here), default=float("inf"))


def open_sides(room: Room) -> list[shapely.LineString]:
    """Where a room goes on in the next without a wall; who goes past a piece does not step onto stairs."""
    stairs = {other.id for other in room.floor.rooms if other.kind in STAIRS}
    return [shapely.LineString([side.wall.at(side.start), side.wall.at(side.end)]) for opening, side in room.openings(doors=True)
            if opening.closure == "open" and not stairs.intersection(opening.rooms)]


MEASURES = [
    Measure("bare_wall", "no stretch of a wall is without furniture, art, door or window", "m", "≤ 3; 0.35 m deep",
            "project", judge_bare),
    Measure("bare_hall_wall", "the same in corridors and halls", "m", "≤ 3", "project", judge_bare_hall),
    Measure("hall_narrow", "nothing stands where a hall is so narrow", "m", "under 1.2 m wide", "UK Part M; HUD", judge_narrow),
    Measure("hall_middling", "a hall with room at one side (a distribution, no limit)", "of the floor", "1.2–1.6 m", "UK Part M; HUD",
            judge_halls(NARROW_HALL, WIDE_HALL, 0)),
    Measure("hall_wide", "something stands in a hall so wide", "of the floor", "1.6–2.4 m", "project",
            judge_halls(WIDE_HALL, ROOM_HALL, 1)),
    Measure("hall_room", "a hall as wide as a room has several pieces", "of the floor", "from 2.4 m", "project",
            judge_halls(ROOM_HALL, float("inf"), 2)),
]
