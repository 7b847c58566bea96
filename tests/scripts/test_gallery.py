"""The gallery's plans, pages and sheets, as far as they need neither the program nor Blender."""

from __future__ import annotations

import pytest

import gallery
from pictures import contact_grid, gallery_plans


def room_type(name, area=(10.0, 40.0), classes=("chair", "lamp"), **more):
    programme = [{"class": list(classes), "count": 1}]
    return {"id": name, "label": name.capitalize(), "area": list(area), "density": [0.2, 0.4], "excludes": [],
            "file": "configs/rooms/homes.yaml", "furnish": True, "programme": programme,
            "styles": ["default", "home_modern"]} | more


@pytest.fixture
def catalog():
    types = [room_type("den"), room_type("way", excludes=["work"], density=[0.1, 0.2], classes=("lamp",)),
             room_type("roof", classes=("chair",)), room_type("garage", classes=("car", "lamp")),
             room_type("shaft", furnish=False)]
    styles = {name: {"id": name, "label": name} for name in ("default", "home_modern", "paper_hall")}
    groups = {"chair": {"seat"}, "lamp": {"light"}, "car": {"vehicle"}}
    return gallery_plans.Catalog({one["id"]: one for one in types}, styles, groups, {"lamp"})


def openings(catalog, name):
    level = gallery_plans.level(catalog, catalog.room_types[name], name, "default")
    return [one["kind"] for one in level["openings"]], "walls" in level["rooms"][0]


def test_each_room_has_the_openings_that_it_needs(catalog):
    assert openings(catalog, "den") == (["door", "window"], False)
    assert openings(catalog, "way") == (["door", "door"], False)
    assert openings(catalog, "roof") == (["door"], True)
    assert openings(catalog, "garage") == (["door", "sliding_door"], False)


def test_a_hall_that_is_filled_with_seats_has_no_window_and_a_den_with_a_rug_has(catalog):
    den = catalog.room_types["den"]
    den["programme"].append({"class": ["rug"], "count": {"fill": 1}})
    assert openings(catalog, "den")[0] == ["door", "window"]
    den["programme"].append({"class": ["chair"], "count": {"fill": 500}})
    assert openings(catalog, "den")[0] == ["door"]


def test_rooms_are_of_usual_areas_and_large_ones_are_kept_small(catalog):
    width, depth = gallery_plans.size(catalog.room_types["den"], False)
    assert width * depth == pytest.approx(20.0, rel=0.02) and width > depth
    hall = room_type("hall", (20.0, 4000.0))
    assert gallery_plans.size(hall, False)[0] * gallery_plans.size(hall, False)[1] == pytest.approx(60.0, rel=0.02)
    vast = room_type("vast", (100.0, 4000.0))
    assert gallery_plans.size(vast, False)[0] * gallery_plans.size(vast, False)[1] >= 99.0


def test_what_is_not_furnished_has_no_picture(catalog):
    plan = gallery_plans.rooms_plan(catalog, set())
    assert [level["id"] for level in plan["levels"]] == ["den", "way", "roof", "garage"]
    assert [level["id"] for level in gallery_plans.rooms_plan(catalog, {"roof"})["levels"]] == ["roof"]


def test_a_style_is_shown_by_a_room_that_is_made_in_it(catalog):
    assert gallery_plans.style_room(catalog, "home_modern")["id"] == "den"
    catalog.room_types["roof"]["styles"].append("paper_hall")
    assert gallery_plans.style_room(catalog, "paper_hall")["id"] == "roof"


def test_a_type_is_shown_in_a_style_that_it_is_made_in(catalog):
    assert gallery_plans.room_style(catalog.room_types["den"]) == "home_modern"
    assert gallery_plans.room_style(room_type("bare", styles=["default"])) == "default"


def test_the_page_shows_the_pictures_that_are_there(catalog, tmp_path):
    for name in ("rooms-den.jpg", "styles-default.jpg", "models-plain.jpg"):
        (tmp_path / name).write_bytes(b"")
    text = gallery.page(catalog, tmp_path)
    assert all(f"]({name})" in text for name in ("rooms-den.jpg", "styles-default.jpg", "models-plain.jpg"))
    assert "rooms-way.jpg" not in text and "models-budget.jpg" not in text


def test_looks_of_a_model_stay_in_one_row():
    cells = contact_grid.group_cells(100, 4)
    assert all(column + 4 <= contact_grid.ACROSS for column, _ in cells)
    assert len(set(cells)) == 100 and cells[0] == (0, 0)


def test_models_are_named_once_and_other_nodes_not():
    nodes = ["sheet", "item-desk-0", "item-desk-1", "item-tv_stand-0"]
    assert contact_grid.names_of(nodes) == ["desk", "tv_stand"]


def test_a_program_that_is_not_there_starts_nothing(tmp_path, capsys):
    assert gallery.main(["--program", str(tmp_path / "absent"), "--out", str(tmp_path)]) == 2
    assert "cannot start" in capsys.readouterr().err
