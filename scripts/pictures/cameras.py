"""Where a camera stands to show a level or a room: from above, as a dollhouse, from a person's eyes.

The choice depends on the file only. Plan coordinates and metres as in floor_view.py.
"""

from __future__ import annotations

import numpy as np

from .camera import FILLED, WALLS, Camera
from .cuts import CUT
from .dollhouse import dollhouse
from .eye import eye
from .floor_view import Level, Room


def choose(level: Level, room: Room | None, view: str, aspect: float) -> Camera:
    """The camera for a view ("top", "dollhouse" or "eye") of a room, or of all rooms.

    `aspect` is the picture's width by its height.
    """
    if view == "top":
        return top(level, room, aspect)
    if view == "dollhouse":
        return dollhouse(level, room, aspect)
    return eye(level, room or largest(level))


def largest(level: Level) -> Room:
    """The room with the largest rectangle around it; the first of equals."""
    return max(level.rooms, key=lambda room: float(np.ptp(room.outline, axis=0).prod()))


def top(level: Level, room: Room | None, aspect: float) -> Camera:
    """Looks down, north up."""
    rooms = [room] if room else level.rooms
    corners = np.vstack([one.outline for one in rooms])
    low, high = corners.min(axis=0) - WALLS, corners.max(axis=0) + WALLS
    width, depth = (high - low) / FILLED
    scale = max(width, depth * aspect) if aspect >= 1 else max(depth, width / aspect)
    x, y = (low + high) / 2
    height = max(one.height for one in rooms) + 10.0
    cuts = {(one.name, edge): CUT for one in rooms for edge in range(len(one.outline))}
    return Camera("top", (x, y, height), (0, 0, -1), (0, 1, 0), scale=scale, cuts=cuts)
