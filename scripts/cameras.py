"""Where a camera stands to show a level or a room: from above, as a dollhouse, from a person's eyes.

The choice depends on the file only. Plan coordinates and metres as in floor_view.py. Needs numpy only.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from floor_view import Box, Level, Room, distances, is_inside

# Millimetres of the sensor's width; Blender's default.
SENSOR = 36.0
# Share of a picture's half that the scene fills.
FILLED = 0.94
# Millimetres of lenses, degrees above the horizon and off the normal of the longest wall.
DOLLHOUSE_LENS, EYE_LENS = 60.0, 20.0
DOLLHOUSE_ELEVATION, DOLLHOUSE_OFFSET = 42.0, 32.0
# Metres at which walls are cut in pictures from above and of whole levels, and where near walls of a room end.
CUT, STUB = 1.2, 0.1
# Metres of walls around the outline that a picture shows too.
WALLS = 0.3
EYE_HEIGHT = 1.6
# What stands as high as this stops a person's view.
TALL = 1.4
# What is not above this stands on the floor or on a rug.
STANDS = 0.02


@dataclass(frozen=True)
class Camera:
    """A camera in plan coordinates, and the walls (room, number) that it looks through."""

    view: str
    position: tuple[float, float, float]
    forward: tuple[float, float, float]
    up: tuple[float, float, float]
    lens: float = 50.0
    # Metres of a parallel picture's longer side; zero for a perspective.
    scale: float = 0.0
    # Share of the picture's longer side by which the horizon moves up.
    shift: float = 0.0
    # Metres at which a wall ends; walls that are not listed stand whole.
    cuts: dict[tuple[str, int], float] = field(default_factory=dict)


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


def dollhouse(level: Level, room: Room | None, aspect: float) -> Camera:
    """Looks down from outside, over the walls that would hide the rooms."""
    rooms = [room] if room else level.rooms
    azimuth = _dollhouse_azimuth(level, rooms)
    toward = np.array([math.cos(azimuth), math.sin(azimuth)])
    cuts = room_cuts(rooms[0], toward) if len(rooms) == 1 else level_cuts(level, toward)
    return fit(_wall_points(rooms, cuts), azimuth, aspect, cuts)


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


def opening_cuts(level: Level, cuts: dict[tuple[str, int], float]) -> dict[str, float]:
    """Where the parts of openings in cut walls end, by the names of their nodes."""
    found = {}
    for opening in level.openings:
        heights = [cuts[key] for side in opening.sides if (key := (side["room"], side["wall"])) in cuts]
        if heights:
            found[opening.node] = min(heights)
    return found


def hidden_furniture(level: Level, cuts: dict[tuple[str, int], float]) -> set[str]:
    """Nodes of what hangs from ceilings, or on walls above where they are cut."""
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


def _has_rooms_behind(level: Level, point: np.ndarray, direction: np.ndarray) -> bool:
    steps = np.arange(0.5, 60.0, 0.25)[:, None]
    return any(is_inside(point + direction * steps, room).any() for room in level.rooms)


def _dollhouse_azimuth(level: Level, rooms: list[Room]) -> float:
    """Of four directions beside the normals of the longest wall, the one whose view the least furniture stands in."""
    room = max(rooms, key=lambda one: _longest_edge(one)[0])
    normal = _longest_edge(room)[1]
    turns = [sign * math.radians(DOLLHOUSE_OFFSET) + half for half in (0.0, math.pi) for sign in (1, -1)]
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
    elevation = math.radians(DOLLHOUSE_ELEVATION)
    back = np.array([math.cos(azimuth) * math.cos(elevation), math.sin(azimuth) * math.cos(elevation),
                     math.sin(elevation)])
    right = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    up = np.cross(back, right)
    reach = SENSOR / 2 / DOLLHOUSE_LENS * FILLED
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
    return Camera("dollhouse", tuple(position), tuple(-back), tuple(up), lens=DOLLHOUSE_LENS, cuts=cuts)


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
    return Camera("eye", (*place, height), forward, (0, 0, 1), lens=EYE_LENS, shift=-0.08)


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
    half = math.atan(SENSOR / 2 / EYE_LENS)
    best = (-1.0, 0.0)
    for direction in np.radians(np.arange(0.0, 360.0, 5.0)):
        apart = np.abs((angles - direction + math.pi) % (2 * math.pi) - math.pi)
        # What is in the middle counts more, so that the view is centred on it.
        score = float(np.where(apart < half, 1.0 - 0.3 * apart / half, 0.0).sum())
        if score > best[0] + 1e-9:
            best = (score, float(direction))
    return best[1], best[0]
