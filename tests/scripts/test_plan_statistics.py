"""Statistics of planned buildings beside real ones: what is counted, and how far two samples are apart."""

from __future__ import annotations

import json

import pytest

from plan_statistics import main
from planned.plan import read_plan
from planned.statistics import MEASURES, distance, samples_of
from planned_building import flats, shed, write_project


def test_equal_samples_have_no_distance():
    assert distance([1, 2, 3], [3, 2, 1]) == 0
    assert distance([1, 1, 2, 2], [1, 2]) == 0


def test_samples_apart_have_the_distance_one():
    assert distance([1, 2], [3, 4, 5]) == 1
    assert distance([5], [3, 4]) == 1


def test_the_distance_is_the_largest_difference_of_the_shares_below():
    # Up to 2: three quarters of the first, a quarter of the second.
    assert distance([1, 2, 2, 5], [2, 3, 4, 5]) == pytest.approx(0.5)
    assert distance([1, 2, 3, 4], [2.5] * 10) == pytest.approx(0.5)
    assert distance([], [1]) is None


def test_rooms_flats_and_landings_are_counted(tmp_path):
    folder = write_project(tmp_path / "plans", (flats(), (0, 0), 0))
    found = samples_of(read_plan(folder / "flats.yaml"))
    assert found["rooms_of_flat"] == [4] * 4 and found["flats_at_landing"] == [2, 2]
    assert found["doors_of_corridor"] == [4] * 4 and found["doors_of_room"] == [1] * 12
    assert found["windows"] == [1] * 8
    assert found["area_living"] == pytest.approx([4.88 * 2.88] * 4)
    assert found["area_bathroom"] == pytest.approx([1.88 * 1.88] * 4)
    hall = 2.88 * 1.88
    assert found["area_of_flat"] == pytest.approx([2 * 4.88 * 2.88 + 1.88 * 1.88 + hall] * 4)
    assert found["corridor_share"][0] == pytest.approx(hall / found["area_of_flat"][0])
    assert found["rectangularity"] == pytest.approx([1.0] * 16)
    assert found.keys() <= MEASURES.keys()


def test_the_command_compares_folders(tmp_path, capsys):
    planned = write_project(tmp_path / "planned", (flats(), (0, 0), 0), (shed(), (50, 0), 0))
    real = write_project(tmp_path / "real", (flats(), (0, 0), 0))
    out = tmp_path / "statistics.json"
    assert main(["--planned", str(planned), "--real", str(real), "--out", str(out)]) == 0
    assert "measures within 0.25" in capsys.readouterr().out
    rows = {row["measure"]: row for row in json.loads(out.read_text())["measures"]}
    assert rows["area_living"]["planned"]["count"] == 4 and rows["area_living"]["distance"] == 0
    assert rows["doors_of_room"]["planned"]["count"] == 13 and rows["area_classroom"]["distance"] is None
    assert rows["rectangularity"]["planned_rectangles"] == 1


def test_nothing_to_measure(tmp_path, capsys):
    assert main(["--planned", str(tmp_path), "--real", str(tmp_path)]) == 2
    assert "there is no plan" in capsys.readouterr().err
