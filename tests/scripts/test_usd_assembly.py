"""Buildings of floors and a city of buildings."""

import math
import time

import numpy as np
import pytest
from conftest import build_floor
from pxr import Gf, Usd, UsdGeom
from stairs_house import RISES, STOREY, ground, upper
from usd_reading import assert_valid, mesh_prims, world_of, world_points

from roomwright import convert
from roomwright.checks.undersides import area_above
from roomwright.gltf_file import GltfFile

# The site of the second building: east and north in metres, radians counter-clockwise.
SITE = {"position": [30.0, 12.0], "turn": math.pi / 2}
LEVELS = [("ground", 0.0), ("upper", 3.0), ("cellar", -2.5)]
Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)


def write_level(folder, building, level, elevation, site=None):
    floor = build_floor()
    root = floor.document["nodes"][0]
    root["name"] = f"{building}/{level}"
    root["extras"] |= {"building": building, "level": level, "elevation": elevation}
    if site:
        root["extras"]["site"] = site
    (folder / building).mkdir(parents=True, exist_ok=True)
    return floor.write(folder / building / f"{level}.glb")


@pytest.fixture
def site(tmp_path):
    for level, elevation in LEVELS:
        write_level(tmp_path / "in", "house", level, elevation)
        write_level(tmp_path / "in", "tower", level, elevation, SITE)
    return tmp_path / "in"


def assembled(source, out, *options) -> Usd.Stage:
    assert convert.main([str(source), "--out", str(out), *options]) == 0
    return Usd.Stage.Open(str(out / "city.usda"))


def test_a_building_has_its_floors_at_their_elevations(site, tmp_path):
    assembled(site, tmp_path / "usd")
    stage = Usd.Stage.Open(str(tmp_path / "usd" / "house" / "building.usda"))
    assert_valid(stage)
    floors = stage.GetDefaultPrim().GetChildren()
    assert [floor.GetName() for floor in floors] == ["cellar", "ground", "upper"], "lowest first"
    assert [world_of(floor)[1, 3] for floor in floors] == [-2.5, 0.0, 3.0]
    assert all(floor.HasPayload() and floor.GetCustomDataByKey("kind") == "level" for floor in floors)


def test_a_flight_leads_to_the_floor_of_the_level_above(tmp_path):
    (tmp_path / "in" / "house").mkdir(parents=True)
    for storey, level in ((ground(), "ground"), (upper(), "upper")):
        storey.write(tmp_path / "in" / "house" / f"{level}.glb")
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd")]) == 0
    stage = Usd.Stage.Open(str(tmp_path / "usd" / "house" / "building.usda"))
    stairs, floor = (triangles_of(stage, f"/house/{path}_hall") for path in ("ground/room_hall/stairs", "upper/room_hall/floor"))
    assert stairs[:, :, 1].max() + STOREY / RISES == pytest.approx(floor[:, :, 1].max(), abs=1e-5) == STOREY
    flight, floor_area = area_above(stairs), area_above(floor)
    assert flight.intersection(floor_area).area < 1e-5 and flight.distance(floor_area) < 1e-5


def triangles_of(stage: Usd.Stage, path: str) -> np.ndarray:
    """The triangles of a node's mesh in the building, n x 3 x 3."""
    (mesh,) = mesh_prims(stage.GetPrimAtPath(path))
    return world_points(mesh).reshape(-1, 3, 3)


@pytest.mark.parametrize("axis", ["Y", "Z"])
def test_a_city_has_every_node_at_its_place(site, tmp_path, axis):
    stage = assembled(site, tmp_path / "usd", "--up-axis", axis)
    assert_valid(stage)
    assert UsdGeom.GetStageUpAxis(stage) == axis
    turn = math.pi / 2
    # Y up: counter-clockwise from above about the origin, then east and north, which is -z.
    place = np.array([[math.cos(turn), 0, math.sin(turn), 30], [0, 1, 0, 0],
                      [-math.sin(turn), 0, math.cos(turn), -12], [0, 0, 0, 1]])
    for building, at in (("house", np.identity(4)), ("tower", place)):
        for level, elevation in LEVELS:
            up = np.identity(4)
            up[1, 3] = elevation
            for node in GltfFile(site / building / f"{level}.glb").nodes:
                prim = find(stage, f"/city/{building}/{level}", node.name)
                expected = (np.identity(4) if axis == "Y" else Z_UP) @ at @ up @ node.world
                np.testing.assert_allclose(world_of(prim), expected, atol=1e-4)


def find(stage, path, name):
    return next(prim for prim in Usd.PrimRange(stage.GetPrimAtPath(path)) if prim.GetCustomDataByKey("name") == name)


def test_it_opens_without_what_it_holds(site, tmp_path):
    assembled(site, tmp_path / "usd")
    stage = Usd.Stage.Open(str(tmp_path / "usd" / "city.usda"), Usd.Stage.LoadNone)
    assert [prim.GetName() for prim in stage.Traverse(Usd.PrimAllPrimsPredicate)] == ["city", "house", "tower"]
    used = [layer.identifier for layer in stage.GetUsedLayers() if not layer.anonymous]
    assert used == [str(tmp_path / "usd" / "city.usda")]
    stage.Load("/city/tower", Usd.LoadWithoutDescendants)
    assert [prim.GetName() for prim in stage.GetPrimAtPath("/city/tower").GetAllChildren()] \
        == ["cellar", "ground", "upper"]


@pytest.mark.parametrize("axis", ["Y", "Z"])
def test_boxes_are_those_of_the_meshes(site, tmp_path, axis):
    loaded = assembled(site, tmp_path / "usd", "--up-axis", axis)
    empty = Usd.Stage.Open(str(tmp_path / "usd" / "city.usda"), Usd.Stage.LoadNone)
    for path in ("/city/house", "/city/tower"):
        hinted, true = (box_of(stage, path, hints) for stage, hints in ((empty, True), (loaded, False)))
        np.testing.assert_allclose(hinted, true, atol=1e-3)


def box_of(stage, path, use_hints):
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"], use_hints)
    box = cache.ComputeWorldBound(stage.GetPrimAtPath(path)).ComputeAlignedRange()
    return np.array([box.GetMin(), box.GetMax()])


def test_all_buildings_share_their_models(site, tmp_path):
    stage = assembled(site, tmp_path / "usd")
    assert len(list((tmp_path / "usd").rglob("desk_0.*.usdc"))) == 1
    desks = [prim for prim in stage.Traverse() if prim.IsA("Mesh") and prim.GetName() == "desk_1_101"]
    models = [{spec.layer.identifier for spec in desk.GetPrimStack() if "shared-models" in spec.layer.identifier}
              for desk in desks]
    assert len(desks) == 6 and all(model == models[0] and len(model) == 1 for model in models)


def test_one_building_is_no_city(tmp_path):
    write_level(tmp_path / "in", "house", "ground", 0.0)
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd")]) == 0
    assert (tmp_path / "usd" / "house" / "building.usda").is_file()
    assert not (tmp_path / "usd" / "city.usda").exists()


def test_buildings_in_one_folder_have_names(tmp_path):
    for building in ("house", "tower"):
        source = write_level(tmp_path / "in", building, building, 0.0)
        source.rename(tmp_path / "in" / source.name)
    assert convert.main([str(tmp_path / "in"), "--out", str(tmp_path / "usd")]) == 0
    assert sorted(file.name for file in (tmp_path / "usd").glob("*.usda")) \
        == ["city.usda", "house.building.usda", "tower.building.usda"]


def test_a_building_keeps_the_floors_that_are_whole(site, tmp_path, capsys):
    (site / "house" / "upper.glb").write_bytes(b"cut")
    assert convert.main([str(site), "--out", str(tmp_path / "usd")]) == 1
    stage = Usd.Stage.Open(str(tmp_path / "usd" / "house" / "building.usda"))
    assert [floor.GetName() for floor in stage.GetDefaultPrim().GetChildren()] == ["cellar", "ground"]


def test_a_file_alone_has_no_stage_of_its_building(site, tmp_path):
    assert convert.main([str(site / "house" / "ground.glb"), "--out", str(tmp_path / "usd")]) == 0
    assert not list((tmp_path / "usd").glob("*.usda"))


def test_a_thousand_floors_open_at_once(tmp_path):
    """The stage of a city, without its buildings' files: what a viewer reads first."""
    from roomwright.usd.assembly import write_assemblies
    from roomwright.usd.floor import Written
    from roomwright.usd.level import Level
    from roomwright.usd.settings import Settings

    box = ((0.0, 0.0, -10.0), (10.0, 3.0, 0.0))
    floors = [Written(tmp_path / f"tower-{tower}" / f"{level}.usdc",
                      Level(f"tower-{tower}", str(level), 3.0 * level, (40.0 * tower, 0.0), 0.0), box)
              for tower in range(100) for level in range(10)]
    assert len(write_assemblies(floors, Settings(root=tmp_path))) == 101
    started = time.monotonic()
    stage = Usd.Stage.Open(str(tmp_path / "city.usda"), Usd.Stage.LoadNone)
    assert time.monotonic() - started < 1.0
    assert len(stage.GetDefaultPrim().GetAllChildren()) == 100
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"], True)
    box = cache.ComputeWorldBound(stage.GetDefaultPrim()).ComputeAlignedRange()
    assert Gf.IsClose(box.GetMax(), Gf.Vec3d(40 * 99 + 10, 30, 0), 1e-3)
