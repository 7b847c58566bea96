"""Converted floors read back through composed stages, compared with their glTF files both ways."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
from pxr import Usd, UsdGeom, UsdShade, UsdValidation

from roomwright import convert
from roomwright.gltf_file import GltfFile
from roomwright.usd.floor import Written
from roomwright.usd.settings import Settings

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


def geometry_of(prim) -> Usd.Prim:
    """The finest mesh of a node's prim, or the instance that has it."""
    return prim.GetChild(prim.GetName()) or prim.GetChild(f"{prim.GetName()}_mesh")


def bound_materials(mesh) -> list[UsdShade.Material]:
    """The materials of a mesh's parts, in the order of the glTF file's primitives."""
    parts = [child for child in mesh.GetFilteredChildren(Usd.TraverseInstanceProxies()) if child.IsA(UsdGeom.Subset)]
    return [UsdShade.MaterialBindingAPI(part).ComputeBoundMaterial()[0] for part in parts or [mesh]]


def mesh_prims(prim) -> list[Usd.Prim]:
    """The meshes below a prim, through instances."""
    return [each for each in Usd.PrimRange(prim, Usd.TraverseInstanceProxies()) if each.IsA(UsdGeom.Mesh)]


def world_points(mesh) -> np.ndarray:
    """The corners of a mesh's triangles, in order."""
    points = np.array(UsdGeom.Mesh(mesh).GetPointsAttr().Get(), float)
    indices = np.array(UsdGeom.Mesh(mesh).GetFaceVertexIndicesAttr().Get())
    matrix = world_of(mesh)
    return (points @ matrix[:3, :3].T + matrix[:3, 3])[indices]


def node_points(gltf, node) -> np.ndarray:
    """The same of a node of a glTF file, one primitive after the other."""
    return np.concatenate([
        (primitive["positions"] @ node.world[:3, :3].T + node.world[:3, 3])[primitive["triangles"].reshape(-1)]
        for primitive in gltf.primitives(node.mesh)])


def assert_same_parts(mesh, gltf, node):
    """Its subsets are the primitives, one after the other, with their materials."""
    primitives, first = gltf.primitives(node.mesh), 0
    subsets = [UsdGeom.Subset(child) for child in mesh.GetFilteredChildren(Usd.TraverseInstanceProxies())]
    assert len(subsets) == (len(primitives) if len(primitives) > 1 else 0), node.name
    for subset, primitive in zip(subsets, primitives):
        last = first + len(primitive["triangles"])
        assert list(subset.GetIndicesAttr().Get()) == list(range(first, last))
        first = last
    names = [gltf.name_of("materials", primitive["material"]) for primitive in primitives]
    assert [material.GetPrim().GetDisplayName() for material in bound_materials(mesh)] == names, node.name


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
    """Every node's mesh is one with the same corners in the world and the same parts, and there are no others."""
    prims = {prim.GetCustomDataByKey("name"): prim for prim in node_prims(stage)}
    known = set()
    for node in gltf.nodes:
        if node.mesh is None:
            continue
        (mesh,) = mesh_prims(geometry_of(prims[node.name]))
        np.testing.assert_allclose(world_points(mesh), node_points(gltf, node) @ turn[:3, :3].T, atol=PLACE_TOLERANCE)
        assert_same_parts(mesh, gltf, node)
        known.add(mesh.GetPath())
    assert {mesh.GetPath() for mesh in mesh_prims(stage.GetPseudoRoot())} == known


def assert_valid(stage):
    """No validator that comes with USD has anything to say."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    issues = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [f"{issue.GetIdentifier()}: {issue.GetMessage()}" for issue in issues] == []
