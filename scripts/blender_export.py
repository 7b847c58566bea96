#!/usr/bin/env python3
"""Writes a level that was edited in Blender as a file that roomwright reads: `audit` judges it as it is now.

In Blender (4.2 or newer): Edit > Preferences > Add-ons > Install from Disk, this file; then File > Export > Roomwright
floor. Without a window:
  python scripts/blender_export.py house.blend --level house/ground --out edited.glb
which needs Blender's Python module, scripts/requirements-render.txt. Exit 0: written. 1: the export failed, nothing is
written. 2: nothing could start.

By a script: export_level(path, "house/ground").

Beyond Blender's own export with custom properties and lights:
- one level, from its place to the origin; hidden objects too
- copies get an id and name of their own: desk.1@101.001 becomes desk.4@101
- furniture without a parent (from the asset browser, or whose parent was deleted) goes to the room that it stands in
- `parent` says what each piece hangs below now, unless that only carries what it was arranged by
- the level's seed is a number again, which Blender keeps as text where it is large
"""

import argparse
import json
import logging
import os
import re
import struct
import sys
from contextlib import contextmanager
from pathlib import Path

try:
    import bpy
    from bpy_extras.io_utils import ExportHelper
    from mathutils import Matrix
except ImportError:  # outside of Blender, where only the document can be put in order
    bpy = None

bl_info = {
    "name": "Roomwright floor",
    "description": "Exports a level that was edited, with ids of its own for each copy",
    "author": "Roomwright",
    "version": (1, 0, 0),
    "blender": (4, 2, 0),
    "location": "File > Export > Roomwright floor",
    "category": "Import-Export",
}

# What Blender calls the copy of a piece, whether or not the piece is still there.
COPY = re.compile(r".+@.+\.\d{3,}")
# What a parent is called that is no object: these, or one of them with a number or an id.
PLACES = ("floor", "ceiling", "wall", "column", "door", "window")

PLACE = ("location", "rotation_quaternion", "rotation_euler", "rotation_axis_angle", "scale")


class ExportError(Exception):
    """A level that cannot be exported; the text says why."""


# ------------------------------------------------------------------------------------------- the document


class Order:
    """Puts the ids and names of an exported document in order; `changes` tells what was not as baked."""

    def __init__(self, document: dict):
        self.nodes = document["nodes"]
        self.parents = {child: number for number, node in enumerate(self.nodes) for child in node.get("children", [])}
        self.changes: list[str] = []
        self._names: set[str] = set()

    def settle(self) -> None:
        """Ids, parents, then names, from the roots down."""
        for node in self.nodes:
            extras = node.get("extras", {})
            seed = extras.get("seed")
            if extras.get("kind") == "level" and isinstance(seed, str) and seed.lstrip("-").isdigit():
                extras["seed"] = int(seed)
        for number in self._of_kind("room"):
            self._settle_ids(number)
        for number in self._of_kind("furniture"):
            self._settle_parent(number)
        # What has its name already keeps it, whatever stands before it in the file.
        wanted = [(self._name(number), number) for number in range(len(self.nodes))]
        for name, number in sorted(wanted, key=lambda one: one[0] != self.nodes[one[1]].get("name")):
            self._rename(number, name)

    def _of_kind(self, kind: str) -> list[int]:
        return [number for number, node in enumerate(self.nodes) if self._extras(number).get("kind") == kind]

    def _extras(self, number: int) -> dict:
        return self.nodes[number].get("extras") or {}

    def _above(self, number: int, *kinds: str) -> int | None:
        """The nearest ancestor of one of the kinds."""
        above = self.parents.get(number)
        while above is not None and self._extras(above).get("kind") not in kinds:
            above = self.parents.get(above)
        return above

    def _below(self, number: int) -> list[int]:
        found = list(self.nodes[number].get("children", []))
        for one in found:  # grows as it goes
            found += self.nodes[one].get("children", [])
        return found

    def _settle_ids(self, room: int) -> None:
        """Gives each piece of a room an id of its own; of equal ones that with the baked name keeps it."""
        room_id = self._extras(room).get("room")
        # Where a scene has two rooms of one name, Blender has numbered all that is in the second.
        has_own_names = self.nodes[room].get("name") == f"room:{room_id}"
        pieces = [number for number in self._below(room) if self._extras(number).get("kind") == "furniture"]
        pieces.sort(key=lambda number: (not self._has_baked_name(number, room_id), self.nodes[number].get("name", "")))
        last: dict[str, int] = {}
        for number in pieces:
            class_, _, count = str(self._extras(number).get("id", "")).rpartition(".")
            last[class_] = max(last.get(class_, 0), int(count) if count.isdigit() else 0)
        taken = set()
        for number in pieces:
            extras = self._extras(number)
            is_copy = has_own_names and COPY.fullmatch(self.nodes[number].get("name", ""))
            if is_copy or extras.get("id") in taken or "id" not in extras:
                class_ = str(extras.get("id", "")).rpartition(".")[0] or str(extras.get("class", "piece"))
                last[class_] = last.get(class_, 0) + 1
                extras["id"] = f"{class_}.{last[class_]}"
                self.changes.append(f"{self.nodes[number].get('name')} is a new piece: {extras['id']}@{room_id}")
            taken.add(extras["id"])

    def _has_baked_name(self, number: int, room_id) -> bool:
        return self.nodes[number].get("name") == f"{self._extras(number).get('id')}@{room_id}"

    def _settle_parent(self, number: int) -> None:
        extras, above = self._extras(number), self._above(number, "furniture", "room")
        if self._is_arranged_by_one_above(number, above):
            pass
        elif above is not None and self._extras(above).get("kind") == "furniture":
            extras["parent"] = self._extras(above)["id"]
        elif str(extras.get("parent", "")).partition(".")[0].partition(":")[0] not in PLACES:
            # It hung below an object, or nowhere.
            extras["parent"], extras["side"] = "floor", "above"
        extras.setdefault("side", "above")

    def _is_arranged_by_one_above(self, number: int, above: int | None) -> bool:
        """Whether a piece names another piece of its room, and hangs below that one, what carries it, or the room alone."""
        room = self._above(number, "room")
        if room is None:
            return False
        pieces = {extras.get("id"): extras for extras in map(self._extras, self._below(room))
                  if extras.get("kind") == "furniture"}
        chain, parent = [], pieces.get(self._extras(number).get("parent"))
        while parent is not None and parent["id"] not in chain:
            chain.append(parent["id"])
            parent = pieces.get(parent.get("parent"))
        return bool(chain) and (above == room or self._extras(above).get("id") in chain)

    def _name(self, number: int) -> str:
        """The name that roomwright gives: docs/output.md, "Nodes"."""
        extras, name = self._extras(number), self.nodes[number].get("name", "")
        kind, room = extras.get("kind"), self._above(number, "room")
        room_id = self._extras(room).get("room") if room is not None else None
        if kind == "level":
            return f"{extras.get('building')}/{extras.get('level')}"
        if kind == "room":
            return f"room:{extras.get('room')}"
        if kind == "opening":
            return f"{extras.get('opening')}:{extras.get('id')}"
        if kind == "light" and (lamp := self._above(number, "furniture")) is not None:
            return f"light.{self._extras(lamp)['id']}@{room_id}"
        if kind == "part" and (opening := self._above(number, "opening")) is not None:
            return f"{extras.get('id', extras.get('part'))}@{self._name(opening)}"
        if kind in ("part", "furniture") and room is not None:
            return f"{extras.get('id', extras.get('part'))}@{room_id}"
        return name

    def _rename(self, number: int, name: str) -> None:
        if name in self._names:
            name = self.nodes[number].get("name", "")
            self.changes.append(f"{name} is there twice; roomwright knows the other one")
        self._names.add(name)
        self.nodes[number]["name"] = name


def put_in_order(path: Path) -> list[str]:
    """Rewrites the document of a .glb; what was not as baked."""
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    document = json.loads(data[20:20 + length])
    order = Order(document)
    order.settle()
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    path.write_bytes(struct.pack("<5I", 0x46546C67, 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest)
    return order.changes


def is_inside(point: tuple[float, float], ring: list) -> bool:
    """Whether a point lies within a ring of corners."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


# ------------------------------------------------------------------------------------------------ in Blender


def levels() -> dict:
    """The levels of the active scene by building/level."""
    return {f"{thing.get('building')}/{thing.get('level')}": thing for thing in bpy.context.scene.objects
            if thing.get("kind") == "level"}


def export_level(path, level: str | None = None) -> list[str]:
    """Writes a level of the active scene to a .glb; what was not as baked, a line each.

    `level` is building/level and may be left out where there is only one. Raises ExportError; nothing is half written,
    and the scene stays as it was.
    """
    found, path = levels(), Path(path).absolute()
    if not found:
        raise ExportError("no level in the scene: no object has a custom property kind that says level\n"
                          "  hint: import with File > Import > glTF or Roomwright bake")
    if level is None and len(found) > 1 or level is not None and level not in found:
        raise ExportError(f"{'which level?' if level is None else f'no level {level}'}; there are {', '.join(sorted(found))}")
    root = found[level] if level else next(iter(found.values()))
    bpy.context.view_layer.update()
    with _whole(path) as partial:
        strays, notes = _strays(root)
        with _as_alone(root, strays):
            silenced = logging.root.manager.disable
            logging.disable(logging.WARNING)  # it has a line for each texture
            try:
                bpy.ops.export_scene.gltf(
                    filepath=str(partial), export_format="GLB", export_extras=True, export_lights=True,
                    export_yup=True, export_animations=False, use_active_scene=True)
            except RuntimeError as error:
                raise ExportError(f"Blender cannot export: {error}") from error
            finally:
                logging.disable(silenced)
        notes += put_in_order(partial)
    return notes


def _strays(root) -> tuple[dict, list[str]]:
    """Furniture without a parent, each with the room of the level that it stands in."""
    rooms = [room for level in levels().values() for room in level.children if room.get("kind") == "room"]
    found, notes = {}, []
    for thing in bpy.context.scene.objects:
        if thing.parent is not None or thing.get("kind") != "furniture":
            continue
        room = next((room for room in rooms if _stands_in(thing, room)), None)
        if room is None:
            notes.append(f"{thing.name} has no parent and stands in no room: it is left out")
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
    # To the last digit, which a matrix does not give back.
    kept = {thing: {name: getattr(thing, name)[:] for name in PLACE} for thing in (root, *strays)}
    places = {stray: room.matrix_world.inverted_safe() @ stray.matrix_world for stray, room in strays.items()}
    window, before = bpy.context.window, bpy.context.scene
    scene = bpy.data.scenes.new("roomwright export")
    try:
        for thing in things:
            scene.collection.objects.link(thing)
        # Before anything moves: where things are is worked out for the scene of the window only.
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


@contextmanager
def _whole(path: Path):
    """A temporary name beside a path, which becomes the path when nothing fails."""
    partial = path.with_name(f".{os.getpid()}.{path.name}")
    try:
        yield partial
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


# ------------------------------------------------------------------------------------------------- the window

if bpy is not None:
    class EXPORT_SCENE_OT_roomwright(bpy.types.Operator, ExportHelper):
        """Export a level that was edited, so that roomwright can judge it"""

        bl_idname, bl_label = "export_scene.roomwright", "Export Roomwright floor"
        filename_ext = ".glb"
        filter_glob: bpy.props.StringProperty(default="*.glb", options={"HIDDEN"})
        level: bpy.props.StringProperty(name="Level", description="building/level; empty where there is only one")

        def invoke(self, context, event):
            thing = context.active_object
            while thing is not None and thing.get("kind") != "level":
                thing = thing.parent
            self.level = next((name for name, one in levels().items() if one == thing), "")
            return super().invoke(context, event)

        def execute(self, _context):
            try:
                notes = export_level(self.filepath, self.level or None)
            except (ExportError, OSError) as error:
                self.report({"ERROR"}, str(error))
                return {"CANCELLED"}
            for note in notes:
                self.report({"WARNING"}, note)
            return {"FINISHED"}


def _menu(menu, _context):
    menu.layout.operator("export_scene.roomwright", text="Roomwright floor (.glb)")


def register():
    bpy.utils.register_class(EXPORT_SCENE_OT_roomwright)
    bpy.types.TOPBAR_MT_file_export.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_menu)
    bpy.utils.unregister_class(EXPORT_SCENE_OT_roomwright)


# ------------------------------------------------------------------------------------------ without a window


def _without_blender() -> int:
    """Goes on where Blender's module is, or says how to set it up; an add-on never comes here."""
    import environment

    environment.require(environment.BLENDER, __name__)
    print(environment.how_to_set_up(environment.BLENDER, environment.missing(environment.BLENDER)), file=sys.stderr)
    return 2


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("blend", type=Path, metavar="FILE.blend", help="a saved file with the level in its scene")
    parser.add_argument("--level", metavar="BUILDING/LEVEL", help="needed where there are several")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.glb", help="where to write")
    parser.add_argument("--force", action="store_true", help="replace a file that is there")
    options = parser.parse_args(arguments)
    if options.out.suffix != ".glb":
        parser.error(f"--out {options.out}: the name must end in .glb")
    if options.out.exists() and not options.force:
        parser.error(f"{options.out} is there already; --force replaces it")
    if bpy is None:
        return _without_blender()
    if not options.blend.is_file():
        print(f"{options.blend}: no such file", file=sys.stderr)
        return 2
    try:
        options.out.parent.mkdir(parents=True, exist_ok=True)
        with _quiet():
            bpy.ops.wm.open_mainfile(filepath=str(options.blend.absolute()))
            notes = export_level(options.out, options.level)
    except (ExportError, RuntimeError, OSError) as error:
        print(f"{options.blend}: {error}", file=sys.stderr)
        return 1
    for note in notes:
        print(note, file=sys.stderr)
    print(options.out)
    return 0


@contextmanager
def _quiet():
    """Keeps Blender's own lines off standard output; it writes them past Python."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)


if __name__ == "__main__":
    sys.exit(main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else None))
