"""The sun, the sky and the lights of a picture. Needs bpy."""

from __future__ import annotations

import math

import bpy  # before mathutils, which it brings
import numpy as np
from mathutils import Vector

from .camera import Camera
from .floor_view import Level, Room

SKY_COLOR, SUN_COLOR = (0.80, 0.90, 1.0), (1.0, 0.93, 0.82)
# Watts per square metre of the sun, strength of the sky, by view.
SUNLIGHT = {"top": 2.2, "dollhouse": 3.0, "eye": 5.0}
SKYLIGHT = {"top": 0.9, "dollhouse": 0.7, "eye": 1.5}
# Watts per square metre of floor that a soft light under the ceiling adds indoors.
FILL = 3.0


class Lighting:
    """The light of one scene, set anew for each picture."""

    def __init__(self, scene):
        self.scene = scene
        self.sky = add_sky(scene)
        self.sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
        self.fills: list = []
        scene.collection.objects.link(self.sun)

    def set(self, level: Level, room: Room | None, camera: Camera) -> None:
        for light in self.fills:
            bpy.data.objects.remove(light)
        self.fills.clear()
        self.sky.inputs["Color"].default_value = (*SKY_COLOR, 1.0)
        self.sky.inputs["Strength"].default_value = SKYLIGHT[camera.view]
        self.sun.data.energy, self.sun.data.color = SUNLIGHT[camera.view], SUN_COLOR
        self.sun.data.angle = math.radians(6.0 if camera.view == "eye" else 12.0)
        aim(self.sun, _sun_direction(level, room, camera))
        if camera.view == "eye":
            for one in level.rooms:
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
        self.fills.append(light)


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
        return _through_window([room] if room else level.rooms, level) or Vector((0.5, -0.5, -0.7))
    forward = Vector(camera.forward)
    right = forward.cross(Vector((0, 0, 1))).normalized()
    ahead = Vector((forward.x, forward.y, 0)).normalized()
    return right * 0.75 + ahead * 0.35 + Vector((0, 0, -1.15))


def _through_window(rooms: list[Room], level: Level) -> Vector | None:
    """Aslant through the first window of rooms."""
    for room in rooms:
        for opening, side in level.openings_of(room):
            if opening.kind == "window":
                outward = room.outward(side["wall"])
                along = (-outward[1], outward[0])
                return Vector((-outward[0] + 0.55 * along[0], -outward[1] + 0.55 * along[1], -0.75))
    return None
