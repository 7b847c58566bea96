"""A baked level in Blender: what is shown, and the picture. Needs bpy.

The importer's axes are the plan's (floor_view.py), so cameras need no conversion.
"""

from __future__ import annotations

import logging
from pathlib import Path

import bpy  # before mathutils, which it brings
from mathutils import Matrix, Vector

from .camera import Camera
from .cuts import hidden_furniture, opening_cuts
from .floor_view import Level, Room
from .glass import PANE_COLOR, let_light_through, panes, plain_material, thin_glass
from .light import Lighting
from .quality import Quality, expose, set_quality
from .sections import CUT_COLORS, cut_open, height_of_cut
from .wall_parts import split_walls


class Stage:
    """One file, loaded; takes one picture after the other."""

    def __init__(self, path: Path, level: Level):
        logging.disable(logging.INFO)  # the importer has a line for each mesh
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.import_scene.gltf(filepath=str(path.resolve()), loglevel=50)
        self.level = level
        self.scene = bpy.context.scene
        bpy.context.view_layer.update()
        self.objects = split_walls(list(self.scene.objects), level)
        self.data = {thing: thing.data for thing in self.objects}
        self.caps = {view: plain_material(f"cut {view}", color) for view, color in CUT_COLORS.items()}
        let_light_through(self.objects)
        self.panes = panes(self.objects)
        self.pane = plain_material("pane", PANE_COLOR)
        thin_glass()
        self.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        self.scene.collection.objects.link(self.camera)
        self.scene.camera = self.camera
        self.lighting = Lighting(self.scene)

    def take(self, camera: Camera, room: Room | None, quality: Quality, path: Path) -> None:
        """Renders one picture to a PNG file."""
        self._show_all(camera)
        if camera.view != "eye":
            self._cut_open(camera, room)
        self._place(camera)
        self.lighting.set(self.level, room, camera)
        set_quality(self.scene, quality, is_transparent=camera.view != "eye")
        if quality.engine != "workbench":
            expose(self.scene)
        self.scene.render.filepath = str(path.resolve())
        bpy.ops.render.render(write_still=True)

    def _show_all(self, camera: Camera) -> None:
        for thing in self.objects:
            thing.hide_render = False
            if thing.data is not self.data[thing]:
                cut_mesh, thing.data = thing.data, self.data[thing]
                bpy.data.meshes.remove(cut_mesh)
        for thing, index, glass in self.panes:
            thing.material_slots[index].material = glass if camera.view == "eye" else self.pane

    def _cut_open(self, camera: Camera, room: Room | None) -> None:
        bpy.context.view_layer.update()
        hidden = hidden_furniture(self.level, camera.cuts)
        cuts = opening_cuts(self.level, camera.cuts)
        for thing in self.objects:
            chain = list(_ancestors(thing))
            if _is_elsewhere(chain, room) or _is_ceiling(thing) or any(one.name in hidden for one in chain):
                thing.hide_render = True
            elif (height := height_of_cut(thing, chain, camera, cuts)) is not None:
                cut_open(thing, height, self.caps[camera.view])

    def _place(self, camera: Camera) -> None:
        forward, up = Vector(camera.forward), Vector(camera.up)
        right = forward.cross(up).normalized()
        axes = Matrix((right, right.cross(forward), -forward)).transposed()
        self.camera.matrix_world = Matrix.Translation(camera.position) @ axes.to_4x4()
        lens = self.camera.data
        lens.type = "ORTHO" if camera.scale else "PERSP"
        lens.ortho_scale, lens.lens, lens.shift_y = camera.scale or 1.0, camera.lens, camera.shift
        lens.clip_start, lens.clip_end = 0.05, 2000.0


def _is_elsewhere(chain: list, room: Room | None) -> bool:
    """Whether it belongs to another room than the one that is shown."""
    if room is None:
        return False
    for one in chain:
        if one.get("kind") == "room":
            return one["room"] != room.name
        if one.get("kind") == "opening":
            return room.name not in list(one["rooms"])
    return False


def _ancestors(thing):
    while thing is not None:
        yield thing
        thing = thing.parent


def _is_ceiling(thing) -> bool:
    return thing.get("part") == "ceiling"
