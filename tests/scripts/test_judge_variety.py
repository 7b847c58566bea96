"""Arrangements over seeds: different ones count, mirrored and shifted ones do not."""

from __future__ import annotations

from pathlib import Path

import pytest
import shapely

from judge import main
from judged_floor import Judged, house
from judging.variety import arrangement_of, distinct

BED, WARDROBE = (1.6, 2.0, 0.6), (1.2, 0.6, 2.0)


def bedroom(bed_x: float, wardrobe_x: float) -> Judged:
    """A room of 5 x 4 m with a bed at its south wall and a wardrobe at its north wall."""
    made = house("bedroom", 5.0, 4.0).piece("double_bed", bed_x, 1.0, "north", BED)
    return made.piece("wardrobe", wardrobe_x, 3.7, "south", WARDROBE)


OTHER = house("bedroom", 5.0, 4.0).piece("double_bed", 1.0, 2.0, "east", BED).piece("wardrobe", 4.0, 3.7, "south", WARDROBE)


@pytest.mark.parametrize("made, count", [
    ([bedroom(1.0, 1.0), bedroom(1.3, 1.2)], 1),  # a step aside
    ([bedroom(1.0, 1.0), bedroom(4.0, 4.0)], 1),  # mirrored
    ([bedroom(1.0, 1.0), bedroom(1.0, 4.0)], 1),  # most of the furniture stands as before
    ([bedroom(1.0, 1.0), bedroom(2.5, 4.0)], 2),
    ([bedroom(1.0, 1.0), OTHER, bedroom(4.0, 4.0)], 2),
])
def test_arrangements_that_differ_are_counted(made, count, tmp_path):
    assert distinct(arrangement_of(one.read(tmp_path)) for one in made) == count


def test_a_room_that_is_not_symmetric_has_no_mirrored_arrangements(tmp_path):
    rooms = [made.read(tmp_path) for made in (bedroom(1.0, 1.0), bedroom(4.0, 4.0))]
    for room in rooms:
        room.region = room.region.difference(shapely.box(3.0, 2.5, 5.0, 4.0))
    assert distinct(arrangement_of(room) for room in rooms) == 2


def write(folder: Path, made: Judged) -> None:
    folder.mkdir()
    made.write(folder)


def test_the_command_reports_variety_and_what_plans_have_no_place_for(tmp_path, capsys):
    write(tmp_path / "a", bedroom(1.0, 1.0))
    missing = [{"class": "double_bed", "reason": "clearance", "required": True}]
    write(tmp_path / "b", house("bedroom", 5.0, 4.0, removed=missing).piece("wardrobe", 1.0, 3.7, "south", WARDROBE))
    assert main([str(tmp_path), "--quiet", "--compare", "--variety", "--worst", "3"]) == 0
    out = capsys.readouterr().out
    assert "0 of 1 rooms (0 %) have 3 or more arrangements" in out and "2.0 on average" in out
    assert "| bedroom | 1 | 0 | 0 % |" in out
    assert "- house/ground/101 bedroom 20.0 m², 1 seed: no double_bed" in out


def test_a_required_piece_with_a_finding_is_not_given(tmp_path, capsys):
    missing = [{"class": "double_bed", "reason": "clearance", "required": True}]
    finding = [{"code": "missing_required", "severity": "failed", "objects": ["double_bed"]}]
    made = house("bedroom", 5.0, 4.0, removed=missing, findings=finding)
    write(tmp_path / "a", made.piece("wardrobe", 1.0, 3.7, "south", WARDROBE))
    assert main([str(tmp_path), "--quiet", "--compare", "--worst", "3"]) == 0
    assert "in 0 of 1 rooms" in capsys.readouterr().out
