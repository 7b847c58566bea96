"""Levels and buildings in MJCF, the format of MuJoCo.

All bodies are children of the world, for a free body may not be anything else there; a level's place in its building is
added to each of them. Shapes that are seen are in group 2, shapes that collide in group 3, which viewers hide.
"""

from __future__ import annotations

import copy
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from .axes import number, numbers, quaternion, small_numbers
from .bodies import Body, Box, Joint, LevelModel
from .doors import RESISTANCE
from .meshes import CONVEX, Meshes

# Seconds of a step, as MuJoCo's own default.
TIME_STEP = 0.002
UNTURNED = np.array([1.0, 0.0, 0.0, 0.0])


def level_document(level: LevelModel, meshes: Meshes, mesh_folder: str) -> Element:
    """The document of a level; `mesh_folder` leads from its file to the meshes."""
    root = empty_document(level.name, mesh_folder)
    assets, world, contact = (root.find(name) for name in ("asset", "worldbody", "contact"))
    known: set[str] = set()

    def mesh(name: str, surface) -> str:
        file = meshes.file_name(name, surface)
        own = file.removesuffix(".obj")
        if own not in known:
            known.add(own)
            SubElement(assets, "mesh", name=own, file=file)
        return own

    for body in level.bodies:
        add_body(world, body, mesh)
        for other in body.apart:
            SubElement(contact, "exclude", body1=body.name, body2=other)
    return root


def empty_document(name: str, mesh_folder: str) -> Element:
    root = Element("mujoco", model=name)
    SubElement(root, "compiler", angle="radian", meshdir=mesh_folder)
    SubElement(root, "option", timestep=number(TIME_STEP), integrator="implicitfast", cone="elliptic")
    # Rooms have no lights of their own here, and MuJoCo's own headlight leaves them dark.
    SubElement(SubElement(root, "visual"), "headlight", ambient="0.4 0.4 0.4", diffuse="0.6 0.6 0.6", specular="0.1 0.1 0.1")
    defaults = SubElement(root, "default")
    # The models have sheets, such as pictures, that have no volume to weigh.
    SubElement(defaults, "mesh", inertia="shell")
    seen = SubElement(defaults, "default", {"class": "visual"})
    SubElement(seen, "geom", type="mesh", contype="0", conaffinity="0", group="2", mass="0")
    SubElement(SubElement(defaults, "default", {"class": "collision"}), "geom", group="3")
    for kind, (damping, friction) in RESISTANCE.items():
        SubElement(SubElement(defaults, "default", {"class": kind}), "joint", type=kind, damping=number(damping),
                   frictionloss=number(friction))
    for section in ("asset", "worldbody", "contact"):
        SubElement(root, section)
    return root


def add_body(world: Element, body: Body, mesh) -> None:
    element = SubElement(world, "body", name=body.name, **place(body.pose[:3, 3], body.pose[:3, :3]))
    if body.is_free:
        SubElement(element, "freejoint", name=body.name)
    if body.joint is not None:
        add_joint(element, body.name, body.joint)
    if body.inertia is not None:
        SubElement(element, "inertial", pos=numbers(body.inertia.centre), mass=small_numbers([body.inertia.mass]),
                   diaginertia=small_numbers(body.inertia.diagonal))
    for visual in body.visuals:
        SubElement(element, "geom", {"class": "visual"}, mesh=mesh(visual.name, visual.surface), rgba=numbers(visual.rgba))
    for collider in body.colliders:
        if isinstance(collider, Box):
            SubElement(element, "geom", {"class": "collision"}, type="box", size=numbers(collider.half),
                       **place(collider.centre, collider.turn))
        else:
            SubElement(element, "geom", {"class": "collision"}, type="mesh", mesh=mesh(CONVEX, collider))


def add_joint(element: Element, name: str, joint: Joint) -> None:
    """A joint whose value is 0 where the leaf is shut, and `ref` where the file has it."""
    SubElement(element, "joint", {"class": joint.kind}, name=name, axis=numbers(joint.axis), ref=number(joint.now),
               range=numbers((joint.low, joint.high)))


def place(position: np.ndarray, turn: np.ndarray) -> dict[str, str]:
    """The attributes of a place; what is not moved or turned has none."""
    attributes = {"pos": numbers(position), "quat": numbers(quaternion(turn))}
    unmoved = {"pos": "0 0 0", "quat": numbers(UNTURNED)}
    return {key: value for key, value in attributes.items() if value != unmoved[key]}


def building_document(name: str, levels: Iterable[tuple[Element, float]]) -> Element:
    """All levels of a building at their elevations; the documents of the levels stand in the same folder."""
    root = None
    known: set[str] = set()
    for level, elevation in levels:
        if root is None:
            root = empty_document(name, level.find("compiler").get("meshdir"))
        for mesh in level.find("asset"):
            if mesh.get("name") not in known:
                known.add(mesh.get("name"))
                root.find("asset").append(copy.deepcopy(mesh))
        for body in level.find("worldbody"):
            root.find("worldbody").append(lifted(body, elevation))
        root.find("contact").extend(copy.deepcopy(list(level.find("contact"))))
    return root


def lifted(body: Element, elevation: float) -> Element:
    own = copy.deepcopy(body)
    x, y, z = (float(value) for value in own.get("pos", "0 0 0").split())
    own.set("pos", numbers((x, y, z + elevation)))
    return own


def text_of(root: Element) -> bytes:
    ElementTree.indent(root, "  ")
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"
