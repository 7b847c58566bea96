"""The walls of a room, which a bake merges to one mesh, as objects of their own again. Needs bpy.

Pictures cut each wall at a height of its own. A face belongs to the wall whose edge of the room all of its corners are nearest
to: that is true of both sides of a wall and of what is fixed to it.
"""

from __future__ import annotations

import bpy  # before bmesh, which it brings
import bmesh
import numpy as np

from .floor_view import Level, Room

# Metres from an edge of the room beyond which a face belongs to none: walls around holes, columns.
FARTHEST = 1.0


def split_walls(objects: list, level: Level) -> list:
    """Hides every merged mesh of walls behind one object a wall; gives all objects that are shown."""
    rooms = {room.name: room for room in level.rooms}
    shown = []
    for thing in objects:
        room = rooms.get(thing.parent.get("room")) if thing.parent is not None else None
        if thing.type == "MESH" and thing.get("part") == "walls" and room is not None:
            shown.extend(_split(thing, room))
        else:
            shown.append(thing)
    return shown


def _split(thing, room: Room) -> list:
    walls = nearest_edges(face_corners(thing), room)
    parts = [_part(thing, np.flatnonzero(walls == wall), int(wall)) for wall in np.unique(walls)]
    bpy.data.objects.remove(thing)
    return parts


def face_corners(thing) -> list[np.ndarray]:
    """The corners of each face in plan metres, n x 2."""
    world = np.array(thing.matrix_world)
    own = np.array([(*vertex.co, 1.0) for vertex in thing.data.vertices])
    plan = (own @ world.T)[:, :2]
    return [plan[list(face.vertices)] for face in thing.data.polygons]


def nearest_edges(faces: list[np.ndarray], room: Room) -> np.ndarray:
    """The number of the edge that each face belongs to, or -1."""
    edges = room.wall_edges()
    starts, ends = (np.array([edge[side] for edge in edges]) for side in (0, 1))
    along = ends - starts
    lengths = np.maximum((along ** 2).sum(axis=1), 1e-12)
    found = []
    for corners in faces:
        offsets = corners[:, None, :] - starts[None]
        shares = np.clip((offsets * along).sum(axis=2) / lengths, 0.0, 1.0)
        distances = np.linalg.norm(offsets - shares[..., None] * along, axis=2).max(axis=0)
        nearest = int(distances.argmin())
        found.append(nearest if distances[nearest] < FARTHEST else -1)
    return np.array(found, dtype=int)


def _part(thing, faces: np.ndarray, wall: int):
    """A copy of an object that has only some of its faces."""
    part = thing.copy()
    part.data = thing.data.copy()
    part["part"], part["id"] = ("wall", f"wall.{wall}") if wall >= 0 else ("column", "column")
    for collection in thing.users_collection:
        collection.objects.link(part)
    shape = bmesh.new()
    shape.from_mesh(part.data)
    shape.faces.ensure_lookup_table()
    kept = set(faces.tolist())
    others = [face for face in shape.faces if face.index not in kept]
    bmesh.ops.delete(shape, geom=others, context="FACES")
    shape.to_mesh(part.data)
    shape.free()
    return part
