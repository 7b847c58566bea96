"""Which floors an import into Blender finds in files and folders, and which files those floors may name."""

from __future__ import annotations

import json
import os

import pytest
from roomwright import resources
from roomwright.blender.extension.document import Document
from roomwright.blender.extension.errors import BakeError
from roomwright.blender.extension.floors import find_floors
from roomwright.blender.extension.parts import sort_nodes
from roomwright.blender.extension.resources import locate
from blender_scene import PNG, storey, write_bake
from conftest import write_manifest


@pytest.fixture
def bake(tmp_path):
    return write_bake(tmp_path)


class TestFiles:
    """What is to be imported."""

    def test_floors_of_a_folder_come_from_the_lowest_up(self, bake):
        assert [floor.name for floor in find_floors(bake)] == ["house/ground", "house/upper"]
        assert [floor.name for floor in find_floors([bake / "house" / "a.glb"])] == ["house/upper"]

    def test_a_manifest_tells_which_files_are_floors_and_others_stay_closed(self, bake):
        path = write_manifest(bake)
        manifest = json.loads(path.read_text())
        for record, level in zip(manifest["levels"], ("upper", "ground")):
            record |= {"building": "house", "level": level}
        path.write_text(json.dumps(manifest))
        (bake / "other.glb").write_text("not glTF")
        (bake / "house" / "a.glb").write_text("not glTF")
        assert [floor.level for floor in find_floors(bake, ["ground"])] == ["ground"]
        assert [floor.level for floor in find_floors(path, ["house/gr*"])] == ["ground"]
        with pytest.raises(BakeError, match="a.glb: is no glTF file"):
            find_floors(bake)

    def test_what_lies_in_hidden_folders_is_no_floor(self, bake):
        (bake / ".roomwright").mkdir()
        (bake / ".roomwright" / "part.glb").write_text("half")
        assert len(find_floors(bake)) == 2

    def test_a_pattern_that_matches_nothing_is_answered_with_what_is_there(self, bake):
        with pytest.raises(BakeError, match="no level matches attic; there are house/upper, house/ground"):
            find_floors(bake, ["attic"])

    @pytest.mark.parametrize("content, message", [
        (None, "no such file or folder"), ("{}", "is no glTF file"), ("glTF", "is cut off"), ("text", "is no glTF file"),
        ('{"asset": {"version": "2.0"}, "nodes": [{"name": "cube"}]}', "is no file of roomwright"),
        ('{"asset": {}, "nodes": [{"extras": {"kind": "level", "level": "1"}}]}', "extras that cannot be read"),
    ])
    def test_a_file_that_is_none_of_ours_is_named_with_the_reason(self, tmp_path, content, message):
        path = tmp_path / "floor.gltf"
        if content is not None:
            path.write_text(content)
        with pytest.raises(BakeError, match=f"floor.gltf: .*{message}"):
            find_floors(path)

    def test_an_empty_folder_and_a_broken_manifest_are_named(self, tmp_path):
        with pytest.raises(BakeError, match="neither a manifest.json nor"):
            find_floors(tmp_path)
        (tmp_path / "manifest.json").write_text('{"levels": [{}]}')
        with pytest.raises(BakeError, match="is no manifest that roomwright wrote"):
            find_floors(tmp_path)

    def test_nodes_are_sorted_by_their_room_and_part(self):
        nodes = storey("ground", 0.0).document["nodes"]
        nodes[2]["children"].append(len(nodes))
        nodes.append({"name": "added by hand"})
        spots = {node["name"]: spot for node, spot in zip(nodes, sort_nodes(nodes))}
        assert spots == {
            "house/ground": (None, "level"), "door:d1": (None, "doors and windows"),
            "frame@door:d1": (None, "doors and windows"), "room:101": ("101", "room"), "floor@101": ("101", "shell"),
            "ceiling@101": ("101", "ceiling"), "desk.1@101": ("101", "furniture"), "desk.2@101": ("101", "furniture"),
            "lamp.1@101": ("101", "furniture"), "light.lamp.1@101": ("101", "lights"),
            "added by hand": ("101", "furniture")}

    def test_stairs_are_of_the_shell_of_their_room(self):
        nodes = [{"name": "room:hall", "extras": {"kind": "room", "room": "hall"}, "children": [1]},
                 {"name": "stairs@hall", "extras": {"kind": "part", "part": "stairs", "id": "stairs"}}]
        assert sort_nodes(nodes)[1] == ("hall", "shell")


class TestFilesThatAFloorNames:
    FORBIDDEN = ["../secret.png", "/etc/passwd", "%2e%2e/secret.png", "file:///etc/passwd", "https://example.org/a.png",
                 "C:/a.png", "a\\..\\b.png", "", ".", "\0", "link.png", "pipe.png", 7, None]
    ALLOWED = ["1.gltf", "./1.gltf", "%31.gltf", "../shared-textures/b.png", "a/../1.gltf"]

    @pytest.fixture
    def file(self, tmp_path):
        """A floor among files that it may name and files that it may not."""
        folder = tmp_path / "out" / "house"
        folder.mkdir(parents=True)
        (tmp_path / "out" / "secret.png").write_bytes(b"secret")
        (tmp_path / "out" / "shared-textures").mkdir()
        (tmp_path / "out" / "shared-textures" / "b.png").write_bytes(PNG)
        (folder / "link.png").symlink_to(tmp_path / "out" / "secret.png")
        os.mkfifo(folder / "pipe.png")
        (folder / "1.gltf").write_text("{}")
        return folder / "1.gltf"

    @pytest.mark.parametrize("uri", FORBIDDEN + ALLOWED)
    def test_are_the_same_for_the_extension_and_the_scripts(self, file, uri):
        if uri in self.ALLOWED:
            assert locate(uri, file) == resources.locate(uri, resources.reach_of(file))
            return
        with pytest.raises(BakeError):
            locate(uri, file)
        with pytest.raises(resources.ForbiddenError):
            resources.locate(uri, resources.reach_of(file))

    @pytest.mark.parametrize("uri", FORBIDDEN)
    def test_are_in_its_folder_and_no_links_that_lead_out(self, file, uri):
        file.write_text(json.dumps({"asset": {}, "images": [{"uri": uri}], "buffers": [{"uri": uri, "byteLength": 6}]}))
        with pytest.raises(BakeError, match="not in the folder of the floor|is no regular file"):
            Document(file, {}).image_key(0)

    def test_may_be_below_it_or_in_the_shared_folders_beside_it(self, tmp_path):
        folder = tmp_path / "out" / "house"
        for name in ("house/shared-textures/a b.png", "shared-textures/b.png"):
            (tmp_path / "out" / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / "out" / name).write_bytes(PNG)
        file = folder / "1.gltf"
        uris = ["shared-textures/a%20b.png", "../shared-textures/b.png"]
        file.write_text(json.dumps({"asset": {}, "images": [{"uri": uri} for uri in uris]}))
        document = Document(file, {})
        assert [document.image_key(index) for index in (0, 1)] == [
            str((folder / "shared-textures/a b.png").resolve()), str((tmp_path / "out/shared-textures/b.png").resolve())]
