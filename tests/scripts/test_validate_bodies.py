"""Meshes measured by validate.py: their health, their rooms, each other. Faults beside their smallest neighbours."""

import numpy as np
import pytest
from conftest import FACES, furniture

from roomwright.checks.bodies import parts_of
from roomwright.checks.geometry import check_collisions, check_containment, check_pieces
from roomwright.checks.overlap import overlap
from roomwright.gltf_file import GltfFile


def box(low, high, faces=FACES) -> dict:
    """A primitive: an upright box."""
    corners = np.array([corner for _, face in faces for corner in face], float)
    positions = np.array(low) + corners * (np.array(high) - low)
    first = np.arange(len(faces))[:, None] * 4
    return {"positions": positions, "triangles": (first + [0, 1, 2, 0, 2, 3]).reshape(-1, 3)}


def tray(low, high, wall) -> dict:
    """A primitive that is not convex: an open box with walls and a bottom, one closed surface."""
    outer, inner = box(low, high, [face for face in FACES if face[0] != (0, 1, 0)]), None
    low, high = np.array(low, float), np.array(high, float)
    inner = box(low + wall, high - (wall, 0, wall), [face for face in FACES if face[0] != (0, 1, 0)])
    rim = [[low[0], low[2]], [high[0], low[2]], [high[0], high[2]], [low[0], high[2]]]
    hole = [[low[0] + wall, low[2] + wall], [high[0] - wall, low[2] + wall],
            [high[0] - wall, high[2] - wall], [low[0] + wall, high[2] - wall]]
    top = np.array([[x, high[1], z] for x, z in rim + hole])
    ring = [[side, 4 + side, (side + 1) % 4] for side in range(4)]
    ring += [[4 + side, 4 + (side + 1) % 4, (side + 1) % 4] for side in range(4)]
    count, more = len(outer["positions"]), len(inner["positions"])
    return {"positions": np.concatenate([outer["positions"], inner["positions"], top]),
            "triangles": np.concatenate([outer["triangles"], inner["triangles"][:, ::-1] + count,
                                         np.array(ring) + count + more])}


def only(primitive):
    parts = parts_of([primitive])
    assert len(parts) == 1
    return parts[0]


def turned(degrees, at=(0.0, 0.0, 0.0)) -> np.ndarray:
    turn = np.radians(degrees)
    return np.array([[np.cos(turn), 0, np.sin(turn), at[0]], [0, 1, 0, at[1]],
                     [-np.sin(turn), 0, np.cos(turn), at[2]], [0, 0, 0, 1]])


class TestParts:
    """Meshes taken apart."""

    def test_boxes_that_touch_nowhere_are_two(self):
        one, other = box((0, 0, 0), (1, 1, 1)), box((2, 0, 0), (3, 1, 1))
        both = {"positions": np.concatenate([one["positions"], other["positions"]]),
                "triangles": np.concatenate([one["triangles"], other["triangles"] + 24])}
        parts = parts_of([both])
        assert sorted(part.low[0] for part in parts) == [0.0, 2.0]
        assert all(part.is_convex and len(part.corners) == 8 and len(part.triangles) == 12 for part in parts)
        assert all(len(part.normals) == 3 for part in parts), "of opposite faces one"

    def test_a_tray_is_not_convex(self):
        part = only(tray((0, 0, 0), (1, 0.5, 1), 0.1))
        assert not part.is_convex and len(part.corners) == 16

    def test_a_part_turns_with_its_piece(self):
        part = only(box((0, 0, 0), (1, 1, 1))).placed(turned(90))
        np.testing.assert_allclose([part.low, part.high], [(0, 0, -1), (1, 1, 0)], atol=1e-12)


class TestOverlap:
    """How deep parts are in each other."""

    def test_boxes_overlap_by_the_shortest_way_out(self):
        one = only(box((0, 0, 0), (1, 1, 1)))
        assert overlap(one, only(box((0.9, 0.2, 0.3), (2, 2, 2))), 0.004) == pytest.approx(0.1)
        assert overlap(one, only(box((1, 0, 0), (2, 1, 1))), 0.004) == pytest.approx(0.0)
        assert overlap(one, only(box((1.5, 0, 0), (2, 1, 1))), 0.004) == pytest.approx(-0.5)

    def test_crossing_boards_overlap_though_no_corner_is_inside(self):
        one, other = only(box((-2, 0, -0.1), (2, 0.2, 0.1))), only(box((-0.1, 0.1, -2), (0.1, 0.3, 2)))
        assert overlap(one, other, 0.004) == pytest.approx(0.1)

    def test_boxes_that_only_their_boxes_overlap_are_apart(self):
        one = only(box((0, 0, 0), (1, 1, 1)))
        for gap, expected in ((0.01, False), (-0.01, True)):
            # A side lies across the diagonal, before the first one's corner.
            reach = 1.0 + (0.5 + gap) * np.sqrt(0.5)
            other = only(box((-0.5, 0, -0.5), (0.5, 1, 0.5))).placed(turned(0, (reach, 0, reach)) @ turned(45))
            assert (overlap(one, other, 0.004) > 0.004) is expected

    def test_slanted_edges_that_pass_each_other_are_apart(self):
        """Two sticks crossing in the air: only a cross product of edges tells."""
        tip = np.array([[1, 0, 0, 0], [0, 0.6, -0.8, 0], [0, 0.8, 0.6, 0], [0, 0, 0, 1]])
        roll = np.array([[0.8, -0.6, 0, 0], [0.6, 0.8, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        stick = only(box((-1, -0.05, -0.05), (1, 0.05, 0.05)))
        first, second = stick.placed(roll @ turned(20)), stick.placed(tip @ turned(70))
        normal = np.cross(*(matrix[:3, :3] @ [1, 0, 0] for matrix in (roll @ turned(20), tip @ turned(70))))
        for gap, expected in ((0.142, False), (0.05, True)):
            shift = np.identity(4)
            shift[:3, 3] = normal / np.linalg.norm(normal) * gap
            assert (overlap(first, second.placed(shift), 0.004) > 0.004) is expected

    def test_a_thing_in_a_tray_is_not_in_its_walls(self):
        dish = only(tray((0, 0, 0), (1, 0.5, 1), 0.1))
        assert overlap(dish, only(box((0.3, 0.1, 0.3), (0.6, 0.4, 0.6))), 0.004) == 0.0
        assert overlap(dish, only(box((0.3, 0.07, 0.3), (0.6, 0.4, 0.6))), 0.004) == pytest.approx(0.03, abs=1e-6)
        assert overlap(dish, only(box((0.05, 0.2, 0.3), (0.6, 0.4, 0.6))), 0.004) == pytest.approx(0.05, abs=2e-3)


class TestCollisions:
    """Pieces of a room."""

    def faults(self, floor, tmp_path):
        notes = check_collisions(GltfFile(floor.write(tmp_path / "floor.glb")))
        return [f"{note.code} {note.node}: {note.message}" for note in notes]

    def test_side_by_side_is_no_collision_and_five_millimetres_are(self, floor, tmp_path):
        # Desk 2 is turned: its long side is along z, from x = 2.6 to 3.4.
        for x, expected in ((1.8, []), (1.803, []),
                            (1.805, ["collision desk.2@101: it is 5 mm inside of desk.1@101"])):
            floor.find("desk.1@101")["translation"] = [x, 0.0, -1.8]
            assert self.faults(floor, tmp_path) == expected

    def test_what_lies_as_flat_as_a_rug_is_floor(self, floor, tmp_path):
        desk = floor.find("desk.1@101")
        desk["translation"] = [3.0, 0.0, -1.8]
        desk["scale"] = [1.0, 0.02, 1.0]
        assert self.faults(floor, tmp_path) == []
        desk["scale"] = [1.0, 0.05, 1.0]
        assert self.faults(floor, tmp_path) != []

    def test_one_above_the_other_is_none(self, floor, tmp_path):
        floor.find("desk.1@101")["translation"] = [3.0, 1.2, -2.0]
        assert self.faults(floor, tmp_path) == []
        floor.find("desk.1@101")["translation"] = [3.0, 0.7, -2.0]
        # Named by the later of the two; the lamp on the second desk is in it too.
        assert self.faults(floor, tmp_path) == ["collision desk.2@101: it is 40 mm inside of desk.1@101",
                                                "collision lamp.1@101: it is 25 mm inside of desk.1@101"]

    def test_a_lamp_may_sink_as_far_as_models_leave_their_shapes(self, floor, tmp_path):
        for height, expected in ((0.74, []), (0.705, []),
                                 (0.695, ["collision lamp.1@101: it is 45 mm inside of desk.2@101"])):
            floor.find("lamp.1@101")["translation"] = [0.5, height, 0.1]
            assert self.faults(floor, tmp_path) == expected

    def test_a_seat_under_a_table_is_none_and_in_its_leg_is(self, floor, tmp_path):
        room = floor.document["nodes"].index(floor.find("room:101"))
        table = floor.box_mesh("table", 1.2, 0.8, 0.04)
        for part in (floor.box_mesh("leg", 0.05, 0.05, 0.7),):
            floor.document["meshes"][table]["primitives"] += floor.document["meshes"].pop(part)["primitives"]
        stool = floor.box_mesh("stool", 0.3, 0.3, 0.45)
        # The table's top lies at the floor of its mesh here, so the piece hangs upside down: top at 0, leg upwards.
        floor.node("table.1@101", furniture("table", 1, "floor", "above", (1.2, 0.8, 0.7)), room, table, at=(1, 1, -2))
        floor.node("stool.1@101", furniture("stool", 1, "floor", "above", (0.3, 0.3, 0.45)), room, stool,
                   at=(1.3, 1.1, -2))
        assert self.faults(floor, tmp_path) == []
        floor.find("stool.1@101")["translation"] = [1.1, 1.1, -2]
        assert self.faults(floor, tmp_path) == ["collision stool.1@101: it is 75 mm inside of table.1@101"]

    def test_other_rooms_are_other_places(self, floor, tmp_path):
        other = dict(floor.find("room:101")["extras"]) | {"room": "102"}
        room = floor.node("room:102", other, 0)
        desk = floor.find("desk.1@101")
        floor.node("desk.9@102", furniture("desk", 9, "floor", "above", (1.6, 0.8, 0.74)), room, desk["mesh"],
                   at=desk["translation"])
        assert self.faults(floor, tmp_path) == []


class TestContainment:
    """Pieces in their rooms."""

    def faults(self, floor, tmp_path):
        notes = check_containment(GltfFile(floor.write(tmp_path / "floor.glb")))
        return [f"{note.code} {note.node}: {note.message}" for note in notes]

    def test_over_a_concave_corner(self, floor, tmp_path):
        """All corners of the desk are in the room, its middle is not."""
        room, desk = floor.find("room:101")["extras"], floor.find("desk.1@101")
        room["outline"] = [[0, 0], [4, 0], [4, 3], [2, 3], [1.2, 0.6], [0.8, 0.6], [0, 3]]
        assert "2 parts of it reach out of room:101" in self.faults(floor, tmp_path)[0]
        room["outline"] = [[0, 0], [4, 0], [4, 3], [2, 3], [1.2, 0.81], [0.8, 0.81], [0, 3]]
        assert self.faults(floor, tmp_path) == []
        assert desk["translation"] == [1.0, 0.0, -0.4]

    def test_around_a_hole(self, floor, tmp_path):
        floor.find("room:101")["extras"]["holes"] = [[[0.9, 0.3], [0.9, 0.5], [1.1, 0.5], [1.1, 0.3]]]
        assert "desk.1@101: 2 parts" in self.faults(floor, tmp_path)[0]
        floor.find("room:101")["extras"]["holes"] = [[[0.9, 0.9], [0.9, 1.1], [1.1, 1.1], [1.1, 0.9]]]
        assert self.faults(floor, tmp_path) == []

    @pytest.mark.parametrize(("height", "expected"), [
        (2.5, ["containment desk.2@101: it stands in column.1@101"]),
        (0.007, ["containment desk.2@101: it stands in column.1@101"]), (0.006, [])])
    def test_in_a_column(self, floor, tmp_path, height, expected):
        room = floor.document["nodes"].index(floor.find("room:101"))
        corners = [[2.9, 1.4], [3.2, 1.4], [3.2, 1.6], [2.9, 1.6]]
        floor.node("column.1@101", {"kind": "part", "part": "column", "id": "column.1", "tags": [], "outline": corners,
                                    "height": height}, room)
        assert self.faults(floor, tmp_path) == expected


class TestHealth:
    """Meshes by themselves."""

    def faults(self, floor, tmp_path):
        return [note.message for note in check_pieces(GltfFile(floor.write(tmp_path / "floor.glb")))]

    def change(self, floor, accessor, edit):
        entry = floor.document["accessors"][accessor]
        view = floor.document["bufferViews"][entry["bufferView"]]
        start, end = view["byteOffset"], view["byteOffset"] + view["byteLength"]
        rows = np.frombuffer(floor.binary[start:end], "<u2" if entry["type"] == "SCALAR" else "<f4").copy()
        edit(rows)
        floor.binary = floor.binary[:start] + rows.tobytes() + floor.binary[end:]

    def lamp(self, floor) -> dict:
        return floor.document["meshes"][floor.find("lamp.1@101")["mesh"]]["primitives"][0]

    def test_a_sound_mesh_has_none(self, floor, tmp_path):
        assert self.faults(floor, tmp_path) == []

    def test_a_face_without_area(self, floor, tmp_path):
        self.change(floor, self.lamp(floor)["indices"], lambda rows: rows.__setitem__(1, rows[0]))
        assert "the mesh has 1 faces without area" in self.faults(floor, tmp_path)

    def test_normals_of_another_length(self, floor, tmp_path):
        self.change(floor, self.lamp(floor)["attributes"]["NORMAL"], lambda rows: rows.__imul__(2))
        assert self.faults(floor, tmp_path) == ["the mesh has 24 normals that are not one long"]

    def test_normals_that_look_inwards(self, floor, tmp_path):
        self.change(floor, self.lamp(floor)["attributes"]["NORMAL"],
                    lambda rows: rows.__setitem__(slice(0, 12), -rows[:12]))
        assert self.faults(floor, tmp_path) == ["the mesh has 6 corners whose normals look into it"]


def test_what_the_program_bakes_has_no_fault(baked):
    for source in sorted(baked.rglob("*.glb"), key=lambda file: file.stat().st_size)[:2]:
        gltf = GltfFile(source)
        assert [*check_pieces(gltf), *check_containment(gltf), *check_collisions(gltf)] == []
