"""Colliders, bodies, masses and joints, as UsdPhysics describes them; on request.

  - Parts of the building, such as walls, floors, stairs and frames, collide as the triangles that they are.
  - Each piece of furniture is a body of its own, at rest until something touches it. A piece that is mounted (see
    physics.json) or fixed to the building collides and does not move. USD has no bodies inside bodies: every piece is a child
    of its room here, also a piece on a desk. `parent` in the customData names the desk.
  - Door leaves turn about their hinges between shut and open.
Densities are data: physics.json.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
from pxr import Gf, Sdf

from ..gltf_file import GltfFile, Node

from .placing import Swing, degrees_about_the_vertical
from .specs import Types, apply_schemas, attribute, new_prim, relationship

TABLE = Path(__file__).with_name("physics.json")
STATIC = "none"  # triangles as they are, for what never moves
# Metres over the floor above which a piece whose parent is a wall or the ceiling is fixed to it.
HANGING = 0.05
# Metres per second squared.
GRAVITY = 9.81
JOINT = "hinge"


@cache
def table() -> dict:
    return json.loads(TABLE.read_text())


@cache
def properties_of(class_name: str) -> dict:
    """Density and shape of a class: the first entry of the table that shares a word with it."""
    for entry in table()["furniture"]:
        if any(f"_{word}_" in f"_{class_name}_" for word in entry["words"]):
            return entry
    return table()["default"]


def collider_of(node: Node) -> str:
    """The shape of a node's mesh for a simulator."""
    if node.kind == "furniture":
        return properties_of(node.extras["class"])["shape"]
    return table()["leaf"]["shape"] if node.extras.get("part") == "leaf" else STATIC


def add_collider(mesh: Sdf.PrimSpec, collider: str) -> None:
    if collider:
        apply_schemas(mesh, "PhysicsCollisionAPI", "PhysicsMeshCollisionAPI")
        attribute(mesh, "physics:approximation", Types.Token, collider, is_uniform=True)


def write_scene(layer: Sdf.Layer, up_axis: str) -> None:
    """Gravity, beside the default prim: what is referenced by others brings none along."""
    scene = new_prim(layer.pseudoRoot, "PhysicsScene", "PhysicsScene")
    down = Gf.Vec3f(0, 0, -1) if up_axis == "Z" else Gf.Vec3f(0, -1, 0)
    attribute(scene, "physics:gravityDirection", Types.Vector3f, down)
    attribute(scene, "physics:gravityMagnitude", Types.Float, GRAVITY)
    layer.pseudoRoot.SetInfo("kilogramsPerUnit", 1.0)


def is_fixed(node: Node) -> bool:
    """Whether a piece stays where it is."""
    if properties_of(node.extras["class"]).get("fixed"):
        return True
    stands_on_piece = node.parent is not None and node.parent.kind == "furniture"
    return not stands_on_piece and node.world[1, 3] > HANGING


def write_body(prim: Sdf.PrimSpec, kilograms: float) -> None:
    apply_schemas(prim, "PhysicsRigidBodyAPI", "PhysicsMassAPI")
    attribute(prim, "physics:startsAsleep", Types.Bool, True, is_uniform=True)
    attribute(prim, "physics:mass", Types.Float, kilograms)


def furniture_mass(node: Node) -> float:
    """Kilograms, by the volume of the box; the mass of a piece that was scaled by hand follows its `size`."""
    return float(properties_of(node.extras["class"])["density"] * np.prod(node.extras["size"]))


def leaf_mass(gltf: GltfFile, mesh: int) -> float:
    return float(table()["leaf"]["density"] * sum(volume(primitive) for primitive in gltf.primitives(mesh)))


def volume(primitive: dict) -> float:
    """Cubic metres inside a closed surface, by the tetrahedra between its triangles and the origin."""
    corners = primitive["positions"].astype(float)[primitive["triangles"]]
    return abs(float(np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum()) / 6.0)


def write_hinge(opening: Sdf.PrimSpec, name: str, frame: tuple[Sdf.PrimSpec, np.ndarray],
                leaf: tuple[Sdf.PrimSpec, np.ndarray], swing: Swing) -> None:
    """A revolute joint between a frame and a leaf, both with their places in the opening.

    The joint's angle is 0 where the leaf is shut, so that its limits are those of the leaf's `rotateY:swing`. The
    leaf does not collide with its frame, which it touches when it is shut.
    """
    from_frame = np.linalg.inv(frame[1]) @ leaf[1]
    shut = Gf.Rotation(Gf.Vec3d(0, 1, 0), degrees_about_the_vertical(from_frame) - swing.now)
    joint = new_prim(opening, name, "PhysicsRevoluteJoint")
    relationship(joint, "physics:body0", [str(frame[0].path)])
    relationship(joint, "physics:body1", [str(leaf[0].path)])
    attribute(joint, "physics:localPos0", Types.Point3f, Gf.Vec3f(*from_frame[:3, 3].tolist()))
    attribute(joint, "physics:localPos1", Types.Point3f, Gf.Vec3f(0.0))
    attribute(joint, "physics:localRot0", Types.Quatf, Gf.Quatf(shut.GetQuat()))
    attribute(joint, "physics:localRot1", Types.Quatf, Gf.Quatf(1.0))
    attribute(joint, "physics:axis", Types.Token, "Y", is_uniform=True)
    attribute(joint, "physics:collisionEnabled", Types.Bool, False)
    for key, angle in zip(("physics:lowerLimit", "physics:upperLimit"), swing.limits):
        attribute(joint, key, Types.Float, angle)
