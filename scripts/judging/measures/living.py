"""Living rooms: something to look at, and seats that look at it."""

from __future__ import annotations

import numpy as np
import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import (BOOKCASES, EASY_CHAIRS, LIVING_ROOMS, PROJECTION, READING_LAMPS, SCREENS, SOFAS, TV_STANDS)
from ..shapes import angle_between

# Metres: a reading corner is a seat with a lamp so near, in a room with books so near.
LAMP = 1.5
BOOKS = 4.0
# Degrees by which a sofa may look past its screen: QUALITY, tv_position.
FACING = 30.0
# Metres above a stand within which a screen on the wall belongs to it.
ABOVE_STAND = 1.5


def screens_of(room: Room) -> list[Piece]:
    return room.of(SCREENS | PROJECTION)


def judge_screen(room: Room) -> Answer | None:
    if room.kind not in LIVING_ROOMS:
        return None
    if screens_of(room) or has_reading_corner(room):
        return answer([])
    return answer([Fault("it has neither a screen nor a reading corner")])


def judge_screen_only(room: Room) -> Answer | None:
    if room.kind not in LIVING_ROOMS:
        return None
    return answer([], float(not screens_of(room)))


def has_reading_corner(room: Room) -> bool:
    return any(is_for_reading(room, seat) for seat in room.of(EASY_CHAIRS))


def is_for_reading(room: Room, seat: Piece) -> bool:
    return near(seat, room.of(READING_LAMPS), LAMP) and near(seat, room.of(BOOKCASES), BOOKS)


def near(piece: Piece, others: list[Piece], metres: float) -> bool:
    return any(shapely.dwithin(piece.footprint, other.footprint, metres) for other in others)


def judge_stands(room: Room) -> Answer | None:
    stands = room.of(TV_STANDS)
    if not stands:
        return None
    screens = room.of(SCREENS)
    empty = [stand for stand in stands if not any(is_over(screen, stand) for screen in screens)]
    return answer([Fault("no screen is on it or over it", (stand.id,)) for stand in empty], len(empty))


def is_over(screen: Piece, stand: Piece) -> bool:
    reach = screen.low - stand.high
    return -0.05 < reach < ABOVE_STAND and shapely.dwithin(shapely.Point(screen.center), stand.footprint, 0.1)


def judge_sofa(room: Room) -> Answer | None:
    """The largest sofa of a living room, by the screen that it looks at best."""
    sofas, screens = room.of(SOFAS), room.of(SCREENS | {"projection_screen"})
    if room.kind not in LIVING_ROOMS or not sofas or not screens:
        return None
    sofa = max(sofas, key=lambda piece: float(piece.size[0]))
    turned = min(angle_past(sofa, screen) for screen in screens)
    faults = [Fault(f"the screen is {turned:.0f}° off its front", (sofa.id,), turned)] if turned > FACING else []
    return answer(faults, turned)


def angle_past(sofa: Piece, screen: Piece) -> float:
    """Degrees between the front of a sofa and the screen, as its best seat sees it."""
    half = sofa.right * (float(sofa.size[0]) / 2 - 0.3)
    seats = [sofa.center + half * share for share in np.linspace(-1.0, 1.0, 5)]
    return min(angle_between(sofa.front, screen.center - seat) for seat in seats)


MEASURES = [
    Measure("living_without_screen_or_corner", "a living room has a screen, or a reading corner instead", "",
            "an easy chair within 1.5 m of a lamp and 4 m of books", "project", judge_screen),
    Measure("living_without_screen", "how many living rooms have no screen (a distribution, no limit)", "of them", "", "project",
            judge_screen_only),
    Measure("empty_tv_stand", "a television stand has a screen on it or over it", "stands", "0", "project", judge_stands),
    Measure("sofa_past_screen", "the largest sofa looks at a screen", "°", "≤ 30", "SMPTE, THX", judge_sofa,
            audit="facing"),
]
