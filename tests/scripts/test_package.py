"""The package `roomwright`: bakes by the program, and reads bakes as data."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT, write_manifest

import roomwright
from roomwright.program import find_program

PROGRAM = os.environ.get("ROOMWRIGHT_PROGRAM")
HOME = ROOT / "tests/cases/sweet_home/flat.sh3d"
needs_program = pytest.mark.skipif(PROGRAM is None, reason="ROOMWRIGHT_PROGRAM names no program")


def saved(floor, folder: Path) -> roomwright.Bake:
    (folder / "house").mkdir(parents=True)
    floor.write(folder / "house" / "ground.glb")
    write_manifest(folder)
    return roomwright.Bake.open(folder)


class TestReading:
    def test_a_level_holds_its_rooms_and_they_their_furniture(self, floor, tmp_path):
        bake = saved(floor, tmp_path)
        (level,) = bake.levels
        (room,) = level.rooms
        assert (level.name, level.file) == ("house/ground", tmp_path / "house" / "ground.glb")
        assert bake.level("house/ground") is level
        assert [piece.id for piece in room.placements] == [node["extras"]["id"] for node in floor.document["nodes"]
                                                           if node["extras"]["kind"] == "furniture"]
        assert {piece.room for piece in bake.placements} == {room.id}
        assert type(room.seed) is int and all(len(point) == 2 for point in room.outline)

    def test_places_are_those_of_the_plan(self, floor, tmp_path):
        found = {piece.id: piece for piece in saved(floor, tmp_path).placements}
        desk, lamp = found["desk.2"], found["lamp.1"]
        assert desk.position == pytest.approx((3.0, 2.0, 0.0)) and desk.angle == pytest.approx(math.pi / 2)
        # The lamp stands half a metre to the desk's east, and 0.1 m to its south. The desk's quarter turn, counter-clockwise from
        # above, takes its east to the plan's north and its south to the plan's east.
        assert lamp.position == pytest.approx((3.1, 2.5, 0.74)) and lamp.angle == pytest.approx(math.pi / 2 + 0.3)
        assert (lamp.carrier, desk.carrier, lamp.size) == ("desk.2", None, (0.2, 0.2, 0.3))

    @pytest.mark.parametrize("change, message", [
        ({"scale": [1, 2, 1]}, "it is scaled, or has a matrix"),
        ({"extras": {"kind": "furniture", "class": "desk"}}, "KeyError: 'id'"),
        ({"children": [0]}, "node 0 has two parents"),
    ])
    def test_a_file_that_is_no_level_is_named_with_its_fault(self, floor, tmp_path, change, message):
        floor.document["nodes"][-1].update(change)
        with pytest.raises(roomwright.BakeError) as error:
            saved(floor, tmp_path).levels
        assert str(error.value).startswith(f"{tmp_path / 'house' / 'ground.glb'}: ") and message in str(error.value)

    def test_a_folder_without_a_manifest_is_no_bake(self, tmp_path):
        with pytest.raises(roomwright.BakeError, match=r"manifest.json: .*hint: name the folder"):
            roomwright.Bake.open(tmp_path)

    @pytest.mark.parametrize("text, message", [("{", "no JSON"), ("[]", "no manifest of version 1"),
                                               ('{"manifest": 2, "levels": []}', "but 2; hint: bake again")])
    def test_a_manifest_of_another_kind_is_said(self, tmp_path, text, message):
        (tmp_path / "manifest.json").write_text(text)
        with pytest.raises(roomwright.BakeError, match=message):
            roomwright.Bake.open(tmp_path)

    def test_a_manifest_sends_nobody_out_of_its_folder(self, floor, tmp_path):
        bake = saved(floor, tmp_path / "out")
        floor.write(tmp_path / "secret.glb")
        bake.manifest["levels"][0]["files"][0]["path"] = "../secret.glb"
        with pytest.raises(roomwright.BakeError, match="secret.glb"):
            bake.levels

    def test_a_name_that_is_no_level_gets_the_names(self, floor, tmp_path):
        with pytest.raises(KeyError, match="hint: its levels are house/ground"):
            saved(floor, tmp_path).level("house/attic")

    def test_every_piece_of_a_whole_bake_is_read(self, baked):
        bake = roomwright.Bake.open(baked)
        assert len(list(bake.rooms)) == bake.manifest["totals"]["rooms"]
        assert len(list(bake.placements)) == bake.manifest["totals"]["placed"]
        for room in bake.rooms:
            xs, ys = zip(*room.outline)
            for piece in room.placements:
                x, y, z = piece.position
                assert min(xs) < x < max(xs) and min(ys) < y < max(ys) and -1e-6 <= z < room.height, (room.id, piece)


class TestBaking:
    @needs_program
    def test_a_plan_becomes_rooms(self, tmp_path):
        bake = roomwright.bake(HOME, tmp_path / "out", seed=7, textures="none", program=PROGRAM)
        assert bake.manifest["levels"][0]["seed"] == 7
        assert {room.type for room in bake.rooms} >= {"kitchen", "bathroom", "living_room"}
        assert "13 pieces of furniture left out" in bake.warnings

    @needs_program
    def test_a_fault_is_the_program_s_own_message(self, tmp_path):
        with pytest.raises(roomwright.ProgramError, match="absent.yaml: there is no such file\n  hint: check the path") as error:
            roomwright.bake([tmp_path / "absent.yaml"], tmp_path / "out", program=PROGRAM)
        assert error.value.code == 2

    def test_options_are_typed_as_the_program_knows_them(self, tmp_path):
        heard = tmp_path / "heard"
        program = tmp_path / "roomwright"
        program.write_text(f'#!/bin/sh\nprintf "%s\\n" "$@" > {heard}\nexit 2\n')
        program.chmod(0o755)
        with pytest.raises(roomwright.ProgramError, match="ended with 2 and no message"):
            roomwright.bake(["-a.yaml", Path("b.yaml")], "out", style="modern", program=program, door_angle=-5, shared_library=True,
                            force=False, effort=None, reroll=["kitchen", "hall"])
        assert heard.read_text().split("\n")[3:-1] == [
            "--style=modern", "--out=out", "--door-angle=-5", "--shared-library", "--reroll=kitchen", "--reroll=hall", "--", "-a.yaml",
            "b.yaml"]


class TestProgram:
    @pytest.fixture
    def places(self, tmp_path, monkeypatch):
        """A program beside the package, one in the variable, one on the path; a test takes them away one by one."""
        files = [tmp_path / place / "roomwright" for place in ("scripts", "variable", "path")]
        for file in files:
            file.parent.mkdir()
            file.write_text("")
            file.chmod(0o755)
        monkeypatch.setattr("roomwright.program.script_folders", lambda: [str(files[0].parent)])
        monkeypatch.setattr("roomwright.program.ROOT", tmp_path)
        monkeypatch.setenv("ROOMWRIGHT_PROGRAM", str(files[1]))
        monkeypatch.setenv("PATH", str(files[2].parent))
        return files

    def test_the_program_beside_the_package_comes_first(self, places):
        for file in places:
            assert find_program() == file
            file.unlink()
        with pytest.raises(roomwright.ProgramError, match="there is no program roomwright; hint: install"):
            find_program()

    def test_a_named_program_is_no_other(self, places, tmp_path):
        with pytest.raises(roomwright.ProgramError, match="absent is no program"):
            find_program(tmp_path / "absent")


def test_the_package_needs_no_other():
    """In a Python without any packages but its own."""
    done = subprocess.run([sys.executable, "-S", "-c", "import roomwright; print(sorted(roomwright.__all__))"], cwd=ROOT / "python",
                          capture_output=True, text=True, check=True)
    assert done.stdout.strip() == str(sorted(roomwright.__all__))
