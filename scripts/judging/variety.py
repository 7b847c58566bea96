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


class Stands(NamedTuple):
    """The pieces of an arrangement as columns."""

    kinds: np.ndarray
    places: np.ndarray
    fronts: np.ndarray
    areas: np.ndarray

    @classmethod
    def of(cls, arrangement: Arrangement) -> Stands:
        kinds, places, fronts, areas = zip(*arrangement.stands) if arrangement.stands else ((), (), (), ())
        return cls(np.array(kinds, str), np.array(places, float).reshape(-1, 2), np.array(fronts, float).reshape(-1, 2),
                   np.array(areas, float))

    def turned(self, turn: Turn) -> Stands:
        places = turn(self.places)
        return self._replace(places=places, fronts=turn(self.places + self.fronts) - places)


def arrangement_of(room: Room) -> Arrangement:
    pieces = [piece for piece in room.standing
              if piece.footprint.area >= LEAST_PIECE and piece.kind not in CHAIRS | OFFICE_CHAIRS]
    stands = tuple(Stand(piece.kind, tuple(piece.center), tuple(piece.front), piece.footprint.area) for piece in pieces)
    return Arrangement(shapely.to_wkb(room.region), stands)


def distinct(arrangements: Iterable[Arrangement]) -> int:
    """The number of arrangements of one room that differ by more than a mirror or a step."""
    found: list[Stands] = []
    turns: list[Turn] | None = None
    for arrangement in arrangements:
        turns = symmetries(shapely.from_wkb(arrangement.outline)) if turns is None else turns
        stands = Stands.of(arrangement)
        turned = [stands.turned(turn) for turn in turns]
        if not any(is_same(one, other) for other in found for one in turned):
            found.append(stands)
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


def is_same(one: Stands, other: Stands) -> bool:
    """Whether most of what stands in two arrangements stands in the same places."""
    if not len(one.areas) or not len(other.areas):
        return not len(one.areas) and not len(other.areas)
    away = np.hypot(*(one.places[:, None] - other.places[None]).transpose(2, 0, 1))
    turned = one.fronts @ other.fronts.T
    match = (away <= SAME_PLACE) & (turned >= np.cos(np.radians(SAME_WAY))) & (one.kinds[:, None] == other.kinds[None])
    shared = one.areas[match.any(axis=1)].sum() + other.areas[match.any(axis=0)].sum()
    return bool(shared >= SAME_SHARE * (one.areas.sum() + other.areas.sum()))
