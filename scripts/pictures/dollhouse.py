"""The camera that looks down from outside, over the walls that would hide the rooms."""

from __future__ import annotations

import math

import numpy as np

from .camera import FILLED, SENSOR, WALLS, Camera
from .cuts import level_cuts, room_cuts
from .floor_view import Level, Room

# Millimetres of the lens, degrees above the horizon and off the normal of the longest wall.
LENS, ELEVATION, OFFSET = 60.0, 42.0, 32.0


def dollhouse(level: Level, room: Room | None, aspect: float) -> Camera:
    """Looks down from outside, over the walls that would hide the rooms."""
    rooms = [room] if room else level.rooms
    azimuth = _azimuth(level, rooms)
    toward = np.array([math.cos(azimuth), math.sin(azimuth)])
    cuts = room_cuts(rooms[0], toward) if len(rooms) == 1 else level_cuts(level, toward)
    return fit(_wall_points(rooms, cuts), azimuth, aspect, cuts)


def _azimuth(level: Level, rooms: list[Room]) -> float:
    """Of four directions beside the normals of the longest wall, the one whose view the least furniture stands in."""
    room = max(rooms, key=lambda one: _longest_edge(one)[0])
    normal = _longest_edge(room)[1]
    turns = [sign * math.radians(OFFSET) + half for half in (0.0, math.pi) for sign in (1, -1)]
    return min((normal + turn for turn in turns), key=lambda azimuth: round(_hidden(level, rooms, azimuth), 6))


def _longest_edge(room: Room) -> tuple[float, float]:
    """Metres of the longest wall, and the direction of its outward normal in radians."""
    lengths = [round(float(np.linalg.norm(end - start)), 3) for start, end in room.wall_edges()]
    edge = lengths.index(max(lengths))
    outward = room.outward(edge)
    return max(lengths), math.atan2(outward[1], outward[0])


def _hidden(level: Level, rooms: list[Room], azimuth: float) -> float:
    """How much stands on the camera's side: tall furniture counts against it, windows there too."""
    toward = np.array([math.cos(azimuth), math.sin(azimuth)])
    total = 0.0
    for room in rooms:
        for box in level.boxes_of(room):
            nearness = float((box.corners.mean(axis=0) - room.middle()) @ toward)
            width = float(np.linalg.norm(box.corners[1] - box.corners[0]))
            total += width * max(box.high - 0.8, 0.0) * nearness * (not box.parent.startswith("ceiling"))
        for opening, side in level.openings_of(room):
            if opening.kind == "window":
                total += 0.25 * opening.width * float(room.outward(side["wall"]) @ toward)
    return total


def _wall_points(rooms: list[Room], cuts: dict[tuple[str, int], float]) -> np.ndarray:
    """The corners that a picture must hold: below and on top of all walls."""
    points = []
    for room in rooms:
        for edge, ends in enumerate(room.wall_edges()):
            top_of_wall = cuts.get((room.name, edge), room.height)
            # The outer corners: past the wall itself and the one before or after it.
            outward = room.outward(edge) * WALLS
            beside = (room.outward(edge - 1) * WALLS, room.outward((edge + 1) % len(room.outline)) * WALLS)
            points += [(*(end + outward + side), height) for end, side in zip(ends, beside)
                       for height in (-0.1, top_of_wall + 0.4)]
    return np.array(points)


def fit(points: np.ndarray, azimuth: float, aspect: float, cuts: dict[tuple[str, int], float]) -> Camera:
    """The nearest camera in a direction whose picture holds all points, centred."""
    elevation = math.radians(ELEVATION)
    back = np.array([math.cos(azimuth) * math.cos(elevation), math.sin(azimuth) * math.cos(elevation),
                     math.sin(elevation)])
    right = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    up = np.cross(back, right)
    reach = SENSOR / 2 / LENS * FILLED
    limits = np.array([reach * min(aspect, 1.0), reach / max(aspect, 1.0)])
    target, distance = points.mean(axis=0), 1.0
    for _ in range(12):
        offset = points - target
        across = np.stack([offset @ right, offset @ up], axis=1)
        distance = float((np.abs(across) / limits + (offset @ back)[:, None]).max())
        seen = across / (distance - offset @ back)[:, None]
        middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
        target = target + (right * middle[0] + up * middle[1]) * distance
    position = target + back * distance
    return Camera("dollhouse", tuple(position), tuple(-back), tuple(up), lens=LENS, cuts=cuts)
