"""Material variants and levels of detail, from small files that have them."""

import numpy as np
import pytest
from pxr import Gf, Usd, UsdGeom
from usd_reading import assert_same_tree, assert_valid, bound_materials, converted, geometry_of, mesh_prims, world_points

from roomwright.gltf_file import GltfFile

ROOM = "/house_ground/room_101"
RED, BLUE = (0.8, 0.1, 0.1, 1.0), (0.1, 0.1, 0.8, 1.0)


def colors(stage, piece, name=None) -> list:
    prim = stage.GetPrimAtPath(f"{ROOM}/{piece}")
    (mesh,) = mesh_prims(prim.GetChild(name) if name else geometry_of(prim))
    found = [material.ComputeSurfaceSource()[0].GetInput("diffuseColor").Get() for material in bound_materials(mesh)]
    return [tuple(round(part, 3) for part in color) for color in found]


@pytest.fixture
def painted(floor):
    """The desks' lower half is red in one variant and blue in another, the lamp blue in the second."""
    for name, color in (("red", RED), ("blue", BLUE)):
        floor.document["materials"].append(
            {"name": name, "pbrMetallicRoughness": {"baseColorFactor": list(color)}})
    floor.document["extensions"] = {"KHR_materials_variants": {"variants": [{"name": "warm"}, {"name": "default"}]}}

    def mappings(node, *listed):
        mesh = floor.document["meshes"][floor.find(node)["mesh"]]
        mesh["primitives"][0]["extensions"] = {"KHR_materials_variants": {"mappings": [
            {"material": material, "variants": variants} for material, variants in listed]}}

    mappings("desk.1@101", (2, [0]), (3, [1]))
    mappings("lamp.1@101", (3, [1]))
    return floor


@pytest.mark.parametrize("is_self_contained", [False, True])
class TestMaterials:
    """KHR_materials_variants."""

    def test_a_choice_recolours_the_floor(self, painted, tmp_path, is_self_contained):
        source = painted.write(tmp_path / "ground.glb")
        stage = converted(source, tmp_path / "ground.usdc", is_self_contained=is_self_contained)
        assert_valid(stage)
        assert_same_tree(stage, GltfFile(source))
        choice = stage.GetDefaultPrim().GetVariantSet("material")
        # A variant of the file that is called as the file's own materials are has another name here.
        assert choice.GetVariantNames() == ["default", "default_2", "warm"]
        assert choice.GetVariantSelection() == "default"
        wood, glass = (0.5, 0.3, 0.1), (1.0, 1.0, 1.0)
        assert (colors(stage, "desk_1_101"), colors(stage, "desk_2_101/lamp_1_101")) == ([wood, glass], [wood])
        choice.SetVariantSelection("warm")
        assert colors(stage, "desk_1_101") == [RED[:3], glass], "what is not mapped stays"
        assert colors(stage, "desk_2_101/lamp_1_101") == [wood], "a variant that says nothing of it"
        choice.SetVariantSelection("default_2")
        assert (colors(stage, "desk_2_101"), colors(stage, "desk_2_101/lamp_1_101")) == ([BLUE[:3], glass], [BLUE[:3]])
        assert_valid(stage)

    def test_a_piece_may_have_a_choice_of_its_own(self, painted, tmp_path, is_self_contained):
        stage = converted(painted.write(tmp_path / "ground.glb"), tmp_path / "ground.usdc",
                          is_self_contained=is_self_contained)
        geometry_of(stage.GetPrimAtPath(f"{ROOM}/desk_1_101")).GetVariantSet("material").SetVariantSelection("warm")
        assert colors(stage, "desk_1_101")[0] == RED[:3] != colors(stage, "desk_2_101")[0]
        assert_valid(stage)

    def test_instances_of_one_choice_are_one(self, painted, tmp_path, is_self_contained):
        stage = converted(painted.write(tmp_path / "ground.glb"), tmp_path / "ground.usdc",
                          is_self_contained=is_self_contained, has_instances=True)
        desks = [geometry_of(stage.GetPrimAtPath(f"{ROOM}/desk_{number}_101")) for number in (1, 2)]
        assert desks[0].GetPrototype() == desks[1].GetPrototype()
        desks[0].GetVariantSet("material").SetVariantSelection("warm")
        assert desks[0].GetPrototype() != desks[1].GetPrototype()
        assert colors(stage, "desk_1_101")[0] == RED[:3] != colors(stage, "desk_2_101")[0]


def test_a_file_without_variants_has_no_set(floor, tmp_path):
    stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usdc")
    assert [prim.GetPath() for prim in stage.Traverse() if prim.GetVariantSets().GetNames()] == []


class TestDetail:
    """MSFT_lod."""

    @pytest.fixture
    def stage(self, floor, tmp_path):
        """Desks with a coarse mesh of one box, whose node stands as the fine one does, but a tenth of a metre up."""
        coarse = floor.box_mesh("desk.0.lod1", 1.6, 0.8, 0.74)
        for number in (1, 2):
            node = floor.find(f"desk.{number}@101")
            other = {key: node[key] for key in ("rotation", "translation") if key in node}
            other |= {"name": f"desk.{number}@101.lod1", "mesh": coarse}
            other["translation"] = list(np.add(other["translation"], (0.0, 0.1, 0.0)))
            floor.document["nodes"].append(other)
            node["extensions"] = {"MSFT_lod": {"ids": [len(floor.document["nodes"]) - 1]}}
            node["extras"] = {**node["extras"], "MSFT_screencoverage": [0.2, 0.01]}
        self.source = floor.write(tmp_path / "ground.glb")
        return converted(self.source, tmp_path / "ground.usdc")

    def test_the_finest_is_shown_first(self, stage):
        assert_valid(stage)
        assert_same_tree(stage, GltfFile(self.source))
        desk = stage.GetPrimAtPath(f"{ROOM}/desk_1_101")
        assert desk.GetVariantSet("lod").GetVariantNames() == ["lod0", "lod1"]
        assert len(mesh_prims(geometry_of(desk))) == 1 and not desk.GetChild("desk_1_101_lod1").IsActive()
        assert list(desk.GetCustomDataByKey("MSFT_screencoverage")) == [0.2, 0.01]

    def test_the_coarse_mesh_stands_where_its_node_stands(self, stage):
        fine = [world_points(mesh) for mesh in mesh_prims(stage.GetPrimAtPath(f"{ROOM}/desk_2_101/desk_2_101_mesh"))]
        for number in (1, 2):
            stage.GetPrimAtPath(f"{ROOM}/desk_{number}_101").GetVariantSet("lod").SetVariantSelection("lod1")
        assert not stage.GetPrimAtPath(f"{ROOM}/desk_2_101/desk_2_101_mesh").IsActive()
        coarse = [world_points(mesh) for mesh in mesh_prims(stage.GetPrimAtPath(f"{ROOM}/desk_2_101/desk_2_101_mesh_lod1"))]
        assert (len(fine), len(coarse)) == (1, 1)
        low, high = np.concatenate(fine).min(axis=0), np.concatenate(fine).max(axis=0)
        np.testing.assert_allclose(coarse[0].min(axis=0), low + (0, 0.1, 0), atol=1e-4)
        np.testing.assert_allclose(coarse[0].max(axis=0), high + (0, 0.1, 0), atol=1e-4)
        assert stage.GetPrimAtPath(f"{ROOM}/desk_2_101/lamp_1_101"), "what stands on it stays"
        assert_valid(stage)

    def test_coarse_meshes_are_shared(self, stage):
        for number in (1, 2):
            stage.GetPrimAtPath(f"{ROOM}/desk_{number}_101").GetVariantSet("lod").SetVariantSelection("lod1")
        meshes = [stage.GetPrimAtPath(f"{ROOM}/{path}") for path in ("desk_1_101/desk_1_101_lod1",
                                                                     "desk_2_101/desk_2_101_mesh_lod1")]
        assert [mesh.GetInherits().GetAllDirectInherits() for mesh in meshes] \
            == [["/house_ground/Prototypes/desk_0_lod1"]] * 2


def test_detail_and_materials_together(painted, tmp_path):
    node = painted.find("desk.1@101")
    coarse = painted.box_mesh("coarse", 1.6, 0.8, 0.74)
    painted.document["meshes"][coarse]["primitives"][0]["extensions"] = {
        "KHR_materials_variants": {"mappings": [{"material": 2, "variants": [0]}]}}
    painted.document["nodes"].append({"name": "coarse", "mesh": coarse, "translation": node["translation"]})
    node["extensions"] = {"MSFT_lod": {"ids": [len(painted.document["nodes"]) - 1]}}
    stage = converted(painted.write(tmp_path / "ground.glb"), tmp_path / "ground.usdc")
    stage.GetDefaultPrim().GetVariantSet("material").SetVariantSelection("warm")
    stage.GetPrimAtPath(f"{ROOM}/desk_1_101").GetVariantSet("lod").SetVariantSelection("lod1")
    assert colors(stage, "desk_1_101", "desk_1_101_lod1") == [RED[:3]]
    assert UsdGeom.Xformable(stage.GetPrimAtPath(f"{ROOM}/desk_1_101/desk_1_101_lod1")).GetLocalTransformation() \
        == Gf.Matrix4d(1.0)
    assert Usd.ModelAPI(stage.GetDefaultPrim()).GetKind() == "assembly"
