"""The models of a contact sheet in Blender, each moved into its cell of the picture's plane. Needs bpy."""

from __future__ import annotations

import logging
import math
from pathlib import Path

import bpy  # before mathutils, which it brings
from mathutils import Matrix, Vector

from .contact_grid import ACROSS, CELL, FILLED, LABEL, group_cells, names_of
from .glass import thin_glass
from .light import add_sky, aim
from .quality import set_cycles

# Where the camera looks from: degrees around from a model's front, and above it.
AROUND, ABOVE = 32.0, 24.0


def render_grid(models: Path, picture: Path, samples: int, looks: int) -> list[str]:
    """Renders all models of a file; their names in the order of the cells."""
    logging.disable(logging.INFO)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(models), loglevel=50)
    thin_glass()
    scene = bpy.context.scene
    bpy.context.view_layer.update()
    things = {thing.name: thing for thing in scene.objects if thing.type == "MESH"}
    names = names_of(list(things))
    axes = _axes()
    for name, (column, row) in zip(names, group_cells(len(names), looks)):
        group = [things[f"item-{name}-{look}"] for look in range(looks) if f"item-{name}-{look}" in things]
        _put_in_row(group, axes, column, row)
    rows = group_cells(len(names), looks)[-1][1] + 1
    _set_camera(scene, axes, rows)
    _set_light(scene, axes)
    _set_picture(scene, picture, rows, samples)
    bpy.ops.render.render(write_still=True)
    return names


def _axes() -> Matrix:
    """Columns: the picture's right, up, and toward the camera. Models face -y after the import."""
    around, above = math.radians(AROUND), math.radians(ABOVE)
    back = Vector((math.sin(around) * math.cos(above), -math.cos(around) * math.cos(above), math.sin(above)))
    right = Vector((0, 0, 1)).cross(back).normalized()
    return Matrix((right, back.cross(right), back)).transposed()


def _put_in_row(group: list, axes: Matrix, column: int, row: int) -> None:
    """Scales the looks of a model alike and moves each into its cell; a cell is one unit wide."""
    extents = [_extent(thing, axes) for thing in group]
    factor = FILLED / max(max(high.x - low.x, high.y - low.y) for low, high in extents)
    pitch = (CELL + LABEL) / CELL
    for look, (thing, (low, high)) in enumerate(zip(group, extents)):
        middle = (low + high) / 2
        cell = Vector((column + look + 0.5, -row * pitch - 0.5, 0.0))
        move = Matrix.Translation(axes @ cell) @ Matrix.Scale(factor, 4) @ Matrix.Translation(-(axes @ middle))
        thing.matrix_world = move @ thing.matrix_world


def _extent(thing, axes: Matrix) -> tuple[Vector, Vector]:
    """Lower and upper bounds along the picture's axes, of the corners as they are."""
    turn = axes.transposed() @ thing.matrix_world.to_3x3()
    offset = axes.transposed() @ thing.matrix_world.translation
    corners = [turn @ corner.co + offset for corner in thing.data.vertices]
    low, high = (Vector([pick(corner[axis] for corner in corners) for axis in range(3)]) for pick in (min, max))
    return low, high


def _set_camera(scene, axes: Matrix, rows: int) -> None:
    height = rows * (CELL + LABEL) / CELL
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", max(float(ACROSS), height)
    camera.data.clip_end = 1000.0
    middle = axes @ Vector((ACROSS / 2, -height / 2, 50.0))
    camera.matrix_world = Matrix.Translation(middle) @ axes.to_4x4()
    scene.collection.objects.link(camera)
    scene.camera = camera


def _set_light(scene, axes: Matrix) -> None:
    """Nearly from the camera, so that no model stands in another's shadow."""
    sky = add_sky(scene)
    sky.inputs["Color"].default_value = (0.9, 0.95, 1.0, 1.0)
    sky.inputs["Strength"].default_value = 1.1
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 2.5, math.radians(10.0)
    aim(sun, axes @ Vector((0.35, -0.45, -1.0)))
    scene.collection.objects.link(sun)


def _set_picture(scene, picture: Path, rows: int, samples: int) -> None:
    render = scene.render
    render.engine, render.film_transparent, render.filepath = "CYCLES", True, str(picture)
    render.resolution_x, render.resolution_y = ACROSS * CELL, rows * (CELL + LABEL)
    render.resolution_percentage = 100
    render.image_settings.file_format, render.image_settings.color_mode = "PNG", "RGBA"
    set_cycles(scene.cycles, samples)
    scene.view_settings.view_transform = "AgX"
    scene.view_settings.look = "AgX - Medium High Contrast"
    scene.view_settings.exposure = -0.1
