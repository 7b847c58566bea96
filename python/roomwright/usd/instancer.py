"""Small objects as one PointInstancer a room; on request.

An object that is smaller than the threshold in every direction, has a mesh and nothing below it (no light, no other
object) is an entry of the room's `small_objects` instead of a prim: for renderers it costs a matrix. Names, extras and ids
of the entries are in the instancer's customData, in the order of its arrays. If the object below an entry is moved, the
entry stays where it is.
"""

from __future__ import annotations

import json

import numpy as np
from pxr import Gf, Sdf, UsdGeom, Vt

from ..gltf_file import GltfFile, Node

from .geometry import Geometry
from .specs import Types, attribute, new_prim, relationship
from .variants import LOD_EXTENSION

INSTANCER = "small_objects"
PROTOTYPES = "Prototypes"


def small_nodes(gltf: GltfFile, below: float) -> dict[int, list[Node]]:
    """The nodes that become entries, by the index of their room's node."""
    parents = {node.parent.index for node in gltf.nodes if node.parent is not None}
    small: dict[int, list[Node]] = {}
    for node in gltf.nodes:
        room = room_of(node)
        if room is None or node.index in parents or not is_small(gltf, node, below):
            continue
        small.setdefault(room.index, []).append(node)
    return small


def is_small(gltf: GltfFile, node: Node, below: float) -> bool:
    extensions = gltf.entry("nodes", node.index).get("extensions", {})
    is_plain = node.kind == "furniture" and node.mesh is not None and LOD_EXTENSION not in extensions
    return is_plain and max(node.extras["size"]) < below and is_rigid(node.world)


def is_rigid(world: np.ndarray) -> bool:
    """An entry has a turn and a scale, but can be neither sheared nor mirrored."""
    scale = np.linalg.norm(world[:3, :3], axis=0)
    turn = world[:3, :3] / scale
    return bool(np.abs(turn.T @ turn - np.identity(3)).max() < 1e-5 and np.linalg.det(turn) > 0.0)


def room_of(node: Node) -> Node | None:
    while node is not None and node.kind != "room":
        node = node.parent
    return node


def write_instancer(room_prim: Sdf.PrimSpec, room: Node, nodes: list[Node], geometry: Geometry) -> None:
    prim = new_prim(room_prim, INSTANCER, "PointInstancer")
    scope = new_prim(prim, PROTOTYPES, "Scope")
    meshes = sorted({node.mesh for node in nodes})
    targets = []
    for number, mesh in enumerate(meshes):
        targets.append(str(geometry.write_use(scope, f"model{number}", mesh).path))
    relationship(prim, "prototypes", targets)
    attribute(prim, "protoIndices", Types.IntArray, Vt.IntArray([meshes.index(node.mesh) for node in nodes]))
    attribute(prim, "ids", Types.Int64Array, Vt.Int64Array(list(range(len(nodes)))))
    places = np.linalg.inv(room.world) @ np.stack([node.world for node in nodes])
    write_places(prim, places)
    write_extent(prim, places, nodes, geometry.gltf)
    extras = [json.dumps(node.extras, sort_keys=True) for node in nodes]
    names = [node.name for node in nodes]
    prim.SetInfo("customData", {"names": Vt.StringArray(names), "extras": Vt.StringArray(extras)})


def write_places(prim: Sdf.PrimSpec, places: np.ndarray) -> None:
    """Positions, turns and scales; turns in single precision, for halves would miss a millimetre on a metre."""
    scales = np.linalg.norm(places[:, :3, :3], axis=1)
    positions = np.ascontiguousarray(places[:, :3, 3], np.float32)
    attribute(prim, "positions", Types.Point3fArray, Vt.Vec3fArray.FromNumpy(positions))
    turns = [turn_of(place[:3, :3] / scale) for place, scale in zip(places, scales)]
    attribute(prim, "orientationsf", Types.QuatfArray, Vt.QuatfArray(turns))
    attribute(prim, "scales", Types.Float3Array, Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(scales, np.float32)))


def turn_of(matrix: np.ndarray) -> Gf.Quatf:
    return Gf.Quatf(Gf.Matrix3d(*matrix.T.reshape(-1).tolist()).ExtractRotation().GetQuat())


def write_extent(prim: Sdf.PrimSpec, places: np.ndarray, nodes: list[Node], gltf: GltfFile) -> None:
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for place, node in zip(places, nodes):
        for primitive in gltf.primitives(node.mesh):
            corners = primitive["positions"] @ place[:3, :3].T + place[:3, 3]
            low, high = np.minimum(low, corners.min(axis=0)), np.maximum(high, corners.max(axis=0))
    extent = Vt.Vec3fArray([Gf.Vec3f(*low.tolist()), Gf.Vec3f(*high.tolist())])
    attribute(prim, UsdGeom.Tokens.extent, Types.Float3Array, extent)
