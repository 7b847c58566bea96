"""The table of what leads up in stairs."""

from __future__ import annotations

import count_stairs


def add_stairs(floor, height: float | None) -> None:
    """A room of stairs, with a part of a height if one is given."""
    room = floor.node("room:stairs", {"kind": "room", "room": "stairs", "type": "stairs"}, 0)
    if height is not None:
        floor.node("stairs@stairs", {"kind": "part", "part": "stairs", "id": "stairs", "height": height}, room)


def test_stairs_are_counted_by_what_leads_up_in_them(floor, tmp_path, capsys):
    add_stairs(floor, 3.0)
    add_stairs(floor, None)
    floor.write(tmp_path / "ground.glb")
    add_stairs(floor, 0.95)
    floor.write(tmp_path / "upper.glb")
    assert count_stairs.main([str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[2:] == ["| with steps up | 2 | 40.0% |", "| without | 2 | 40.0% |", "| where steps end | 1 | 20.0% |"]


def test_a_building_of_one_level_needs_no_steps(floor, tmp_path, capsys):
    add_stairs(floor, None)
    floor.write(tmp_path / "ground.glb")
    assert count_stairs.main([str(tmp_path)]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 2


def test_a_broken_floor_is_named_and_an_empty_folder_cannot_start(floor, tmp_path, capsys):
    assert count_stairs.main([str(tmp_path)]) == 2
    floor.write(tmp_path / "ground.glb")
    (tmp_path / "upper.glb").write_bytes(b"glTF")
    assert count_stairs.main([str(tmp_path)]) == 1
    assert "upper.glb" in capsys.readouterr().err
