"""Each fault of a tileset that validate.py looks for: a tileset that has it, beside the correct one that has none."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT
from tile_site import Site, features, offsets_of

from roomwright import validate
from roomwright.checks.tileset import check_tileset


@pytest.fixture
def site() -> Site:
    return Site()


def faults_of(site: Site, folder) -> list[str]:
    tileset = site.write(folder)
    return [f"{fault.code} {fault.node}: {fault.message}" for fault in check_tileset(tileset)]


def faults_of_tile(site: Site, folder) -> list[str]:
    faults, _ = validate.check_file(site.tile.write(folder / "tile.glb"))
    return [f"{fault.code} {fault.node}: {fault.message}" for fault in faults if "wood.png" not in fault.message]


def test_a_correct_tileset_has_no_fault(site, tmp_path):
    assert faults_of(site, tmp_path) == []
    assert faults_of_tile(site, tmp_path) == []


def test_what_all_rows_share_may_be_the_default_of_its_property(site, tmp_path):
    describe("level", type="STRING", default="ground")(site)
    assert faults_of_tile(site, tmp_path) == []


# --- the tree ---


def change(name: str, **values):
    return lambda site: site.find(name).update(values)


def drop(name: str, key: str):
    return lambda site: site.find(name).pop(key)


def set_box(name: str, place: int, value: float):
    def damage(site: Site) -> None:
        tile = site.find(name)
        tile["boundingVolume"] = {"box": [*tile["boundingVolume"]["box"]]}
        tile["boundingVolume"]["box"][place] = value
    return damage


def set_transform(place: int, value: float):
    def damage(site: Site) -> None:
        matrix = [*site.find("level")["transform"]]
        matrix[place] = value
        site.find("level")["transform"] = matrix
    return damage


def of_first(**values):
    return lambda site: site.first.update(values)


def of_quarter(**values):
    return lambda site: site.first["root"]["children"][0].update(values)


def add_file(path: str):
    return lambda site: site.files.update({path: b"{}"})


@pytest.mark.parametrize(("damage", "expected"), [
    # The shape.
    (of_first(asset={"version": "1.0"}), "tiles : asset.version: '1.0' is not as its schema says: const '1.1'"),
    (lambda site: site.first.pop("geometricError"), "tiles : geometricError: it is missing"),
    (of_first(gltfUpAxis="Z"), "tiles : the key 'gltfUpAxis' is unknown"),
    (drop("boxes", "boundingVolume"), "tiles : root.children[0].children[0].boundingVolume: it is missing"),
    (change("full", boundingVolume={"box": [0.0] * 11}), "tiles : root.children[0].children[0].children[0].boundingVolume.box"),
    (change("full", boundingVolume={}), "tiles : root.children[0].children[0].children[0].boundingVolume"),
    (change("full", boundingVolume={"sphere": [0.0] * 4}), "tiles root.children[0].children[0].children[0]: its volume is no box"),
    (change("full", geometricError=-1.0), "tiles : root.children[0].children[0].children[0].geometricError: -1.0 is not 0 or more"),
    (change("level", refine="replace"), "tiles : root.children[0].refine: 'replace' is not as its schema says"),
    (drop("building", "refine"), "tiles root: `refine` is missing"),
    (of_first(extensionsRequired=["MAXAR_content_geojson"]), "tiles : it requires an extension that it does not use"),
    (drop("full", "content"), "tiles : no tile leads to it"),
    (change("full", content={"url": "../house/ground.full.glb"}), "tiles : root.children[0].children[0].children[0].content.uri: it is"),
    (change("boxes", contents=[{"uri": "../house/ground.boxes.glb"}]), "tiles root.children[0].children[0]: it has several contents"),
    # Volumes.
    (set_box("boxes", 0, 2.002), "tiles root.children[0].children[0]: its box reaches 0.0020 m out of that of the tile above"),
    (set_box("building", 0, 2.002), "tiles root: its box reaches 0.0020 m out of that of the tile above"),
    (set_transform(14, 3.01), "tiles root.children[0]: its box reaches 0.0100 m out of that of the tile above"),
    (set_box("full", 11, 0.29), "tiles root.children[0].children[0].children[0]: its content draws up to 0.0100 m outside"),
    (set_box("full", 4, 0.5), "tiles root.children[0].children[0].children[0]: the axes of its box are not at right angles"),
    (set_transform(0, -1.0), "tiles root.children[0]: `transform` is none: it mirrors or flattens"),
    (set_transform(3, 1.0), "tiles root.children[0]: `transform` is none: its last row"),
    # Errors.
    (change("full", geometricError=0.3), "tiles root.children[0].children[0].children[0]: its error, 0.3, is not smaller than that of the"),
    (of_first(geometricError=16.0), "tiles root: its error, 16.0, is not smaller than that of the file, 16.0"),
    (of_quarter(geometricError=4.0), "tiles root: its error, 4.0, is not smaller than that of the tile above, 4.0"),
    (lambda site: site.second.update(geometricError=9.0), "tiles : its error, 9.0, is larger than that of the tile that leads to it"),
    # Files.
    (change("full", content={"uri": "../house/gone.glb"}), "tiles root.children[0].children[0].children[0]: content.uri: '../house/gone"),
    (change("full", content={"uri": "../../x.glb"}), "path root.children[0].children[0].children[0]: content.uri: '../../x.glb' leads out"),
    (change("full", content={"uri": "/x.glb"}), "path root.children[0].children[0].children[0]: content.uri: '/x.glb' is an absolute"),
    (change("full", content={"uri": "../house/ground.boxes.glb"}),
     "tiles root.children[0].children[0].children[0]: content.uri: '../house/ground.boxes.glb' is already the content of"),
    (change("full", content={"uri": "../tileset.json"}), "tiles root.children[0].children[0].children[0]: content.uri: '../tileset.json'"),
    (of_quarter(children=[{"boundingVolume": {"box": [8.5, 22, 3.2, 1, 0, 0, 0, 1, 0, 0, 0, 0.1]}, "geometricError": 1.0}]),
     "tiles root.children[0]: a tile that leads to another tileset has no children of its own"),
    (add_file("house/old.glb"), "tiles : no tile leads to it"),
    (add_file("shared-textures/old.png"), "tiles : no tile leads to it"),
    (lambda site: site.files.update({"house/ground.boxes.glb.part": b""}), "tiles : no tile leads to it"),
    (lambda site: site.tile.document["images"][0].update(uri="../shared-textures/gone.png"), "file : cannot be read: images[0].uri"),
    # Metadata.
    (change("level", metadata={"class": "storey"}), "tiles root.children[0]: the file's schema has no class 'storey'"),
    (change("level", metadata={"class": "level"}), "tiles root.children[0]: the property 'id' is missing"),
    (change("level", metadata={"class": "level", "properties": {"id": 1}}), "tiles root.children[0]: the property 'id' is 1, which is no"),
    (change("level", metadata={"class": "level", "properties": {"id": "1", "name": "x"}}), "tiles root.children[0]: its class has no"),
    (lambda site: site.second["schema"].update(id="a site"), "tiles : schema.id: 'a site' is not as its schema says: pattern"),
])
def test_each_fault_of_a_tree_is_found_and_named(site, tmp_path, damage, expected):
    damage(site)
    faults = faults_of(site, tmp_path)
    assert any(fault.startswith(expected) for fault in faults), faults


def test_a_box_may_reach_a_millimetre_out_of_that_of_the_tile_above(site, tmp_path):
    set_box("full", 0, 2.0009)(site)
    assert faults_of(site, tmp_path) == []


def test_instances_are_part_of_what_is_drawn(site, tmp_path):
    index = site.tile.instancing["attributes"]["TRANSLATION"]
    view = site.tile.document["bufferViews"][site.tile.document["accessors"][index]["bufferView"]]
    moved = np.array([[1.0, 0.0, -1.0], [4.0, 0.0, -2.0]], "<f4").tobytes()
    start = view["byteOffset"]
    site.tile.binary = site.tile.binary[:start] + moved + site.tile.binary[start + len(moved):]
    assert "its content draws up to 0.2500 m outside of its box" in "".join(faults_of(site, tmp_path))


def test_a_file_that_is_no_json_is_a_fault(site, tmp_path):
    tileset = site.write(tmp_path)
    (tmp_path / "tileset" / "0.json").write_text("{")
    assert any(fault.code == "file" for fault in check_tileset(tileset))


# --- features ---


def set_numbers(values: list[float]):
    """Other numbers for the instances."""
    return lambda site: site.tile.instancing["attributes"].update(_FEATURE_ID_0=site.tile.numbers(values))


def set_offsets(rows: list[int]):
    def damage(site: Site) -> None:
        site.tile.table["properties"]["id"]["stringOffsets"] = site.tile.view(np.array(rows, "<u4").tobytes())
    return damage


def mix_corners(site: Site) -> None:
    site.tile.slab["attributes"]["_FEATURE_ID_0"] = site.tile.numbers([0, 1] * 12)


def misalign(site: Site) -> None:
    view = site.tile.view(b"\0\0\0\0" + offsets_of(["floor", "desk.1", "desk.2"]))
    entry = site.tile.document["bufferViews"][view]
    entry.update(byteOffset=entry["byteOffset"] + 4, byteLength=entry["byteLength"] - 4)
    site.tile.table["properties"]["id"]["stringOffsets"] = view


def of_document(key: str, value):
    return lambda site: site.tile.document.update({key: value})


def of_table(**values):
    return lambda site: site.tile.table.update(values)


def describe(name: str, **about):
    """A property of the schema that has no column."""
    return lambda site: site.tile.described.update({name: about})


def of_node(features_of_node: dict):
    return lambda site: site.tile.document["nodes"][2]["extensions"].update(EXT_instance_features=features_of_node)


@pytest.mark.parametrize(("damage", "expected"), [
    (set_numbers([1, 3]), "features desks: featureIds[0]: numbers from 1 to 3 are not those of the 3 rows"),
    (set_numbers([-1, 2]), "features desks: featureIds[0]: numbers from -1 to 2 are not"),
    (set_numbers([1, 1.5]), "features desks: featureIds[0]: numbers from 1 to 1.5 are not"),
    (set_numbers([1, 2, 2]), "features desks: its attributes have 2, 3 rows"),
    (mix_corners, "features meshes[0].primitives[0]: featureIds[0]: 12 triangles join corners of different pieces"),
    (of_node(features(1)), "features desks: featureIds[0]: there are 2 features, and `featureCount` is 1"),
    (of_node(features(0)), "features desks: featureIds[0].featureCount: 0 is not 1 or more"),
    (of_node({"featureIds": [{"featureCount": 3, "attribute": 1, "propertyTable": 0}]}),
     "features desks: featureIds[0]: there is no attribute _FEATURE_ID_1"),
    (of_node({"featureIds": [{"featureCount": 3, "attribute": 0, "propertyTable": 1}]}), "features desks: featureIds[0]: there is no table 1"),
    (lambda site: site.tile.slab.pop("extensions"), "features meshes[0].primitives[0]: nothing says which pieces it shows"),
    (lambda site: site.tile.document["nodes"][2]["extensions"].pop("EXT_instance_features"), "features desks: nothing says"),
    (set_offsets([0, 11, 5, 17]), "features : propertyTables[0]: id: `stringOffsets` does not rise from 0"),
    (set_offsets([1, 5, 11, 17]), "features : propertyTables[0]: id: `stringOffsets` does not rise from 0"),
    (set_offsets([0, 5, 11, 18]), "features : propertyTables[0]: id: `stringOffsets` ends at 18, after the 17 bytes"),
    (set_offsets([0, 5, 11]), "features : propertyTables[0]: id: `stringOffsets` has 12 bytes, not those of 4 numbers"),
    (misalign, "features : propertyTables[0]: id: `stringOffsets` does not begin at a multiple of 8 bytes"),
    (lambda site: site.tile.table["properties"]["id"].update(values=site.tile.view(b"\xff" * 17)),
     "features : propertyTables[0]: id: row 0 is no text in UTF-8"),
    (lambda site: site.tile.table["properties"]["id"].pop("stringOffsets"), "features : propertyTables[0]: id: a column of texts has no"),
    (lambda site: site.tile.table["properties"].pop("id"), "features : propertyTables[0]: the property 'id' is missing"),
    (describe("level", type="STRING"), "features : propertyTables[0]: the property 'level' has neither a column nor a text as `default`"),
    (describe("level", type="STRING", default=1), "features : propertyTables[0]: the property 'level' has neither a column nor a text"),
    (lambda site: site.tile.table["properties"].update(name=site.tile.table["properties"]["id"]),
     "features : propertyTables[0]: its class has no property 'name'"),
    (of_table(count=4), "features : propertyTables[0]: room: `stringOffsets` has 16 bytes, not those of 5 numbers"),
    (of_table(**{"class": "chair"}), "features : propertyTables[0]: the schema has no class 'chair'"),
    (of_table(rows=3), "features : EXT_structural_metadata: propertyTables[0]: the key 'rows' is unknown"),
    (of_document("extensionsRequired", []), "features : it needs EXT_mesh_gpu_instancing, but does not require it"),
    (of_document("extensionsRequired", ["EXT_mesh_gpu_instancing", "KHR_x"]), "features : it requires KHR_x, but does not use it"),
    (lambda site: site.tile.document["extensionsUsed"].append("KHR_lights_punctual"), "features : it has lights"),
    (lambda site: site.tile.document["accessors"][site.tile.slab["attributes"]["POSITION"]].update(componentType=5122),
     "features : it needs KHR_mesh_quantization, but does not require it"),
])
def test_each_fault_of_features_is_found_and_named(site, tmp_path, damage, expected):
    damage(site)
    faults = faults_of_tile(site, tmp_path)
    assert any(fault.startswith(expected) for fault in faults), faults


# --- the command, and what the program writes ---


def run(*arguments) -> tuple[int, dict]:
    done = subprocess.run([sys.executable, ROOT / "scripts/validate.py", *arguments, "--no-khronos", "--json", "--quiet"],
                          capture_output=True, text=True, check=False)
    return done.returncode, json.loads(done.stdout)


def test_a_folder_with_a_tileset_is_judged_as_one(site, tmp_path):
    site.files.pop("manifest.json")
    site.write(tmp_path)
    status, report = run(tmp_path)
    assert (status, report["tilesets"], report["files"], report["faults"]) == (0, 1, 2, [])
    add_file("house/old.png")(site)
    site.write(tmp_path)
    status, report = run(tmp_path)
    assert status == 1 and [fault["code"] for fault in report["faults"]] == ["tiles"]


PROJECT = """version: 1
project:
  name: Street
  plans:
    - {plan: %s, id: "house-{n}", count: 3, columns: 2, step: [20, 15]}
"""


@pytest.mark.parametrize("options", [
    [], ["--instancing", "none"], ["--origin", "13.41,52.53,40", "--heading", "12"], ["--near", "60,20,8"]])
def test_what_the_program_writes_has_no_fault(tmp_path, options):
    program = os.environ.get("ROOMWRIGHT_PROGRAM") or shutil.which("roomwright")
    if not program:
        pytest.skip("ROOMWRIGHT_PROGRAM names no program, and none is on the path")
    project = tmp_path / "street.yaml"
    project.write_text(PROJECT % (ROOT / "configs/plans/house.yaml"), encoding="utf-8")
    subprocess.run([program, "tiles", project, *options, "--out", tmp_path / "tiles", "--quiet"], check=True)
    status, report = run(tmp_path / "tiles")
    assert (status, report["tilesets"], report["faults"]) == (0, 1, [])
