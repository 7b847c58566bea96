"""The table of what viewers have to draw."""

from __future__ import annotations

import count_draw_calls


def test_meshes_that_several_nodes_show_count_as_often(floor, tmp_path, capsys):
    floor.write(tmp_path / "ground.glb")
    assert count_draw_calls.main([str(tmp_path)]) == 0
    counts = count_draw_calls.load_of(tmp_path / "ground.glb")
    # A slab, a lamp, and two desks of one mesh in two parts; boxes have 12 triangles.
    assert (counts.nodes, counts.draw_calls, counts.triangles) == (7, 6, 72)
    assert "| ground | 7 | 6 | 72 | 0 | 0 |" in capsys.readouterr().out


def test_a_comparison_has_the_floors_of_both_folders_and_their_sums(floor, tmp_path, capsys):
    for folder in ("old", "new"):
        (tmp_path / folder).mkdir()
        floor.write(tmp_path / folder / "ground.glb")
    floor.node("lamp", {}, 0)
    floor.write(tmp_path / "new" / "ground.glb")
    floor.write(tmp_path / "new" / "upper.glb")
    assert count_draw_calls.main([str(tmp_path / "new"), "--before", str(tmp_path / "old")]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split(" | ")[:2] for line in lines[2:]] == [["| ground", "7 → 8"], ["| all", "7 → 8"]]


def test_a_broken_floor_is_named_and_the_others_are_counted(floor, tmp_path, capsys):
    floor.write(tmp_path / "ground.glb")
    (tmp_path / "upper.glb").write_bytes(b"glTF")
    assert count_draw_calls.main([str(tmp_path)]) == 1
    said = capsys.readouterr()
    assert "upper.glb" in said.err and "| ground |" in said.out


def test_an_empty_folder_cannot_start(tmp_path):
    assert count_draw_calls.main([str(tmp_path)]) == 2
