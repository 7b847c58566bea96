"""How many ways of furnishing a room many seeds find; mirrored ones count once."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np
import shapely
from shapely import affinity

from .floors import Room
from .roles import CHAIRS, OFFICE_CHAIRS

# Square metres of pieces that make an arrangement; chairs are moved.
LEAST_PIECE = 0.2
# Metres and degrees by which a piece may differ and still stand in the same place.
SAME_PLACE = 0.75
SAME_WAY = 45.0
# The share of the pieces' footprint that stands in the same places in two arrangements that are the same.
SAME_SHARE = 0.8
# The share of a room that lies on itself if the room is mirrored: it is symmetric.
SYMMETRIC = 0.95

Turn = Callable[[np.ndarray], np.ndarray]  # of points; directions are differences of points


class Stand(NamedTuple):
    """A piece of an arrangement."""

    kind: str
    at: tuple[float, float]
    front: tuple[float, float]
    area: float


class Arrangement(NamedTuple):
    """A room's outline and what stands in it."""

    outline: bytes  # well-known binary
    stands: tuple[Stand, ...]


def arrangement_of(room: Room) -> Arrangement:
    pieces = [piece for piece in room.standing
              if piece.footprint.area >= LEAST_PIECE and piece.kind not in CHAIRS | OFFICE_CHAIRS]
    stands = tuple(Stand(piece.kind, tuple(piece.center), tuple(piece.front), piece.footprint.area) for piece in pieces)
    return Arrangement(shapely.to_wkb(room.region), stands)


def distinct(arrangements: Iterable[Arrangement]) -> int:
    """The number of arrangements of one room that differ by more than a mirror or a step."""
    found: list[Arrangement] = []
    turns: list[Turn] | None = None
    for arrangement in arrangements:
        turns = symmetries(shapely.from_wkb(arrangement.outline)) if turns is None else turns
        if not any(is_same(arrangement, other, turn) for other in found for turn in turns):
            found.append(arrangement)
    return len(found)


def symmetries(region: shapely.Geometry) -> list[Turn]:
    """Identity, and the mirrors and the half turn that lay a room on itself."""
    box = shapely.get_coordinates(shapely.minimum_rotated_rectangle(region))
    middle, edge = box[:4].mean(axis=0), box[1] - box[0]
    along = edge / max(np.hypot(*edge), 1e-9)
    mirror = np.outer(along, along) * 2 - np.identity(2)
    found: list[Turn] = [lambda points: points]
    for matrix in (mirror, -mirror, -np.identity(2)):
        offset = middle - matrix @ middle
        moved = affinity.affine_transform(region, [*matrix.ravel(), *offset])
        if moved.intersection(region).area >= SYMMETRIC * region.area:
            found.append(lambda points, matrix=matrix, offset=offset: points @ matrix.T + offset)
    return found


def is_same(one: Arrangement, other: Arrangement, turn: Turn) -> bool:
    """Whether most of what stands in two arrangements stands in the same places."""
    left, shared = list(other.stands), 0.0
    for stand in one.stands:
        place, tip = turn(np.array([stand.at, np.add(stand.at, stand.front)]))
        match = next((candidate for candidate in left if stand.kind == candidate.kind
                      and np.hypot(*(place - candidate.at)) <= SAME_PLACE
                      and (tip - place) @ np.array(candidate.front) >= np.cos(np.radians(SAME_WAY))), None)
        if match is not None:
            left.remove(match)
            shared += stand.area + match.area
    return shared >= SAME_SHARE * sum(stand.area for stand in (*one.stands, *other.stands))
