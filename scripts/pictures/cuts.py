"""Which walls a camera looks over, and what is hidden with them.

Heights in metres by wall: the room's id and the number of its edge. Walls that are not listed stand whole.
"""

from __future__ import annotations

import math

import numpy as np

from .floor_view import Box, Level, Room, is_inside

# Metres at which walls are cut in pictures from above and of whole levels, and where near walls of a room end.
CUT, STUB = 1.2, 0.1
# Metres: an object that begins below this stands on the floor or on a rug.
STANDS = 0.02


def room_cuts(room: Room, toward: np.ndarray) -> dict[tuple[str, int], float]:
    """The walls of a room that stand between it and a camera in that direction."""
    near = [edge for edge in range(len(room.outline)) if float(room.outward(edge) @ toward) > 0.05]
    return {(room.name, edge): STUB for edge in near}


def level_cuts(level: Level, toward: np.ndarray) -> dict[tuple[str, int], float]:
    """All walls but those with nothing behind them."""
    cuts = {}
    for room in level.rooms:
        for edge, (start, end) in enumerate(room.wall_edges()):
            is_near = float(room.outward(edge) @ toward) > -0.05
            if is_near or _has_rooms_behind(level, (start + end) / 2, -toward):
                cuts[room.name, edge] = CUT
    return cuts


def _has_rooms_behind(level: Level, point: np.ndarray, direction: np.ndarray) -> bool:
    steps = np.arange(0.5, 60.0, 0.25)[:, None]
    return any(is_inside(point + direction * steps, room).any() for room in level.rooms)


def opening_cuts(level: Level, cuts: dict[tuple[str, int], float]) -> dict[str, float]:
    """Where the parts of openings in cut walls end, by the names of their nodes."""
    found = {}
    for opening in level.openings:
        heights = [cuts[key] for side in opening.sides if (key := (side["room"], side["wall"])) in cuts]
        if heights:
            found[opening.node] = min(heights)
    return found


def hidden_furniture(level: Level, cuts: dict[tuple[str, int], float]) -> set[str]:
    """Nodes of objects on ceilings, or on walls above the cut."""
    cut_openings = opening_cuts(level, cuts)
    return {box.name for box in level.boxes if _hangs(level, box, cuts, cut_openings)}


def _hangs(level: Level, box: Box, cuts: dict[tuple[str, int], float], cut_openings: dict[str, float]) -> bool:
    part, _, number = box.parent.partition(".")
    if part == "ceiling":
        return True
    if part == "wall" and number.isdigit():
        return box.low > 0.3 and box.high > cuts.get((box.room, int(number)), math.inf)
    # A car belongs to its gate as curtains do to their window, but stands on the floor.
    return box.low > STANDS and box.parent in cut_openings and box.high > cut_openings[box.parent]
