"""Writes a level that was edited in Blender as a file that roomwright reads.

Beyond Blender's own export with custom properties and lights:
- one level, from its place to the origin; hidden objects too
- copies get an id and name of their own: desk.1@101.001 becomes desk.4@101
- furniture without a parent (from the asset browser, or whose parent was deleted) goes to the room that it stands in
- `parent` of a piece names the piece above it, unless that one only carries the piece that it was arranged by
- the level's seed is a number again, which Blender keeps as text where it is large
"""

import logging
from contextlib import contextmanager
from pathlib import Path

import bpy
from mathutils import Matrix

from .errors import ExportError
from .identities import renew_identities
from .outline import is_inside
from .whole_file import whole_file

# The properties that make up an object's place. A matrix would lose their last digits.
PLACE = ("location", "rotation_quaternion", "rotation_euler", "rotation_axis_angle", "scale")


def levels() -> dict:
    """The levels of the active scene by building/level."""
    return {f"{thing.get('building')}/{thing.get('level')}": thing for thing in bpy.context.scene.objects
            if thing.get("kind") == "level"}


def export_level(path, level: str | None = None) -> list[str]:
    """Writes a level of the active scene to a .glb; a line for each id or name that was not as baked.

    `level` is building/level and may be left out where there is only one. Raises ExportError; nothing is half written,
    and the scene stays as it was.
    """
    root = _root_of(level)
    bpy.context.view_layer.update()
    with whole_file(Path(path).absolute()) as partial:
        strays, notes = _strays(root)
        with _as_alone(root, strays):
            _export_gltf(partial)
        notes += renew_identities(partial)
    return notes


def _root_of(level: str | None):
    found = levels()
    if not found:
        raise ExportError("no level in the scene: no object has a custom property kind that says level\n"
                          "  hint: import with File > Import > glTF or Roomwright bake")
    if level is None and len(found) > 1 or level is not None and level not in found:
        raise ExportError(f"{'which level?' if level is None else f'no level {level}'}; there are {', '.join(sorted(found))}")
    return found[level] if level else next(iter(found.values()))


def _export_gltf(path: Path) -> None:
    silenced = logging.root.manager.disable
    logging.disable(logging.WARNING)  # it has a line for each texture
    try:
        bpy.ops.export_scene.gltf(
            filepath=str(path), export_format="GLB", export_extras=True, export_lights=True,
            export_yup=True, export_animations=False, use_active_scene=True)
    except RuntimeError as error:
        raise ExportError(f"Blender cannot export: {error}") from error
    finally:
        logging.disable(silenced)


def _strays(root) -> tuple[dict, list[str]]:
    """Furniture without a parent, each with the room of the level that it stands in."""
    rooms = [room for level in levels().values() for room in level.children if room.get("kind") == "room"]
    found, notes = {}, []
    for thing in bpy.context.scene.objects:
        if thing.parent is not None or thing.get("kind") != "furniture":
            continue
        room = next((room for room in rooms if _stands_in(thing, room)), None)
        if room is None:
            notes.append(f"{thing.name} has no parent and stands in no room: it is not exported")
        elif room.parent == root:
            found[thing] = room
            notes.append(f"{thing.name} has no parent: it is put into {room.name}")
    return found, notes


def _stands_in(thing, room) -> bool:
    x, y, z = (room.matrix_world.inverted_safe() @ thing.matrix_world).translation
    # Half a metre below the floor is not the level below.
    return -0.5 < z < room.get("height", 3.0) and is_inside((x, y), [tuple(corner) for corner in room["outline"]])


@contextmanager
def _as_alone(root, strays: dict):
    """A level in a scene of its own, at the origin, nothing hidden, strays below their rooms; all undone afterwards."""
    things = [root, *root.children_recursive, *strays, *(one for stray in strays for one in stray.children_recursive)]
    hidden = [thing for thing in things if thing.hide_viewport]
    kept = {thing: {name: getattr(thing, name)[:] for name in PLACE} for thing in (root, *strays)}
    places = {stray: room.matrix_world.inverted_safe() @ stray.matrix_world for stray, room in strays.items()}
    window, before = bpy.context.window, bpy.context.scene
    scene = bpy.data.scenes.new("roomwright export")
    try:
        for thing in things:
            scene.collection.objects.link(thing)
        # Before anything moves: Blender works out places for the scene of the window only.
        window.scene = scene
        for thing in hidden:
            thing.hide_viewport = False
        for stray, room in strays.items():
            stray.parent, stray.matrix_parent_inverse = room, Matrix.Identity(4)
            stray.matrix_basis = places[stray]
        # Far from the origin, numbers lose digits.
        root.matrix_basis = Matrix.Identity(4)
        scene.view_layers[0].update()
        yield
    finally:
        window.scene = before
        for stray in strays:
            stray.parent = None
        for thing, place in kept.items():
            for name, value in place.items():
                setattr(thing, name, value)
        for thing in hidden:
            thing.hide_viewport = True
        bpy.data.scenes.remove(scene)
        bpy.context.view_layer.update()
