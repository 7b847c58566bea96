"""Models: assets that floors share, prototypes, instancers; and their materials and textures."""

import time

import numpy as np
import pytest
from conftest import build_floor
from pxr import Gf, Sdf, Usd, UsdGeom, UsdShade
from usd_reading import assert_same_meshes, assert_valid, bound_materials, converted, geometry_of, mesh_prims

from roomwright import convert
from roomwright.gltf_file import GltfFile

PNG = b"\x89PNG\r\n\x1a\n and the rest"
ROOM = "/house_ground/room_101"


@pytest.fixture
def source(floor, tmp_path):
    return floor.write(tmp_path / "ground.glb")


def models_in(folder) -> list[str]:
    return sorted(file.name.split(".")[0] for file in (folder / "shared-models").glob("*.usdc"))


def geometry(stage, piece):
    return geometry_of(stage.GetPrimAtPath(f"{ROOM}/{piece}"))


def files_of(prim) -> set[str]:
    """The names of the layers that say something of a prim."""
    return {spec.layer.GetDisplayName().split(".")[0] for spec in prim.GetPrimStack()}


def test_shared_meshes_are_one_asset(source, tmp_path):
    stage = converted(source, tmp_path / "usd" / "ground.usdc")
    desks = [geometry(stage, f"desk_{number}_101") for number in (1, 2)]
    assert [files_of(desk) for desk in desks] == [{"ground", "desk_0"}] * 2
    assert models_in(tmp_path / "usd") == ["desk_0", "lamp_0"]
    assert files_of(geometry(stage, "floor_101")) == {"ground"}, "no other floor has this slab"
    assert not stage.GetPrototypes(), "importers make objects of instances"


@pytest.mark.parametrize("is_self_contained", [False, True])
def test_models_are_instances_where_one_asks_for_them(source, tmp_path, is_self_contained):
    stage = converted(source, tmp_path / "usd" / "ground.usdc", has_instances=True, is_self_contained=is_self_contained)
    desks = [geometry(stage, f"desk_{number}_101") for number in (1, 2)]
    assert all(desk.IsInstance() for desk in desks)
    assert desks[0].GetPrototype() == desks[1].GetPrototype()
    assert not geometry(stage, "floor_101").IsInstance()
    assert_valid(stage)


def test_an_asset_stands_by_itself(source, tmp_path):
    converted(source, tmp_path / "usd" / "ground.usdc")
    for file in (tmp_path / "usd" / "shared-models").glob("*.usdc"):
        stage = Usd.Stage.Open(str(file))
        assert_valid(stage)
        assert UsdGeom.GetStageUpAxis(stage) == "Y" and Usd.ModelAPI(stage.GetDefaultPrim()).GetKind() == "component"
        (mesh,) = mesh_prims(stage.GetDefaultPrim())
        assert all(bound_materials(mesh))


def test_equal_models_of_two_floors_are_one_file_and_a_tint_is_another(floor, tmp_path):
    (tmp_path / "in").mkdir()
    floor.write(tmp_path / "in" / "ground.glb")
    floor.document["materials"].reverse()
    for mesh in floor.document["meshes"]:
        for primitive in mesh["primitives"]:
            primitive["material"] = 1 - primitive["material"]
    floor.write(tmp_path / "in" / "numbered-otherwise.glb")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd")]) == 0
    assert models_in(tmp_path / "usd") == ["desk_0", "lamp_0"]
    floor.document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = [0.2, 0.2, 0.2, 1.0]
    floor.write(tmp_path / "in" / "tinted.glb")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd")]) == 0
    assert models_in(tmp_path / "usd") == ["desk_0", "desk_0", "lamp_0", "lamp_0"]


def test_a_model_of_an_earlier_run_is_written_anew(source, tmp_path):
    converted(source, tmp_path / "usd" / "ground.usdc")
    files = list((tmp_path / "usd" / "shared-models").glob("*.usdc"))
    good = [file.read_bytes() for file in files]
    for file in files:
        file.write_bytes(b"cut")
    converted(source, tmp_path / "usd" / "ground.usdc", started=time.time() + 1.0)
    assert [file.read_bytes() for file in files] == good


def test_a_self_contained_floor_has_prototypes(source, tmp_path):
    stage = converted(source, tmp_path / "usd" / "ground.usdc", is_self_contained=True)
    for number in (1, 2):
        inherited = geometry(stage, f"desk_{number}_101").GetInherits().GetAllDirectInherits()
        assert inherited == ["/house_ground/Prototypes/desk_0"]
    lamp = geometry(stage, "desk_2_101/lamp_1_101")
    assert lamp and not lamp.HasAuthoredInherits(), "the only one of its kind needs no prototype"
    assert stage.GetPrimAtPath("/house_ground/Prototypes").IsAbstract(), "the prototypes are not drawn"
    assert [file.name for file in (tmp_path / "usd").iterdir()] == ["ground.usdc"]


@pytest.mark.parametrize("has_instances", [False, True])
@pytest.mark.parametrize("is_self_contained", [False, True])
def test_materials_reach_the_parts_of_meshes(source, tmp_path, is_self_contained, has_instances):
    stage = converted(source, tmp_path / "ground.usdc", is_self_contained=is_self_contained,
                      has_instances=has_instances)
    colors, opacities = [], []
    for material in bound_materials(mesh_prims(geometry(stage, "desk_1_101"))[0]):
        surface, _, _ = material.ComputeSurfaceSource()
        assert surface.GetIdAttr().Get() == "UsdPreviewSurface"
        colors.append(surface.GetInput("diffuseColor").Get())
        opacities.append(round(surface.GetInput("opacity").Get(), 6))
    assert colors == [Gf.Vec3f(0.5, 0.3, 0.1), Gf.Vec3f(1, 1, 1)]
    assert opacities == [1.0, 0.4]


def test_a_level_can_be_referenced_with_its_materials(source, tmp_path):
    converted(source, tmp_path / "ground.usdc", is_self_contained=True)
    stage = Usd.Stage.CreateInMemory()
    stage.DefinePrim("/City/Ground").GetReferences().AddReference(str(tmp_path / "ground.usdc"))
    for name in ("desk_1_101", "floor_101"):
        mesh = geometry_of(stage.GetPrimAtPath(f"/City/Ground/room_101/{name}"))
        assert all(str(material.GetPath()).startswith("/City/Ground/Materials/") for material in bound_materials(mesh))


@pytest.mark.parametrize("is_self_contained", [False, True])
def test_a_floor_has_each_material_once(source, tmp_path, is_self_contained):
    stage = converted(source, tmp_path / "ground.usdc", is_self_contained=is_self_contained)
    used = {str(material.GetPath()) for mesh in mesh_prims(stage.GetPseudoRoot()) for material in bound_materials(mesh)}
    assert used == {"/house_ground/Materials/modern_wood", "/house_ground/Materials/modern_glass"}
    assert {str(prim.GetPath()) for prim in stage.TraverseAll() if prim.GetTypeName() == "Material"} == used


def test_what_holds_materials_and_models_is_nothing_that_an_importer_makes_an_object_of(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc")
    for name in ("Materials", "Prototypes"):
        assert not stage.GetPrimAtPath(f"/house_ground/{name}").IsA(UsdGeom.Imageable)


class TestNormals:
    """Primitives without normals are flat, whatever their mesh's others are."""

    @pytest.fixture
    def mesh(self, floor, tmp_path):
        def convert_without(*numbers):
            desk = next(mesh for mesh in floor.document["meshes"] if mesh["name"] == "desk.0")
            for number in numbers:
                del desk["primitives"][number]["attributes"]["NORMAL"]
            stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usdc")
            assert_valid(stage)
            return stage, UsdGeom.Mesh(geometry(stage, "desk_1_101"))

        return convert_without

    @pytest.mark.parametrize(("without", "interpolation", "count"), [
        ((), "vertex", 48), ((0, 1), "uniform", 24), ((1,), "faceVarying", 72)])
    def test_each_corner_of_a_box_has_the_normal_of_its_face(self, mesh, without, interpolation, count):
        _stage, box = mesh(*without)
        normals = np.array(box.GetNormalsAttr().Get())
        assert (box.GetNormalsInterpolation(), len(normals)) == (interpolation, count)
        ring = np.array(box.GetPointsAttr().Get())[np.array(box.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)]
        flat = np.cross(ring[:, 1] - ring[:, 0], ring[:, 2] - ring[:, 0])
        flat /= np.linalg.norm(flat, axis=1, keepdims=True)
        if interpolation == "vertex":
            normals = normals[np.array(box.GetFaceVertexIndicesAttr().Get())]
        corners = normals.reshape(24, -1, 3)
        np.testing.assert_allclose(corners, np.repeat(flat[:, None], corners.shape[1], axis=1), atol=1e-6)


def add_bytes(floor, data: bytes) -> int:
    """A view of a floor's buffer that holds some bytes."""
    floor.document["bufferViews"].append({"buffer": 0, "byteOffset": len(floor.binary), "byteLength": len(data)})
    floor.binary += data + b"\0" * (-len(data) % 4)
    return len(floor.document["bufferViews"]) - 1


class TestTextures:
    """Images, their readers, and where they are."""

    @pytest.fixture
    def textured(self, floor, tmp_path):
        (tmp_path / "in" / "house").mkdir(parents=True)
        (tmp_path / "in" / "shared-textures").mkdir()
        (tmp_path / "in" / "shared-textures" / "wood.base_color.0123456789ab.png").write_bytes(PNG)
        floor.document["images"] = [{"uri": "../shared-textures/wood.base_color.0123456789ab.png"}]
        floor.document["textures"] = [{"source": 0}]
        floor.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
        floor.write(tmp_path / "in" / "house" / "ground.glb")
        floor.write(tmp_path / "in" / "house" / "upper.glb")
        return tmp_path / "in"

    def texture(self, stage, owner="/house_ground"):
        return UsdShade.Shader(stage.GetPrimAtPath(f"{owner}/Materials/modern_wood/diffuseColorTexture"))

    def file(self, texture):
        return texture.GetInput("file").Get()

    def test_each_set_of_coordinates_has_its_primvar_and_its_reader(self, floor, tmp_path):
        (tmp_path / "wood.png").write_bytes(PNG)
        floor.document["images"] = [{"uri": "wood.png"}]
        floor.document["textures"] = [{"source": 0}]
        wood = floor.document["materials"][0]
        wood["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
        wood["occlusionTexture"] = {"index": 0, "texCoord": 1}
        wood["emissiveTexture"] = {"index": 0, "texCoord": 1}
        desk = next(mesh for mesh in floor.document["meshes"] if mesh["name"] == "desk.0")
        corners = np.tile(np.array([(0, 0), (1, 0), (1, 1), (0, 1)], "<f4"), (6, 1))
        for number, scale in enumerate((1, 3)):
            coordinates = floor.accessor(corners * np.float32(scale), "VEC2")
            desk["primitives"][0]["attributes"][f"TEXCOORD_{number}"] = coordinates
        stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usdc", is_self_contained=True)
        mesh = mesh_prims(geometry(stage, "desk_1_101"))[0]
        primvars = UsdGeom.PrimvarsAPI(mesh)
        # USD counts from below: a v of 3 becomes -2.
        assert [primvars.GetPrimvar(name).Get()[2] for name in ("st", "st1")] == [(1, 0), (3, -2)]
        material = bound_materials(mesh)[0]
        read = {}
        for name in ("diffuseColor", "occlusion", "emissiveColor"):
            texture = UsdShade.Shader(material.GetPrim().GetChild(f"{name}Texture"))
            source, _, _ = texture.GetInput("st").GetConnectedSource()
            read[name] = UsdShade.Shader(source.GetPrim()).GetInput("varname").Get()
        assert read == {"diffuseColor": "st", "occlusion": "st1", "emissiveColor": "st1"}
        assert_valid(stage)

    def test_all_floors_and_models_share_one_copy(self, textured, tmp_path):
        assert convert.main([str(textured), "--out", str(tmp_path / "usd")]) == 0
        copies = [path for path in (tmp_path / "usd").rglob("*.png")]
        assert [path.read_bytes() for path in copies] == [PNG]
        assert copies[0].parent.name == "shared-textures"
        model = next((tmp_path / "usd" / "shared-models").glob("desk_0.*"))
        for file, owner in ((tmp_path / "usd" / "house" / "upper.usdc", "/house_ground"), (model, "/desk_0")):
            stage = Usd.Stage.Open(str(file))
            asset = self.file(self.texture(stage, owner))
            assert asset.path == f"../shared-textures/{copies[0].name}" and asset.resolvedPath == str(copies[0])

    def test_images_inside_the_files_are_taken_out_once_each(self, floor, tmp_path):
        """Two floors hold the same image, one of them twice, by other names; another image is another file."""
        other = PNG + b" of another"
        (tmp_path / "in").mkdir()
        for name, images in (("ground", [PNG, PNG, other]), ("upper", [other, PNG])):
            whole = build_floor()
            whole.document["images"] = [{"name": f"{name}{number}", "mimeType": "image/png",
                                         "bufferView": add_bytes(whole, data)} for number, data in enumerate(images)]
            whole.document["textures"] = [{"source": number} for number in range(len(images))]
            whole.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
            whole.document["materials"][0]["emissiveTexture"] = {"index": 1}
            whole.document["materials"][0]["normalTexture"] = {"index": len(images) - 1}
            whole.write(tmp_path / "in" / f"{name}.glb")
        assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd"), "--jobs", "1"]) == 0
        files = list((tmp_path / "usd" / "shared-textures").iterdir())
        assert sorted(file.read_bytes() for file in files) == sorted([PNG, other])
        stage = Usd.Stage.Open(str(tmp_path / "usd" / "upper.usdc"))
        assert open(self.file(self.texture(stage)).resolvedPath, "rb").read() == other

    def test_beside_the_source_images_stay_where_they_are(self, textured):
        assert convert.main([str(textured)]) == 0
        assert len(list(textured.rglob("*.png"))) == 1
        stage = Usd.Stage.Open(str(textured / "house" / "ground.usdc"))
        assert self.file(self.texture(stage)).path == "../shared-textures/wood.base_color.0123456789ab.png"

    def test_a_package_has_them_inside(self, textured, tmp_path):
        stage = converted(textured / "house" / "ground.glb", tmp_path / "usd" / "ground.usdz")
        assert "ground.usdz[" in self.file(self.texture(stage)).resolvedPath
        assert [file.name for file in (tmp_path / "usd").iterdir()] == ["ground.usdz"]

    def test_the_surface_reads_them_times_the_factor(self, textured, tmp_path):
        stage = converted(textured / "house" / "ground.glb", tmp_path / "usd" / "ground.usda")
        shader = UsdShade.Shader(stage.GetPrimAtPath("/house_ground/Materials/modern_wood/surface"))
        source, output, _ = shader.GetInput("diffuseColor").GetConnectedSource()
        assert (source.GetPrim(), output) == (self.texture(stage).GetPrim(), "rgb")
        np.testing.assert_allclose(self.texture(stage).GetInput("scale").Get(), (0.5, 0.3, 0.1, 1.0), rtol=1e-6)
        assert not shader.GetInput("opacity").HasConnectedSource(), "an opaque material has no holes"

    def test_holes_are_in_the_alpha(self, floor, textured, tmp_path):
        floor.document["materials"][0] |= {"alphaMode": "MASK", "alphaCutoff": 0.3}
        floor.write(textured / "house" / "ground.glb")
        stage = converted(textured / "house" / "ground.glb", tmp_path / "usd" / "ground.usda")
        shader = UsdShade.Shader(stage.GetPrimAtPath("/house_ground/Materials/modern_wood/surface"))
        _, output, _ = shader.GetInput("opacity").GetConnectedSource()
        assert output == "a" and shader.GetInput("opacityThreshold").Get() == pytest.approx(0.3)

    def test_a_missing_image_is_a_fault_of_its_floor(self, textured, tmp_path, capsys):
        next(textured.rglob("*.png")).unlink()
        assert convert.main([str(textured), "--out", str(tmp_path / "usd")]) == 1
        assert "ground.glb: images[0].uri: '../shared-textures/wood" in capsys.readouterr().err


class TestPointInstancer:
    """Small objects as entries of one prim."""

    def test_entries_stand_where_the_nodes_stand(self, source, tmp_path):
        stage, gltf = converted(source, tmp_path / "ground.usdc", instanced_below=0.5), GltfFile(source)
        assert_valid(stage)
        instancer = UsdGeom.PointInstancer(stage.GetPrimAtPath(f"{ROOM}/small_objects"))
        lamp = next(node for node in gltf.nodes if node.name == "lamp.1@101")
        places = instancer.ComputeInstanceTransformsAtTime(Usd.TimeCode.Default(), Usd.TimeCode.Default())
        room = UsdGeom.Xformable(instancer.GetPrim()).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
        assert len(places) == 1
        np.testing.assert_allclose(np.array(places[0] * room).T, lamp.world, atol=1e-4)
        assert list(instancer.GetPrim().GetCustomDataByKey("names")) == ["lamp.1@101"]
        assert '"class": "lamp"' in instancer.GetPrim().GetCustomDataByKey("extras")[0]
        assert not stage.GetPrimAtPath(f"{ROOM}/desk_2_101/lamp_1_101"), "it is there once"

    def test_its_extent_holds_the_corners(self, source, tmp_path):
        stage, gltf = converted(source, tmp_path / "ground.usdc", instanced_below=0.5), GltfFile(source)
        extent = np.array(UsdGeom.PointInstancer(stage.GetPrimAtPath(f"{ROOM}/small_objects")).GetExtentAttr().Get())
        lamp = next(node for node in gltf.nodes if node.name == "lamp.1@101")
        corners = gltf.primitives(lamp.mesh)[0]["positions"] @ lamp.world[:3, :3].T + lamp.world[:3, 3]
        np.testing.assert_allclose(extent, [corners.min(axis=0), corners.max(axis=0)], atol=1e-5)

    @pytest.mark.parametrize("below", [0.3, 0.2])
    def test_what_is_as_large_as_the_threshold_stays(self, source, tmp_path, below):
        stage = converted(source, tmp_path / "ground.usdc", instanced_below=below)
        assert not stage.GetPrimAtPath(f"{ROOM}/small_objects")
        assert_same_meshes(stage, GltfFile(source))

    def test_what_carries_something_stays(self, source, tmp_path):
        stage = converted(source, tmp_path / "ground.usdc", instanced_below=9.0)
        names = stage.GetPrimAtPath(f"{ROOM}/small_objects").GetCustomDataByKey("names")
        assert list(names) == ["desk.1@101", "lamp.1@101"]

    def test_bodies_are_no_entries(self, source):
        with pytest.raises(SystemExit) as stopped:
            convert.main([str(source), "--physics", "--point-instancer"])
        assert stopped.value.code == 2


def test_layers_name_nothing_absolute(source, tmp_path):
    converted(source, tmp_path / "usd" / "ground.usda")
    layer = Sdf.Layer.FindOrOpen(str(tmp_path / "usd" / "ground.usda"))
    assert layer.GetCompositionAssetDependencies()
    assert all(path.startswith("./shared-models/") for path in layer.GetCompositionAssetDependencies())
