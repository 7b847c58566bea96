"""What Blender makes of USD floors with the options that it has by itself, beside what it makes of the glTF files.

Needs Blender's module, and for convert.py the project's .venv, or usd-core beside Blender's module.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from contextlib import contextmanager

import pytest
from blender_scene import HAS_BLENDER, PROGRAM, needs_blender
from conftest import LACKS, ROOT, build_floor
from roomwright.gltf_file import GltfFile

if HAS_BLENDER:
    import bpy

pytestmark = [
    needs_blender,
    pytest.mark.skipif(bool(LACKS) and not (ROOT / ".venv").is_dir(),
                       reason="usd-core is not installed, neither here nor in .venv (source scripts/set_up.sh)"),
]


def converted(source, target, *options):
    """The USD floor of a glTF file; convert.py goes on in .venv by itself where it has to."""
    command = [sys.executable, str(ROOT / "scripts" / "convert.py"), str(source), "--out", str(target), *options]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return target / source.with_suffix(".usdc").name


@contextmanager
def quiet():
    """Keeps Blender's own lines off standard output."""
    sys.stdout.flush()
    kept, nothing = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nothing)


def imported(file) -> dict:
    """Imports a file into an empty scene; how many there are of each kind."""
    with quiet():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        if file.suffix == ".glb":
            bpy.ops.import_scene.gltf(filepath=str(file))
        else:
            bpy.ops.wm.usd_import(filepath=str(file))
    kinds = Counter(each.type for each in bpy.data.objects)
    return {"objects": len(bpy.data.objects), "materials": len(bpy.data.materials), "images": len(bpy.data.images),
            **{kind.lower(): kinds[kind] for kind in ("MESH", "EMPTY", "LIGHT")}}


@pytest.fixture(scope="module")
def house(tmp_path_factory):
    """A floor of the program's, where there is the program; else the tests' own."""
    folder = tmp_path_factory.mktemp("bake")
    if PROGRAM is None:
        return build_floor().write(folder / "ground.glb")
    plan = ROOT / "configs" / "plans" / "house.yaml"
    subprocess.run([PROGRAM, "bake", plan, "--out", folder, "--quiet", "--no-edits"], check=True)
    return folder / "house" / "ground.glb"


@pytest.fixture(scope="module")
def usd(house, tmp_path_factory):
    return converted(house, tmp_path_factory.mktemp("usd"))


def carriers_of(gltf) -> int:
    """Nodes with a mesh and others below: USD has no mesh below a mesh, so these are an empty and a mesh."""
    parents = {node.parent.index for node in gltf.nodes if node.parent is not None}
    return sum(node.mesh is not None and node.index in parents for node in gltf.nodes)


def test_objects_and_materials_are_as_many_as_of_the_glTF_file(house, usd):
    carriers = carriers_of(GltfFile(house))
    expected, found = imported(house), imported(usd)
    expected["objects"] += carriers
    expected["empty"] += carriers
    # One image is one here, by whatever names the glTF file holds it.
    assert found.pop("images") <= expected.pop("images")
    assert found == expected
    assert not bpy.data.collections, "instances would be collections"
    assert not [each.name for each in bpy.data.objects if each.name.startswith(("Materials", "Prototypes", "geometry"))]


def test_extras_are_custom_properties_of_objects_with_the_nodes_names(house, usd):
    imported(usd)
    objects = {each["name"]: each for each in bpy.data.objects if "name" in each.keys()}
    for node in GltfFile(house).nodes:
        each = objects.pop(node.name)
        assert each.name.split(".")[0] == "".join(letter if letter.isalnum() else "_" for letter in node.name)
        for key, value in node.extras.items():
            if type(value) in (str, bool, int, float) and key != "seed":
                assert each[key] == value, (node.name, key)
        if node.kind == "furniture":
            assert list(each["size"]) == node.extras["size"]
        if node.parent is not None:
            assert each.parent["name"] == node.parent.name
    assert not objects


def test_meshes_have_the_materials_of_the_glTF_file(house, usd):
    def slots() -> dict:
        return {(each.get("class"), each.get("id"), each.get("part"), len(each.data.polygons)): [
            "".join(letter if letter.isalnum() else "_" for letter in slot.material.name) for slot in each.material_slots]
            for each in bpy.data.objects if each.type == "MESH" and each.get("kind") == "furniture"}

    imported(house)
    expected = slots()
    imported(usd)
    found = slots()
    assert found and {key: expected[key] for key in found} == found


def test_instances_that_somebody_asks_for_are_collections(house, tmp_path):
    floor = converted(house, tmp_path, "--instances")
    imported(floor)
    meshes = {node.mesh for node in GltfFile(house).nodes if node.mesh is not None}
    assert len(bpy.data.meshes) <= len(meshes), "each model is there once"
    assert [each for each in bpy.data.objects if each.instance_collection]


def test_a_lamp_s_light_in_blender_is_a_room_s_and_no_stadium_s(house, tmp_path):
    """Watts at exposure 0, which is how Blender draws by itself: a household lamp has 10 to 100."""
    lamps = [node.name for node in GltfFile(house).nodes if node.kind == "light"]
    if not lamps:
        pytest.skip("the floor has no lamps (ROOMWRIGHT_PROGRAM names a program that bakes some)")
    imported(converted(house, tmp_path, "--lights"))
    watts = {each["name"]: each.data.energy * 2.0**each.data.exposure for each in bpy.data.objects if each.type == "LIGHT"}
    assert sorted(watts) == sorted(lamps) and all(10.0 < each < 100.0 for each in watts.values()), watts
