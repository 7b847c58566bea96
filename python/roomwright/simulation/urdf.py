"""Levels in URDF, the format of ROS and of most simulators.

Every body is a link, joined to the link `world`: by a hinge or slide, as `floating` where it is free, fixed elsewhere.
"""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement

import numpy as np

from .axes import number, numbers, roll_pitch_yaw, small_numbers
from .bodies import Body, Box, LevelModel
from .doors import RESISTANCE
from .level import shut_pose
from .meshes import CONVEX, Meshes

# The link that stands still: readers know it by this name, and free bodies may hang on nothing else.
WORLD = "world"
KINDS = {"hinge": "revolute", "slide": "prismatic"}
# What URDF demands of every joint with a range: newton metres or newtons, and radians or metres a second.
LIMITS = {"effort": "100", "velocity": "10"}


def level_document(level: LevelModel, meshes: Meshes, mesh_folder: str) -> Element:
    root = Element("robot", name=level.name)
    # MuJoCo's reader drops the folders of meshes unless it is told not to; other readers pass over this element.
    SubElement(SubElement(root, "mujoco"), "compiler", strippath="false", fusestatic="false")
    SubElement(root, "link", name=WORLD)
    colours: dict[tuple, str] = {}
    for body in level.bodies:
        add_link(root, body, meshes, mesh_folder, colours)
        add_joint(root, body)
    return root


def add_link(root: Element, body: Body, meshes: Meshes, mesh_folder: str, colours: dict[tuple, str]) -> None:
    link = SubElement(root, "link", name=body.name)
    if body.inertia is not None:
        inertial = SubElement(link, "inertial")
        SubElement(inertial, "origin", xyz=numbers(body.inertia.centre))
        SubElement(inertial, "mass", value=small_numbers([body.inertia.mass]))
        diagonal = {f"i{axis}{axis}": small_numbers([value]) for axis, value in zip("xyz", body.inertia.diagonal)}
        SubElement(inertial, "inertia", **diagonal, ixy="0", ixz="0", iyz="0")
    for visual in body.visuals:
        seen = SubElement(link, "visual")
        add_mesh(seen, f"{mesh_folder}/{meshes.file_name(visual.name, visual.surface)}")
        # Colours have names that all links share.
        name = colours.setdefault(visual.rgba, f"colour_{len(colours)}")
        SubElement(SubElement(seen, "material", name=name), "color", rgba=numbers(visual.rgba))
    for collider in body.colliders:
        shape = SubElement(link, "collision")
        if isinstance(collider, Box):
            add_origin(shape, collider.centre, collider.turn)
            SubElement(SubElement(shape, "geometry"), "box", size=numbers(2 * collider.half))
        else:
            add_mesh(shape, f"{mesh_folder}/{meshes.file_name(CONVEX, collider)}")


def add_mesh(parent: Element, file: str) -> None:
    SubElement(SubElement(parent, "geometry"), "mesh", filename=file)


def add_joint(root: Element, body: Body) -> None:
    kind = "floating" if body.is_free else KINDS[body.joint.kind] if body.joint is not None else "fixed"
    joint = SubElement(root, "joint", name=f"{body.name}/joint", type=kind)
    pose = body.pose if body.joint is None else shut_pose(body)
    add_origin(joint, pose[:3, 3], pose[:3, :3])
    SubElement(joint, "parent", link=WORLD)
    SubElement(joint, "child", link=body.name)
    if body.joint is not None:
        SubElement(joint, "axis", xyz=numbers(body.joint.axis))
        SubElement(joint, "limit", lower=number(body.joint.low), upper=number(body.joint.high), **LIMITS)
        damping, friction = RESISTANCE[body.joint.kind]
        SubElement(joint, "dynamics", damping=number(damping), friction=number(friction))


def add_origin(parent: Element, position: np.ndarray, turn: np.ndarray) -> None:
    SubElement(parent, "origin", xyz=numbers(position), rpy=numbers(roll_pitch_yaw(turn)))
