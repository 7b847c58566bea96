"""Lamps: what reaches a surface is what the glTF says, worked out from the formulas of UsdLux without the exposure."""

import math

import pytest
from pxr import Gf, Usd, UsdGeom, UsdLux
from usd_reading import assert_same_tree, assert_valid, converted, geometry_of

from roomwright.gltf_file import GltfFile
from roomwright.usd.lights import EXPOSURE

LAMP = "/house_ground/room_101/desk_2_101/lamp_1_101"
KELVIN = 2700.0


def add_light(floor, light, extras=None, name="light.lamp.1@101"):
    """Hangs a light over the lamp of the floor."""
    floor.document["extensions"] = {"KHR_lights_punctual": {"lights": [light]}}
    parent = floor.document["nodes"].index(floor.find("lamp.1@101"))
    node = floor.node(name, extras or {}, parent, at=(0, 0.32, 0))
    floor.document["nodes"][node]["extensions"] = {"KHR_lights_punctual": {"light": 0}}


def converted_light(floor, tmp_path):
    source = floor.write(tmp_path / "ground.glb")
    stage = converted(source, tmp_path / "ground.usda")
    assert_same_tree(stage, GltfFile(source))
    assert_valid(stage)
    return stage, stage.GetPrimAtPath(f"{LAMP}/light_lamp_1_101/light_lamp_1_101")


def luminance(color) -> float:
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]


def sphere_candelas(prim) -> float:
    """Luminous intensity of a sphere at exposure 0: its luminance over the disc that is seen."""
    light, radius = UsdLux.LightAPI(prim), UsdLux.SphereLight(prim).GetRadiusAttr().Get()
    assert light.GetExposureAttr().Get() == EXPOSURE, "all lights of a scene are exposed alike"
    nits = light.GetIntensityAttr().Get() * luminance(color_of(light))
    if light.GetNormalizeAttr().Get():
        nits /= 4.0 * math.pi * radius ** 2
    return nits * math.pi * radius ** 2


def color_of(light) -> Gf.Vec3f:
    color = light.GetColorAttr().Get()
    if not light.GetEnableColorTemperatureAttr().Get():
        return color
    return Gf.CompMult(color, UsdLux.BlackbodyTemperatureAsRgb(light.GetColorTemperatureAttr().Get()))


def test_a_lamp_has_its_lumens_and_kelvins(floor, tmp_path):
    warm = {"type": "point", "intensity": 800 / (4 * math.pi), "color": [1.0, 0.42, 0.1]}
    add_light(floor, warm, {"kind": "light", "lumens": 800.0, "kelvin": KELVIN})
    _stage, prim = converted_light(floor, tmp_path)
    assert prim.GetTypeName() == "SphereLight"
    assert sphere_candelas(prim) * 4 * math.pi == pytest.approx(800.0, rel=1e-4)
    assert UsdLux.LightAPI(prim).GetColorTemperatureAttr().Get() == KELVIN
    assert prim.GetParent().GetCustomDataByKey("lumens") == 800.0


@pytest.mark.parametrize("lights_lamps", [False, True])
def test_a_lamp_that_is_no_light_of_the_file_is_one_where_somebody_asks(floor, tmp_path, lights_lamps):
    parent = floor.document["nodes"].index(floor.find("lamp.1@101"))
    extras = {"kind": "light", "lumens": 800.0, "kelvin": KELVIN}
    floor.node("light.lamp.1@101", extras, parent, at=(0, 0.32, 0))
    source = floor.write(tmp_path / "ground.glb")
    stage = converted(source, tmp_path / "ground.usda", lights_lamps=lights_lamps)
    assert_same_tree(stage, GltfFile(source))
    assert_valid(stage)
    prim = stage.GetPrimAtPath(f"{LAMP}/light_lamp_1_101/light_lamp_1_101")
    assert bool(prim) is lights_lamps
    assert stage.GetPrimAtPath(f"{LAMP}/light_lamp_1_101").GetAttribute("userProperties:lumens").Get() == 800.0
    if lights_lamps:
        assert sphere_candelas(prim) * 4 * math.pi == pytest.approx(800.0, rel=1e-4)


def test_a_wider_bulb_is_no_brighter(floor, tmp_path):
    add_light(floor, {"type": "point"}, {"kind": "light", "lumens": 800.0, "kelvin": KELVIN})
    _stage, prim = converted_light(floor, tmp_path)
    UsdLux.SphereLight(prim).GetRadiusAttr().Set(0.1)
    assert sphere_candelas(prim) * 4 * math.pi == pytest.approx(800.0, rel=1e-4)


def test_a_light_without_lumens_keeps_candelas_and_colour(floor, tmp_path):
    add_light(floor, {"type": "point", "intensity": 50.0, "color": [1.0, 0.5, 0.25]})
    _stage, prim = converted_light(floor, tmp_path)
    assert sphere_candelas(prim) == pytest.approx(50.0 * luminance((1.0, 0.5, 0.25)), rel=1e-5)
    assert UsdLux.LightAPI(prim).GetColorAttr().Get() == Gf.Vec3f(1.0, 0.5, 0.25)


def test_a_spot_shines_in_its_cone(floor, tmp_path):
    spot = {"innerConeAngle": math.radians(15), "outerConeAngle": math.radians(30)}
    add_light(floor, {"type": "spot", "intensity": 100.0, "spot": spot})
    _stage, prim = converted_light(floor, tmp_path)
    shaping = UsdLux.ShapingAPI(prim)
    assert sphere_candelas(prim) == pytest.approx(100.0, rel=1e-5)
    assert prim.HasAPI(UsdLux.ShapingAPI)
    assert shaping.GetShapingConeAngleAttr().Get() == pytest.approx(30.0)
    assert shaping.GetShapingConeSoftnessAttr().Get() == pytest.approx(0.5)


def test_a_sun_has_its_lux(floor, tmp_path):
    add_light(floor, {"type": "directional", "intensity": 20_000.0})
    _stage, prim = converted_light(floor, tmp_path)
    light = UsdLux.LightAPI(prim)
    assert prim.GetTypeName() == "DistantLight"
    assert (light.GetIntensityAttr().Get(), light.GetNormalizeAttr().Get()) == (20_000.0, True)
    assert light.GetExposureAttr().Get() == EXPOSURE


def test_a_light_on_a_node_with_a_mesh_is_a_child(floor, tmp_path):
    floor.document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 5.0}]}}
    floor.find("lamp.1@101")["extensions"] = {"KHR_lights_punctual": {"light": 0}}
    stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usda")
    assert stage.GetPrimAtPath(LAMP).GetTypeName() == "Xform"
    assert sphere_candelas(stage.GetPrimAtPath(f"{LAMP}/lamp_1_101_light")) == pytest.approx(5.0, rel=1e-5)


def test_lamps_of_the_program(baked, tmp_path):
    """Their spheres touch nothing: they are smaller than the 2 cm that the program keeps."""
    source = min(baked.rglob("*.glb"), key=lambda file: file.stat().st_size)
    stage = converted(source, tmp_path / "floor.usdc", lights_lamps=True)
    lights = [prim for prim in stage.Traverse() if prim.HasAPI(UsdLux.LightAPI)]
    nodes = [node for node in GltfFile(source).nodes if node.kind == "light"]
    assert [prim.GetParent().GetCustomDataByKey("name") for prim in lights] == [node.name for node in nodes] != []
    for prim, node in zip(lights, nodes):
        assert sphere_candelas(prim) * 4 * math.pi == pytest.approx(node.extras["lumens"], rel=1e-3)
        lamp = geometry_of(prim.GetParent().GetParent())
        cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"])
        box = cache.ComputeUntransformedBound(lamp).ComputeAlignedRange()
        centre = UsdGeom.Xformable(prim.GetParent()).GetLocalTransformation().ExtractTranslation()
        gap = math.sqrt(box.GetDistanceSquared(centre))
        assert gap > UsdLux.SphereLight(prim).GetRadiusAttr().Get(), node.name
