"""The judge's command, its tables, and its page."""

from __future__ import annotations

import json

import pytest

from conftest import ROOT
from judge import main
from judged_floor import house
from judging.report import measures_table
from judging.table import MEASURES, SUBJECTS


@pytest.fixture
def bake(tmp_path):
    """Two levels: a bedroom without a bed that the audit did not complain about, and a kitchen."""
    for name, made in (("a", house("bedroom").piece("wardrobe", 1.0, 0.3, "north", (1.2, 0.6, 2.0))),
                       ("b", house("kitchen").piece("sink_unit", 1.0, 0.3, "north", (0.6, 0.6, 0.9)))):
        (tmp_path / name).mkdir()
        made.write(tmp_path / name)
    return tmp_path


def test_the_command_prints_a_row_for_each_measure(bake, capsys):
    assert main([str(bake), "--quiet", "--compare", "--worst", "5"]) == 0
    out = capsys.readouterr().out
    assert "2 furnished rooms, 1 seed" in out
    assert "| `bedroom_without_bed` |  | 1 | 1 | 100.0 % | **not met**" in out
    assert "- house/ground/101 bedroom 16.0 m², seed 1: no bed on 16.0 m²" in out


def test_the_command_tells_what_only_the_judge_sees(bake, capsys):
    assert main([str(bake), "--quiet", "--json"]) == 0
    agreement = {row["code"]: row for row in json.loads(capsys.readouterr().out)["agreement"]}
    row = agreement["bedroom_without_bed"]
    assert (row["both"], row["only_judge"], row["only_audit"]) == (0, 1, 0)


def test_a_file_that_cannot_be_read_is_reported_and_the_others_are_judged(bake, capsys):
    (bake / "broken.glb").write_bytes(b"glTF")
    assert main([str(bake), "--quiet"]) == 1
    captured = capsys.readouterr()
    assert "broken.glb" in captured.err and "2 furnished rooms" in captured.out


def test_the_figures_of_a_page_are_renewed(bake, capsys):
    page = bake / "page.md"
    page.write_text("# Judge\n\n<!-- figures -->\n\nold\n", encoding="utf-8")
    assert main([str(bake), "--quiet", "--page", str(page)]) == 0
    text = page.read_text(encoding="utf-8")
    assert text.startswith("# Judge\n\n<!-- figures -->\n\n2 furnished rooms, 1 seed. No finding, drawings apart: ") and "old" not in text
    assert "| `bedroom_without_bed` |" in text


def test_nothing_to_judge(tmp_path, capsys):
    assert main([str(tmp_path)]) == 2
    assert main([str(tmp_path / "absent")]) == 2


def test_codes_are_unique():
    assert len(MEASURES) == sum(len(module.MEASURES) for module in SUBJECTS.values())


def test_the_page_lists_the_measures():
    assert measures_table() in (ROOT / "docs" / "judge.md").read_text(encoding="utf-8")
