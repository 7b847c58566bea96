"""What convert.py writes, read back through the composed stage and compared with the glTF."""

import json
import shutil
import zipfile

import numpy as np
import pytest
from conftest import build_floor
from pxr import Kind, Sdf, Usd, UsdGeom, UsdSemantics
from usd_reading import assert_same_meshes, assert_same_places, assert_same_tree, assert_valid, converted, node_prims

from roomwright import convert
from roomwright.gltf_file import GltfFile

Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)


@pytest.fixture
def source(floor, tmp_path):
    return floor.write(tmp_path / "ground.glb")


@pytest.mark.parametrize("settings", [{}, {"is_self_contained": True}, {"has_instances": True},
                                      {"is_self_contained": True, "has_instances": True}])
@pytest.mark.parametrize("ending", ["usdc", "usda", "usdz"])
def test_the_tree_is_the_same(source, tmp_path, ending, settings):
    stage = converted(source, tmp_path / f"ground.{ending}", **settings)
    gltf = GltfFile(source)
    assert_same_tree(stage, gltf)
    assert_same_meshes(stage, gltf)
    assert stage.GetDefaultPrim().GetPath() == "/house_ground"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    assert_valid(stage)


def test_z_up_turns_the_whole_tree(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc", up_axis="Z")
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert_same_tree(stage, GltfFile(source), Z_UP)
    assert_same_meshes(stage, GltfFile(source), Z_UP)


def test_a_tenth_of_a_millimetre_too_much_is_seen(source, floor, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc")
    floor.find("lamp.1@101")["translation"][0] += 0.0002
    moved = GltfFile(floor.write(tmp_path / "moved.glb"))
    for compare in (assert_same_places, assert_same_meshes):
        with pytest.raises(AssertionError):
            compare(stage, moved)


def test_extras_are_custom_data(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usda")
    desk = stage.GetPrimAtPath("/house_ground/room_101/desk_1_101").GetCustomData()
    assert (desk["kind"], desk["class"], desk["variant"]) == ("furniture", "desk", 0)
    assert list(desk["size"]) == [1.6, 0.8, 0.74]
    room = stage.GetPrimAtPath("/house_ground/room_101").GetCustomData()
    assert room["removed"] == '[{"class": "chair", "reason": "no place", "required": false}]'
    assert (room["seed"], stage.GetDefaultPrim().GetCustomData()["seed"]) == ("7", "18446744073709551615")


def test_labels_say_what_a_pixel_shows(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usda")

    def labels(path, taxonomy):
        query = UsdSemantics.LabelsQuery(taxonomy, Usd.TimeCode.Default())
        return list(query.ComputeUniqueInheritedLabels(stage.GetPrimAtPath(path)))

    room = "/house_ground/room_101"
    assert labels(f"{room}/desk_1_101/desk_1_101", "class") == ["desk"]
    assert labels(f"{room}/desk_2_101/lamp_1_101", "room") == ["office"]
    assert labels(f"{room}/floor_101", "class") == ["floor"]
    assert labels(f"{room}/floor_101", "building") == ["house"]
    own = UsdSemantics.LabelsAPI(stage.GetPrimAtPath(f"{room}/desk_2_101/lamp_1_101"), "class")
    assert list(own.GetLabelsAttr().Get()) == ["lamp"]


def test_kinds_form_a_model_hierarchy(source, tmp_path):
    stage = converted(source, tmp_path / "ground.usdc")
    kinds = {prim.GetName(): Usd.ModelAPI(prim).GetKind() for prim in node_prims(stage)}
    assert kinds == {
        "house_ground": Kind.Tokens.assembly, "door_d1": Kind.Tokens.component, "room_101": Kind.Tokens.group,
        "floor_101": Kind.Tokens.component, "desk_1_101": Kind.Tokens.component,
        "desk_2_101": Kind.Tokens.component, "lamp_1_101": Kind.Tokens.subcomponent,
    }
    assert all(prim.IsModel() for prim in node_prims(stage) if prim.GetName() != "lamp_1_101")


def test_names_that_become_equal_are_told_apart(floor, tmp_path):
    floor.find("desk.1@101")["name"] = "desk-2@101"
    stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usda")
    names = [prim.GetName() for prim in node_prims(stage)]
    assert "desk_2_101" in names and "desk_2_101_2" in names


def test_a_package_says_nothing_about_when_it_was_packed(source, tmp_path):
    converted(source, tmp_path / "ground.usdz")
    with zipfile.ZipFile(tmp_path / "ground.usdz") as package:
        assert package.testzip() is None
        assert {entry.date_time for entry in package.infolist()} == {(1980, 1, 1, 0, 0, 0)}


@pytest.mark.parametrize("ending", ["usdc", "usda", "usdz"])
def test_equal_inputs_give_equal_bytes(source, tmp_path, ending):
    for folder in ("a", "b"):
        converted(source, tmp_path / folder / f"ground.{ending}")
    first, second = ({file.relative_to(tmp_path / folder): file.read_bytes()
                      for file in (tmp_path / folder).rglob("*.usd*")} for folder in ("a", "b"))
    assert first == second
    assert len(first) == (1 if ending == "usdz" else 3), "the floor, a desk and a lamp"


def test_a_folder_keeps_its_tree_and_a_broken_file_fails_alone(floor, tmp_path, capsys):
    (tmp_path / "in" / "house").mkdir(parents=True)
    floor.write(tmp_path / "in" / "house" / "ground.glb")
    (tmp_path / "in" / "broken.glb").write_bytes(b"no glTF")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "out"), "--jobs", "2"]) == 1
    written = {path.relative_to(tmp_path / "out").as_posix() for path in (tmp_path / "out").rglob("*.usd*")}
    assert {name for name in written if not name.startswith("shared-models/")} == {
        "house/ground.usdc", "house/building.usda"}
    assert not [path for path in (tmp_path / "out").rglob(".*")], "nothing is left half written"
    error = capsys.readouterr().err
    assert "broken.glb: not a glTF file" in error and error.count("\n") == 1


def test_a_file_that_is_glTF_and_says_nonsense_fails_alone(floor, tmp_path, capsys):
    floor.write(tmp_path / "good.glb")
    for number, nonsense in enumerate(({"extras": ["desk"]}, {"mesh": 99}, {"translation": "left"}, {"children": [0]})):
        odd = build_floor()
        odd.find("desk.1@101").update(nonsense)
        odd.write(tmp_path / f"odd{number}.glb")
    assert convert.main([str(tmp_path), "--out", str(tmp_path / "usd")]) == 1
    assert [file.name for file in (tmp_path / "usd").glob("*.usdc")] == ["good.usdc"]
    error = capsys.readouterr().err
    assert all(f"odd{number}.glb: " in error for number in range(4)) and "Traceback" not in error


def test_nothing_to_convert_cannot_start(tmp_path):
    assert convert.main([str(tmp_path)]) == 2
    assert convert.main([str(tmp_path / "absent.glb")]) == 2


def test_two_sources_of_one_target_cannot_start(floor, tmp_path, capsys):
    for ending in ("glb", "gltf"):
        floor.write(tmp_path / f"ground.{ending}")
    assert convert.main([str(tmp_path)]) == 2
    assert "would both become" in capsys.readouterr().err


@pytest.mark.parametrize("settings", [{}, {"is_self_contained": True}, {"has_physics": True}, {"has_instances": True}])
def test_a_floor_that_the_program_baked(baked, tmp_path, settings):
    by_size = sorted(baked.rglob("*.glb"), key=lambda file: file.stat().st_size)
    for source in by_size[:1] if settings else [by_size[0], by_size[-1]]:
        stage, gltf = converted(source, tmp_path / source.with_suffix(".usdc").name, **settings), GltfFile(source)
        assert_valid(stage)
        (assert_same_places if settings.get("has_physics") else assert_same_tree)(stage, gltf)
        assert_same_meshes(stage, gltf)


def test_a_baked_city(baked, tmp_path):
    """Stages of its buildings, a second run that writes the same, and no absolute path."""
    buildings = [folder for folder in ("house", "office") if (baked / folder).is_dir()]
    for folder in [*buildings, "shared-textures"]:
        if (baked / folder).is_dir():
            shutil.copytree(baked / folder, tmp_path / "in" / folder)
    for out in ("a", "b"):
        assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / out)]) == 0
    stage = Usd.Stage.Open(str(tmp_path / "a" / "city.usda"))
    floors = [prim for prim in stage.Traverse() if prim.GetCustomDataByKey("kind") == "level"]
    assert len(floors) == len(list((tmp_path / "in").rglob("*.glb"))) > 1
    files = {out: {file.relative_to(tmp_path / out): file.read_bytes()
                   for file in (tmp_path / out).rglob("*") if file.is_file()} for out in ("a", "b")}
    assert files["a"] == files["b"]
    for file in (tmp_path / "a").rglob("*.usd*"):
        for path in filter(None, Sdf.Layer.FindOrOpen(str(file)).GetCompositionAssetDependencies()):
            assert path.startswith(("./", "../")), f"{file} refers to {path}"


def test_levels_that_no_plan_has_any_more_are_left_out(floor, tmp_path, capsys):
    bake = tmp_path / "bake"
    (bake / "house").mkdir(parents=True)
    for name in ("ground", "gone"):
        floor.write(bake / "house" / f"{name}.glb")
    former = [{"files": [{"path": "house/gone.glb", "bytes": 1, "sha256": ""}]}]
    (bake / "manifest.json").write_text(json.dumps({"levels": [], "former_levels": former}))
    assert convert.main([str(bake), "--out", str(tmp_path / "usd")]) == 0
    assert (tmp_path / "usd/house/ground.usdc").exists() and not (tmp_path / "usd/house/gone.usdc").exists()
    assert "gone.glb is skipped" in capsys.readouterr().err
