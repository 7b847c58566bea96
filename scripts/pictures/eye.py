"""The camera that stands where a person has room to, and looks at the largest part of the room."""

from __future__ import annotations

import math

import numpy as np

from .camera import SENSOR, Camera
from .floor_view import Box, Level, Room, distances, is_inside

# Millimetres of the lens, metres of a person's eyes.
LENS, EYE_HEIGHT = 20.0, 1.6
# Metres: objects of this height stop a person's view.
TALL = 1.4


def eye(level: Level, room: Room) -> Camera:
    """Stands where a person has room to, a corner or a door, and looks at the largest part of the room."""
    boxes = level.boxes_of(room)
    floor = _floor_points(room)
    leaves = [np.array(leaf) for opening, _ in level.openings_of(room) for leaf in opening.leaves]
    sides = _sight_edges(room, boxes, leaves)
    best = None
    for place in _standing_places(level, room, boxes, leaves, floor):
        direction, seen = _best_direction(place, floor[_is_seen(place, floor, sides)])
        if best is None or seen > best[0] + 1e-9:
            best = (seen, place, direction)
    _, place, direction = best
    height = min(EYE_HEIGHT, room.height - 0.3)
    forward = (math.cos(direction), math.sin(direction), 0.0)
    return Camera("eye", (*place, height), forward, (0, 0, 1), lens=LENS, shift=-0.08)


def _floor_points(room: Room, step: float = 0.25) -> np.ndarray:
    low, high = room.outline.min(axis=0), room.outline.max(axis=0)
    step = max(step, float((high - low).max()) / 60)
    x, y = (np.arange(low[axis] + step / 2, high[axis], step) for axis in (0, 1))
    points = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    inside = points[is_inside(points, room)]
    return inside if len(inside) else room.middle()[None]


def _standing_places(level: Level, room: Room, boxes: list[Box], leaves: list[np.ndarray],
                     floor: np.ndarray) -> list[np.ndarray]:
    """Free corners and doors; where there is none, the freest point of the floor."""
    wanted = _corner_places(room) + _door_places(level, room)
    free = [place for place in wanted
            if is_inside(place[None], room)[0] and _space(place, boxes, leaves) >= 0.25]
    if free:
        return free
    return [max(floor, key=lambda place: round(min(_space(place, boxes, leaves), distances(place, room.outline)), 6))]


def _corner_places(room: Room) -> list[np.ndarray]:
    places = []
    for edge, (corner, _) in enumerate(room.wall_edges()):
        inward = -(room.outward(edge) + room.outward(edge - 1))
        places += [corner + inward * inset for inset in (0.3, 0.5, 0.8)]
    return places


def _door_places(level: Level, room: Room) -> list[np.ndarray]:
    places = []
    for opening, side in level.openings_of(room):
        if opening.kind == "door":
            start, end = room.wall_edges()[side["wall"]]
            along = (end - start) / np.linalg.norm(end - start)
            places.append(start + along * (side["from"] + side["to"]) / 2 - room.outward(side["wall"]) * 0.3)
    return places


def _space(place: np.ndarray, boxes: list[Box], leaves: list[np.ndarray]) -> float:
    """Metres to the nearest thing that a person or a view would meet; negative inside one."""
    nearest = [distances(place, leaf) for leaf in leaves]
    for box in boxes:
        if box.high < 0.15 or box.low > 2.1:
            continue
        is_within = is_inside(place[None], Room("", "", "", box.corners, (), 0.0))[0]
        # The view goes over low things, so a camera may stand closer to them.
        ease = 0.15 if box.high < 1.0 else 0.0
        nearest.append(-1.0 if is_within else distances(place, box.corners) + ease)
    return min(nearest, default=10.0)


def _sight_edges(room: Room, boxes: list[Box], leaves: list[np.ndarray]) -> np.ndarray:
    """Edges that stop the view at a person's eyes: n x 2 x 2."""
    rings = [room.outline, *room.holes, *leaves]
    rings += [box.corners for box in boxes if box.high > TALL and box.low < TALL]
    return np.vstack([np.stack([ring, np.roll(ring, -1, axis=0)], axis=1) for ring in rings])


def _is_seen(place: np.ndarray, points: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Which points no edge stands before."""
    ray, side = points - place, edges[:, 1] - edges[:, 0]
    start = edges[:, 0] - place
    cross = ray[:, None, 0] * side[None, :, 1] - ray[:, None, 1] * side[None, :, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        along_ray = (start[:, 0] * side[:, 1] - start[:, 1] * side[:, 0])[None] / cross
        along_side = (start[None, :, 0] * ray[:, None, 1] - start[None, :, 1] * ray[:, None, 0]) / cross
    hits = (along_ray > 1e-6) & (along_ray < 1 - 1e-6) & (along_side >= 0) & (along_side <= 1)
    return ~hits.any(axis=1)


def _best_direction(place: np.ndarray, seen: np.ndarray) -> tuple[float, float]:
    """The direction in radians with the most of the floor in the picture, and how many of its points."""
    if not len(seen):
        return 0.0, 0.0
    angles = np.arctan2(seen[:, 1] - place[1], seen[:, 0] - place[0])
    half = math.atan(SENSOR / 2 / LENS)
    best = (-1.0, 0.0)
    for direction in np.radians(np.arange(0.0, 360.0, 5.0)):
        apart = np.abs((angles - direction + math.pi) % (2 * math.pi) - math.pi)
        # Points in the middle count more, so that the view is centred on the floor.
        score = float(np.where(apart < half, 1.0 - 0.3 * apart / half, 0.0).sum())
        if score > best[0] + 1e-9:
            best = (score, float(direction))
    return best[1], best[0]
