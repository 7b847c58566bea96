"""Faults of drawings and layer maps: all at once, with their places; nothing half written, no trace, bounded work."""

from __future__ import annotations

import os
import random
import time
from pathlib import Path

import pytest
import yaml
from drawn_flat import LAYERS, closed, flat, rectangle, save

from roomwright.dxf.layer_map import read_layer_map
from roomwright.dxf_to_plan import main


@pytest.fixture
def folder(tmp_path) -> Path:
    (tmp_path / "map.yaml").write_text(LAYERS, encoding="utf-8")
    return tmp_path


def run(folder: Path, *arguments, drawing: Path | None = None) -> int:
    drawing = drawing or folder / "flat.dxf"
    return main([str(drawing), "--layers", str(folder / "map.yaml"), "--out", str(folder / "plan.yaml"), *arguments])


class TestParts:
    @pytest.fixture
    def faulty(self, folder) -> dict[str, str]:
        """A flat with a fault of each kind; the handle of each faulty entity."""
        drawing = flat()
        space = drawing.modelspace()
        area, text = {"layer": "A-AREA"}, {"layer": "A-AREA-IDEN"}
        made = {
            "open": space.add_lwpolyline([(0, 7000), (4000, 7000), (4000, 9000), (0, 7350)], dxfattribs=area),
            "crossing": space.add_lwpolyline([(5000, 7000), (8000, 9000), (8000, 7000), (5000, 9000)], close=True, dxfattribs=area),
            "overlap": closed(space, rectangle(-1000, -500, 2000, 3000), "A-AREA"),
            "mark": space.add_circle((6000, 20_000), 50, dxfattribs=area),
            "twice": closed(space, rectangle(5100, 0, 2400, 4000), "A-AREA"),
            "unknown": space.add_text("Qxzwv", dxfattribs=text | {"insert": (4000, 4800)}),
            "outside": space.add_text("Garden", dxfattribs=text | {"insert": (0, -5000)}),
            "door": space.add_line((0, 40_000), (900, 40_000), dxfattribs={"layer": "A-DOOR"}),
            "wide": space.add_line((-3000, 50_000), (40_000, 50_000), dxfattribs={"layer": "A-GLAZ"}),
        }
        for hall in space.query('TEXT[layer=="A-AREA-IDEN"]'):
            if hall.dxf.text.startswith("Hall"):
                space.delete_entity(hall)
        save(drawing, folder / "flat.dxf")
        return {name: entity.dxf.handle for name, entity in made.items()}

    def test_are_reported_together_and_left_out(self, folder, faulty, capsys):
        assert run(folder) == 1
        said = capsys.readouterr().err
        file = folder / "flat.dxf"
        for line in (
            f'{file}: layer "A-AREA", LWPOLYLINE {faulty["open"]} at (0, 7000): error: the outline of a room is open: its ends are 0.35 m',
            f'LWPOLYLINE {faulty["crossing"]} at (5000, 7000): error: the outline crosses or touches itself at (6500, 8000)',
            f'LWPOLYLINE {faulty["overlap"]} at (-1000, -500): error: shares 2.50 m² with the room',
            f'CIRCLE {faulty["mark"]} at (6050, 20000): warning: an outline of 0.00',
            f'LWPOLYLINE {faulty["twice"]} at (5100, 0): warning: is the same outline as LWPOLYLINE',
            'warning: the name "Qxzwv" has no room type: read as generic',
            f'TEXT {faulty["outside"]} at (0, -5000): warning: the text "Garden" is in no room',
            f'layer "A-DOOR", LINE {faulty["door"]} at (0, 40000): warning: this door is at no wall of a room',
            f'layer "A-GLAZ", LINE {faulty["wide"]} at (-3000, 50000): error: is 43 m wide',
        ):
            assert line in said, line
        plan = yaml.safe_load((folder / "plan.yaml").read_text(encoding="utf-8"))
        assert len(plan["levels"][0]["rooms"]) == 5

    def test_without_rooms_there_is_no_plan(self, folder, capsys):
        drawing = flat()
        for outline in drawing.rooms.values():
            outline.dxf.layer = "A-WALL"
        save(drawing, folder / "flat.dxf")
        assert run(folder) == 2
        assert "has no room: no closed outline on the layers of the role rooms, A-AREA" in capsys.readouterr().err
        assert not (folder / "plan.yaml").exists()

    def test_a_drawing_without_a_unit_names_the_option(self, folder, capsys):
        save(flat(unit=0), folder / "flat.dxf")
        assert run(folder) == 2
        assert "names no unit ($INSUNITS is 0)\n  hint: --unit with one of m, dm, cm" in capsys.readouterr().err

    def test_a_wrong_unit_is_a_fault(self, folder, capsys):
        save(flat(unit=6), folder / "flat.dxf")
        assert run(folder) == 2
        assert "an outline of 5000 by 4000 m is no room\n  hint: is the unit right? --unit names another" in capsys.readouterr().err

    def test_all_drawings_are_read_before_one_is_refused(self, folder, capsys):
        (folder / "a.dxf").write_text("no drawing")
        (folder / "b.dxf").write_bytes(b"AC1027 and the rest of a DWG")
        assert main([*(str(folder / name) for name in ("a.dxf", "b.dxf", "absent.dxf")), "--layers", str(folder / "map.yaml")]) == 2
        said = capsys.readouterr().err
        assert "a.dxf: the drawing is damaged" in said and "b.dxf: is a DWG file\n  hint: save it as DXF" in said
        assert "absent.dxf: No such file" in said


class TestFiles:
    BAD_VALUES = (b"nan", b"1e300", b"-7", b"", b"INSERT", b"999999", b"0", b"\xff\xfe")

    def test_a_plan_is_not_overwritten_unless_told(self, folder, capsys):
        save(flat(), folder / "flat.dxf")
        (folder / "plan.yaml").write_text("mine")
        assert run(folder) == 2 and "is there already; hint: --force" in capsys.readouterr().err
        assert (folder / "plan.yaml").read_text() == "mine"
        assert run(folder, "--force") == 0
        assert sorted(path.name for path in folder.iterdir()) == ["flat.dxf", "map.yaml", "plan.yaml"]

    def test_a_folder_that_is_not_there_is_said(self, folder, capsys):
        save(flat(), folder / "flat.dxf")
        assert main([str(folder / "flat.dxf"), "--layers", str(folder / "map.yaml"), "--out", str(folder / "no" / "plan.yaml")]) == 2
        assert f"{folder / 'no'}: is no folder" in capsys.readouterr().err

    @pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
    def test_a_pipe_is_no_drawing(self, folder, capsys):
        os.mkfifo(folder / "flat.dxf")
        assert run(folder) == 2 and "is no file" in capsys.readouterr().err

    def test_a_cut_off_drawing_is_damaged(self, folder, capsys):
        whole = save(flat(), folder / "whole.dxf").read_bytes()
        for length in range(0, len(whole) - 8, len(whole) // 20):
            (folder / "flat.dxf").write_bytes(whole[:length])
            assert run(folder) == 2, length
            assert "flat.dxf: " in capsys.readouterr().err
            assert not (folder / "plan.yaml").exists()

    def test_a_damaged_drawing_gives_an_error_or_a_plan_and_never_a_trace(self, folder, capsys):
        whole = save(flat(), folder / "whole.dxf").read_bytes()
        start = whole.index(b"ENTITIES")
        lines = whole[start:].split(b"\n")
        draw = random.Random(7)
        codes = []
        for _ in range(200):
            damaged = list(lines)
            for _ in range(draw.randint(1, 6)):
                damaged[draw.randrange(len(damaged) - 3)] = draw.choice(self.BAD_VALUES)
            (folder / "flat.dxf").write_bytes(whole[:start] + b"\n".join(damaged))
            code = run(folder, "--force")
            codes.append(code)
            if code == 2:
                assert capsys.readouterr().err.strip()
                assert not (folder / "plan.yaml").exists()
            else:
                yaml.safe_load((folder / "plan.yaml").read_text(encoding="utf-8"))
                (folder / "plan.yaml").unlink()
        assert set(codes) <= {0, 1, 2} and len(set(codes)) > 1


class TestWork:
    """What a small file asks for is bounded."""

    LONGEST = 60  # seconds, on a busy machine

    def test_blocks_of_blocks_are_opened_so_far(self, folder, capsys):
        drawing = flat()
        closed(drawing.blocks.new("B0"), rectangle(0, 0, 1000, 1000), "A-AREA")
        for depth in range(1, 9):
            block = drawing.blocks.new(f"B{depth}")
            for index in range(10):
                block.add_blockref(f"B{depth - 1}", (index * 1000, depth * 1000))
        drawing.modelspace().add_blockref("B8", (0, 20_000))
        save(drawing, folder / "flat.dxf")
        started = time.monotonic()
        assert run(folder) == 2
        assert time.monotonic() - started < self.LONGEST
        assert "has too many entities" in capsys.readouterr().err

    @pytest.mark.parametrize("layer", ["A-AREA", "A-DOOR"])
    def test_grids_of_empty_blocks_are_counted(self, folder, capsys, layer):
        drawing = flat()
        drawing.blocks.new("EMPTY")
        drawing.modelspace().add_blockref("EMPTY", (0, 0), dxfattribs={"layer": layer, "row_count": 30_000, "column_count": 30_000,
                                                                       "row_spacing": 1, "column_spacing": 1})
        save(drawing, folder / "flat.dxf")
        started = time.monotonic()
        assert run(folder) == 2
        assert time.monotonic() - started < self.LONGEST
        assert "has too many entities" in capsys.readouterr().err

    def test_a_block_in_itself_ends(self, folder):
        drawing = flat()
        block = drawing.blocks.new("SELF")
        closed(block, rectangle(0, 0, 1000, 1000), "A-AREA")
        block.add_blockref("SELF", (2000, 0))
        drawing.modelspace().add_blockref("SELF", (0, 20_000))
        save(drawing, folder / "flat.dxf")
        assert run(folder) in (0, 1, 2)

    def test_outlines_that_lie_over_each_other_are_compared_so_far(self, folder):
        drawing = flat()
        for index in range(600):
            closed(drawing.modelspace(), rectangle(index, 20_000 + index, 5000, 5000), "A-AREA")
        save(drawing, folder / "flat.dxf")
        started = time.monotonic()
        assert run(folder) == 1
        assert time.monotonic() - started < self.LONGEST


class TestLayerMap:
    def faults(self, folder: Path, text: str) -> list[str]:
        (folder / "map.yaml").write_text(text, encoding="utf-8")
        save(flat(), folder / "flat.dxf")
        assert run(folder) == 2
        assert not (folder / "plan.yaml").exists()
        _, report = read_layer_map(folder / "map.yaml")
        return [line.split("map.yaml:")[1] for line in report.errors]

    def test_has_all_faults_at_once_with_line_and_column(self, folder):
        text = "version: 2\nlayer: {}\nlayers:\n  rooms: A\n  door: B\n  windows: {a: 1}\nunit: yard\noutlines: outer\nlevel_height: high\n"
        found = self.faults(folder, text)
        found.sort()
        assert [line.split(": error: ")[0] for line in found] == ["1:10", "2:1", "5:3", "6:12", "7:7", "8:11", "9:15"]
        assert 'unknown key "layer"\n  hint: did you mean "layers"?' in found[1] and 'did you mean "doors"?' in found[2]
        assert '"yard" is none of m, dm, cm, mm, ft, in' in found[4]

    def test_needs_a_layer_of_rooms(self, folder):
        (fault,) = self.faults(folder, "version: 1\nlayers: {walls: A-WALL}\n")
        assert "no layer has the role rooms" in fault and "walls are not turned into rooms" in fault

    @pytest.mark.parametrize("text", ["", "- a\n", "a: [\n", "a: &a [*a]\n", "[" * 5000, "\0"])
    def test_that_is_none_is_refused(self, folder, capsys, text):
        (folder / "map.yaml").write_text(text, encoding="utf-8")
        save(flat(), folder / "flat.dxf")
        assert run(folder) == 2
        assert "map.yaml" in capsys.readouterr().err

    def test_a_layer_has_one_role(self, folder, capsys):
        (folder / "map.yaml").write_text("version: 1\nlayers: {rooms: A-AREA, walls: 'A-*'}\n", encoding="utf-8")
        save(flat(), folder / "flat.dxf")
        assert run(folder) == 2
        assert 'layer "A-AREA" has two roles, rooms and walls' in capsys.readouterr().err

    def test_a_glob_without_a_layer_is_reported(self, folder, capsys):
        (folder / "map.yaml").write_text(LAYERS.replace("rooms: A-AREA", "rooms: [A-AREA, A-AERA]"), encoding="utf-8")
        save(flat(), folder / "flat.dxf")
        assert run(folder) == 0
        assert 'no layer is called "A-AERA" (rooms)\n  hint: did you mean "A-AREA' in capsys.readouterr().err


def test_layers_are_listed_with_what_they_hold(folder, capsys):
    save(flat(), folder / "flat.dxf")
    assert main([str(folder / "flat.dxf"), "--list-layers"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "A-AREA: 5 LWPOLYLINE" in lines and "A-GLAZ: 1 INSERT, 3 LINE" in lines


@pytest.mark.parametrize("options", [("--chord-error", "0"), ("--chord-error", "nan"), ("--unit", "yard"), ()])
def test_options_that_mean_nothing_are_refused(folder, options, capsys):
    arguments = ["flat.dxf", *options, *(["--layers", "map.yaml"] if options else [])]
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2 and capsys.readouterr().err
