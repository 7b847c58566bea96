"""What convert.py writes for simulators, read back without one."""

import json
import math

import numpy as np
import pytest
import shapely
from conftest import build_floor, furniture, write_manifest
from stairs_house import EAST, FOOT, GOING, HEAD, RISES, STOREY, block, ground, steps
from simulation_reading import at, bodies, document, extent, is_in_convex, mesh_points, run, shapes, vector
from test_usd_doors import HINGE, OPEN_TIP, SHUT_TIP, add_door, move_points

from roomwright.checks.bodies import parts_of
from roomwright.gltf_file import GltfFile
from roomwright.simulation.axes import quaternion, roll_pitch_yaw
from roomwright.simulation.bodies import Surface
from roomwright.simulation.level import read_level
from roomwright.simulation.prisms import area_of, colliders_of_shell, convex_pieces, prism

ROOM = "house/ground/101"
LEAF = "house/ground/door:d1/leaf"


def bake_of(folder, floor, name="ground"):
    """A folder as the program writes it."""
    (folder / "house").mkdir(parents=True, exist_ok=True)
    floor.write(folder / "house" / f"{name}.glb")
    write_manifest(folder)
    return folder


@pytest.fixture
def bake(floor, tmp_path):
    return bake_of(tmp_path / "out", add_door(floor))


@pytest.fixture
def mjcf(bake, tmp_path):
    assert run(bake, "--out", tmp_path / "simulation", "--format", "mjcf") == 0
    return tmp_path / "simulation" / "house" / "ground.xml"


class TestLevels:
    """The bodies of a level in MJCF."""

    def test_bodies_are_the_nodes_by_their_paths(self, mjcf):
        assert set(bodies(document(mjcf))) == {
            f"{ROOM}/floor", f"{ROOM}/desk.1", f"{ROOM}/desk.2", f"{ROOM}/lamp.1", LEAF, "house/ground/door:d1/frame"}

    def test_x_is_east_y_is_north_and_z_is_up(self, mjcf):
        found = bodies(document(mjcf))
        np.testing.assert_allclose(vector(found[f"{ROOM}/desk.1"], "pos"), [1.0, 0.4, 0.0], atol=1e-6)
        # The second desk is turned by 90°, so that x of the lamp on it runs north.
        np.testing.assert_allclose(vector(found[f"{ROOM}/lamp.1"], "pos"), [3.1, 2.5, 0.74], atol=1e-6)
        np.testing.assert_allclose(at(found[f"{ROOM}/desk.2"], np.array([1.0, 0.0, 0.0])), [3.0, 3.0, 0.0], atol=1e-6)

    @pytest.mark.parametrize(("kind", "tolerance"), [("collision", 1e-6), ("visual", 1e-6)])
    def test_shapes_cover_the_boxes_of_furniture(self, mjcf, kind, tolerance):
        root = document(mjcf)
        low, high = extent(shapes(mjcf, root, bodies(root)[f"{ROOM}/desk.2"], kind))
        np.testing.assert_allclose(low, [2.6, 1.2, 0.0], atol=tolerance)
        np.testing.assert_allclose(high, [3.4, 2.8, 0.74], atol=tolerance)

    def test_every_mesh_is_there_and_used_and_no_file_is_left_over(self, mjcf):
        root = document(mjcf)
        files = {mesh.get("file") for mesh in root.find("asset")}
        folder = mjcf.parent / root.find("compiler").get("meshdir")
        assert files == {file.name for file in folder.iterdir()} and files
        assert {geom.get("mesh") for geom in root.iter("geom")} - {None} == {mesh.get("name") for mesh in root.find("asset")}
        for file in files:
            assert len(mesh_points(folder / file)) >= 4, "MuJoCo rejects smaller meshes"

    def test_equal_models_share_their_meshes(self, mjcf):
        found = bodies(document(mjcf))
        one, other = ({geom.get("mesh") for geom in found[f"{ROOM}/desk.{number}"].iter("geom")} for number in (1, 2))
        assert one == other

    def test_nothing_but_leaves_moves(self, mjcf):
        moving = {name for name, body in bodies(document(mjcf)).items() if body.find("joint") is not None
                  or body.find("freejoint") is not None}
        assert moving == {LEAF}

    def test_colours_are_those_of_the_materials(self, mjcf):
        desk = bodies(document(mjcf))[f"{ROOM}/desk.1"]
        colours = [geom.get("rgba") for geom in desk.iter("geom") if geom.get("class") == "visual"]
        # (0.5, 0.3, 0.1) in linear light, and white glass.
        assert sorted(colours) == ["0.735 0.584 0.349 1", "1 1 1 0.4"]

    def test_the_same_bake_gives_the_same_bytes(self, bake, mjcf, tmp_path):
        first = contents(mjcf.parents[1])
        assert run(bake, "--out", tmp_path / "again", "--format", "mjcf") == 0
        assert contents(tmp_path / "again") == first
        assert run(bake, "--out", tmp_path / "simulation", "--format", "mjcf") == 0
        assert contents(mjcf.parents[1]) == first

    def test_a_building_has_its_levels_at_their_elevations(self, bake, tmp_path):
        upper = build_floor()
        upper.find("house/ground")["extras"] |= {"level": "upper", "elevation": 2.9}
        upper.find("house/ground")["name"] = "house/upper"
        bake_of(bake, upper, "upper")
        assert run(bake, "--out", tmp_path / "simulation", "--format", "mjcf", "--movable") == 0
        file = tmp_path / "simulation" / "house" / "building.xml"
        found = bodies(document(file))
        for body in ("desk.1", "lamp.1"):
            lower, higher = (vector(found[f"house/{level}/101/{body}"], "pos") for level in ("ground", "upper"))
            np.testing.assert_allclose(higher - lower, [0.0, 0.0, 2.9], atol=1e-6)
        assert len(found) == 6 + 4
        assert document(file).find("contact/exclude").get("body1") == LEAF
        names = [mesh.get("name") for mesh in document(file).find("asset")]
        assert len(names) == len(set(names))

    def test_one_level_makes_no_building(self, mjcf):
        assert [file.name for file in mjcf.parent.iterdir()] == ["ground.xml"]


def contents(folder):
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in folder.rglob("*")
            if file.is_file() and file.name != "converted.json"}


class TestDoors:
    """Leaves in MJCF."""

    @pytest.mark.parametrize(("turn", "hinge", "shut", "wide_open", "limits"), [
        (math.pi / 2, HINGE, SHUT_TIP, OPEN_TIP, (0.0, math.pi / 2)),
        (-math.pi / 2, HINGE, SHUT_TIP, [1.0, -0.9], (-math.pi / 2, 0.0)),
        (math.pi / 6, HINGE, SHUT_TIP, OPEN_TIP, (0.0, math.pi / 2)),
        (math.pi / 2, SHUT_TIP, HINGE, [1.9, 0.9], (-math.pi / 2, 0.0)),
    ])
    def test_a_leaf_hinges_between_shut_and_open(self, floor, tmp_path, turn, hinge, shut, wide_open, limits):
        bake = bake_of(tmp_path / "out", add_door(floor, turn, hinge, shut, wide_open))
        assert run(bake, "--out", tmp_path, "--format", "mjcf") == 0
        leaf = bodies(document(tmp_path / "house" / "ground.xml"))[LEAF]
        joint = leaf.find("joint")
        assert (joint.get("class"), joint.get("axis"), joint.get("pos")) == ("hinge", "0 0 1", None)
        np.testing.assert_allclose(vector(leaf, "pos"), [*hinge, 0.0], atol=1e-6)
        np.testing.assert_allclose(vector(joint, "range"), limits, atol=1e-5)
        # Turned back by the angle that it has now, the leaf is shut; turned to its other limit, it is open.
        now = float(joint.get("ref"))
        for angle, tip in ((0.0, shut), (sum(limits), wide_open)):
            swing = angle - now
            own = 0.9 * np.array([math.cos(swing), math.sin(swing), 0.0])
            np.testing.assert_allclose(at(leaf, own)[:2], tip, atol=1e-5)

    def test_a_leaf_has_the_mass_of_its_wood_and_its_own_inertia(self, mjcf):
        inertial = bodies(document(mjcf))[LEAF].find("inertial")
        mass = 330 * 0.9 * 0.04 * 2.0
        assert float(inertial.get("mass")) == pytest.approx(mass, rel=1e-4)
        np.testing.assert_allclose(vector(inertial, "pos"), [0.45, 0.0, 1.0], atol=1e-6)
        expected = [mass / 12 * (0.04**2 + 2.0**2), mass / 12 * (0.9**2 + 2.0**2), mass / 12 * (0.9**2 + 0.04**2)]
        np.testing.assert_allclose(vector(inertial, "diaginertia"), expected, rtol=1e-4)

    def test_a_leaf_does_not_collide_with_its_own_frame(self, mjcf):
        excluded = [(pair.get("body1"), pair.get("body2")) for pair in document(mjcf).find("contact")]
        assert excluded == [(LEAF, "house/ground/door:d1/frame")]

    def test_a_leaf_that_was_tipped_over_stays(self, floor, tmp_path):
        add_door(floor).find("leaf@door:d1")["rotation"] = [0.5, 0.5, 0.5, 0.5]
        assert run(bake_of(tmp_path / "out", floor), "--out", tmp_path, "--format", "mjcf") == 0
        leaf = bodies(document(tmp_path / "house" / "ground.xml"))[LEAF]
        assert leaf.find("joint") is None and leaf.find("geom") is not None

    def test_sliding_leaves_run_behind_each_other(self, floor, tmp_path):
        opening = floor.document["nodes"].index(floor.find("door:d1"))
        floor.find("door:d1")["extras"]["closure"] = "sliding"
        for number, (x, z) in enumerate([(-0.4, 0.02), (0.4, -0.02)], 1):
            mesh = floor.box_mesh(f"panel.{number}", 0.9, 0.03, 2.0)
            floor.node(f"leaf.{number}@door:d1", {"kind": "part", "part": "leaf", "id": f"leaf.{number}", "tags": []},
                       opening, mesh, at=(x, 0, z))
        assert run(bake_of(tmp_path / "out", floor), "--out", tmp_path, "--format", "mjcf") == 0
        found = bodies(document(tmp_path / "house" / "ground.xml"))
        joints = [found[f"house/ground/door:d1/leaf.{number}"].find("joint") for number in (1, 2)]
        assert [joint.get("class") for joint in joints] == ["slide", "slide"]
        assert [joint.get("axis") for joint in joints] == ["1 0 0", "-1 0 0"]
        for joint in joints:
            np.testing.assert_allclose(vector(joint, "range"), [0.0, 0.84], atol=1e-5)


class TestMovable:
    """Pieces that are free bodies."""

    def free(self, floor, tmp_path, *limit):
        out = tmp_path / "simulation"
        assert run(bake_of(tmp_path / "out", floor), "--out", out, "--format", "mjcf", "--movable", *limit) == 0
        file = out / "house" / "ground.xml"
        return file, {name.rsplit("/", 1)[1]: body for name, body in bodies(document(file)).items()
                      if body.find("freejoint") is not None}

    def test_light_pieces_are_free_and_heavy_ones_are_not(self, floor, tmp_path):
        _, free = self.free(floor, tmp_path)
        assert set(free) == {"lamp.1"}, "a desk weighs 43 kg"
        assert float(free["lamp.1"].find("inertial").get("mass")) == pytest.approx(60 * 0.2 * 0.2 * 0.3, rel=1e-4)
        assert (vector(free["lamp.1"].find("inertial"), "diaginertia") > 0).all()

    def test_the_limit_is_given_in_kilograms(self, floor, tmp_path):
        assert set(self.free(floor, tmp_path, 50)[1]) == {"desk.1", "desk.2", "lamp.1"}
        assert set(self.free(floor, tmp_path, 0.5)[1]) == set()

    @pytest.mark.parametrize(("class_name", "height", "side"), [("picture", 1.5, "front"), ("toilet", 0.0, "above")])
    def test_what_is_mounted_stays(self, floor, tmp_path, class_name, height, side):
        room = floor.document["nodes"].index(floor.find("room:101"))
        mesh = floor.box_mesh(class_name, 0.2, 0.2, 0.2)
        floor.node(f"{class_name}.9@101", furniture(class_name, 9, "wall.0", side, (0.2, 0.2, 0.2)), room, mesh,
                   at=(2.0, height, -1.0))
        assert set(self.free(floor, tmp_path)[1]) == {"lamp.1"}

    def test_what_carries_a_mounted_piece_stays(self, floor, tmp_path):
        floor.find("lamp.1@101")["extras"]["side"] = "front"
        assert set(self.free(floor, tmp_path, 50)[1]) == {"desk.1"}

    def test_free_pieces_are_a_millimetre_narrower_and_as_high(self, floor, tmp_path):
        file, free = self.free(floor, tmp_path, 50)
        low, high = extent(shapes(file, document(file), free["desk.1"]))
        np.testing.assert_allclose(low, [0.201, 0.001, 0.0], atol=1e-6)
        np.testing.assert_allclose(high, [1.799, 0.799, 0.74], atol=1e-6)


    @pytest.mark.parametrize(("height", "is_free"), [(0.74, True), (0.739, True), (0.73, False), (0.3, False)])
    def test_a_piece_inside_of_another_is_fixed(self, floor, tmp_path, height, is_free):
        floor.find("lamp.1@101")["translation"][1] = height
        assert set(self.free(floor, tmp_path)[1]) == ({"lamp.1"} if is_free else set())

    def test_boxes_that_overlap_beside_each_other_are_free(self, floor, tmp_path):
        """The boxes around two turned pieces overlap, the pieces do not."""
        room = floor.document["nodes"].index(floor.find("room:101"))
        mesh = floor.box_mesh("stool", 0.4, 0.4, 0.4)
        for number, (x, z) in enumerate([(0.0, 0.0), (0.3, 0.3)], 1):
            floor.node(f"stool.{number}@101", furniture("stool", number, "floor", "above", (0.4, 0.4, 0.4)), room, mesh,
                       at=(1.0 + x, 0.0, -2.0 + z), turn=math.pi / 4)
        assert set(self.free(floor, tmp_path)[1]) == {"lamp.1", "stool.1", "stool.2"}


class TestShapes:
    """Walls and floors as convex pieces."""

    def test_an_area_with_a_hole_stays_open(self):
        area = shapely.box(0, 0, 4, 3).difference(shapely.box(1, 1, 2, 2))
        segments = np.concatenate([rings_of(ring) for ring in (area.exterior, *area.interiors)])
        pieces = convex_pieces(area_of(segments))
        assert sum(piece.area for piece in pieces) == pytest.approx(11.0)
        assert not any(piece.contains(shapely.Point(1.5, 1.5)) for piece in pieces)
        assert all(piece.area == pytest.approx(piece.convex_hull.area) for piece in pieces)

    def test_a_mitred_wall_is_one_prism_and_a_square_one_a_box(self):
        mitred = prism(shapely.Polygon([(0, 0), (4, 0), (4.3, 0.3), (-0.3, 0.3)]), 0.0, 2.5)
        assert isinstance(mitred, Surface) and mitred.volume == pytest.approx(4.3 * 0.3 * 2.5)
        turned = shapely.affinity.rotate(shapely.box(0, 0, 4, 0.3), 30)
        box = prism(turned, 0.0, 2.5)
        assert sorted(box.half) == pytest.approx([0.15, 1.25, 2.0])
        np.testing.assert_allclose(sorted(map(tuple, np.round(box.corners[box.corners[:, 2] == 0][:, :2], 6))),
                                   sorted(map(tuple, np.round(shapely.get_coordinates(turned)[:4], 6))), atol=1e-6)

    @pytest.mark.parametrize(("size", "height", "is_obstacle"), [
        ((2.0, 0.01, 0.07), 0.0, False), ((0.08, 0.01, 0.08), 0.3, False), ((2.0, 0.05, 0.05), 1.0, True),
        ((2.0, 0.1, 2.5), 0.0, True),
    ])
    def test_skirting_boards_and_sockets_are_no_obstacles_and_rails_are(self, size, height, is_obstacle, tmp_path):
        floor = build_floor()
        mesh = floor.box_mesh("walls", *size)
        for accessor in {primitive["attributes"]["POSITION"] for primitive in floor.document["meshes"][mesh]["primitives"]}:
            move_points(floor, accessor, (0.0, height, 0.0))
        room = floor.document["nodes"].index(floor.find("room:101"))
        floor.node("walls@101", {"kind": "part", "part": "walls", "id": "walls", "tags": []}, room, mesh)
        level = read_level(GltfFile(floor.write(tmp_path / "ground.glb")), None)
        found = next(body for body in level.bodies if body.name == f"{ROOM}/walls")
        assert bool(found.colliders) is is_obstacle and found.visuals

    def test_pieces_fill_the_parts_of_a_baked_level(self, baked):
        gltf = GltfFile(min(baked.rglob("*.glb"), key=lambda file: file.stat().st_size))
        slabs = [node for node in gltf.nodes if node.extras.get("part") in ("floor", "ceiling", "threshold")]
        parts = [part for node in slabs if node.mesh is not None for part in parts_of(gltf.primitives(node.mesh))]
        assert len(parts) > 5
        for part in parts:
            whole = Surface(part.corners, part.triangles).volume
            assert sum(piece.volume for piece in colliders_of_shell(part)) == pytest.approx(whole, rel=1e-3)

    def test_doorways_of_a_baked_level_are_open_and_the_walls_beside_them_are_not(self, baked, tmp_path):
        source = min(baked.rglob("*.glb"), key=lambda file: file.stat().st_size)
        assert run(source, "--out", tmp_path, "--format", "mjcf") == 0
        file = tmp_path / f"{source.stem}.xml"
        root = document(file)
        shell = [corners for name, body in bodies(root).items() if body.find("joint") is None
                 and name.rsplit("/", 1)[1] in ("walls", "frame", "floor", "threshold") for corners in shapes(file, root, body)]
        doors = [node for node in GltfFile(source).nodes if node.extras.get("closure") in ("door", "sliding", "passage")]
        assert len(doors) > 3
        for door in doors:
            for across, height, is_open in ((0.0, 1.0, True), (0.35, 0.1, True), (-0.35, 1.8, True),
                                            (0.0, door.extras["height"] + 0.15, False)):
                # Beside the middle of the wall, where the halves of both rooms meet.
                east, up, south = (door.world @ [across * door.extras["width"], height, 0.03, 1.0])[:3]
                point = np.array([east, -south, up])
                assert any(is_in_convex(point, corners) for corners in shell) is not is_open, (door.name, across, height)


class TestStairs:
    """Steps that one can climb."""

    def colliders(self, tmp_path, bodies=None):
        level = read_level(GltfFile(ground(bodies).write(tmp_path / "ground.glb")), None)
        return next(body for body in level.bodies if body.name == "house/ground/hall/stairs").colliders

    def test_each_step_is_a_shape_of_its_own(self, tmp_path):
        found = self.colliders(tmp_path)
        tops = sorted(collider.corners[:, 2].max() for collider in found)
        assert tops == pytest.approx([STOREY / RISES * number for number in range(1, RISES)], abs=1e-5)
        # One stands on the second step as on the mesh: nothing fills what is above it, as the hull of the flight would.
        over = [collider for collider in found if is_in_convex(np.array([0.5, FOOT + 1.9 * GOING, 0.45]), collider.corners)]
        assert over == []

    def test_what_is_under_a_flight_stays_free(self, tmp_path):
        below = np.array([0.5, HEAD - GOING / 2, 2.6 - STOREY / RISES - 0.14 - 0.01])
        assert not any(is_in_convex(below, collider.corners) for collider in self.colliders(tmp_path))

    def test_handrails_and_low_steps_are_obstacles(self, tmp_path):
        rail, post = block((EAST - 0.04, FOOT, 0.9), (EAST, HEAD, 0.94)), block((0.5, FOOT, 0.9), (0.55, FOOT + 0.05, 0.95))
        low = block((0.0, FOOT - GOING, 0.0), (EAST, FOOT, 0.05))
        assert len(self.colliders(tmp_path, [*steps(), rail, post, low])) == RISES - 1 + 3


def rings_of(ring) -> np.ndarray:
    points = shapely.get_coordinates(ring)
    return np.stack([points[:-1], points[1:]], axis=1)


@pytest.mark.parametrize("turn", [(0, 0, 0), (0, 0, 180), (0, 0, -90), (180, 0, 0), (0, 180, 0), (20, -40, 130), (0, 90, 30)])
def test_angles_and_quaternions_are_the_rotation(turn):
    def about(axis, degrees):
        angle, (i, j) = math.radians(degrees), [(1, 2), (2, 0), (0, 1)][axis]
        matrix = np.identity(3)
        matrix[[i, j], [i, j]] = math.cos(angle)
        matrix[i, j], matrix[j, i] = -math.sin(angle), math.sin(angle)
        return matrix

    def composed(roll, pitch, yaw):
        return about(2, yaw) @ about(1, pitch) @ about(0, roll)

    matrix = composed(*turn)
    np.testing.assert_allclose(composed(*np.degrees(roll_pitch_yaw(matrix))), matrix, atol=1e-9)
    w, x, y, z = quaternion(matrix)
    own = np.array([w, x, y, z])
    assert np.linalg.norm(own) == pytest.approx(1.0)
    for axis in np.identity(3):
        turned = axis + 2 * np.cross([x, y, z], np.cross([x, y, z], axis) + w * axis)
        np.testing.assert_allclose(turned, matrix @ axis, atol=1e-9)


class TestUrdf:
    """The same level in URDF."""

    @pytest.fixture
    def urdf(self, bake, tmp_path):
        assert run(bake, "--out", tmp_path / "simulation", "--format", "urdf", "--movable") == 0
        return tmp_path / "simulation" / "house" / "ground.urdf"

    def test_every_link_has_one_joint_to_the_world(self, urdf):
        root = document(urdf)
        links = [link.get("name") for link in root.iter("link")]
        joints = {joint.find("child").get("link"): joint for joint in root.iter("joint")}
        assert len(links) == len(set(links)) and set(joints) == {*links} - {"world"}
        assert {joint.find("parent").get("link") for joint in joints.values()} == {"world"}
        kinds = {name: joint.get("type") for name, joint in joints.items() if joint.get("type") != "fixed"}
        assert kinds == {LEAF: "revolute", f"{ROOM}/lamp.1": "floating"}

    def test_a_leaf_is_shut_at_zero(self, urdf):
        joint = next(joint for joint in document(urdf).iter("joint") if joint.get("type") == "revolute")
        np.testing.assert_allclose(vector(joint.find("origin"), "xyz"), [1.0, 0.0, 0.0], atol=1e-6)
        np.testing.assert_allclose(vector(joint.find("origin"), "rpy"), [0.0, 0.0, 0.0], atol=1e-6)
        limit = joint.find("limit")
        assert (float(limit.get("lower")), float(limit.get("upper"))) == pytest.approx((0.0, math.pi / 2), abs=1e-5)
        assert float(joint.find("dynamics").get("damping")) > 0

    def test_meshes_are_named_by_paths_from_the_file(self, urdf):
        files = {mesh.get("filename") for mesh in document(urdf).iter("mesh")}
        assert files and all((urdf.parent / file).is_file() and file.startswith("../shared-meshes/") for file in files)

    def test_moving_links_have_masses(self, urdf):
        links = {link.get("name"): link for link in document(urdf).iter("link")}
        for name in (LEAF, f"{ROOM}/lamp.1"):
            inertial = links[name].find("inertial")
            assert float(inertial.find("mass").get("value")) > 0
            assert all(float(inertial.find("inertia").get(key)) > 0 for key in ("ixx", "iyy", "izz"))

    def test_another_format_replaces_the_first(self, bake, urdf):
        out = urdf.parents[1]
        assert run(bake, "--out", out, "--format", "mjcf") == 0
        assert [file.name for file in urdf.parent.iterdir()] == ["ground.xml"]


class TestFaults:
    """Inputs that are no bake, damaged files, options that do not fit."""

    def test_a_folder_without_a_manifest_is_no_bake(self, bake, tmp_path, capsys):
        (bake / "manifest.json").unlink()
        assert run(bake, "--out", tmp_path / "simulation", "--format", "mjcf") == 2
        assert f"{bake} is no bake: it has no manifest.json; hint: `roomwright bake" in capsys.readouterr().err
        assert not (tmp_path / "simulation").exists()

    @pytest.mark.parametrize("text", ["", "[]", '{"levels": [{}]}', '{"levels": 7}'])
    def test_a_damaged_manifest_is_named(self, bake, tmp_path, capsys, text):
        (bake / "manifest.json").write_text(text)
        assert run(bake, "--out", tmp_path / "simulation", "--format", "urdf") == 2
        assert f"{bake / 'manifest.json'} is no manifest" in capsys.readouterr().err

    def test_a_missing_level_is_named(self, bake, tmp_path, capsys):
        (bake / "house" / "ground.glb").unlink()
        assert run(bake, "--out", tmp_path / "simulation", "--format", "mjcf") == 2
        assert "lists 'house/ground.glb', which is not there; hint: bake again" in capsys.readouterr().err

    def test_a_damaged_level_is_named_and_the_others_are_written(self, bake, tmp_path, capsys):
        data = (bake / "house" / "ground.glb").read_bytes()
        (bake / "house" / "broken.glb").write_bytes(data[:len(data) // 2])
        write_manifest(bake)
        assert run(bake, "--out", tmp_path / "simulation", "--format", "mjcf") == 1
        assert f"convert: {bake / 'house' / 'broken.glb'}: " in capsys.readouterr().err
        assert [file.name for file in (tmp_path / "simulation" / "house").iterdir()] == ["ground.xml"]

    def test_a_scene_of_another_kind_is_refused(self, bake, floor, tmp_path, capsys):
        floor.find("house/ground")["extras"]["kind"] = "other"
        assert run(floor.write(tmp_path / "other.glb"), "--format", "mjcf") == 1
        assert "its first node 'house/ground' is no level" in capsys.readouterr().err
        assert not (tmp_path / "other.xml").exists()

    def test_a_level_without_meshes_of_its_own_is_refused(self, floor, tmp_path, capsys):
        for node in floor.document["nodes"]:
            node.pop("mesh", None)
        assert run(floor.write(tmp_path / "web.glb"), "--format", "mjcf") == 1
        assert "hint: bake without `--profile web`" in capsys.readouterr().err

    @pytest.mark.parametrize(("options", "message"), [
        (["--format", "sdf"], "invalid choice: 'sdf'"),
        (["--movable"], "--movable is for --format mjcf and urdf, not usdc"),
        (["--format", "mjcf", "--movable", "0"], "0 is no mass; hint: kilograms over 0"),
        (["--format", "urdf", "--physics"], "--physics is for USD, not urdf"),
        (["--format", "mjcf", "--up-axis", "Z"], "--up-axis is for USD, not mjcf"),
    ])
    def test_options_that_do_not_fit_are_refused(self, bake, capsys, options, message):
        with pytest.raises(SystemExit) as ended:
            run(bake, *options)
        assert ended.value.code == 2
        assert message in capsys.readouterr().err


def test_the_record_lists_every_file(mjcf):
    record = json.loads((mjcf.parents[1] / "converted.json").read_text())
    assert {entry["path"] for entry in record["files"]} == set(contents(mjcf.parents[1]))
