"""Export from Blender: ids and names in order, and, where Blender's module is installed, edits that come back."""

from __future__ import annotations

import copy
import json
import math
import subprocess

from roomwright.blender import export_command as blender_export
import numpy as np
import pytest
from roomwright.blender import extension
from roomwright.blender.extension.errors import ExportError
from roomwright.blender.extension.identities import Identities
from roomwright.blender.extension.outline import is_inside
from blender_scene import HAS_BLENDER, PROGRAM, census, delete, duplicate, needs_blender, storey, world_matrices
from conftest import furniture
from roomwright.gltf_file import GltfFile

if HAS_BLENDER:
    import bpy
    from roomwright.blender.extension.exporting import export_level
    from roomwright.blender.extension.importing import import_bake
    from roomwright.blender.extension.options import Options
    from mathutils import Matrix, Vector

SITE = {"position": [300.0, -200.0], "turn": 0.5}


class TestIdentities:
    """The document, by hand."""

    @pytest.fixture
    def document(self, floor):
        return copy.deepcopy(floor.document)

    def settled(self, document) -> tuple[dict, list[str]]:
        identities = Identities(document)
        identities.renew()
        return {node["name"]: node.get("extras") for node in document["nodes"]}, identities.notes

    def add(self, document, name, extras, parent) -> None:
        document["nodes"].append({"name": name, "extras": extras})
        above = next(node for node in document["nodes"] if node["name"] == parent)
        above.setdefault("children", []).append(len(document["nodes"]) - 1)

    def test_what_nobody_changed_stays(self, document, floor):
        assert self.settled(document)[1] == []
        assert document == floor.document

    def test_the_seed_of_a_level_that_blender_kept_as_text_is_a_number_again(self, document, floor):
        level = document["nodes"][0]["extras"]
        level["seed"] = str(level["seed"])
        self.settled(document)
        assert document == floor.document

    def test_copies_get_the_next_free_number_and_their_children_too(self, document):
        piece = lambda kind, parent: furniture(kind, 1, parent, "front", (1, 1, 1))
        self.add(document, "desk.1@101.001", piece("desk", "wall.0"), "room:101")
        self.add(document, "lamp.1@101.001", piece("lamp", "desk.2"), "desk.1@101.001")
        self.add(document, "light.lamp.1@101.001", {"kind": "light"}, "lamp.1@101.001")
        names, changes = self.settled(document)
        assert names["desk.3@101"]["id"] == "desk.3" and names["desk.3@101"]["parent"] == "wall.0"
        assert names["lamp.2@101"]["parent"] == "desk.3" and "light.lamp.2@101" in names
        assert names["desk.1@101"]["id"] == "desk.1" and names["lamp.1@101"]["parent"] == "desk.2"
        assert changes == ["desk.1@101.001 is a new piece: desk.3@101", "lamp.1@101.001 is a new piece: lamp.2@101"]

    def test_the_second_building_of_a_scene_has_its_names_back(self, document, floor):
        for node in document["nodes"]:
            node["name"] += ".001"  # the room's, too
        assert self.settled(document)[1] == [] and document == floor.document

    def test_models_of_the_asset_browser_get_an_id_a_parent_and_a_side(self, document):
        extras = {"kind": "furniture", "class": "desk", "size": [1, 1, 1], "variant": 3}
        self.add(document, "desk.3@plain/modern.001", extras, "room:101")
        placed = self.settled(document)[0]["desk.3@101"]
        assert (placed["id"], placed["parent"], placed["side"]) == ("desk.3", "floor", "above")

    def test_what_hung_below_a_piece_that_is_gone_stands_on_the_floor(self, document):
        nodes = document["nodes"]
        lamp, desk, room = (next(n for n in nodes if n["name"] == f"{name}") for name in
                            ("lamp.1@101", "desk.2@101", "room:101"))
        room["children"] += desk.pop("children")
        room["children"].remove(nodes.index(desk))
        assert self.settled(document)[0]["lamp.1@101"]["parent"] == "floor"
        assert lamp["extras"]["side"] == "above"

    def test_a_copy_of_a_door_is_told(self, document):
        door = next(node for node in document["nodes"] if node["name"] == "door:d1")
        self.add(document, "door:d1.001", dict(door["extras"]), "house/ground")
        names, changes = self.settled(document)
        assert {"door:d1", "door:d1.001"} <= set(names) and "door:d1.001 exists twice" in changes[0]

    def test_points_are_inside_concave_rings_or_not(self):
        ring = [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)]
        assert is_inside((0.5, 0.5), ring) and is_inside((3.5, 3.0), ring)
        assert not is_inside((2.0, 2.0), ring) and not is_inside((5.0, 1.0), ring)


class TestCommand:
    """What is refused before Blender is asked for anything."""

    @pytest.mark.parametrize("name, message", [("floor.gltf", "must end in .glb"), ("there.glb", "--force")])
    def test_what_cannot_be_meant_starts_nothing(self, tmp_path, name, message, capsys):
        (tmp_path / "there.glb").write_text("mine")
        with pytest.raises(SystemExit) as stop:
            blender_export.main(["house.blend", "--out", str(tmp_path / name)])
        assert stop.value.code == 2 and message in capsys.readouterr().err


def nodes_of(path) -> dict:
    return {node.name: node for node in GltfFile(path).nodes}


@needs_blender
class TestBlender:
    """There and back."""

    @pytest.fixture(autouse=True)
    def house(self, tmp_path):
        """Two levels far from the origin, their ceilings hidden."""
        bpy.ops.wm.read_factory_settings(use_empty=True)
        storey("upper", 3.0, SITE).write(tmp_path / "upper.glb")
        storey("ground", 0.0, SITE).write(tmp_path / "ground.glb")
        import_bake(tmp_path, Options(ceilings=False))

    def test_what_nobody_changed_comes_back_from_its_place_hidden_or_not(self, tmp_path):
        bpy.data.objects["desk.1@101"].hide_viewport = True  # ceilings are hidden by the eye
        for level in ("ground", "upper"):
            assert export_level(tmp_path / "back.glb", f"house/{level}") == []
            old, new = nodes_of(tmp_path / f"{level}.glb"), nodes_of(tmp_path / "back.glb")
            assert old.keys() == new.keys()
            for name, node in old.items():
                assert new[name].world == pytest.approx(node.world, abs=2e-6), name
                assert new[name].extras == node.extras, name
                assert (new[name].parent and new[name].parent.name) == (node.parent and node.parent.name), name

    def test_edits_come_back(self, tmp_path):
        desk, second = bpy.data.objects["desk.1@101"], bpy.data.objects["desk.2@101"]
        desk.location += Vector((0.5, 0.25, 0.0))
        second.matrix_basis = second.matrix_basis @ Matrix.Rotation(math.pi / 2, 4, "Z")
        copied = duplicate("desk.2@101", linked=True)
        copied.location.x -= 1.5
        notes = export_level(tmp_path / "back.glb", "house/ground")
        assert notes == ["desk.2@101.002 is a new piece: desk.3@101", "lamp.1@101.002 is a new piece: lamp.2@101"]
        old, new = nodes_of(tmp_path / "ground.glb"), nodes_of(tmp_path / "back.glb")
        assert new["desk.1@101"].local[:3, 3] - old["desk.1@101"].local[:3, 3] == pytest.approx([0.5, 0.0, -0.25], abs=1e-5)
        turned = old["desk.2@101"].local @ np.array([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]])
        assert new["desk.2@101"].local == pytest.approx(turned, abs=1e-5)
        assert new["lamp.1@101"].local == pytest.approx(old["lamp.1@101"].local, abs=1e-5)
        assert new["desk.3@101"].mesh == new["desk.2@101"].mesh
        assert new["desk.3@101"].local[0, 3] == pytest.approx(1.5, abs=1e-5)
        assert new["lamp.2@101"].parent is new["desk.3@101"] and "light.lamp.2@101" in new

    def test_a_copy_is_no_original_when_that_is_gone(self, tmp_path):
        duplicate("desk.2@101", linked=True)
        desk = bpy.data.objects["desk.2@101"]
        delete(desk, *desk.children_recursive)
        export_level(tmp_path / "back.glb", "house/ground")
        new = nodes_of(tmp_path / "back.glb")
        assert {name for name in new if "desk" in name} == {"desk.1@101", "desk.3@101"}
        assert new["lamp.2@101"].parent is new["desk.3@101"] and "lamp.1@101" not in new

    def test_pieces_without_a_parent_go_to_the_room_that_they_stand_in(self, tmp_path):
        placed = world_matrices()["desk.1@101"][:3, 3]
        delete(bpy.data.objects["desk.2@101"])  # the lamp on it stays, at the site's origin
        model = bpy.data.objects.new("model", bpy.data.meshes[0])
        for name, value in {"kind": "furniture", "class": "chair", "size": [1, 1, 1], "variant": 0}.items():
            model[name] = value
        model.location = placed + np.array([0.3, 0.3, 0.0])
        bpy.context.scene.collection.objects.link(model)
        notes = export_level(tmp_path / "back.glb", "house/ground")
        assert "lamp.1@101 has no parent and stands in no room: it is not exported" in notes
        assert "model has no parent: it is put into room:101" in notes
        new = nodes_of(tmp_path / "back.glb")
        turn = np.array([math.cos(0.5) + math.sin(0.5), 0.0, math.sin(0.5) - math.cos(0.5)]) * 0.3
        assert new["chair.1@101"].world[:3, 3] - new["desk.1@101"].world[:3, 3] == pytest.approx(turn, abs=1e-4)
        assert model.parent is None and list(model.matrix_world.translation) == pytest.approx(list(model.location))
        export_level(tmp_path / "upper_back.glb", "house/upper")
        assert "chair.1@101" not in nodes_of(tmp_path / "upper_back.glb")

    def test_the_scene_stays_as_it_was(self, tmp_path):
        bpy.data.objects["desk.1@101"].hide_viewport = True
        before, places, scene = census(), world_matrices(), bpy.context.scene
        export_level(tmp_path / "back.glb", "house/upper")
        (tmp_path / "folder.glb").mkdir()
        with pytest.raises(OSError):
            export_level(tmp_path / "folder.glb", "house/upper")
        assert census() == before and bpy.context.scene == scene and bpy.data.objects["desk.1@101"].hide_viewport
        after = world_matrices()
        # Blender does not work out where hidden things are.
        shown = {thing.name for thing in bpy.context.scene.objects if thing.visible_get()}
        assert len(shown) > 10 and all(np.array_equal(places[name], after[name]) for name in shown)
        assert sorted(one.name for one in tmp_path.iterdir()) == ["back.glb", "folder.glb", "ground.glb", "upper.glb"]

    def test_it_asks_which_level(self, tmp_path):
        with pytest.raises(ExportError, match="which level.; there are house/ground, house/upper"):
            export_level(tmp_path / "back.glb")
        with pytest.raises(ExportError, match="no level house/attic; there are"):
            export_level(tmp_path / "back.glb", "house/attic")
        bpy.ops.wm.read_factory_settings(use_empty=True)
        with pytest.raises(ExportError, match="no level in the scene"):
            export_level(tmp_path / "back.glb")

    def test_without_a_window_and_from_the_menu(self, tmp_path, capsys):
        blend, target = tmp_path / "house.blend", tmp_path / "back.glb"
        bpy.ops.wm.save_as_mainfile(filepath=str(blend))
        assert blender_export.main([str(blend), "--out", str(target)]) == 1
        assert "which level" in capsys.readouterr().err and not target.exists()
        assert blender_export.main([str(blend), "--out", str(target), "--level", "house/upper"]) == 0
        assert blender_export.main([str(tmp_path / "absent.blend"), "--out", str(tmp_path / "2.glb")]) == 2
        extension.register()
        try:
            done = bpy.ops.export_scene.roomwright(filepath=str(tmp_path / "menu.glb"), level="house/upper")
        finally:
            extension.unregister()
        assert done == {"FINISHED"} and nodes_of(tmp_path / "menu.glb").keys() == nodes_of(target).keys()

    @pytest.mark.skipif(PROGRAM is None, reason="no roomwright program is built (ROOMWRIGHT_PROGRAM names one)")
    def test_the_audit_judges_what_was_edited(self, baked, tmp_path):
        def audit(path) -> dict:
            run = subprocess.run([PROGRAM, "audit", str(path), "--json", "--all"], capture_output=True, text=True)
            assert run.returncode in (0, 1), run.stderr
            assert "cannot be read" not in run.stderr
            return json.loads(run.stdout)

        bpy.ops.wm.read_factory_settings(use_empty=True)
        import_bake(baked / "house" / "ground.glb")
        assert export_level(tmp_path / "back.glb") == []
        same = audit(tmp_path / "back.glb")
        assert findings(same) == findings(audit(baked / "house" / "ground.glb"))
        desk = bpy.data.objects["desk.1@study"]
        duplicate("desk.1@study", linked=True)
        desk.location.x += 0.3
        export_level(tmp_path / "back.glb")
        assert "collision" in findings(audit(tmp_path / "back.glb"))


def findings(report) -> list[str]:
    """The codes of all findings anywhere in the audit's answer."""
    if isinstance(report, dict):
        own = [report["code"]] if isinstance(report.get("code"), str) else []
        return sorted(own + [code for value in report.values() for code in findings(value)])
    return sorted(code for one in report for code in findings(one)) if isinstance(report, list) else []
