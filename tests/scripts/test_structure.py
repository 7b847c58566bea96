"""What the sources promise about themselves: files that a newcomer can read one after the other."""

from __future__ import annotations

from pathlib import Path

import pytest

from source_graph import SourceGraph, expand

PROJECT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def graph() -> SourceGraph:
    return SourceGraph(PROJECT / "src")


FOLDERS = [
    "layout", "audit", "solve", "best", "batch", "plan/read", "recipes", "texture", "scene", "walk", "geometry",
    "view", "world",
]
# Rooms are furnished, judged, searched for places and furnished again: no stage knows those after it.
STAGES = ["layout", "audit", "solve", "best"]


@pytest.mark.parametrize("folder", FOLDERS)
def test_no_file_uses_itself_through_others(graph, folder):
    assert graph.circles(tuple(folder.split("/"))) == []


@pytest.mark.parametrize("stage", STAGES)
def test_no_stage_of_a_room_uses_a_later_one(graph, stage):
    later = STAGES[STAGES.index(stage) + 1 :]
    is_test = lambda module: module[-1] in ("tests", "testing")  # noqa: E731
    of_stage = {module: used for module, used in graph.uses.items() if module[:1] == (stage,) and not is_test(module)}
    assert of_stage
    assert [(module, other) for module, used in of_stage.items() for other in used if other[0] in later] == []


def test_textures_know_the_catalogue_and_not_the_other_way_round(graph):
    of_catalog = [used for module, used in graph.uses.items() if module[:1] == ("catalog",)]
    assert not [other for used in of_catalog for other in used if other[:1] == ("texture",)]


def test_recipes_use_nothing_of_the_program_but_geometry(graph):
    of_recipes = [used for module, used in graph.uses.items() if module[:1] == ("recipes",)]
    assert {other[:1] for used in of_recipes for other in used} <= {("recipes",), ("geometry",)}


@pytest.mark.parametrize("user", ["model", "scene", "draw", "layout"])
def test_the_catalogue_uses_nothing_of_what_uses_it(graph, user):
    of_catalog = [(module, used) for module, used in graph.uses.items() if module[:1] == ("catalog",)]
    assert not [module for module, used in of_catalog for other in used if other[:1] == (user,)]


def test_use_trees_name_all_their_paths():
    paths = ["super::a::self", "super::a::b", "super::a::d::e", "super::a::d::f"]
    assert expand("super::a::{self, b as c, d::{e, f}}") == paths


def test_circles_are_found(tmp_path):
    (tmp_path / "mod.rs").write_text("mod a; mod b; pub use b::B;", encoding="utf-8")
    (tmp_path / "a.rs").write_text("use super::B;\npub struct A(B);", encoding="utf-8")
    (tmp_path / "b.rs").write_text("pub struct B;\nfn f() -> super::a::A { todo!() }", encoding="utf-8")
    assert SourceGraph(tmp_path).circles(()) == [["a", "b"]]
