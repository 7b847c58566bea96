"""What convert.py writes, read back through the composed stage and compared with the glTF."""

import numpy as np
import pytest
from pxr import Gf, Kind, Usd, UsdGeom, UsdShade, UsdValidation

import convert
from gltf_file import GltfFile

# Metres.
PLACE_TOLERANCE = 1e-4


def converted(source, target, up_axis="Y") -> Usd.Stage:
    assert convert.convert_file(source, target, up_axis) == ""
    return Usd.Stage.Open(str(target))


def node_prims(stage) -> list[Usd.Prim]:
    """The prims that stand for nodes, parents before children, in the file's order."""
    return [prim for prim in stage.Traverse() if "name" in prim.GetCustomData()]


def world_of(prim) -> np.ndarray:
    return np.array(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())).T


def assert_same_tree(stage, gltf, turn=np.identity(4)):
    prims = node_prims(stage)
    assert [prim.GetCustomDataByKey("name") for prim in prims] == [node.name for node in gltf.nodes]
    for prim, node in zip(prims, gltf.nodes):
        assert prim.GetDisplayName() == node.name
        np.testing.assert_allclose(world_of(prim), turn @ node.world, atol=PLACE_TOLERANCE)
        parent = prim.GetParent().GetCustomDataByKey("name")
        assert parent == (node.parent.name if node.parent else None)


def assert_same_bounds(stage, gltf):
    """The box of every mesh, through instances, against the corners in the file."""
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), [UsdGeom.Tokens.default_])
    for prim, node in zip(node_prims(stage), gltf.nodes):
        if node.mesh is None:
            continue
        corners = np.concatenate([part["positions"] for part in gltf.primitives(node.mesh)])
        box = cache.ComputeUntransformedBound(prim.GetChild(convert.GEOMETRY)).ComputeAlignedRange()
        np.testing.assert_allclose([box.GetMin(), box.GetMax()], [corners.min(axis=0), corners.max(axis=0)],
                                   atol=PLACE_TOLERANCE)


def assert_valid(stage):
    """No validator that comes with USD has anything to say."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    issues = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [f"{issue.GetIdentifier()}: {issue.GetMessage()}" for issue in issues] == []


@pytest.fixture
def source(floor, tmp_path):
    return floor.write(tmp_path / "ground.glb")


@pytest.mark.parametrize("ending", ["usdc", "usda"])
def test_the_tree_is_the_same(source, tmp_path, ending):
    stage, gltf = converted(source, tmp_path / f"ground.{ending}"), GltfFile(source)
    assert_same_tree(stage, gltf)
    assert_same_bounds(stage, gltf)
    assert stage.GetDefaultPrim().GetPath() == "/house_ground"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    assert_valid(stage)


def test_z_up_turns_the_whole_tree(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc", "Z")
    up = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert_same_tree(stage, GltfFile(source), up)


def test_extras_are_custom_data(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usda")
    desk = stage.GetPrimAtPath("/house_ground/room_101/desk_1_101").GetCustomData()
    assert (desk["kind"], desk["class"], desk["variant"]) == ("furniture", "desk", 0)
    assert list(desk["size"]) == [1.6, 0.8, 0.74]
    room = stage.GetPrimAtPath("/house_ground/room_101").GetCustomData()
    assert room["removed"] == '[{"class": "chair", "reason": "no place"}]'
    assert (room["seed"], stage.GetDefaultPrim().GetCustomData()["seed"]) == ("7", "18446744073709551615")


def test_shared_meshes_are_instances_of_one_prototype(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc")
    desks = [stage.GetPrimAtPath(f"/house_ground/room_101/desk_{n}_101/geometry") for n in (1, 2)]
    assert all(desk.IsInstance() for desk in desks)
    assert desks[0].GetPrototype() == desks[1].GetPrototype()
    lamp = stage.GetPrimAtPath("/house_ground/room_101/desk_2_101/lamp_1_101/geometry")
    assert lamp and not lamp.IsInstance(), "the only one of its kind needs no prototype"
    assert stage.GetPrimAtPath("/house_ground/Prototypes").IsAbstract(), "the prototypes are not drawn"


def test_kinds_form_a_model_hierarchy(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc")
    kinds = {prim.GetName(): Usd.ModelAPI(prim).GetKind() for prim in node_prims(stage)}
    assert kinds == {
        "house_ground": Kind.Tokens.assembly, "door_d1": Kind.Tokens.component, "room_101": Kind.Tokens.group,
        "floor_101": Kind.Tokens.component, "desk_1_101": Kind.Tokens.component,
        "desk_2_101": Kind.Tokens.component, "lamp_1_101": Kind.Tokens.subcomponent,
    }
    assert all(prim.IsModel() for prim in node_prims(stage) if prim.GetName() != "lamp_1_101")


def test_materials_reach_the_meshes_of_instances(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc")
    geometry = stage.GetPrimAtPath("/house_ground/room_101/desk_1_101/geometry")
    colors, opacities = [], []
    for mesh in Usd.PrimRange(geometry, Usd.TraverseInstanceProxies()):
        if mesh.IsA(UsdGeom.Mesh):
            material, _ = UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()
            surface, _, _ = material.ComputeSurfaceSource()
            assert surface.GetIdAttr().Get() == "UsdPreviewSurface"
            colors.append(surface.GetInput("diffuseColor").Get())
            opacities.append(round(surface.GetInput("opacity").Get(), 6))
    assert colors == [Gf.Vec3f(0.5, 0.3, 0.1), Gf.Vec3f(1, 1, 1)]
    assert opacities == [1.0, 0.4]


def test_a_level_can_be_referenced_with_its_materials(source, tmp_path):
    converted(source, tmp_path / "ground.usdc")
    stage = Usd.Stage.CreateInMemory()
    stage.DefinePrim("/City/Ground").GetReferences().AddReference(str(tmp_path / "ground.usdc"))
    for path in ("room_101/desk_1_101/geometry/part0", "room_101/floor_101/geometry/part0"):
        mesh = stage.GetPrimAtPath(f"/City/Ground/{path}")
        material, _ = UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()
        assert material, path


def test_textures_are_written_beside_the_file(floor, tmp_path):
    png = b"\x89PNG\r\n\x1a\n and the rest"
    (tmp_path / "wood.png").write_bytes(png)
    floor.document["images"] = [{"uri": "wood.png"}]
    floor.document["textures"] = [{"source": 0}]
    floor.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "usd" / "ground.usda")
    shader = UsdShade.Shader(stage.GetPrimAtPath("/house_ground/Materials/modern_wood/surface"))
    source, output, _ = shader.GetInput("diffuseColor").GetConnectedSource()
    assert (source.GetPrim().GetName(), output) == ("diffuseColorTexture", "rgb")
    assert source.GetPrim().GetAttribute("inputs:file").Get().path == "./ground.textures/image0.png"
    assert (tmp_path / "usd" / "ground.textures" / "image0.png").read_bytes() == png


def test_names_that_become_equal_are_told_apart(floor, tmp_path):
    floor.find("desk.1@101")["name"] = "desk-2@101"
    stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usda")
    names = [prim.GetName() for prim in node_prims(stage)]
    assert "desk_2_101" in names and "desk_2_101_2" in names


@pytest.mark.parametrize("ending", ["usdc", "usda"])
def test_equal_inputs_give_equal_bytes(source, tmp_path, ending):
    for folder in ("a", "b"):
        converted(source, tmp_path / folder / f"ground.{ending}")
    first, second = ((tmp_path / folder / f"ground.{ending}").read_bytes() for folder in ("a", "b"))
    assert first == second


def test_a_folder_keeps_its_tree_and_a_broken_file_fails_alone(floor, tmp_path, capsys):
    (tmp_path / "in" / "house").mkdir(parents=True)
    floor.write(tmp_path / "in" / "house" / "ground.glb")
    (tmp_path / "in" / "broken.glb").write_bytes(b"no glTF")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "out"), "--jobs", "2"]) == 1
    written = [path.relative_to(tmp_path / "out").as_posix() for path in (tmp_path / "out").rglob("*.*")]
    assert written == ["house/ground.usdc"]
    assert "broken.glb" in capsys.readouterr().err


def test_nothing_to_convert_cannot_start(tmp_path):
    assert convert.main([str(tmp_path)]) == 2
    assert convert.main([str(tmp_path / "absent.glb")]) == 2


def test_a_floor_that_the_program_baked(baked, tmp_path):
    sources = sorted(baked.rglob("*.glb"))
    assert sources, f"no floor in {baked}"
    for source in sources[:3]:
        stage, gltf = converted(source, tmp_path / source.with_suffix(".usdc").name), GltfFile(source)
        assert_valid(stage)
        assert_same_tree(stage, gltf)
        assert_same_bounds(stage, gltf)
