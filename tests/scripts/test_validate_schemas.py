"""Every value of extras and manifests changed, one at a time: validate.py reports each change with its node and its place."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator

import pytest
from blender_scene import storey
from roomwright.checks.contract import check_extras
from roomwright.checks.manifest import complaints
from roomwright.checks.schemas import extras_schemas, place_of
from conftest import write_manifest
from roomwright.gltf_file import GltfFile

# Keys that a bake writes only where there is something to say.
OPTIONAL_OF_EXTRAS = {("level", "site"), ("opening", "leaves"), ("part", "outline"), ("part", "height"), ("room", "score"),
                      ("room", "findings[0].not_searched_further")}
OPTIONAL_OF_TOTALS = ("findings", "given", "score", "broken", "misfits", "score.mean")
OPTIONAL_OF_MANIFESTS = {
    "former_files", "former_levels", "levels[0].left_out", "levels[0].library", "levels[0].program",
    *(f"levels[0].rooms[0].{key}" for key in ("grade", "score", "removed", "findings", "misfits", "failure")),
    *(f"levels[0].rooms[0].findings[0].{key}" for key in ("objects", "severity", "measured", "threshold",
                                                          "not_searched_further")),
    *(f"{totals}.{key}" for totals in ("totals", "levels[0].totals") for key in OPTIONAL_OF_TOTALS)}


def rich_floor():
    """The small floor with every key that the schema of extras knows."""
    floor = storey("ground", 0.0, {"position": [1.0, 2.0], "turn": 0.5})
    floor.find("door:d1")["extras"]["leaves"] = [{"hinge": [1.0, 0.0], "closed": [1.9, 0.0], "open": [1.0, 0.9]}]
    floor.find("floor@101")["extras"] |= {"outline": [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], "height": 2.5}
    floor.find("room:101")["extras"] |= {"score": 0.5, "holes": [[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0]]], "findings": [
        {"code": "sparse", "severity": "minor", "objects": ["desk.1"], "measured": 0.1, "threshold": 0.2,
         "not_searched_further": True}]}
    return floor


@pytest.fixture
def rich_manifest(floor, tmp_path):
    """A manifest with every key that its schema knows."""
    (tmp_path / "house").mkdir()
    floor.write(tmp_path / "house" / "ground.glb")
    path = write_manifest(tmp_path)
    document = json.loads(path.read_text())
    document["totals"] |= {"broken": 0, "misfits": 1, "findings": {"sparse": 1}, "given": {"sparse": 1},
                           "score": {"rooms": 1, "sum": 0.5, "mean": 0.5}}
    finding = {"code": "sparse", "severity": "minor", "objects": ["desk.1"], "measured": 0.1, "threshold": 0.2,
               "not_searched_further": True}
    document["levels"][0] |= {
        "left_out": ["a door"], "library": ["shared-models/a.glb"], "program": "test", "classes": {"desk": 2},
        "totals": document["totals"], "rooms": [
            {"room": "101", "grade": "minor", "score": 0.5, "removed": [{"class": "lamp", "reason": "no place"}],
             "findings": [finding], "misfits": ["desk.9"], "failure": "a fault"}]}
    document |= {"former_levels": [], "former_files": []}
    path.write_text(json.dumps(document))
    return path


def paths_of(value, path=()) -> Iterator[tuple]:
    """The path of every value in a value."""
    for key in value if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ():
        yield (*path, key)
        yield from paths_of(value[key], (*path, key))


def owner_of(value, path):
    for key in path[:-1]:
        value = value[key]
    return value


def with_wrong_kinds(value) -> Iterator[tuple[str, object]]:
    for path in paths_of(value):
        changed = copy.deepcopy(value)
        # No value of the contract is a list of nulls.
        owner_of(changed, path)[path[-1]] = [None]
        yield place_of(list(path)), changed


def without_keys(value) -> Iterator[tuple[str, object]]:
    for path in paths_of(value):
        if isinstance(path[-1], str):
            changed = copy.deepcopy(value)
            del owner_of(changed, path)[path[-1]]
            yield place_of(list(path)), changed


def with_unknown_keys(value) -> Iterator[tuple[str, object]]:
    for path in [(), *paths_of(value)]:
        changed = copy.deepcopy(value)
        found = owner_of(changed, (*path, "odd"))
        if isinstance(found, dict):
            found["odd"] = {}
            yield place_of(list(path)), changed


def faults_of_extras(tmp_path, changes) -> Iterator[tuple[str, str, list[str]]]:
    """Node, place and what the changed extras of this node are reported for, for each change to each node."""
    floor = rich_floor()
    assert list(check_extras(GltfFile(floor.write(tmp_path / "whole.glb")))) == []
    for node in floor.document["nodes"]:
        whole = node["extras"]
        for place, node["extras"] in changes(whole):
            notes = list(check_extras(GltfFile(floor.write(tmp_path / "changed.glb"))))
            yield whole["kind"], place, [note.message for note in notes if note.node == node["name"]]
        node["extras"] = whole


def test_the_fixture_has_every_key_of_every_kind():
    nodes = rich_floor().document["nodes"]
    assert {node["extras"]["kind"] for node in nodes} == extras_schemas().keys()


def test_a_value_of_another_kind_is_reported_with_its_node_and_place(tmp_path):
    reported = list(faults_of_extras(tmp_path, with_wrong_kinds))
    assert len(reported) > 100
    for kind, place, messages in reported:
        assert any(message.startswith((f"{place}: ", f"{place}[0]: ")) for message in messages), (kind, place, messages)


def test_a_missing_key_is_reported_with_its_node_and_place(tmp_path):
    silent = set()
    for kind, place, messages in faults_of_extras(tmp_path, without_keys):
        if not messages:
            silent.add((kind, place))
        else:
            assert f"{place}: it is missing" in messages or place == "kind", (kind, place, messages)
    assert silent == OPTIONAL_OF_EXTRAS


def test_an_unknown_key_is_reported_with_its_node_and_place(tmp_path):
    reported = list(faults_of_extras(tmp_path, with_unknown_keys))
    assert len(reported) > 10
    for kind, place, messages in reported:
        wanted = f"{place}: the key 'odd' is unknown" if place else "the key 'odd' is unknown"
        assert messages == [wanted], (kind, place, messages)


def test_an_unknown_key_hides_no_other_fault(tmp_path):
    floor = rich_floor()
    floor.find("desk.1@101")["extras"] |= {"odd": 1, "side": "top"}
    notes = list(check_extras(GltfFile(floor.write(tmp_path / "changed.glb"))))
    assert [note.message for note in notes] == ["the key 'odd' is unknown", "'top' is no side"]


def faults_of_manifest(path, changes) -> Iterator[tuple[str, list[str]]]:
    whole = json.loads(path.read_text())
    assert list(complaints(path)) == []
    for place, changed in changes(whole):
        path.write_text(json.dumps(changed))
        yield place, [message.partition("; hint")[0] for message in complaints(path)]


def test_a_value_of_another_kind_in_a_manifest_is_reported_with_its_place(rich_manifest):
    reported = list(faults_of_manifest(rich_manifest, with_wrong_kinds))
    assert len(reported) > 60
    for place, messages in reported:
        assert any(message.startswith((f"{place}: ", f"{place}[0]: ")) for message in messages), (place, messages)


def test_a_missing_key_of_a_manifest_is_reported_with_its_place(rich_manifest):
    silent = set()
    for place, messages in faults_of_manifest(rich_manifest, without_keys):
        if messages:
            assert f"{place}: it is missing" in messages, (place, messages)
        else:
            silent.add(place)
    # Counts by class and by code have no keys of their own.
    counts = {place for place in silent if place.endswith((".classes.desk", ".sparse"))}
    assert silent - counts == OPTIONAL_OF_MANIFESTS


def test_an_unknown_key_of_a_manifest_is_reported_with_its_place(rich_manifest):
    for place, messages in faults_of_manifest(rich_manifest, with_unknown_keys):
        if place.endswith((".classes", ".findings", ".given")) or place in ("findings", "given"):
            assert messages == [f"{place}.odd: a dict is not a whole number"]
        else:
            assert messages == [f"{place}: the key 'odd' is unknown" if place else "the key 'odd' is unknown"]
