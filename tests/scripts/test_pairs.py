"""Pages of pairs: the room as furnished beside the room as drawn."""

from __future__ import annotations

import json

import pytest

from judged_floor import house
from judging.sketch import fixture_shapes
from pairs import main


def drawing(*items: dict) -> dict:
    """A drawing of archilyse's, in which a pixel is a centimetre."""
    return {"scale": 1.0, "layers": {"layer-1": {"items": {str(number): item for number, item in enumerate(items)}}}}


def item(kind: str, x: float, y: float, width: float, depth: float) -> dict:
    size = {"width": {"value": width * 100}, "length": {"value": depth * 100}}
    return {"type": kind, "x": x * 100, "y": y * 100, "rotation": 0.0, "properties": size}


@pytest.fixture
def kitchen(tmp_path):
    """A baked kitchen, named as a drawing that stands beside it."""
    made = house("kitchen")
    for number, kind in enumerate(("sink_unit", "worktop", "cooker")):
        made.piece(kind, 0.3 + 0.6 * number, 0.3, "north", (0.6, 0.6, 0.9))
    made.floor.find("house/ground")["extras"] |= {"building": "plan_1", "level": "floor_0"}
    (tmp_path / "baked").mkdir()
    made.write(tmp_path / "baked")
    (tmp_path / "plan_1.json").write_text(json.dumps(drawing(item("kitchen", 2.0, 3.7, 3.0, 0.6), item("stairs", 1, 1, 1, 1))))
    return tmp_path


def test_a_page_shows_both_sides_by_name(kitchen, capsys):
    page = kitchen / "pairs.html"
    assert main([str(kitchen / "baked"), "--drawn", str(kitchen), "--out", str(page)]) == 0
    assert "1 of 1 rooms" in capsys.readouterr().out
    text = page.read_text(encoding="utf-8")
    assert text.count("<svg") == 2 and "the architect&#x27;s" in text and "sink unit" in text


def test_a_blind_page_says_whose_is_whose_in_its_key_only(kitchen):
    page = kitchen / "pairs.html"
    assert main([str(kitchen / "baked"), "--drawn", str(kitchen), "--out", str(page), "--blind"]) == 0
    pairs, key = page.read_text(encoding="utf-8").split("<details>")
    assert "architect" not in pairs and "sink unit" not in pairs and "on the left" in key


def test_units_that_touch_are_one_block(tmp_path):
    room = house("kitchen").piece("sink_unit", 0.3, 0.3, "north", (0.6, 0.6, 0.9)).piece("cooker", 0.9, 0.3, "north", (0.6, 0.6, 0.9))
    room = room.piece("fridge", 3.0, 0.3, "north", (0.6, 0.6, 1.8)).read(tmp_path)
    assert sorted(round(shape.geometry.area, 2) for shape in fixture_shapes(room)) == [0.36, 0.72]


def test_rooms_without_a_drawing_make_no_page(kitchen, capsys):
    (kitchen / "plan_1.json").unlink()
    assert main([str(kitchen / "baked"), "--drawn", str(kitchen), "--out", str(kitchen / "pairs.html")]) == 2
    assert not (kitchen / "pairs.html").exists()
