"""Door leaves that turn, and what simulators get: colliders, masses, hinges."""

import math

import numpy as np
import pytest
from conftest import build_floor, furniture
from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics
from stairs_house import ground
from usd_reading import assert_same_meshes, assert_same_places, assert_valid, converted, mesh_prims, world_of

from roomwright.gltf_file import GltfFile
from roomwright.usd import physics

LEAF = "/house_ground/door_d1/leaf_door_d1"
ROOM = "/house_ground/room_101"
HINGE, SHUT_TIP, OPEN_TIP = [1.0, 0.0], [1.9, 0.0], [1.0, 0.9]


def add_door(floor, turn=math.pi / 2, hinge=HINGE, shut=SHUT_TIP, wide_open=OPEN_TIP):
    """A leaf in the floor's door, a wall's plane in the plan at y = 0; `turn` is where it stands."""
    opening = floor.document["nodes"].index(floor.find("door:d1"))
    floor.find("door:d1")["extras"]["leaves"] = [{"hinge": hinge, "closed": shut, "open": wide_open}]
    frame = floor.box_mesh("frame", 1.0, 0.1, 2.1)
    floor.node("frame@door:d1", {"kind": "part", "part": "frame", "id": "frame", "tags": []}, opening, frame,
               at=(1.45, 0, 0.05))
    # The hinge at the origin, x towards the free end.
    mesh = floor.box_mesh("leaf", 0.9, 0.04, 2.0)
    accessor = floor.document["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"]
    move_points(floor, accessor, (0.45, 0.0, 0.0))
    floor.node("leaf@door:d1", {"kind": "part", "part": "leaf", "id": "leaf", "tags": []}, opening, mesh,
               at=(hinge[0], 0, -hinge[1]), turn=turn)
    return floor


def move_points(floor, accessor, by):
    entry = floor.document["accessors"][accessor]
    view = floor.document["bufferViews"][entry["bufferView"]]
    start, end = view["byteOffset"], view["byteOffset"] + view["byteLength"]
    points = np.frombuffer(floor.binary[start:end], "<f4").reshape(-1, 3) + np.float32(by)
    floor.binary = floor.binary[:start] + points.astype("<f4").tobytes() + floor.binary[end:]
    entry |= {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}


@pytest.fixture
def source(floor, tmp_path):
    return add_door(floor).write(tmp_path / "ground.glb")


def swing(stage):
    return next(op for op in UsdGeom.Xformable(stage.GetPrimAtPath(LEAF)).GetOrderedXformOps()
                if op.GetOpName() == "xformOp:rotateY:swing")


def tip(stage, path=LEAF) -> np.ndarray:
    """The free end of the leaf on the plan: x east, y north."""
    east, _, south = (world_of(stage.GetPrimAtPath(path)) @ [0.9, 0, 0, 1])[:3]
    return np.array([east, -south])


class TestSwing:
    """The operation that turns a leaf."""

    def test_it_stands_where_it_stood_and_shuts_at_zero(self, source, tmp_path):
        stage = converted(source, tmp_path / "ground.usdc")
        assert_same_places(stage, GltfFile(source))
        np.testing.assert_allclose(tip(stage), OPEN_TIP, atol=1e-6)
        assert swing(stage).Get() == pytest.approx(90.0, abs=1e-5)
        swing(stage).Set(0.0)
        np.testing.assert_allclose(tip(stage), SHUT_TIP, atol=1e-6)

    @pytest.mark.parametrize(("turn", "wide_open", "limits"), [
        (-math.pi / 2, [1.0, -0.9], (-90.0, 0.0)),
        (math.pi / 2, OPEN_TIP, (0.0, 90.0)),
        (math.pi / 6, OPEN_TIP, (0.0, 90.0)),
        (math.pi, [0.1, 0.0], (-180.0, 0.0)),
    ])
    def test_its_limits_are_shut_and_open(self, floor, tmp_path, turn, wide_open, limits):
        source = add_door(floor, turn, wide_open=wide_open).write(tmp_path / "ground.glb")
        stage = converted(source, tmp_path / "ground.usda")
        assert_same_places(stage, GltfFile(source))
        found = stage.GetPrimAtPath(LEAF).GetCustomDataByKey("swing")
        np.testing.assert_allclose(found, limits, atol=1e-4)

    def test_a_hinge_on_the_other_side(self, floor, tmp_path):
        source = add_door(floor, math.pi / 2, SHUT_TIP, HINGE, [1.9, 0.9]).write(tmp_path / "ground.glb")
        stage = converted(source, tmp_path / "ground.usda")
        assert_same_places(stage, GltfFile(source))
        assert swing(stage).Get() == pytest.approx(-90.0, abs=1e-5)
        swing(stage).Set(0.0)
        np.testing.assert_allclose(tip(stage), HINGE, atol=1e-6)

    @pytest.mark.parametrize("damage", [{"scale": [1, 2, 1]}, {"rotation": [0.5, 0.5, 0.5, 0.5]}])
    def test_a_leaf_that_was_scaled_or_tipped_has_none(self, floor, tmp_path, damage):
        add_door(floor).find("leaf@door:d1").update(damage)
        source = floor.write(tmp_path / "ground.glb")
        stage = converted(source, tmp_path / "ground.usda")
        assert_same_places(stage, GltfFile(source))
        assert not stage.GetPrimAtPath(LEAF).HasAttribute("xformOp:rotateY:swing")

    def test_every_hinged_leaf_of_the_program_has_one(self, baked, tmp_path):
        source = min(baked.rglob("*.glb"), key=lambda file: file.stat().st_size)
        stage, gltf = converted(source, tmp_path / "floor.usdc"), GltfFile(source)
        leaves = sum(len(node.extras.get("leaves", [])) for node in gltf.nodes if node.kind == "opening")
        turning = [prim for prim in stage.Traverse() if prim.HasAttribute("xformOp:rotateY:swing")]
        assert len(turning) == leaves > 0
        for prim in turning:
            angle, (low, high) = prim.GetAttribute("xformOp:rotateY:swing").Get(), prim.GetCustomDataByKey("swing")
            assert min(abs(angle - low), abs(angle - high)) < 0.01, "baked leaves stand fully open"


class TestPhysics:
    """Colliders, bodies and joints."""

    @pytest.fixture
    def stage(self, source, tmp_path):
        return converted(source, tmp_path / "usd" / "ground.usdc", has_physics=True)

    def test_everything_collides_and_is_where_it_was(self, stage, source):
        assert_valid(stage)
        assert_same_places(stage, GltfFile(source))
        assert_same_meshes(stage, GltfFile(source))
        meshes = mesh_prims(stage.GetPseudoRoot())
        assert all(mesh.HasAPI(UsdPhysics.CollisionAPI) for mesh in meshes)
        shapes = {mesh.GetParent().GetName(): UsdPhysics.MeshCollisionAPI(mesh).GetApproximationAttr().Get()
                  for mesh in meshes}
        assert shapes["floor_101"] == shapes["frame_door_d1"] == "none", "what stays collides as it is"
        assert (shapes["desk_1_101"], shapes["lamp_1_101"]) == ("convexDecomposition", "convexHull")

    def test_stairs_are_named_and_collide_as_the_steps_that_they_are(self, tmp_path):
        source = ground().write(tmp_path / "ground.glb")
        stage = converted(source, tmp_path / "usd" / "ground.usdc", has_physics=True)
        stairs = stage.GetPrimAtPath("/house_ground/room_hall/stairs_hall")
        assert stairs.GetDisplayName() == "stairs@hall" and stairs.GetMetadata("kind") == "component"
        assert list(stairs.GetAttribute("semantics:labels:class").Get()) == ["stairs"]
        (mesh,) = mesh_prims(stairs)
        # The hull of a flight is a ramp.
        assert UsdPhysics.MeshCollisionAPI(mesh).GetApproximationAttr().Get() == "none"
        assert not stairs.HasAPI(UsdPhysics.RigidBodyAPI) and mesh.HasAPI(UsdPhysics.CollisionAPI)

    def test_without_the_option_there_is_none(self, source, tmp_path):
        stage = converted(source, tmp_path / "ground.usdc")
        assert not any("Physics" in name for prim in stage.Traverse() for name in prim.GetAppliedSchemas())

    def test_furniture_is_bodies_and_no_body_is_in_another(self, stage):
        bodies = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
        assert {prim.GetName() for prim in bodies} == {"desk_1_101", "desk_2_101", "lamp_1_101", "leaf_door_d1"}
        assert stage.GetPrimAtPath(f"{ROOM}/lamp_1_101").GetCustomDataByKey("parent") == "desk.2"
        paths = [prim.GetPath() for prim in bodies]
        assert not [path for path in paths for other in paths if path != other and path.HasPrefix(other)]

    def test_masses_are_density_times_box(self, stage):
        desk = UsdPhysics.MassAPI(stage.GetPrimAtPath(f"{ROOM}/desk_1_101")).GetMassAttr().Get()
        assert desk == pytest.approx(physics.properties_of("desk")["density"] * 1.6 * 0.8 * 0.74, rel=1e-5)
        leaf = UsdPhysics.MassAPI(stage.GetPrimAtPath(LEAF)).GetMassAttr().Get()
        assert leaf == pytest.approx(330 * 0.9 * 0.04 * 2.0, rel=1e-4)
        assert UsdPhysics.GetStageKilogramsPerUnit(stage) == 1.0

    def test_a_hinge_holds_the_leaf_where_it_is(self, stage):
        joint = UsdPhysics.RevoluteJoint(stage.GetPrimAtPath("/house_ground/door_d1/hinge_leaf_door_d1"))
        frame, leaf = (stage.GetPrimAtPath(rel.GetTargets()[0]) for rel in (joint.GetBody0Rel(), joint.GetBody1Rel()))
        assert (frame.GetName(), leaf.GetName()) == ("frame_door_d1", "leaf_door_d1")
        assert not joint.GetCollisionEnabledAttr().Get() and joint.GetAxisAttr().Get() == "Y"
        limits = joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()
        np.testing.assert_allclose(limits, (0.0, 90.0), atol=1e-4)
        # The two frames of the joint, turned by the leaf's angle, are one place in the world.
        now = Gf.Matrix4d().SetRotate(Gf.Rotation((0, 1, 0), swing(stage).Get()))
        held = now * frame_of(joint.GetLocalPos0Attr(), joint.GetLocalRot0Attr()) * Gf.Matrix4d(*world_of(frame).T.flat)
        holds = frame_of(joint.GetLocalPos1Attr(), joint.GetLocalRot1Attr()) * Gf.Matrix4d(*world_of(leaf).T.flat)
        np.testing.assert_allclose(held, holds, atol=1e-5)

    @pytest.mark.parametrize(("class_name", "height", "is_fixed"), [
        ("desk", 0.0, False), ("picture", 1.5, True), ("toilet", 0.0, True), ("corner_unit", 0.0, True),
    ])
    def test_what_hangs_or_is_mounted_stays(self, class_name, height, is_fixed, tmp_path):
        floor = build_floor()
        room = floor.document["nodes"].index(floor.find("room:101"))
        mesh = floor.box_mesh(class_name, 0.4, 0.4, 0.4)
        floor.node(f"{class_name}.9@101", furniture(class_name, 9, "wall.0", "front", (0.4, 0.4, 0.4)), room, mesh,
                   at=(2.0, height, -1.0))
        stage = converted(floor.write(tmp_path / "ground.glb"), tmp_path / "ground.usda", has_physics=True)
        prim = stage.GetPrimAtPath(f"{ROOM}/{class_name}_9_101")
        assert prim.HasAPI(UsdPhysics.RigidBodyAPI) is not is_fixed
        assert all(mesh.HasAPI(UsdPhysics.CollisionAPI) for mesh in mesh_prims(prim))

    def test_gravity_stays_with_the_stage(self, stage, tmp_path):
        scene = UsdPhysics.Scene(stage.GetPrimAtPath("/PhysicsScene"))
        assert scene.GetGravityDirectionAttr().Get() == Gf.Vec3f(0, -1, 0)
        other = Usd.Stage.CreateInMemory()
        other.DefinePrim("/A").GetReferences().AddReference(stage.GetRootLayer().identifier)
        assert not [prim for prim in other.Traverse() if prim.IsA(UsdPhysics.Scene)]

    def test_the_table_is_sound(self):
        for entry in [*physics.table()["furniture"], physics.table()["default"], physics.table()["leaf"]]:
            assert 20 <= entry["density"] <= 1000, entry
            is_floor = entry["shape"] == "" and entry["fixed"]
            assert is_floor or entry["shape"] in {"convexHull", "convexDecomposition", "boundingCube"}
            assert entry["example"]
        words = [word for entry in physics.table()["furniture"] for word in entry["words"]]
        assert len(words) == len(set(words)), "the second would never be found"
        assert physics.properties_of("desk_lamp")["density"] != physics.properties_of("desk")["density"]
        assert physics.properties_of("something_new") == physics.table()["default"]


def frame_of(position, turn) -> Gf.Matrix4d:
    return Gf.Matrix4d(Gf.Rotation(Gf.Quatd(turn.Get())), Gf.Vec3d(position.Get()))


def test_a_leaf_of_a_model_has_a_collider_of_its_own(tmp_path):
    """The same mesh with and without physics is two assets: the content differs."""
    floor = build_floor()
    source = floor.write(tmp_path / "ground.glb")
    for has_physics in (False, True):
        converted(source, tmp_path / "usd" / "ground.usdc", has_physics=has_physics)
    assets = [Sdf.Layer.FindOrOpen(str(file)) for file in (tmp_path / "usd" / "shared-models").glob("desk_0.*")]
    assert len(assets) == 2
