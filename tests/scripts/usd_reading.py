"""Converted floors read back through composed stages, compared with their glTF files both ways."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
from pxr import Usd, UsdGeom, UsdValidation

import convert
from gltf_file import GltfFile
from usd.floor import Written
from usd.settings import Settings
from usd.variants import GEOMETRY

# Metres.
PLACE_TOLERANCE = 1e-4


def converted(source: Path, target: Path, **settings) -> Usd.Stage:
    """Converts one file into a folder that is its own root, and opens it."""
    settings = {"root": target.parent, "ending": target.suffix, "started": float(int(time.time())), **settings}
    answer = convert.convert_file(convert.Job(source, target, Settings(**settings)))
    assert isinstance(answer, Written), answer
    return Usd.Stage.Open(str(target))


def node_prims(stage) -> list[Usd.Prim]:
    """The prims that stand for nodes, parents before children, in the file's order."""
    return [prim for prim in stage.Traverse() if "name" in prim.GetCustomData()]


def world_of(prim) -> np.ndarray:
    return np.array(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())).T


def mesh_prims(prim) -> list[Usd.Prim]:
    """The meshes below a prim, through instances."""
    return [each for each in Usd.PrimRange(prim, Usd.TraverseInstanceProxies()) if each.IsA(UsdGeom.Mesh)]


def world_points(mesh) -> np.ndarray:
    """The corners of a mesh's triangles, in order."""
    points = np.array(UsdGeom.Mesh(mesh).GetPointsAttr().Get(), float)
    indices = np.array(UsdGeom.Mesh(mesh).GetFaceVertexIndicesAttr().Get())
    matrix = world_of(mesh)
    return (points @ matrix[:3, :3].T + matrix[:3, 3])[indices]


def node_points(gltf, node) -> list[np.ndarray]:
    """The same of each primitive of a node of a glTF file."""
    return [(primitive["positions"] @ node.world[:3, :3].T + node.world[:3, 3])[primitive["triangles"].reshape(-1)]
            for primitive in gltf.primitives(node.mesh)]


def assert_same_tree(stage, gltf: GltfFile, turn=np.identity(4)):
    prims = node_prims(stage)
    assert [prim.GetCustomDataByKey("name") for prim in prims] == [node.name for node in gltf.nodes]
    for prim, node in zip(prims, gltf.nodes):
        assert prim.GetDisplayName() == node.name
        parent = prim.GetParent().GetCustomDataByKey("name")
        assert parent == (node.parent.name if node.parent else None)
    assert_same_places(stage, gltf, turn)


def assert_same_places(stage, gltf: GltfFile, turn=np.identity(4)):
    """Every node has its prim, in the same place of the world."""
    prims = {prim.GetCustomDataByKey("name"): prim for prim in node_prims(stage)}
    assert sorted(prims) == sorted(node.name for node in gltf.nodes)
    for node in gltf.nodes:
        np.testing.assert_allclose(world_of(prims[node.name]), turn @ node.world, atol=PLACE_TOLERANCE)


def assert_same_meshes(stage, gltf: GltfFile, turn=np.identity(4)):
    """Every primitive of every node is a mesh with the same corners in the world, and there are no others."""
    prims = {prim.GetCustomDataByKey("name"): prim for prim in node_prims(stage)}
    known = set()
    for node in gltf.nodes:
        if node.mesh is None:
            continue
        meshes = mesh_prims(prims[node.name].GetChild(GEOMETRY))
        expected = [corners @ turn[:3, :3].T for corners in node_points(gltf, node)]
        assert len(meshes) == len(expected), node.name
        for mesh, corners in zip(meshes, expected):
            np.testing.assert_allclose(world_points(mesh), corners, atol=PLACE_TOLERANCE)
            known.add(mesh.GetPath())
    assert {mesh.GetPath() for mesh in mesh_prims(stage.GetPseudoRoot())} == known


def assert_valid(stage):
    """No validator that comes with USD has anything to say."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    issues = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [f"{issue.GetIdentifier()}: {issue.GetMessage()}" for issue in issues] == []
