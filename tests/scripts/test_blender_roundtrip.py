"""From a bake through Blender into an edits file, and into the next bake: nothing stands elsewhere than where it was put.

Needs Blender's module and the program (ROOMWRIGHT_PROGRAM, target/, or the PATH).
"""

from __future__ import annotations

import importlib.util
import json
import math
import shutil
import subprocess

import pytest

from blender_scene import HAS_BLENDER, PROGRAM, delete, duplicate, needs_blender
from conftest import ROOT

if HAS_BLENDER:
    import bpy
    from roomwright.blender.extension.exporting import export_level
    from roomwright.blender.extension.importing import import_bake
    from roomwright.blender.extension.options import Options
    from mathutils import Matrix, Vector

EXAMPLES = ROOT / "docs" / "examples"
PLACES = {"moved", "turned", "added", "removed", "class", "variant", "parent", "resized"}
FLOOR = "house/ground.glb"

pytestmark = [
    needs_blender,
    pytest.mark.skipif(PROGRAM is None, reason="no roomwright: cargo build, or ROOMWRIGHT_PROGRAM"),
]


def must(*arguments) -> str:
    """Runs the program, which must succeed; what it says."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, f"{arguments}\n{done.stdout}{done.stderr}"
    return done.stdout


def kinds_of(old, new) -> set[str]:
    """The kinds of PLACES in which two bakes or files differ."""
    told = json.loads(must("diff", old, new, "--json"))
    assert told["troubles"] == []
    return PLACES & told["summary"]["changes"].keys()


@pytest.fixture(scope="module")
def before(tmp_path_factory):
    folder = tmp_path_factory.mktemp("before")
    must("bake", ROOT / "configs/plans/house.yaml", "--out", folder, "--textures", "none", "--quiet", "--no-edits")
    return folder


@pytest.fixture
def plan(tmp_path):
    """A copy of the house's plan, beside which an edits file may be written."""
    return shutil.copy(ROOT / "configs/plans/house.yaml", tmp_path / "house.yaml")


class Own:
    """File > Import and Export > glTF, with Custom Properties and Punctual Lights ticked."""

    @staticmethod
    def open(folder):
        bpy.ops.import_scene.gltf(filepath=str(folder / FLOOR), loglevel=50)

    @staticmethod
    def export(path):
        bpy.ops.export_scene.gltf(filepath=str(path), export_format="GLB", export_extras=True, export_lights=True,
                                  export_yup=True)


class Scripts:
    """Both levels at their places, of which one is exported."""

    @staticmethod
    def open(folder):
        import_bake(folder, Options(ceilings=False))

    @staticmethod
    def export(path):
        export_level(path, "house/ground")


@pytest.fixture(params=[Own, Scripts], ids=["blender's own", "scripts"])
def way(request, before):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    request.param.open(before)
    return request.param


def piece(class_: str, room: str):
    """The first of a class in a room."""
    return min((thing for thing in bpy.data.objects if thing.get("class") == class_ and thing.name.endswith(f"@{room}")),
               key=lambda thing: thing.name)


def turn(thing, degrees: float) -> None:
    """R Z: about the piece's own origin."""
    thing.matrix_basis = thing.matrix_basis @ Matrix.Rotation(math.radians(degrees), 4, "Z")


def capture(before, edited, plan):
    """Writes the edits file beside the plan; where that is."""
    path = plan.with_name("house.edits.yaml")
    must("edits", "capture", before / FLOOR, edited, "--edits", path)
    return path


def bake(plan, folder):
    must("bake", plan, "--out", folder, "--textures", "none", "--quiet")
    return folder


def moved(_):
    piece("armchair", "study").location += Vector((0.3, 0.25, 0.0))


def turned(_):
    turn(piece("dining_table", "living"), 30.0)


def child_moved(_):
    lamp = piece("desk_lamp", "study")
    assert lamp.parent["kind"] == "furniture"
    lamp.location += Vector((-0.1, 0.05, 0.0))
    turn(lamp, -25.0)


def hierarchy_deleted(_):
    cabinet = piece("cabinet", "study")
    assert cabinet.children
    delete(cabinet, *cabinet.children_recursive)


def copied(_):
    duplicate(piece("plant", "study").name, linked=True).location.x += 1.1


def hierarchy_copied(_):
    """Shift+D of a lamp with its light, or of whatever stands with something on it."""
    lamp = duplicate(piece("floor_lamp", "study").name, linked=False)
    lamp.location += Vector((0.4, 0.3, 0.0))
    turn(lamp, 40.0)


def stack_copied(_):
    """Alt+D of a sideboard with what stands on it: new pieces that stand on a new piece."""
    sideboard = piece("sideboard", "living")
    assert sideboard.children
    duplicate(sideboard.name, linked=True).location.x -= 1.2


# What each edit is, and the kinds of difference that it makes to the house.
EDITS = {
    moved: {"moved"},
    turned: {"moved", "turned"},  # the chairs go round with the table
    child_moved: {"moved", "turned"},
    hierarchy_deleted: {"removed"},
    copied: {"added"},
    hierarchy_copied: {"added"},
    stack_copied: {"added"},
}


@pytest.mark.parametrize("edit", EDITS, ids=lambda edit: edit.__name__)
def test_an_edit_is_baked_again_where_it_was_made(way, edit, before, plan, tmp_path):
    edited = tmp_path / "edited.glb"
    edit(way)
    way.export(edited)
    capture(before, edited, plan)
    after = bake(plan, tmp_path / "after")
    assert kinds_of(edited, after / FLOOR) == set()
    assert kinds_of(before, after) == EDITS[edit] == kinds_of(before / FLOOR, edited)


def test_all_edits_together_and_then_more(way, before, plan, tmp_path):
    for edit in EDITS:
        edit(way)
    way.export(tmp_path / "edited.glb")
    capture(before, tmp_path / "edited.glb", plan)
    after = bake(plan, tmp_path / "after")
    assert kinds_of(tmp_path / "edited.glb", after / FLOOR) == set()
    # A second round, from the bake that has the first one's edits.
    bpy.ops.wm.read_factory_settings(use_empty=True)
    way.open(after)
    moved(way)
    way.export(tmp_path / "again.glb")
    capture(after, tmp_path / "again.glb", plan)
    again = bake(plan, tmp_path / "again")
    assert kinds_of(tmp_path / "again.glb", again / FLOOR) == set()
    assert kinds_of(after, again) == {"moved"}


def test_what_nobody_changed_is_no_edit(way, before, plan, tmp_path):
    way.export(tmp_path / "edited.glb")
    path = capture(before, tmp_path / "edited.glb", plan)
    assert not path.exists() or "objects" not in path.read_text()
    assert kinds_of(before, bake(plan, tmp_path / "after")) == set()


def test_the_examples_make_the_same_edits_with_blender_and_without(before, plan, tmp_path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    Scripts.open(before)
    example("edit_in_blender").edit()
    Scripts.export(tmp_path / "in_blender.glb")
    example("edit_without_blender").main(before / FLOOR, tmp_path / "without.glb")
    assert kinds_of(tmp_path / "in_blender.glb", tmp_path / "without.glb") == set()
    assert kinds_of(before / FLOOR, tmp_path / "without.glb") == {"moved", "turned", "added", "removed"}


def example(name: str):
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
