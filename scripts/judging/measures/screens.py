"""Screens and windows: something to see, and light. QUALITY §2."""

from __future__ import annotations

import numpy as np
import shapely

from ..floors import Room, Side
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import CHAIRS, CURTAINS, OFFICE_CHAIRS, SCREENS, SLIM_KINDS, VIEWERS
from ..shapes import angle_between

# Degrees off a screen's axis, and diagonals of the screen between it and who looks.
ANGLE = 30.0
DIAGONALS = (1.2, 3.5)
# Metres of height between which a body stands in the line of sight.
SIGHT = (1.0, 1.5)
# Metres: how far over a sill, how far before a window.
OVER_SILL = 0.1
BEFORE = 0.5
# Metres of what leaves the light: low before windows down to the floor, or slim.
LOW = 0.9
# Metres under the ceiling at which a piece hangs from it, and over the floor above which it is a lamp and no wardrobe.
CEILING = 0.05
OVERHEAD = 1.0
SLIM = 0.6
# Metres: what of a low piece rises over it and is so slim takes no light either. Architects set sinks before windows.
TAP = 0.2


def judge_screens(room: Room) -> Answer | None:
    screens, viewers = room.of(SCREENS), room.of(VIEWERS)
    if not screens or not viewers:
        return None
    faults = []
    for screen in screens:
        seen = [how for viewer in viewers if (how := view_of(room, screen, viewer)) is not None]
        if not seen:
            faults.append(Fault("nobody sees it from a seat or bed", (screen.id,)))
        if any(is_before(screen, side) for _, side in room.openings(doors=False)):
            faults.append(Fault("it is before a window", (screen.id,)))
    return answer(faults)


def view_of(room: Room, screen: Piece, viewer: Piece) -> float | None:
    """Diagonals between a screen and the best place on a seat or bed, or None if it is not seen from there."""
    diagonal = float(np.hypot(screen.size[0], screen.high - screen.low))
    half = viewer.right * max(float(viewer.size[0]) / 2 - 0.3, 0.0)
    for share in (0.0, -1.0, 1.0):
        eye = viewer.center + half * share
        away = float(np.hypot(*(eye - screen.center))) / diagonal
        if (angle_between(screen.front, eye - screen.center) <= ANGLE and DIAGONALS[0] <= away <= DIAGONALS[1]
                and is_clear(room, screen, viewer, eye)):
            return away
    return None


def is_clear(room: Room, screen: Piece, viewer: Piece, eye: np.ndarray) -> bool:
    line = shapely.LineString([eye, screen.center])
    others = [piece for piece in room.pieces if piece not in (screen, viewer, screen.carrier) and piece.low < SIGHT[1]
              and piece.high > SIGHT[0] and piece.footprint.intersects(line)]
    return not any(piece.below(SIGHT[1], SIGHT[0]).intersects(line) for piece in others)


def is_before(screen: Piece, side: Side) -> bool:
    """Whether a screen hangs or stands with its back to a window."""
    zone = side.before(BEFORE)
    return screen.front @ side.wall.inward > 0.7 and screen.footprint.intersection(zone).area > 0.1 * screen.footprint.area


def judge_windows(room: Room) -> Answer | None:
    windows = room.openings(doors=False)
    if not windows:
        return None
    faults = []
    for opening, side in windows:
        zone, sill = side.before(BEFORE).buffer(-0.01), max(opening.sill + OVER_SILL, LOW)
        for piece in room.pieces:
            if piece.high > sill and takes_light(piece, room) and rises_before(piece, (opening.sill + opening.height, sill), zone):
                note = f"{piece.high:.2f} m high before window {opening.id}"
                faults.append(Fault(note, (piece.id,), piece.high - opening.sill))
    return answer(faults)


def rises_before(piece: Piece, heights: tuple[float, float], zone: shapely.Polygon) -> bool:
    """Whether some of a piece between two heights is before a window, and is no tap."""
    shape = piece.below(*heights)
    west, south, east, north = shape.bounds
    return max(east - west, north - south) >= TAP and shape.intersects(zone)


def takes_light(piece: Piece, room: Room) -> bool:
    """Curtains do not, nor lamps of the ceiling, chairs, which are moved, and plants, lamps and small things that are slim."""
    hangs = piece.high > room.height - CEILING and piece.low > OVERHEAD
    if hangs or piece.kind in CURTAINS | CHAIRS | OFFICE_CHAIRS:
        return False
    return max(piece.size) >= SLIM or not (piece.kind in SLIM_KINDS or piece.carrier is not None)


MEASURES = [
    Measure("tv_position", "a screen is seen from a seat or bed, and is before no window", "",
            "30°, 1.2–3.5 diagonals, line of sight", "SMPTE, THX", judge_screens, audit="tv_position"),
    Measure("window_blocked", "no body before a window takes its light", "m", "0.1 over the sill, 0.5 before it", "QUALITY §2",
            judge_windows, audit="window_blocked"),
]
