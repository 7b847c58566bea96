"""What validate.py says of USD files: correct ones, and each fault beside them."""

import json

import pytest
from conftest import build_floor
from pxr import Sdf, Usd, UsdGeom

from roomwright import convert
from roomwright import validate
from roomwright.checks.stages import check_stage


def faults_of(file) -> list[str]:
    return [f"{fault.code} {fault.node}: {fault.message}" for fault in check_stage(file)[0]]


@pytest.fixture
def usd(tmp_path):
    """A converted building of one floor with a textured slab."""
    (tmp_path / "in" / "house").mkdir(parents=True)
    floor = build_floor()
    (tmp_path / "in" / "wood.png").write_bytes(b"\x89PNG\r\n\x1a\n and the rest")
    floor.document["images"] = [{"uri": "../wood.png"}]
    floor.document["textures"] = [{"source": 0}]
    floor.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    floor.write(tmp_path / "in" / "house" / "ground.glb")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd"), "--format", "usda"]) == 0
    return tmp_path / "usd"


@pytest.mark.parametrize("options", [
    [], ["--up-axis", "Z"], ["--self-contained"], ["--physics"], ["--point-instancer"], ["--format", "usdz"]])
def test_what_convert_writes_has_no_fault(tmp_path, options, capsys):
    (tmp_path / "in").mkdir()
    build_floor().write(tmp_path / "in" / "ground.glb")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd"), *options]) == 0
    capsys.readouterr()
    assert validate.main([str(tmp_path / "usd")]) == 0
    assert "stages" in capsys.readouterr().out


def edit(file, change):
    """A change to a file by hand, past all layers that this process has open."""
    text = file.read_text()
    assert change[0] in text
    file.write_text(text.replace(*change))
    layer = Sdf.Layer.Find(str(file))
    if layer:
        layer.Reload(force=True)


FLOOR, BUILDING = "house/ground.usda", "house/building.usda"
WOOD = "/house_ground/Materials/modern_wood/"


@pytest.mark.parametrize(("name", "change", "expected"), [
    (FLOOR, ('defaultPrim = "house_ground"', ""), "usd : it has no default prim"),
    (FLOOR, ("metersPerUnit = 1", "metersPerUnit = 0.01"), "usd : a unit is 0.01 m"),
    (FLOOR, ("@../shared-models/lamp_0", "@../shared-models/no"), "file : it names '../shared-models/no"),
    (FLOOR, ("@../shared-models/lamp_0", "@/shared-models/lamp_0"), "path : it names a file that it may not: '/shared-models/"),
    (BUILDING, ("@./ground.usda@", "@./cellar.usda@"), "file : it names './cellar.usda', which does not exist"),
    (FLOOR, ("@../shared-textures/", "@../shared-textures/no-"), f"texture {WOOD}diffuseColorTexture: it reads '../"),
    (FLOOR, ("@../shared-textures/", "@/shared-textures/"), "path : it names a file that it may not: '/shared-textures/"),
    (FLOOR, ("#usda 1.0", "#usda"), "file : cannot be opened"),
    (FLOOR, ('upAxis = "Y"', ""), "usd /: usdGeomValidators:StageMetadataChecker"),
    (FLOOR, ('"MaterialBindingAPI"', '"GeomModelAPI"'), "usd /house_ground/room_101/floor_101/floor_101"),
])
def test_each_fault_is_found(usd, name, change, expected):
    assert faults_of(usd / name) == []
    edit(usd / name, change)
    faults = faults_of(usd / name)
    assert any(fault.startswith(expected) for fault in faults), faults


def test_a_missing_image_is_a_fault_of_the_floors_and_models_that_show_it(usd):
    next((usd / "shared-textures").iterdir()).unlink()
    faults = faults_of(usd / "house" / "ground.usda")
    assert any(fault.startswith("texture /house_ground/Materials/modern_wood/") for fault in faults)
    model = next((usd / "shared-models").glob("desk_0.*"))
    assert any(fault.startswith("texture /desk_0/Materials/modern_wood/") for fault in faults_of(model))


def test_a_building_is_judged_without_loading_its_floors(usd):
    (usd / "house" / "ground.usda").write_text("#usda 1.0\n")
    assert faults_of(usd / "house" / "building.usda") == []


@pytest.mark.parametrize("content", [b"", b"no USD", b"PXR-USDC"])
@pytest.mark.parametrize("ending", ["usda", "usdc", "usdz"])
def test_what_is_no_usd_is_one_fault(tmp_path, content, ending):
    file = tmp_path / f"floor.{ending}"
    file.write_bytes(content)
    assert len(faults_of(file)) == 1


def test_a_validator_of_usd_is_asked(tmp_path):
    stage = Usd.Stage.CreateNew(str(tmp_path / "odd.usda"))
    UsdGeom.SetStageUpAxis(stage, "Y")
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetDefaultPrim(stage.DefinePrim("/A", "Xform"))
    stage.DefinePrim("/A/M", "Material")
    stage.DefinePrim("/A/M/inside", "Mesh")
    stage.Save()
    assert any("Encapsulation" in fault for fault in faults_of(tmp_path / "odd.usda"))


def test_floors_and_stages_are_counted_together(usd, capsys):
    assert validate.main([str(usd), str(usd.parent / "in"), "--no-khronos", "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert (report["floors"], report["stages"], report["furniture"]) == (1, 4, 3)
    assert (report["files"], report["faults"]) == (5, [])
