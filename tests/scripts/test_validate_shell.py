"""Walls, columns, frames and leaves as validate.py measures them: faults beside their smallest neighbours."""

import pytest
from conftest import Floor, furniture

from roomwright import validate
from roomwright.checks.shell import check_shell
from roomwright.gltf_file import GltfFile

SIDE, HEIGHT, THICKNESS = 3.0, 2.5, 0.1


def part(kind: str, **extras) -> dict:
    return {"kind": "part", "part": kind, "id": kind, "tags": [], **extras}


class Rooms:
    """Square rooms of 3 m in a row from the west, 0.2 m apart, a door from the first to the second."""

    def __init__(self, count: int = 1):
        self.floor = Floor()
        self.level = self.floor.node("house/ground", {"kind": "level", "building": "house", "level": "ground",
                                                      "elevation": 0.0, "height": 3.0, "seed": 1, "generator": "test"})
        self.rooms = [self._room(number) for number in range(count)]
        self.door = None
        if count > 1:
            sides = [{"room": "1", "wall": 1, "from": 1.0, "to": 2.0}, {"room": "2", "wall": 3, "from": 1.0, "to": 2.0}]
            self.door = self.floor.node("door:d", {
                "kind": "opening", "opening": "door", "closure": "door", "id": "d", "rooms": ["1", "2"], "sides": sides,
                "width": 1.0, "height": 2.0, "sill": 0.0}, self.level)

    def _room(self, number: int) -> int:
        west = number * (SIDE + 2 * THICKNESS)
        outline = [[west, 0.0], [west + SIDE, 0.0], [west + SIDE, SIDE], [west, SIDE]]
        return self.floor.node(f"room:{number + 1}", {
            "kind": "room", "room": str(number + 1), "type": "office", "style": "default", "seed": "7",
            "outline": outline, "holes": [], "height": HEIGHT, "requested": 0, "placed": 0, "removed": [],
            "grade": "none", "findings": []}, self.level)

    def box(self, owner: int, low, high, kind: str = "walls", **extras) -> None:
        """A box between two corners: x east, y north, z up."""
        size = [upper - lower for lower, upper in zip(low, high)]
        name = f"{kind}.{len(self.floor.document['nodes'])}@{owner}"
        mesh = self.floor.box_mesh(name, size[0], size[1], size[2])
        place = ((low[0] + high[0]) / 2, low[2], -(low[1] + high[1]) / 2)
        self.floor.node(name, part(kind, **extras), owner, mesh, at=place)

    def walls(self, behind: float = 0.0) -> None:
        """The four walls of the first room, their faces a distance behind the floor's edge."""
        near, far, top = -behind, SIDE + behind, HEIGHT + 0.1
        self.box(self.rooms[0], (near - 0.1, near - 0.1, 0), (far + 0.1, near, top))
        self.box(self.rooms[0], (near - 0.1, far, 0), (far + 0.1, far + 0.1, top))
        self.box(self.rooms[0], (near - 0.1, near, 0), (near, far, top))
        self.box(self.rooms[0], (far, near, 0), (far + 0.1, far, top))

    def faults(self, folder) -> list[str]:
        notes = list(check_shell(GltfFile(self.floor.write(folder / "floor.glb"))))
        assert all(note.code == "shell" for note in notes)
        return [note.message for note in notes]


class TestRooms:
    """Parts of the shell in rooms."""

    def test_walls_around_a_room_are_no_fault(self, tmp_path):
        rooms = Rooms()
        rooms.walls()
        assert rooms.faults(tmp_path) == []

    @pytest.mark.parametrize(("depth", "count"), [(0.008, 0), (0.03, 1)])
    def test_a_wall_may_reach_a_centimetre_into_a_room(self, tmp_path, depth, count):
        rooms = Rooms()
        rooms.walls()
        rooms.box(rooms.rooms[0], (-0.1, 1.0, 0.0), (depth, 1.2, HEIGHT))
        found = rooms.faults(tmp_path)
        assert len(found) == count and all("30 mm into room:1" in message for message in found)

    def test_a_wall_of_another_room_is_measured_too(self, tmp_path):
        rooms = Rooms(2)
        rooms.box(rooms.rooms[1], (2.7, 2.5, 0.0), (3.2, 2.6, HEIGHT))
        assert any("300 mm into room:1" in message for message in rooms.faults(tmp_path))

    def test_a_thin_post_in_the_middle_is_found(self, tmp_path):
        rooms = Rooms()
        rooms.walls()
        rooms.box(rooms.rooms[0], (1.5, 1.5, 0.0), (1.51, 1.51, HEIGHT))
        assert len(rooms.faults(tmp_path)) == 1

    @pytest.mark.parametrize("low", [0.3, HEIGHT])
    def test_what_is_above_the_ceiling_is_not_in_the_room(self, tmp_path, low):
        rooms = Rooms()
        rooms.walls()
        rooms.box(rooms.rooms[0], (-0.1, 1.0, low), (0.5, 1.2, low + 0.2))
        assert len(rooms.faults(tmp_path)) == (low < HEIGHT)

    def test_a_column_may_stand_where_it_says(self, tmp_path):
        rooms = Rooms()
        rooms.walls()
        outline = [[1.0, 1.0], [1.3, 1.0], [1.3, 1.3], [1.0, 1.3]]
        rooms.box(rooms.rooms[0], (1.0, 1.0, 0), (1.3, 1.3, HEIGHT), "column", outline=outline, height=HEIGHT)
        assert rooms.faults(tmp_path) == []
        rooms.box(rooms.rooms[0], (2.0, 1.0, 0), (2.3, 1.3, HEIGHT), "column")
        assert len(rooms.faults(tmp_path)) == 1

    @pytest.mark.parametrize(("depth", "count"), [(0.012, 0), (0.03, 1)])
    def test_boards_stand_out_of_walls(self, tmp_path, depth, count):
        rooms = Rooms()
        rooms.walls()
        rooms.box(rooms.rooms[0], (0.0, 0.5, 0.0), (depth, 2.5, 0.07), "skirting")
        assert len(rooms.faults(tmp_path)) == count


class TestDoorways:
    """Parts of the shell in doorways, and doors in rooms."""

    @pytest.mark.parametrize(("south", "count"), [(2.1, 0), (1.9, 1)])
    def test_no_wall_stands_in_a_doorway(self, tmp_path, south, count):
        rooms = Rooms(2)
        rooms.box(rooms.rooms[1], (3.02, south, 0.0), (3.18, 2.5, HEIGHT))
        found = [message for message in rooms.faults(tmp_path) if "door:d" in message]
        assert len(found) == count

    def test_a_lintel_is_above_a_doorway(self, tmp_path):
        rooms = Rooms(2)
        rooms.box(rooms.rooms[1], (3.02, 0.5, 2.0), (3.18, 2.5, HEIGHT))
        assert not any("door:d" in message for message in rooms.faults(tmp_path))

    @pytest.mark.parametrize(("south", "count"), [(0.95, 0), (0.5, 1)])
    def test_a_frame_stands_beside_its_door(self, tmp_path, south, count):
        rooms = Rooms(2)
        rooms.box(rooms.door, (2.98, south, 0.0), (3.22, 1.0, 2.0), "frame")
        assert len(rooms.faults(tmp_path)) == 2 * count, "in both rooms"

    def test_a_leaf_opens_into_its_own_rooms(self, tmp_path):
        rooms = Rooms(3)
        rooms.box(rooms.door, (2.0, 1.0, 0.0), (3.0, 1.04, 2.0), "leaf")
        assert rooms.faults(tmp_path) == []
        rooms.box(rooms.door, (6.5, 1.0, 0.0), (7.0, 1.04, 2.0), "leaf")
        assert len(rooms.faults(tmp_path)) == 1


class TestFurniture:
    """Parts of the shell in furniture."""

    @pytest.mark.parametrize(("depth", "count"), [(0.008, 0), (0.04, 1)])
    def test_a_handle_stays_out_of_furniture(self, tmp_path, depth, count):
        rooms = Rooms(2)
        mesh = rooms.floor.box_mesh("desk", 1.6, 0.8, 0.74)
        extras = furniture("desk", 1, "wall.0", "front", (1.6, 0.8, 0.74))
        rooms.floor.node("desk.1@1", extras, rooms.rooms[0], mesh, at=(1.0, 0.0, -1.0))
        rooms.box(rooms.door, (1.8 - depth, 0.9, 0.5), (2.5, 1.0, 0.6), "leaf")
        found = rooms.faults(tmp_path)
        assert len(found) == count and all("40 mm inside of desk.1@1" in message for message in found)


class TestGaps:
    """Floors that end before their walls."""

    @pytest.mark.parametrize(("behind", "count"), [(0.015, 0), (0.03, 4)])
    def test_walls_stand_at_the_edge_of_the_floor(self, tmp_path, behind, count):
        rooms = Rooms()
        rooms.walls(behind)
        found = rooms.faults(tmp_path)
        assert len(found) == count and all("no wall stands" in message for message in found)

    def test_an_opening_is_no_gap(self, tmp_path):
        rooms = Rooms(2)
        for low, high in [((0, -0.1), (3.1, 0)), ((0, 3), (3.1, 3.1)), ((-0.1, 0), (0, 3)), ((3, 0), (3.1, 1)),
                          ((3, 2), (3.1, 3))]:
            rooms.box(rooms.rooms[0], (*low, 0), (*high, HEIGHT))
        assert rooms.faults(tmp_path) == []


def test_validate_measures_the_shell(tmp_path, capsys):
    rooms = Rooms()
    rooms.walls()
    rooms.box(rooms.rooms[0], (-0.1, 1.0, 0.0), (0.5, 1.2, HEIGHT))
    file = str(rooms.floor.write(tmp_path / "floor.glb"))
    assert validate.main([file, "--no-khronos", "--quiet"]) == 1
    assert "[shell]" in capsys.readouterr().out
