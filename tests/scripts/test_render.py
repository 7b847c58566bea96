"""Pictures of baked floors: where the cameras stand, and, where Blender's module is installed, that they are taken."""

from __future__ import annotations

import importlib.util
import math

import numpy as np
import pytest

import render
from conftest import furniture
from roomwright.gltf_file import GltfFile
from pictures import cameras, cuts, floor_view
from pictures.camera import SENSOR

HAS_BLENDER = importlib.util.find_spec("bpy") is not None and importlib.util.find_spec("PIL") is not None


def level_of(floor, tmp_path):
    return floor_view.read_level(GltfFile(floor.write(tmp_path / "floor.glb")))


def picture_of(camera, points, aspect):
    """Where a perspective camera sees points: from -1 to 1 across the picture."""
    forward, up = np.array(camera.forward), np.array(camera.up)
    offset = np.array(points) - camera.position
    reach = SENSOR / 2 / camera.lens
    across = np.stack([offset @ np.cross(forward, up), offset @ up], axis=1) / (offset @ forward)[:, None]
    return across / (reach * min(aspect, 1.0), reach / max(aspect, 1.0))


def test_boxes_stand_where_the_nodes_do(floor, tmp_path):
    level = level_of(floor, tmp_path)
    boxes = {box.name: box for box in level.boxes}
    desk, turned, lamp = (boxes[f"{name}@101"] for name in ("desk.1", "desk.2", "lamp.1"))
    assert desk.corners.min(axis=0) == pytest.approx([0.2, 0.0]) and desk.corners.max(axis=0) \
        == pytest.approx([1.8, 0.8])
    assert np.ptp(turned.corners, axis=0) == pytest.approx([0.8, 1.6])
    assert (lamp.room, lamp.low, lamp.high) == ("101", pytest.approx(0.74), pytest.approx(1.04))


def test_a_room_that_is_not_there_is_answered_with_those_that_are(floor, tmp_path):
    with pytest.raises(floor_view.ViewError, match="no room '102'; rooms of house/ground: 101"):
        level_of(floor, tmp_path).room("102")


def test_a_file_without_rooms_is_no_level(floor, tmp_path):
    floor.find("room:101")["extras"]["kind"] = "part"
    with pytest.raises(floor_view.ViewError, match="no room in it"):
        level_of(floor, tmp_path)


@pytest.mark.parametrize("aspect", [0.6, 1.0, 1.8])
def test_a_picture_from_above_holds_the_walls(floor, tmp_path, aspect):
    camera = cameras.top(level_of(floor, tmp_path), None, aspect)
    width, height = (camera.scale, camera.scale / aspect) if aspect >= 1 else (camera.scale * aspect, camera.scale)
    assert camera.position[:2] == pytest.approx((2.0, 1.5))
    assert width >= 4.6 and height >= 3.6 and min(width / 4.6, height / 3.6) < 1.1
    assert set(camera.cuts) == {("101", wall) for wall in range(4)}


@pytest.mark.parametrize("aspect", [0.6, 4 / 3])
def test_a_dollhouse_holds_the_room_and_is_no_smaller_than_it_must_be(floor, tmp_path, aspect):
    camera = cameras.dollhouse(level_of(floor, tmp_path), None, aspect)
    far = [wall for wall in range(4) if ("101", wall) not in camera.cuts]
    corners = [(x, y, 0.0) for x in (0, 4) for y in (0, 3)] + [(0, 3, 2.5), (4, 0, 2.5)]
    seen = picture_of(camera, corners[:4], aspect)
    assert len(far) == 2 and np.abs(seen).max() <= 1.0
    assert np.abs(seen).max() > 0.5


def test_tall_furniture_is_looked_at_and_not_past(floor, tmp_path):
    """A wardrobe turns the camera to the other side of the room."""
    shelf = floor.box_mesh("shelf.0", 1.6, 0.4, 2.2)
    room = next(i for i, node in enumerate(floor.document["nodes"]) if node["name"] == "room:101")
    floor.node("shelf.1@101", furniture("shelf", 1, "wall.0", "front", (1.6, 0.4, 2.2)), room, shelf,
               at=(2.8, 0.0, -0.2))
    south = cameras.dollhouse(level_of(floor, tmp_path), None, 1.5).position
    floor.find("shelf.1@101")["translation"] = [2.8, 0.0, -2.8]
    north = cameras.dollhouse(level_of(floor, tmp_path), None, 1.5).position
    assert south[1] > 3.0 and north[1] < 0.0


def test_what_hangs_on_a_near_wall_is_hidden_and_what_stands_there_is_not(floor, tmp_path):
    level = level_of(floor, tmp_path)
    hidden = lambda: cuts.hidden_furniture(level, {("101", 0): cuts.STUB})
    assert hidden() == set()
    box = level.boxes[0]
    level.boxes.append(floor_view.Box("101", "picture", "wall.0", box.corners, 1.4, 1.9))
    level.boxes.append(floor_view.Box("101", "other", "wall.2", box.corners, 1.4, 1.9))
    level.boxes.append(floor_view.Box("101", "lamp", "ceiling", box.corners, 2.2, 2.5))
    assert hidden() == {"picture", "lamp"}
    # At an opening in a cut wall a curtain hangs, while a car before its gate stands.
    door = level.openings[0]
    side = door.sides[0]
    level.boxes.append(floor_view.Box(side["room"], "curtain", door.node, box.corners, 0.1, 2.3))
    level.boxes.append(floor_view.Box(side["room"], "car", door.node, box.corners, 0.0, 1.5))
    assert cuts.hidden_furniture(level, {(side["room"], side["wall"]): cuts.STUB}) >= {"curtain"}
    assert "car" not in cuts.hidden_furniture(level, {(side["room"], side["wall"]): cuts.STUB})


def test_a_person_stands_free_and_looks_into_the_room(floor, tmp_path):
    level = level_of(floor, tmp_path)
    camera = cameras.eye(level, level.rooms[0])
    place = np.array(camera.position[:2])
    assert camera.position[2] == 1.6 and floor_view.is_inside(place[None], level.rooms[0])[0]
    assert min(floor_view.distances(place, box.corners) for box in level.boxes) > 0.1
    ahead = place + 1.5 * np.array(camera.forward[:2])
    assert floor_view.is_inside(ahead[None], level.rooms[0])[0]


def test_a_leaf_is_not_stood_behind(floor, tmp_path):
    """With its door open before the camera, another place is better."""
    level = level_of(floor, tmp_path)
    before = cameras.eye(level, level.rooms[0])
    place, ahead = np.array(before.position[:2]), np.array(before.forward[:2])
    aside = np.array([-ahead[1], ahead[0]]) * 0.6
    door = level.openings[0]
    leaf = (place + ahead * 0.4 - aside, place + ahead * 0.4 + aside)
    level.openings[0] = floor_view.Opening(door.node, door.kind, door.sides, 0.9, 2.0, 0.0, (leaf,))
    assert cameras.eye(level, level.rooms[0]).position != before.position


def test_the_same_file_has_the_same_cameras(floor, tmp_path):
    level = level_of(floor, tmp_path)
    for view in render.VIEWS:
        camera = cameras.choose(level, None, view, 1.5)
        assert camera == cameras.choose(level_of(floor, tmp_path), None, view, 1.5)
        assert math.hypot(*camera.forward) == pytest.approx(1.0)


def test_a_name_has_nothing_that_a_file_system_forbids():
    level = floor_view.Level("tower A/1", "2:3")
    assert render.picture_name(level, None, "top", "png") == "tower_A_1-2_3-top.png"


@pytest.mark.parametrize("arguments", [["--size", "10"], ["--samples", "0"], ["--view", "below"],
                                       ["--format", "jpg", "--transparent"]])
def test_what_cannot_be_meant_starts_nothing(arguments, tmp_path):
    with pytest.raises(SystemExit) as stop:
        render.main(["floor.glb", "--out", str(tmp_path), *arguments])
    assert stop.value.code == 2


def test_a_missing_file_starts_nothing(tmp_path, capsys):
    assert render.main([str(tmp_path / "absent.glb"), "--out", str(tmp_path)]) == 2
    assert "no such file" in capsys.readouterr().err


@pytest.mark.skipif(HAS_BLENDER, reason="bpy is installed")
def test_without_blender_it_says_how_to_install_it(floor, tmp_path, capsys):
    assert render.main([str(floor.write(tmp_path / "floor.glb")), "--out", str(tmp_path)]) == 2
    assert "requirements-render.txt" in capsys.readouterr().err


@pytest.mark.skipif(not HAS_BLENDER, reason="bpy or Pillow is not installed (scripts/requirements-render.txt)")
class TestBlender:
    """The pictures themselves, small and quick."""

    def test_each_view_is_a_picture_of_its_size_with_something_in_it(self, floor, tmp_path):
        from PIL import Image
        path = floor.write(tmp_path / "floor.glb")
        views = [word for view in render.VIEWS for word in ("--view", view)]
        assert render.main([str(path), "--out", str(tmp_path), "--size", "64x48", "--samples", "1", *views]) == 0
        for view in render.VIEWS:
            with Image.open(tmp_path / f"house-ground-{view}.png") as picture:
                assert picture.size == (64, 48)
                assert len(set(picture.convert("L").tobytes())) > 10, view

    def test_an_unknown_room_fails_the_file(self, floor, tmp_path, capsys):
        path = floor.write(tmp_path / "floor.glb")
        assert render.main([str(path), "--out", str(tmp_path), "--room", "102"]) == 1
        assert "rooms of house/ground: 101" in capsys.readouterr().err
