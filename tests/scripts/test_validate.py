"""Each fault that validate.py looks for: a floor that has it, beside the correct one that has none."""

import json
import shutil

import pytest
from conftest import FACES, ROOT, write_manifest

from roomwright import validate

KHRONOS_IS_THERE = shutil.which("node") and (ROOT / "python/roomwright/khronos/node_modules/gltf-validator").is_dir()


def faults_of(path) -> list[str]:
    faults, _ = validate.check_file(path)
    return [f"{fault.code} {fault.node}: {fault.message}" for fault in faults]


@pytest.mark.parametrize("name", ["floor.glb", "floor.gltf"])
def test_a_correct_floor_has_no_fault(floor, tmp_path, name):
    assert faults_of(floor.write(tmp_path / name)) == []


def rename(node: str, new: str):
    return lambda floor: floor.find(node).update(name=new)


def set_extra(node: str, **values):
    return lambda floor: floor.find(node)["extras"].update(values)


def drop_extra(node: str, key: str):
    return lambda floor: floor.find(node)["extras"].pop(key)


def move(node: str, *at):
    return lambda floor: floor.find(node).update(translation=list(at))


def stand_open_box(floor):
    floor.find("lamp.1@101")["mesh"] = floor.box_mesh("open", 0.2, 0.2, 0.3, faces=FACES[:-1])


@pytest.mark.parametrize(("damage", "expected"), [
    (rename("desk.1@101", "desk.2@101"), "names desk.2@101: 2 nodes have this name"),
    (rename("desk.1@101", ""), "names : 1 nodes have no name"),
    (drop_extra("desk.1@101", "variant"), "extras desk.1@101: variant: it is missing"),
    (drop_extra("desk.1@101", "kind"), "extras desk.1@101: kind: None is not one of level, opening, "),
    (set_extra("desk.1@101", id="desk.9"), "extras desk.1@101: the name is not that of 'desk.9' in its room"),
    (set_extra("desk.1@101", side="top"), "extras desk.1@101: 'top' is no side"),
    (set_extra("desk.1@101", parent="desk.9"),
     "extras desk.1@101: `parent` is 'desk.9', which is not in its room"),
    (set_extra("lamp.1@101", parent="desk.1"),
     "extras lamp.1@101: `parent` is 'desk.1', but the node is below 'desk.2@101'"),
    (set_extra("lamp.1@101", parent="floor"), "extras lamp.1@101: `parent` is 'floor'"),
    (set_extra("room:101", placed=4), "extras room:101: `placed` is 4, but 3 objects are below the room"),
    (set_extra("room:101", outline=[[0, 0], [4, 3], [4, 0], [0, 3]]), "extras room:101: its outline is no area"),
    (set_extra("door:d1", rooms=["102"]), "extras door:d1: it names the room '102'"),
    (rename("house/ground", "house"), "extras house: the name of the level is not 'house/ground'"),
    (set_extra("desk.1@101", size=[1.6, 0.8, 0.75]), "geometry desk.1@101: the mesh measures"),
    (move("desk.1@101", 0.78, 0.0, -0.4), "containment desk.1@101: 2 parts of it reach out of room:101"),
    (move("desk.1@101", 1.0, 1.8, -0.4), "containment desk.1@101: it reaches from 1.800 to 2.540"),
    (stand_open_box, "geometry lamp.1@101: the mesh is not closed: 4 edges have a side missing"),
])
def test_each_fault_is_found_and_named(floor, tmp_path, damage, expected):
    damage(floor)
    faults = faults_of(floor.write(tmp_path / "floor.glb"))
    assert any(fault.startswith(expected) for fault in faults), faults


def test_six_millimetres_outside_are_rounding_and_seven_are_not(floor, tmp_path):
    move("desk.1@101", 0.794, 0.0, -0.4)(floor)
    assert faults_of(floor.write(tmp_path / "floor.glb")) == []
    move("desk.1@101", 0.793, 0.0, -0.4)(floor)
    assert len(faults_of(floor.write(tmp_path / "floor.glb"))) == 1


def test_an_origin_off_the_underside_is_found(floor, tmp_path):
    lamp = floor.document["meshes"][floor.find("lamp.1@101")["mesh"]]["primitives"][0]
    desk = floor.document["meshes"][floor.find("desk.1@101")["mesh"]]["primitives"]
    lamp["attributes"]["POSITION"] = desk[1]["attributes"]["POSITION"]
    floor.find("lamp.1@101")["extras"]["size"] = [1.6, 0.8, 0.37]
    assert any("the origin is off" in fault for fault in faults_of(floor.write(tmp_path / "floor.glb")))


def test_a_mesh_closed_only_as_a_whole_is_closed(floor, tmp_path):
    mesh = floor.box_mesh("split", 0.2, 0.2, 0.3, faces=FACES[:-1])
    lid = floor.box_mesh("lid", 0.2, 0.2, 0.3, faces=FACES[-1:])
    floor.document["meshes"][mesh]["primitives"] += floor.document["meshes"][lid]["primitives"]
    floor.find("lamp.1@101")["mesh"] = mesh
    assert faults_of(floor.write(tmp_path / "floor.glb")) == []


@pytest.mark.parametrize("uri", ["/somewhere/floor.bin", "file:///floor.bin", "C:\\floor.bin"])
def test_an_absolute_path_is_a_fault(floor, tmp_path, uri):
    path = floor.write(tmp_path / "floor.gltf")
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = uri
    path.write_text(json.dumps(document))
    assert [(note.code, note.message) for note in validate.check_paths(validate.GltfFile(path))] == [
        ("path", f"buffers[0].uri: {uri!r} is an absolute path; hint: keep the file in the folder of the floor, or name "
                 "the folder that holds both on the command line")]


def test_a_missing_or_cut_buffer_is_a_fault(floor, tmp_path):
    path = floor.write(tmp_path / "floor.gltf")
    buffer = tmp_path / "floor.bin"
    buffer.write_bytes(buffer.read_bytes()[:-4])
    assert any("shorter" in fault for fault in faults_of(path))
    buffer.unlink()
    assert any("buffers[0].uri: 'floor.bin' cannot be read: No such file" in fault for fault in faults_of(path))


def test_every_missing_image_is_a_fault_and_the_rest_is_judged(floor, tmp_path):
    (tmp_path / "here.png").write_bytes(b"\x89PNG\r\n\x1a\n and the rest")
    (tmp_path / "text.png").write_bytes(b"no image")
    floor.document["images"] = [{"uri": name} for name in ("here.png", "gone.png", "lost.png", "text.png")]
    floor.find("desk.1@101")["extras"]["side"] = "top"
    faults = faults_of(floor.write(tmp_path / "floor.glb"))
    assert faults == ["texture : images[1].uri: 'gone.png' cannot be read: No such file or directory",
                      "texture : images[2].uri: 'lost.png' cannot be read: No such file or directory",
                      "texture : images[3] is neither PNG nor JPEG nor WebP",
                      "extras desk.1@101: 'top' is no side"]


def test_geometry_that_floors_share_may_lie_beside_their_folder(floor, tmp_path):
    (tmp_path / "house").mkdir()
    path = floor.write(tmp_path / "house" / "floor.gltf")
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = "../shared-geometry/floor.bin"
    path.write_text(json.dumps(document))
    (tmp_path / "shared-geometry").mkdir()
    (tmp_path / "house" / "floor.bin").rename(tmp_path / "shared-geometry" / "floor.bin")
    assert faults_of(path) == []


def test_levels_of_detail_and_material_variants_are_no_faults(floor, tmp_path):
    """Nodes that stand for others are not in the scene; the meshes of both are judged by the Khronos validator."""
    floor.document["nodes"].append({"name": "desk.1@101.lod1", "mesh": floor.box_mesh("coarse", 1.6, 0.8, 0.74)})
    floor.find("desk.1@101")["extensions"] = {"MSFT_lod": {"ids": [len(floor.document["nodes"]) - 1]}}
    floor.document["extensionsUsed"] = ["MSFT_lod", "KHR_materials_variants"]
    floor.document["extensions"] = {"KHR_materials_variants": {"variants": [{"name": "clear"}]}}
    primitive = floor.document["meshes"][floor.find("desk.1@101")["mesh"]]["primitives"][0]
    primitive["extensions"] = {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]}]}}
    path = floor.write(tmp_path / "floor.glb")
    assert faults_of(path) == []
    if KHRONOS_IS_THERE:
        assert validate.check_khronos([path]) == []


@pytest.mark.parametrize("content", [b"", b"glTF", b"no glTF at all", b"{}", b"[1, 2]"])
@pytest.mark.parametrize("ending", [".glb", ".gltf"])
def test_what_is_no_gltf_is_one_fault(tmp_path, content, ending):
    path = tmp_path / f"floor{ending}"
    path.write_bytes(content)
    assert len(faults_of(path)) == 1


class TestManifest:
    """The files listed against the files there."""

    @pytest.fixture
    def manifest(self, floor, tmp_path):
        (tmp_path / "house").mkdir()
        floor.write(tmp_path / "house" / "ground.glb")
        return write_manifest(tmp_path)

    def messages(self, manifest):
        return [fault.message for fault in validate.check_manifest(manifest)]

    def test_a_true_manifest_has_no_fault(self, manifest):
        assert self.messages(manifest) == []

    def test_levels_in_a_format_that_no_script_reads_are_checked_against_it(self, manifest, capsys):
        level = manifest.parent / "house" / "ground.glb"
        text = level.rename(level.with_suffix(".obj"))
        manifest.write_text(manifest.read_text().replace("ground.glb", "ground.obj"))
        assert validate.main([str(manifest.parent), "--no-khronos"]) == 0
        text.write_bytes(text.read_bytes() + b"o more")
        assert validate.main([str(manifest.parent), "--no-khronos"]) == 1
        assert "ground.obj has" in "".join(capsys.readouterr())

    def test_a_changed_byte_is_another_hash(self, manifest):
        file = manifest.parent / "house" / "ground.glb"
        file.write_bytes(file.read_bytes()[:-1] + b"\x07")
        assert self.messages(manifest) == ["levels[0].files[0]: house/ground.glb has another hash than listed"]

    def test_a_cut_file_has_other_bytes(self, manifest):
        file = manifest.parent / "house" / "ground.glb"
        file.write_bytes(file.read_bytes()[:-1])
        assert "bytes, not" in self.messages(manifest)[0]

    def test_a_missing_and_a_foreign_floor_are_found(self, manifest):
        file = manifest.parent / "house" / "ground.glb"
        file.rename(file.with_name("first.glb"))
        assert self.messages(manifest) == [
            "levels[0].files[0].path: 'house/ground.glb' cannot be read: No such file or directory",
            "house/first.glb exists, but is not listed"]

    def test_a_level_that_no_plan_has_any_more_is_listed_too(self, manifest):
        document = json.loads(manifest.read_text())
        document |= {"levels": [], "former_levels": document["levels"]}
        manifest.write_text(json.dumps(document))
        assert self.messages(manifest) == []

    def test_what_is_no_manifest_is_a_fault(self, manifest):
        manifest.write_text("{}")
        assert self.messages(manifest)[0].startswith("manifest: it is missing; hint: ")
        manifest.write_text("[")
        assert self.messages(manifest)[0].startswith("cannot be read: ")


@pytest.mark.skipif(not KHRONOS_IS_THERE, reason="node or gltf-validator is not installed (npm ci in python/roomwright/khronos/)")
class TestKhronos:
    """The Khronos validator behind validate.py."""

    def test_a_correct_floor_has_neither_errors_nor_warnings(self, floor, tmp_path):
        assert validate.check_khronos([floor.write(tmp_path / "floor.glb")]) == []
        assert validate.check_khronos([floor.write(tmp_path / "floor.gltf")]) == []

    def test_errors_are_given_with_their_place(self, floor, tmp_path):
        floor.find("desk.1@101")["mesh"] = 99
        faults = validate.check_khronos([floor.write(tmp_path / "floor.glb")])
        assert [(fault.code, fault.node) for fault in faults] == [("khronos", "/nodes/4/mesh")]
        assert "UNRESOLVED_REFERENCE" in faults[0].message

    def test_the_exit_code_says_the_verdict(self, floor, tmp_path, capsys):
        floor.write(tmp_path / "ground.glb")
        write_manifest(tmp_path)
        assert validate.main([str(tmp_path), "--jobs", "2"]) == 0
        assert "1 files, 1 manifests, 0 tilesets, 1 floors, 7 nodes, 1 rooms, 3 furniture: 0 faults" in capsys.readouterr().out
        set_extra("desk.1@101", side="top")(floor)
        floor.write(tmp_path / "ground.glb")
        assert validate.main([str(tmp_path), "--json"]) == 1
        codes = [fault["code"] for fault in json.loads(capsys.readouterr().out)["faults"]]
        assert codes == ["extras", "manifest"]


def test_nothing_to_validate_cannot_start(tmp_path):
    assert validate.main([str(tmp_path)]) == 2
    assert validate.main([str(tmp_path / "absent.txt")]) == 2
