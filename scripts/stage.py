"""A baked level in Blender: what is shown, the light, the camera, the picture. Needs bpy.

The importer's axes are the plan's (floor_view.py), so cameras need no conversion.
"""

from __future__ import annotations

import logging
import math
import tempfile
from dataclasses import dataclass
from pathlib import Path

import bpy  # before bmesh and mathutils, which it brings
import bmesh
import numpy as np
from mathutils import Matrix, Vector

from cameras import Camera, hidden_furniture, opening_cuts
from floor_view import Level, Room
from wall_parts import split_walls

ENGINES = {"cycles": "CYCLES", "eevee": "BLENDER_EEVEE", "workbench": "BLENDER_WORKBENCH"}
CUT_COLORS = {"top": (0.02, 0.021, 0.024, 1.0), "dollhouse": (0.12, 0.123, 0.13, 1.0)}
# Panes of windows, seen from outside and above: what lies behind them is the paper.
PANE_COLOR = (0.62, 0.72, 0.78, 1.0)
SKY_COLOR, SUN_COLOR = (0.80, 0.90, 1.0), (1.0, 0.93, 0.82)
# Watts per square metre of the sun, strength of the sky, by view.
SUNLIGHT = {"top": 2.2, "dollhouse": 3.0, "eye": 5.0}
SKYLIGHT = {"top": 0.9, "dollhouse": 0.7, "eye": 1.5}
# Watts per square metre of floor that a soft light under the ceiling adds indoors.
FILL = 3.0
# Luminance that the pictures' mean is brought to, and how many stops that may take.
MIDDLE_GREY, LEAST_STOPS, MOST_STOPS = 0.30, -4.0, 6.0


@dataclass(frozen=True)
class Quality:
    """How a picture is made."""

    width: int = 960
    height: int = 720
    samples: int = 64
    engine: str = "cycles"
    is_transparent: bool = False


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
        self.caps = {view: _plain_material(f"cut {view}", color) for view, color in CUT_COLORS.items()}
        self.extra_lights: list = []
        _let_light_through(self.objects)
        self.panes = _panes(self.objects)
        self.pane = _plain_material("pane", PANE_COLOR)
        thin_glass()
        self.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        self.sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
        for thing in (self.camera, self.sun):
            self.scene.collection.objects.link(thing)
        self.scene.camera = self.camera
        self.sky = add_sky(self.scene)

    def take(self, camera: Camera, room: Room | None, quality: Quality, path: Path) -> None:
        """Renders one picture to a PNG file."""
        self._show(camera, room)
        self._place(camera)
        self._light(camera, room)
        self._set_quality(camera, quality)
        if quality.engine != "workbench":
            self._expose(camera)
        self.scene.render.filepath = str(path.resolve())
        bpy.ops.render.render(write_still=True)

    def _show(self, camera: Camera, room: Room | None) -> None:
        for thing in self.objects:
            thing.hide_render = False
            if thing.data is not self.data[thing]:
                cut_mesh, thing.data = thing.data, self.data[thing]
                bpy.data.meshes.remove(cut_mesh)
        for thing, index, glass in self.panes:
            thing.material_slots[index].material = glass if camera.view == "eye" else self.pane
        if camera.view == "eye":
            return
        bpy.context.view_layer.update()
        hidden = hidden_furniture(self.level, camera.cuts)
        cuts = opening_cuts(self.level, camera.cuts)
        for thing in self.objects:
            chain = list(_ancestors(thing))
            if self._is_elsewhere(chain, room) or _is_ceiling(thing) or any(one.name in hidden for one in chain):
                thing.hide_render = True
            elif (height := self._cut_of(thing, chain, camera, cuts)) is not None:
                self._cut(thing, height, self.caps[camera.view])

    def _is_elsewhere(self, chain: list, room: Room | None) -> bool:
        """Whether it belongs to another room than the one that is shown."""
        if room is None:
            return False
        for one in chain:
            if one.get("kind") == "room":
                return one["room"] != room.name
            if one.get("kind") == "opening":
                return room.name not in list(one["rooms"])
        return False

    def _cut_of(self, thing, chain: list, camera: Camera, cuts: dict[str, float]) -> float | None:
        if thing.type != "MESH" or thing.get("kind") != "part":
            return None
        part, parent = thing["part"], chain[1] if len(chain) > 1 else None
        if part == "floor" or parent is None:
            return None
        if parent.get("kind") == "opening":
            return cuts.get(parent.name)
        number = str(thing.get("id", "")).partition(".")[2].partition(".")[0]
        if part in ("wall", "socket", "switch") and number.isdigit():
            return camera.cuts.get((parent["room"], int(number)))
        # Columns and the like end where the walls do, where all walls end.
        return max(camera.cuts.values(), default=None) if camera.view == "top" else None

    def _cut(self, thing, height: float, cap) -> None:
        """Takes away what is above a height and closes the cut."""
        levels = [(thing.matrix_world @ Vector(corner)).z for corner in thing.bound_box]
        if min(levels) >= height - 1e-4:
            thing.hide_render = True
            return
        if max(levels) <= height + 1e-4:
            return
        thing.data = thing.data.copy()
        thing.data.materials.append(cap)
        _bisect(thing.data, thing.matrix_world, height, len(thing.data.materials) - 1)

    def _place(self, camera: Camera) -> None:
        forward, up = Vector(camera.forward), Vector(camera.up)
        right = forward.cross(up).normalized()
        axes = Matrix((right, right.cross(forward), -forward)).transposed()
        self.camera.matrix_world = Matrix.Translation(camera.position) @ axes.to_4x4()
        lens = self.camera.data
        lens.type = "ORTHO" if camera.scale else "PERSP"
        lens.ortho_scale, lens.lens, lens.shift_y = camera.scale or 1.0, camera.lens, camera.shift
        lens.clip_start, lens.clip_end = 0.05, 2000.0

    def _light(self, camera: Camera, room: Room | None) -> None:
        for light in self.extra_lights:
            bpy.data.objects.remove(light)
        self.extra_lights.clear()
        self.sky.inputs["Color"].default_value = (*SKY_COLOR, 1.0)
        self.sky.inputs["Strength"].default_value = SKYLIGHT[camera.view]
        self.sun.data.energy, self.sun.data.color = SUNLIGHT[camera.view], SUN_COLOR
        self.sun.data.angle = math.radians(6.0 if camera.view == "eye" else 12.0)
        aim(self.sun, _sun_direction(self.level, room, camera))
        if camera.view == "eye":
            for one in self.level.rooms:
                self._add_fill(one)

    def _add_fill(self, room: Room) -> None:
        """A soft light under the ceiling, as photographers of rooms use one."""
        width, depth = (np.ptp(room.outline, axis=0) * 0.8).tolist()
        data = bpy.data.lights.new("fill", "AREA")
        data.shape, data.size, data.size_y = "RECTANGLE", width, depth
        data.energy, data.specular_factor = FILL * width * depth, 0.0
        light = bpy.data.objects.new("fill", data)
        light.location = (*room.middle(), room.height - 0.05)
        light.visible_camera = light.visible_glossy = False
        self.scene.collection.objects.link(light)
        self.extra_lights.append(light)

    def _set_quality(self, camera: Camera, quality: Quality) -> None:
        render = self.scene.render
        render.engine = ENGINES[quality.engine]
        render.resolution_x, render.resolution_y, render.resolution_percentage = quality.width, quality.height, 100
        render.film_transparent = camera.view != "eye"
        render.image_settings.file_format = "PNG"
        render.image_settings.color_mode = "RGBA"
        if quality.engine == "cycles":
            set_cycles(self.scene.cycles, quality.samples)
        elif quality.engine == "eevee":
            self.scene.eevee.taa_render_samples = quality.samples
        else:
            _set_workbench(self.scene.display)
        view = self.scene.view_settings
        view.view_transform = "Standard" if quality.engine == "workbench" else "AgX"
        view.look = "None" if quality.engine == "workbench" else "AgX - Medium High Contrast"
        view.exposure = 0.0

    def _expose(self, camera: Camera) -> None:
        """Brings the middle of a small picture's brightness to a usual one, as a camera does."""
        render, settings = self.scene.render, self.scene.render.image_settings
        size, samples = (render.resolution_x, render.resolution_y), self.scene.cycles.samples
        largest = max(size)
        render.resolution_x, render.resolution_y = (max(8, round(side * 96 / largest)) for side in size)
        settings.file_format, self.scene.cycles.samples = "OPEN_EXR", 8
        with tempfile.TemporaryDirectory() as folder:
            render.filepath = str(Path(folder) / "small.exr")
            bpy.ops.render.render(write_still=True)
            image = bpy.data.images.load(render.filepath)
            pixels = np.array(image.pixels[:]).reshape(-1, 4)
            bpy.data.images.remove(image)
        render.resolution_x, render.resolution_y = size
        settings.file_format, self.scene.cycles.samples = "PNG", samples
        self.scene.view_settings.exposure = stops(pixels)


def stops(pixels: np.ndarray) -> float:
    """Stops of exposure for linear pixels, rows of red, green, blue and cover."""
    seen = pixels[pixels[:, 3] > 0.5]
    if not len(seen):
        return 0.0
    luminance = np.clip(seen[:, :3] @ (0.2126, 0.7152, 0.0722), 1e-4, 8.0)
    # The geometric mean lets a bright window and a dark corner weigh alike.
    mean = math.exp(float(np.log(luminance).mean()))
    return min(max(math.log2(MIDDLE_GREY / mean), LEAST_STOPS), MOST_STOPS)


def _ancestors(thing):
    while thing is not None:
        yield thing
        thing = thing.parent


def _is_ceiling(thing) -> bool:
    return thing.get("part") == "ceiling"


def _let_light_through(objects: list) -> None:
    """Panes stop neither the sun nor the sky: few samples would not find the way through them."""
    for thing in objects:
        if thing.get("part") == "glass":
            thing.visible_shadow = thing.visible_diffuse = False


def _panes(objects: list) -> list[tuple]:
    """Glass of the shell: object, slot, material. The slots become the objects' own, for meshes are shared."""
    found = []
    for thing in objects:
        for index, slot in enumerate(thing.material_slots if thing.get("kind") == "part" else []):
            if slot.material is not None and any(_is_clear(one) for one in _shaders(slot.material)):
                glass, slot.link = slot.material, "OBJECT"
                slot.material = glass
                found.append((thing, index, glass))
    return found


def _shaders(material) -> list:
    tree = material.node_tree
    return [one for one in (tree.nodes if tree else []) if one.type == "BSDF_PRINCIPLED"]


def _is_clear(shader) -> bool:
    inputs = shader.inputs
    is_seen_through = inputs["Transmission Weight"].default_value > 0.5 or inputs["Alpha"].default_value < 0.5
    return is_seen_through and not inputs["Alpha"].is_linked


def thin_glass() -> None:
    """Clear materials become thin panes: refraction needs many more samples than a small picture has."""
    for material in bpy.data.materials:
        for shader in _shaders(material):
            inputs = shader.inputs
            if _is_clear(shader):
                inputs["Transmission Weight"].default_value = 0.0
                inputs["Alpha"].default_value = min(inputs["Alpha"].default_value, 0.2)
                inputs["Roughness"].default_value = 0.1


def _plain_material(name: str, color: tuple) -> object:
    material = bpy.data.materials.new(name)
    if material.node_tree is None:
        material.use_nodes = True
    shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = color
    shader.inputs["Roughness"].default_value = 1.0
    material.diffuse_color = color
    return material


def add_sky(scene):
    scene.world = bpy.data.worlds.new("sky")
    if scene.world.node_tree is None:
        scene.world.use_nodes = True
    nodes = scene.world.node_tree.nodes
    return next(node for node in nodes if node.type == "BACKGROUND")


def aim(thing, direction: Vector) -> None:
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = direction.to_track_quat("-Z", "Y")


def _sun_direction(level: Level, room: Room | None, camera: Camera) -> Vector:
    """The way of the sun's light: from the upper left of the picture, or indoors through a window."""
    if camera.view == "top":
        return Vector((0.5, -0.55, -1.4))
    if camera.view == "eye":
        for one in [room] if room else level.rooms:
            for opening, side in level.openings_of(one):
                if opening.kind == "window":
                    outward = one.outward(side["wall"])
                    along = (-outward[1], outward[0])
                    return Vector((-outward[0] + 0.55 * along[0], -outward[1] + 0.55 * along[1], -0.75))
        return Vector((0.5, -0.5, -0.7))
    forward = Vector(camera.forward)
    right = forward.cross(Vector((0, 0, 1))).normalized()
    ahead = Vector((forward.x, forward.y, 0)).normalized()
    return right * 0.75 + ahead * 0.35 + Vector((0, 0, -1.15))


def _bisect(mesh, world: Matrix, height: float, cap: int) -> None:
    point = world.inverted_safe() @ Vector((0, 0, height))
    normal = (world.to_3x3().transposed() @ Vector((0, 0, 1))).normalized()
    shape = bmesh.new()
    shape.from_mesh(mesh)
    # The file has corners once per face; the cut closes where edges meet.
    bmesh.ops.remove_doubles(shape, verts=shape.verts, dist=1e-5)
    everything = shape.verts[:] + shape.edges[:] + shape.faces[:]
    cut = bmesh.ops.bisect_plane(shape, geom=everything, plane_co=point, plane_no=normal, clear_outer=True)
    edges = [one for one in cut["geom_cut"] if isinstance(one, bmesh.types.BMEdge)]
    if edges:
        filled = bmesh.ops.triangle_fill(shape, edges=edges, use_beauty=True)
        for face in (one for one in filled["geom"] if isinstance(one, bmesh.types.BMFace)):
            face.material_index, face.smooth = cap, False
    shape.to_mesh(mesh)
    shape.free()


def set_cycles(cycles, samples: int) -> None:
    cycles.device, cycles.seed, cycles.samples = "CPU", 0, samples
    cycles.use_adaptive_sampling = False
    cycles.use_denoising, cycles.denoiser = True, "OPENIMAGEDENOISE"
    cycles.denoising_input_passes, cycles.denoising_prefilter = "RGB_ALBEDO_NORMAL", "FAST"
    cycles.max_bounces, cycles.diffuse_bounces, cycles.glossy_bounces = 5, 3, 2
    cycles.transmission_bounces, cycles.transparent_max_bounces = 4, 8
    cycles.caustics_reflective = cycles.caustics_refractive = False
    cycles.sample_clamp_indirect = 6.0


def _set_workbench(display) -> None:
    display.shading.light, display.shading.color_type = "STUDIO", "TEXTURE"
    display.shading.show_cavity, display.shading.show_shadows = True, True
    display.render_aa = "8"
