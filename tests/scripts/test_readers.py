"""Floors of the demo in other libraries, as these read a file by themselves."""

from __future__ import annotations

from pathlib import Path

import pytest
import trimesh
from pxr import Usd, UsdGeom, UsdUtils

from roomwright import convert
from roomwright.gltf_file import GltfFile

FLOORS = ("house/ground.glb", "office/office.glb")


@pytest.fixture(params=FLOORS)
def path(baked: Path, request) -> Path:
    return baked / request.param


def test_trimesh_finds_every_part_and_texture_by_its_default_resolver(path):
    """Files that refer to `../shared-textures` lost their textures: trimesh reads nothing outside of the file's folder."""
    document = GltfFile(path).document
    materials = {entry["name"]: entry["pbrMetallicRoughness"] for entry in document["materials"]}
    shown = {node["mesh"] for node in document["nodes"] if "mesh" in node}
    scene = trimesh.load(path)
    assert len(scene.geometry) == sum(len(document["meshes"][mesh]["primitives"]) for mesh in shown)
    for part in scene.geometry.values():
        is_textured = "baseColorTexture" in materials[part.visual.material.name]
        assert (part.visual.material.baseColorTexture is not None) == is_textured


def test_usd_opens_with_every_object_and_file_that_it_names(path, tmp_path):
    gltf = GltfFile(path)
    assert convert.main([str(path), "--out", str(tmp_path)]) == 0
    target = next(tmp_path.rglob(f"{path.stem}.usdc"))
    stage = Usd.Stage.Open(str(target))
    prims = stage.Traverse(Usd.TraverseInstanceProxies())
    names = {prim.GetDisplayName() or prim.GetName() for prim in prims if prim.IsA(UsdGeom.Imageable)}
    assert {node.name for node in gltf.nodes} <= names
    _, _, missing = UsdUtils.ComputeAllDependencies(str(target))
    assert not missing
