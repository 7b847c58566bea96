"""Drawings become native plans: rooms and their names, doors, windows, what stands between and in rooms, units, curves."""

from __future__ import annotations

import math
import os
import subprocess
import zipfile
from pathlib import Path

import ezdxf
import pytest
import yaml
from conftest import ROOT
from drawn_flat import LAYERS, closed, flat, rectangle, save
from ezdxf.document import Drawing
from shapely import Point, Polygon

from roomwright.dxf_to_plan import main

PROGRAM = os.environ.get("ROOMWRIGHT_PROGRAM")
SHARED = ROOT.parent / "shared" / "data" / "floorplans" / "archilyse" / "dxf" / "AL_Sample building_1OG_DXF.dxf.zip"
needs_program = pytest.mark.skipif(PROGRAM is None, reason="ROOMWRIGHT_PROGRAM names no program")


@pytest.fixture
def folder(tmp_path) -> Path:
    (tmp_path / "map.yaml").write_text(LAYERS, encoding="utf-8")
    return tmp_path


def read(folder: Path, *drawings, options=()) -> dict:
    """The plan of drawings, which are read without a fault."""
    paths = [str(save(drawing, folder / f"{index}.dxf")) for index, drawing in enumerate(drawings)]
    out = folder / "plan.yaml"
    assert main([*paths, "--layers", str(folder / "map.yaml"), "--out", str(out), "--force", *options]) == 0
    return yaml.safe_load(out.read_text(encoding="utf-8"))


def level_of(plan: dict) -> dict:
    (level,) = plan["levels"]
    return level


def by_name(plan: dict) -> dict[str, dict]:
    return {room["name"]: room for room in level_of(plan)["rooms"]}


def openings_of(plan: dict, kind: str) -> list[dict]:
    return [opening for opening in level_of(plan)["openings"] if opening["kind"] == kind]


@pytest.fixture
def plan(folder) -> dict:
    return read(folder, flat())


class TestRooms:
    def test_have_the_names_in_them_without_sizes_and_the_types_of_their_names(self, plan):
        types = {name: room["type"] for name, room in by_name(plan).items()}
        assert types == {"Living room": "living_room", "Küche": "kitchen", "Hall 0.03": "corridor", "Study": "study", "BATH": "bathroom"}

    def test_are_in_metres(self, plan):
        assert Polygon(by_name(plan)["BATH"]["outline"]).equals(Polygon([(5.1, 0), (7.5, 0), (7.5, 4), (5.1, 4)]))

    def test_have_ids_by_their_handles(self, folder):
        drawing = flat()
        plan = read(folder, drawing)
        assert by_name(plan)["Study"]["id"] == f"room-{drawing.rooms['study'].dxf.handle}"

    @pytest.mark.parametrize("options, error", [((), 0.01), (("--chord-error", "0.1"), 0.1)])
    def test_curves_are_edges_within_the_chord_error(self, folder, options, error):
        outline = by_name(read(folder, flat(), options=options))["Study"]["outline"]
        bay = [(x, y) for x, y in outline if x >= 10 - 1e-9]
        assert len(bay) > 6
        assert all(abs(math.dist(corner, (10, 2)) - 2) <= error for corner in bay)
        middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in zip(bay, bay[1:])]
        assert all(2 - math.dist(middle, (10, 2)) <= error for middle in middles)

    def test_a_larger_chord_error_gives_fewer_corners(self, folder):
        fine, coarse = (by_name(read(folder, flat(), options=("--chord-error", error)))["Study"]["outline"] for error in ("0.005", "0.2"))
        assert len(coarse) < len(fine) / 2

    def test_splines_that_stand_for_polygons_are_straight(self, folder):
        drawing = flat()
        corners = rectangle(0, 10_000, 4000, 3000)
        controls = [point for a, b in zip(corners, corners[1:] + corners[:1]) for point in (a, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2))]
        drawing.modelspace().add_open_spline([*controls, corners[0]], degree=2, dxfattribs={"layer": "A-AREA"})
        drawing.modelspace().add_text("Bedroom", dxfattribs={"layer": "A-AREA-IDEN", "insert": (1000, 11_000)})
        outline = by_name(read(folder, drawing))["Bedroom"]["outline"]
        assert len(outline) == 4 and Polygon(outline).area == pytest.approx(12)

    def test_other_splines_are_curves(self, folder):
        drawing = flat()
        corners = [(*corner, 0) for corner in rectangle(0, 10_000, 4000, 4000)]
        drawing.modelspace().add_open_spline([*corners, corners[0]], degree=3, dxfattribs={"layer": "A-AREA"})
        drawing.modelspace().add_text("Bedroom", dxfattribs={"layer": "A-AREA-IDEN", "insert": (1500, 11_500)})
        outline = by_name(read(folder, drawing))["Bedroom"]["outline"]
        assert len(outline) > 8 and Polygon(outline).area < 15

    def test_closed_splines_without_ends_are_curves_through_their_inner_knots(self, folder):
        drawing = flat()
        controls = rectangle(0, 10_000, 4000, 4000)
        drawing.modelspace().add_spline(dxfattribs={"layer": "A-AREA"}).set_closed([(*corner, 0) for corner in controls], degree=3)
        drawing.modelspace().add_text("Bedroom", dxfattribs={"layer": "A-AREA-IDEN", "insert": (2000, 12_000)})
        outline = Polygon(by_name(read(folder, drawing))["Bedroom"]["outline"])
        # The blending functions of uniform cubic B-splines.
        exact = []
        for index, step in ((index, step / 100) for index in range(4) for step in range(100)):
            weights = ((1 - step)**3, 3 * step**3 - 6 * step**2 + 4, -3 * step**3 + 3 * step**2 + 3 * step + 1, step**3)
            near = [controls[(index + shift) % 4] for shift in range(4)]
            exact.append(tuple(sum(weight * corner[axis] for weight, corner in zip(weights, near)) / 6000 for axis in (0, 1)))
        assert outline.boundary.hausdorff_distance(Polygon(exact).boundary) <= 0.01

    def test_an_outline_in_another_is_cut_out_of_it(self, folder):
        drawing = flat()
        closed(drawing.modelspace(), rectangle(500, 500, 1000, 1000), "A-AREA")
        drawing.modelspace().add_text("Store", dxfattribs={"layer": "A-AREA-IDEN", "insert": (900, 900)})
        rooms = by_name(read(folder, drawing))
        assert rooms["Store"]["type"] == "storeroom"
        (hole,) = rooms["Living room"]["holes"]
        assert Polygon(hole).area == pytest.approx(1)

    def test_may_lie_in_blocks_of_blocks(self, folder):
        drawing, plain = flat(), flat()
        inner, outer = drawing.blocks.new("INNER"), drawing.blocks.new("OUTER")
        closed(inner, rectangle(0, 0, 2000, 3000), "A-AREA")
        inner.add_text("WC", dxfattribs={"layer": "A-AREA-IDEN", "insert": (500, 500)})
        outer.add_blockref("INNER", (0, 0))
        drawing.modelspace().add_blockref("OUTER", (20_000, 0), dxfattribs={"rotation": 90})
        added = by_name(read(folder, drawing)).keys() - by_name(read(folder, plain)).keys()
        assert added == {"WC"}
        assert Polygon(by_name(read(folder, drawing))["WC"]["outline"]).bounds == pytest.approx((17, 0, 20, 2))

    def test_may_have_their_names_on_their_own_layer(self, folder):
        drawing = flat()
        for text in drawing.modelspace().query("TEXT MTEXT"):
            text.dxf.layer = "A-AREA"
        assert by_name(read(folder, drawing)).keys() == {"Living room", "Küche", "Hall 0.03", "Study", "BATH"}

    def test_take_the_words_of_the_layer_map_first(self, folder):
        (folder / "map.yaml").write_text(LAYERS + "room_types: {STUDY: library, 'living room 2': lobby}\n", encoding="utf-8")
        rooms = by_name(read(folder, flat()))
        assert (rooms["Study"]["type"], rooms["Living room"]["type"]) == ("library", "lobby")


class TestOpenings:
    def door(self, plan: dict, x: float, y: float) -> dict:
        """The door whose middle is there, in metres of the drawing."""
        (found,) = [door for door in openings_of(plan, "door") if math.dist(door["at"], (x, y)) < 1e-3]
        return found

    def test_an_arc_is_a_leaf_with_its_hinge_and_side(self, plan):
        door = self.door(plan, 1.45, 4)
        assert (door["width"], door["hinge"], door["opens_into"]) == (0.9, "left", by_name(plan)["Living room"]["id"])

    def test_so_is_one_in_a_mirrored_block(self, plan):
        door = self.door(plan, 6.6, 4.1)
        assert (door["width"], door["hinge"], door["opens_into"]) == (0.8, "left", by_name(plan)["Hall 0.03"]["id"])

    def test_two_arcs_that_meet_are_a_door_of_two_leaves(self, plan):
        door = self.door(plan, 0, 4.9)
        assert (door["width"], door["leaves"], door["opens_into"]) == (1.2, 2, by_name(plan)["Hall 0.03"]["id"])
        assert "hinge" not in door

    def test_a_frame_without_an_arc_leaves_hinge_and_side_to_the_program(self, plan):
        door = self.door(plan, 8.45, 4.05)
        assert door["width"] == 0.9 and not {"hinge", "opens_into", "leaves"} & door.keys()

    def test_there_are_no_others(self, plan):
        assert [len(openings_of(plan, kind)) for kind in ("door", "sliding_door", "window", "open_boundary")] == [4, 0, 2, 1]

    def test_lines_beside_each_other_and_a_block_are_a_window_each(self, plan):
        sizes = sorted((window["width"], *window["at"]) for window in openings_of(plan, "window"))
        assert sizes == [pytest.approx((1.0, 6.3, -0.15)), pytest.approx((2.0, 2.0, -0.15))]

    def test_rooms_without_a_wall_between_them_are_open_to_each_other(self, plan):
        (boundary,) = openings_of(plan, "open_boundary")
        rooms = by_name(plan)
        assert set(boundary["rooms"]) == {rooms["Küche"]["id"], rooms["Living room"]["id"]}
        assert boundary["width"] == pytest.approx(4, abs=0.1)

    def test_a_wide_door_without_a_leaf_slides(self, folder):
        drawing = flat()
        closed(drawing.modelspace(), rectangle(1000, -300, 3000, 300), "A-DOOR")
        for window in drawing.modelspace().query('LINE[layer=="A-GLAZ"]'):
            drawing.modelspace().delete_entity(window)
        assert [door["width"] for door in openings_of(read(folder, drawing), "sliding_door")] == [3.0]

    def test_an_arc_in_a_polyline_is_a_leaf_too(self, folder):
        drawing = flat()
        space = drawing.modelspace()
        for entity in space.query('ARC[layer=="A-DOOR"]'):
            if entity.dxf.center.x == 1000:
                space.delete_entity(entity)
        # From the open end to the shut end, a quarter turn counter-clockwise.
        space.add_lwpolyline([(1000, 3100, math.tan(math.pi / 8)), (1900, 4000, 0)], format="xyb", dxfattribs={"layer": "A-DOOR"})
        door = self.door(read(folder, drawing), 1.45, 4)
        assert (door["width"], door["hinge"]) == (0.9, "left")

    def test_a_block_that_is_stretched_to_the_width_of_its_door_is_a_leaf_too(self, folder):
        drawing = flat()
        space = drawing.modelspace()
        for entity in space.query('ARC[layer=="A-DOOR"]'):
            if entity.dxf.center.x == 1000:
                space.delete_entity(entity)
        block = drawing.blocks.new("UNIT_DOOR")
        block.add_arc((0, 0), 900, -90, 0)
        block.add_line((0, 0), (0, -900))
        space.add_blockref("UNIT_DOOR", (1000, 4000), dxfattribs={"layer": "A-DOOR", "xscale": 1.2})
        door = self.door(read(folder, drawing), 1.54, 4)
        assert (door["width"], door["hinge"]) == (pytest.approx(1.08), "left")


def test_columns_and_walls_in_a_room_are_obstacles_and_contours_are_none(plan):
    outlines = sorted((Polygon(column["outline"]) for column in level_of(plan)["columns"]), key=lambda outline: outline.area)
    round_column, stub = outlines
    assert round_column.area == pytest.approx(math.pi * 0.15**2, rel=0.1)
    assert round_column.centroid.distance(Point(2.5, 2)) < 0.01
    assert stub.area == pytest.approx(0.1)


def test_railings_are_outlines_and_lines_as_wide_as_a_railing(plan):
    sizes = [(Polygon(outline).bounds, Polygon(outline).area) for outline in level_of(plan)["railings"]]
    assert sizes == [(pytest.approx((9.98, 4.1, 10.02, 5.6)), pytest.approx(0.06)),
                     (pytest.approx((9, 5.585, 10, 5.635)), pytest.approx(0.05))]


def test_walls_are_no_obstacles_where_outlines_are_their_middle(folder):
    (folder / "map.yaml").write_text(LAYERS + "outlines: center\n", encoding="utf-8")
    plan = read(folder, flat())
    (column,) = level_of(plan)["columns"]
    assert plan["outlines"] == "center" and Polygon(column["outline"]).contains(Point(2.5, 2))


class TestUnits:
    def test_a_unit_that_is_named_counts_before_that_of_the_drawing(self, folder):
        # Millimetres that are read as tenths of their size would be no rooms: the flat is drawn in units of 1 mm.
        from_header = read(folder, flat(unit=4))
        assert read(folder, flat(unit=6), options=("--unit", "mm")) == from_header

    def test_a_unit_of_the_layer_map_counts(self, folder):
        from_header = read(folder, flat(unit=4))
        (folder / "map.yaml").write_text(LAYERS + "unit: mm\n", encoding="utf-8")
        assert read(folder, flat(unit=0)) == from_header


def test_coordinates_of_a_national_grid_are_moved_by_whole_kilometres(folder):
    drawing = flat()
    for entity in drawing.modelspace():
        entity.translate(2_600_123_000, 1_200_456_000, 0)
    plan = read(folder, drawing)
    assert Polygon(by_name(plan)["BATH"]["outline"]).bounds == pytest.approx((128.1, 456, 130.5, 460))
    assert "[0, 0] is (2600000000, 1200000000) of the drawing" in (folder / "plan.yaml").read_text(encoding="utf-8")
    assert len(level_of(plan)["openings"]) == len(level_of(read(folder, flat()))["openings"])


def test_drawings_are_levels_lowest_first(folder):
    (folder / "map.yaml").write_text(LAYERS + "level_height: 2.8\n", encoding="utf-8")
    plan = read(folder, flat(), flat())
    assert [(level["id"], level["height"], len(level["rooms"])) for level in plan["levels"]] == [("0", 2.8, 5), ("1", 2.8, 5)]


def test_text_and_binary_files_of_all_versions_give_the_same_plan(folder):
    drawing = flat()
    texts = set()
    for version, form in (("R2000", "asc"), ("R2004", "asc"), ("R2018", "asc"), ("R2010", "bin")):
        drawing.dxfversion = version
        drawing.saveas(folder / "flat.dxf", fmt=form)
        assert main([str(folder / "flat.dxf"), "--layers", str(folder / "map.yaml"), "--out", str(folder / "plan.yaml"), "--force"]) == 0
        texts.add((folder / "plan.yaml").read_text(encoding="utf-8"))
    assert len(texts) == 1


def test_drawings_of_the_oldest_version_are_read(folder):
    drawing = ezdxf.new("R12")
    drawing.header["$INSUNITS"] = 4
    space = drawing.modelspace()
    space.add_polyline2d(rectangle(0, 0, 4000, 3000), close=True, dxfattribs={"layer": "A-AREA"})
    space.add_text("Küche", dxfattribs={"layer": "A-AREA-IDEN", "insert": (500, 500)})
    (room,) = by_name(read(folder, drawing, options=("--unit", "mm"))).values()
    assert room["type"] == "kitchen" and Polygon(room["outline"]).area == pytest.approx(12)


def test_the_same_drawing_gives_the_same_bytes(folder):
    texts = []
    for _ in range(2):
        read(folder, flat())
        texts.append((folder / "plan.yaml").read_bytes())
    assert texts[0] == texts[1]


@needs_program
def test_the_program_takes_the_plan(folder):
    read(folder, flat(), flat())
    for command in (["check"], ["bake", "--out", "out", "--textures", "none"]):
        done = subprocess.run([PROGRAM, *command, "plan.yaml"], cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        assert "warning" not in done.stderr.replace("0 warnings", ""), done.stderr
    assert len(list((folder / "out").rglob("*.glb"))) == 2


def test_the_layer_map_of_the_documentation_works(folder):
    text = (ROOT / "docs" / "importing.md").read_text(encoding="utf-8")
    section = text.split("## How to export from CAD programs")[1].split("\n## ")[0]
    (folder / "map.yaml").write_text(section.split("```yaml\n")[1].split("```")[0], encoding="utf-8")
    plan = read(folder, flat())
    assert len(by_name(plan)) == 5 and len(level_of(plan)["openings"]) == 7 and len(level_of(plan)["columns"]) == 2


@pytest.mark.skipif(not SHARED.is_file(), reason=f"{SHARED.name} is not beside the project (its licence, AGPL, keeps it out)")
class TestAnArchitectsDrawing:
    """A floor of an apartment block: outlines as splines, names in German, 39 doors and 34 windows of several entities each."""

    MAP = "version: 1\nlayers: {rooms: Raumpolygone, room_names: Raumstempel, doors: Türen, windows: Fenster, walls: Wände}\n"

    @pytest.fixture
    def drawing(self, tmp_path) -> Drawing:
        with zipfile.ZipFile(SHARED) as archive:
            (name,) = [name for name in archive.namelist() if name.endswith(".dxf")]
            (tmp_path / "floor.dxf").write_bytes(archive.read(name))
        return ezdxf.readfile(tmp_path / "floor.dxf")

    @pytest.fixture
    def plan(self, tmp_path, drawing) -> dict:
        (tmp_path / "map.yaml").write_text(self.MAP, encoding="utf-8")
        return read(tmp_path, drawing)

    def test_every_outline_is_a_room_with_a_name_and_the_area_of_its_stamp(self, plan, drawing):
        rooms = level_of(plan)["rooms"]
        assert len(rooms) == 47 and all("name" in room for room in rooms)
        texts = drawing.modelspace().query('MTEXT[layer=="Raumstempel"]')
        stamps = [(Point(text.dxf.insert.x, text.dxf.insert.y), float(text.plain_text().split()[0])) for text in texts
                  if text.plain_text().endswith(" m2")]
        outlines = [Polygon(room["outline"]) for room in rooms]
        areas = [(outline.area, area) for outline in outlines for at, area in stamps if outline.contains(at)]
        # Stamps are rounded to half a square metre.
        assert len(areas) >= 45 and max(abs(area - stamp) for area, stamp in areas) <= 0.5, areas
        assert {room["type"] for room in rooms} == {"balcony", "living_dining", "room", "corridor", "kitchen", "bathroom", "storeroom"}

    def test_the_program_finds_a_wall_for_every_opening(self, plan):
        counts = [len(openings_of(plan, kind)) for kind in ("door", "window", "open_boundary")]
        assert counts == [39, 32, 9]

    @needs_program
    def test_the_program_takes_the_plan(self, plan, tmp_path):
        done = subprocess.run([PROGRAM, "check", "plan.yaml"], cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0 and "47 rooms: 0 errors, 0 warnings" in done.stdout + done.stderr, done.stderr
