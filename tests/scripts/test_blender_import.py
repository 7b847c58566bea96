"""Import into Blender: the command's arguments, and, where Blender's module is installed, what becomes of floors."""

from __future__ import annotations

from roomwright.blender import import_command as blender_import
import numpy as np
import pytest
from roomwright.blender import extension
from roomwright.blender.extension.errors import BakeError
from blender_scene import HAS_BLENDER, PNG, census, needs_blender, storey, world_matrices, write_bake
from conftest import glass
from stairs_house import DEPTH, EAST, HEAD, RISES, STOREY, ground, upper

if HAS_BLENDER:
    import bpy
    from mathutils import Vector
    from roomwright.blender.extension.assets import CATALOG_FILE, catalog_id, write_catalog
    from roomwright.blender.extension.importing import import_bake
    from roomwright.blender.extension.options import Options
    from roomwright.blender.extension.visibility import collections_of, show_part


@pytest.fixture
def bake(tmp_path):
    return write_bake(tmp_path)


class TestCommand:
    """What is refused before Blender is asked for anything."""

    @pytest.mark.parametrize("arguments, message", [
        (["house.glb"], "--save"), (["house.glb", "--save", "house.glb"], "must end in .blend")])
    def test_what_cannot_be_meant_starts_nothing(self, arguments, message, capsys):
        with pytest.raises(SystemExit) as stop:
            blender_import.main(arguments)
        assert stop.value.code == 2 and message in capsys.readouterr().err

    def test_a_file_that_is_there_is_replaced_only_by_force(self, tmp_path, capsys):
        path = tmp_path / "house.blend"
        path.write_text("mine")
        with pytest.raises(SystemExit) as stop:
            blender_import.main(["house.glb", "--save", str(path)])
        assert stop.value.code == 2 and "--force" in capsys.readouterr().err and path.read_text() == "mine"


def properties(thing) -> dict:
    return {name: plain(value) for name, value in thing.items()}


def plain(value):
    """A custom property as Python's own lists and dictionaries."""
    value = getattr(value, "to_list", getattr(value, "to_dict", lambda: value))()
    if isinstance(value, dict):
        return {name: plain(one) for name, one in value.items()}
    return [plain(one) for one in value] if isinstance(value, list) else value


def shape_of(thing) -> tuple:
    corners = np.empty(len(thing.data.vertices) * 3, "f")
    thing.data.vertices.foreach_get("co", corners)
    return corners.tolist(), len(thing.data.polygons), [one.name for one in thing.data.materials]


def is_hidden(part: str) -> list[bool]:
    return [one.hide_viewport for one in collections_of(part)]


@needs_blender
class TestBlender:
    """The import itself."""

    @pytest.fixture(autouse=True)
    def empty(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)

    def test_collections_are_building_level_room_and_part(self, bake):
        done = import_bake(bake)
        building = bpy.context.scene.collection.children["house"]
        assert [level.name for level in building.children] == ["house/ground", "house/upper"]
        level = building.children["house/ground"]
        assert {one.name for one in level.children} == {"house/ground/101", "house/ground doors and windows"}
        room = level.children["house/ground/101"]
        assert {one.name: sorted(thing.name for thing in one.objects) for one in room.children} == {
            "house/ground/101 shell": ["floor@101"], "house/ground/101 ceiling": ["ceiling@101"],
            "house/ground/101 furniture": ["desk.1@101", "desk.2@101", "lamp.1@101"],
            "house/ground/101 lights": ["light.lamp.1@101"]}
        assert [thing.name for thing in room.objects] == ["room:101"]
        assert bpy.data.objects["lamp.1@101"].parent.name == "desk.2@101"
        assert done.object_count == len(bpy.data.objects) == 20
        assert all(len(thing.users_collection) == 1 for thing in bpy.data.objects)
        assert [scene.name for scene in bpy.data.scenes] == [bpy.context.scene.name]

    def test_it_looks_as_blenders_own_import_does(self, bake):
        def everything():
            return ({thing.name: properties(thing) for thing in bpy.data.objects},
                    {thing.name: shape_of(thing) for thing in bpy.data.objects if thing.type == "MESH"},
                    {thing.name: thing.parent and thing.parent.name for thing in bpy.data.objects},
                    [light.energy for light in bpy.data.lights])

        import_bake(bake / "house" / "b.glb")
        ours, places = everything(), world_matrices()
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.import_scene.gltf(filepath=str(bake / "house" / "b.glb"), loglevel=50)
        assert ours == everything()
        for name, matrix in world_matrices().items():
            assert places[name] == pytest.approx(matrix, abs=1e-6), name

    def test_equal_meshes_materials_and_lights_are_one_in_all_floors(self, bake):
        import_bake(bake)
        assert len(bpy.data.meshes) == 5 and len(bpy.data.materials) == 2 and len(bpy.data.lights) == 1
        assert bpy.data.objects["desk.1@101"].data == bpy.data.objects["desk.2@101.001"].data
        assert not any(name.startswith("roomwright") for kind in ("objects", "materials", "meshes")
                       for one in getattr(bpy.data, kind) for name in one.keys())

    def test_images_inside_files_are_one_in_all_floors(self, tmp_path):
        for level, name in (("1", "modern.wood"), ("2", "modern.metal")):
            floor = storey(level, 0.0)
            floor.document["bufferViews"].append(
                {"buffer": 0, "byteOffset": len(floor.binary), "byteLength": len(PNG)})
            floor.binary += PNG + b"\0" * (-len(PNG) % 4)
            floor.document |= {"images": [{"mimeType": "image/png", "name": "grain",
                                           "bufferView": len(floor.document["bufferViews"]) - 1}],
                               "textures": [{"source": 0}]}
            wood = floor.document["materials"][0]
            wood["name"], wood["pbrMetallicRoughness"]["baseColorTexture"] = name, {"index": 0}
            floor.write(tmp_path / f"{level}.glb")
        import_bake(tmp_path)
        assert sorted(one.name for one in bpy.data.materials) == ["modern.glass", "modern.metal", "modern.wood"]
        assert [one.name for one in bpy.data.images] == ["grain"] and bpy.data.images[0].packed_file
        assert tuple(bpy.data.images[0].size) == (1, 1)

    def test_what_differs_is_not_shared(self, tmp_path):
        first, second = storey("ground", 0.0), storey("upper", 3.0)
        second.document["materials"][1] = glass() | {"alphaMode": "OPAQUE"}
        lights = second.document["extensions"]["KHR_lights_punctual"]["lights"]
        lights[0] = lights[0] | {"intensity": 10.0}
        first.write(tmp_path / "1.glb"), second.write(tmp_path / "2.glb")
        import_bake(tmp_path)
        # The desk and the ceiling have glass in them, the other three meshes have not.
        assert len(bpy.data.meshes) == 7 and len(bpy.data.materials) == 3 and len(bpy.data.lights) == 2
        assert bpy.data.objects["lamp.1@101"].data == bpy.data.objects["lamp.1@101.001"].data
        assert bpy.data.objects["desk.1@101"].data != bpy.data.objects["desk.1@101.001"].data

    def test_what_is_in_no_scene_stays_out(self, tmp_path):
        floor = storey("ground", 0.0)
        coarse = floor.node("coarse desk", {"kind": "furniture"}, None, 1)
        floor.node("below it", {}, coarse, 1)
        floor.write(tmp_path / "1.glb")
        import_bake(tmp_path)
        assert len(bpy.data.objects) == 10

    def test_levels_stand_at_their_elevation_and_buildings_at_their_place(self, bake):
        import_bake(bake)
        placed = world_matrices()
        cosine, sine = np.cos(0.5), np.sin(0.5)
        # desk.1 stands at 1.0, 0.4 of its level.
        assert placed["desk.1@101"][:3, 3] == pytest.approx([1.0, 0.4, 0.0], abs=1e-5)
        assert placed["desk.1@101.001"][:3, 3] == pytest.approx(
            [10.0 + cosine - 0.4 * sine, 20.0 + sine + 0.4 * cosine, 3.0], abs=1e-5)
        bpy.ops.wm.read_factory_settings(use_empty=True)
        import_bake(bake, Options(place=False))
        assert world_matrices()["desk.1@101.001"][:3, 3] == pytest.approx([1.0, 0.4, 0.0], abs=1e-5)

    def test_a_flight_leads_to_the_floor_of_the_level_above(self, tmp_path):
        for storey, level in ((ground(), "ground"), (upper(), "upper")):
            storey.write(tmp_path / f"{level}.glb")
        import_bake(tmp_path)
        stairs = bpy.data.objects["stairs@hall"]
        assert [one.name for one in stairs.users_collection] == ["house/ground/hall shell"]
        bpy.context.view_layer.update()
        tops = sorted({round((stairs.matrix_world @ face.center).z, 3): stairs.matrix_world @ face.center
                       for face in stairs.data.polygons if face.normal.z > 0.9}.items())
        assert len(tops) == RISES - 1
        for top, middle in tops:
            assert self.first_hit(Vector((middle.x, middle.y, top + 0.01)), 1.0) in (None, ("ceiling@hall.001", 2 * STOREY - 0.3))
        landing = Vector((EAST / 2, (HEAD + DEPTH) / 2, STOREY + 0.5))
        assert self.first_hit(landing, -1.0) == ("floor@hall.001", pytest.approx(tops[-1][0] + STOREY / RISES, abs=1e-5))

    def first_hit(self, start, up: float) -> tuple[str, float] | None:
        """What a ray along the vertical meets first, and at which height."""
        is_hit, place, _, _, thing, _ = bpy.context.scene.ray_cast(bpy.context.evaluated_depsgraph_get(), start, (0, 0, up))
        return (thing.name, pytest.approx(place.z, abs=1e-5)) if is_hit else None

    def test_ceilings_are_hidden_and_shown_again(self, bake):
        import_bake(bake, Options(ceilings=False))
        assert is_hidden("ceiling") == [True, True] and is_hidden("shell") == [False, False]
        assert all(one.collection.hide_render for one in collections_of("ceiling"))
        assert not bpy.data.objects["ceiling@101"].visible_get() and bpy.data.objects["floor@101"].visible_get()
        # Hidden things are placed all the same, or a plain export would have them elsewhere.
        assert world_matrices()["ceiling@101.001"][2, 3] == pytest.approx(5.5, abs=1e-5)
        assert show_part("ceiling", True) == 2
        assert bpy.data.objects["ceiling@101"].visible_get()

    @pytest.mark.parametrize("fault", ["cut off", "texture", "mesh"])
    def test_a_failure_leaves_the_file_as_it_was(self, bake, fault):
        bpy.data.objects.new("desk.1@101", bpy.data.meshes.new("mine"))
        before, scene = census(), bpy.context.scene
        path = bake / "house" / "a.glb"  # the upper level, which comes second
        if fault == "cut off":
            path.write_bytes(path.read_bytes()[:-4000])
        else:
            floor = storey("upper", 3.0)
            if fault == "texture":
                floor.document |= {"images": [{"uri": "absent.png"}], "textures": [{"source": 0}]}
                floor.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
            else:
                floor.document["nodes"][-1]["mesh"] = 99
                del floor.document["nodes"][-1]["extensions"]
            floor.write(path)
        with pytest.raises(BakeError, match="a.glb: .*" + {"cut off": "cut off", "texture": "absent.png is missing",
                                                           "mesh": "cannot be read"}[fault]):
            import_bake(bake)
        assert census() == before and bpy.context.scene == scene
        (bake / "house" / "a.glb").unlink()
        import_bake(bake)
        assert "house/ground" in bpy.data.collections

    def test_each_step_is_reported(self, bake):
        steps = []
        import_bake(bake, progress=lambda *step: steps.append(step))
        assert steps == [(1, 4, "read house/ground"), (2, 4, "read house/upper"), (3, 4, "built house/ground"),
                         (4, 4, "built house/upper")]

    def test_a_class_has_the_same_catalogue_everywhere(self):
        assert catalog_id("desk") == catalog_id("desk")
        assert catalog_id("desk") != catalog_id("chair")

    def test_another_level_joins_its_building(self, bake):
        import_bake(bake, Options(levels=("ground",)))
        import_bake(bake, Options(levels=("upper",)))
        assert [one.name for one in bpy.context.scene.collection.children] == ["house"]
        assert len(bpy.data.collections["house"].children) == 2

    def test_furniture_becomes_assets_by_class(self, bake, tmp_path):
        import_bake(bake, Options(assets=True))
        models = {thing["class"]: thing for thing in bpy.data.objects if thing.asset_data}
        assert set(models) == {"desk", "lamp"} and models["desk"].data == bpy.data.objects["desk.1@101"].data
        assert models["desk"].parent is None and not models["desk"].users_collection and "id" not in models["desk"]
        assert models["desk"].asset_data.catalog_id == catalog_id("desk")
        other = "6b2d6e4e-0000-4000-8000-000000000000:Mine:Mine"
        (tmp_path / CATALOG_FILE).write_text(f"VERSION 1\n\n{other}\n")
        for _ in range(2):
            lines = write_catalog(tmp_path).read_text().splitlines()
        assert lines == ["VERSION 1", "", other, f"{catalog_id('desk')}:Roomwright/desk:desk",
                         f"{catalog_id('lamp')}:Roomwright/lamp:lamp"]

    def test_saved_without_a_window_it_opens_again(self, bake, tmp_path, capsys):
        path = tmp_path / "saved" / "house.blend"
        arguments = [str(bake), "--save", str(path), "--no-ceilings", "--asset-catalog"]
        assert blender_import.main(arguments) == 0
        told = capsys.readouterr()
        # Standard error is no terminal here, and progress is for terminals.
        assert told.err == "" and "20 objects, 5 meshes" in told.out
        assert sorted(one.name for one in path.parent.iterdir()) == [CATALOG_FILE, "house.blend"]
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.wm.open_mainfile(filepath=str(path))
        assert len(bpy.context.scene.objects) == 20 and len(bpy.data.meshes) == 5
        assert list(bpy.data.objects["room:101"]["outline"][2]) == [4.0, 3.0]
        assert is_hidden("ceiling") == [True, True]
        assert sum(thing.asset_data is not None for thing in bpy.data.objects) == 2

    def test_what_fails_saves_nothing(self, bake, tmp_path, capsys):
        save = ["--save", str(tmp_path / "house.blend")]
        assert blender_import.main([str(tmp_path / "absent"), *save]) == 2
        path = bake / "house" / "a.glb"
        path.write_bytes(path.read_bytes()[:-4000])
        assert blender_import.main([str(bake), *save]) == 1
        assert "a.glb: is cut off" in capsys.readouterr().err and not (tmp_path / "house.blend").exists()

    def test_from_the_menu(self, bake):
        extension.register()
        try:
            folder = str(bake / "house") + "/"
            done = bpy.ops.import_scene.roomwright(directory=folder, files=[{"name": "b.glb"}], ceilings=False)
            assert done == {"FINISHED"} and "house/ground" in bpy.data.collections
            assert bpy.ops.roomwright.show_part(part="ceiling") == {"FINISHED"}
            assert is_hidden("ceiling") == [False]
            assert bpy.ops.import_scene.roomwright(directory=folder, levels="upper nothing") == {"FINISHED"}
            with pytest.raises(RuntimeError, match="no level matches attic"):
                bpy.ops.import_scene.roomwright(directory=folder, levels="attic")
        finally:
            extension.unregister()
        assert not hasattr(bpy.types, "IMPORT_SCENE_OT_roomwright")

    def test_a_real_bake_with_textures(self, baked):
        import_bake(baked / "house", Options(ceilings=False))
        assert {"house/ground", "house/upper"} <= set(bpy.data.collections.keys())
        plain = len(bpy.data.meshes), len(bpy.data.images), len(bpy.data.materials)
        images = {(image.filepath, bytes(image.packed_file.data)) for image in bpy.data.images}
        assert len(images) == plain[1], "an image is there twice"
        assert len({(one.name.partition("@")[0], tuple(m.name for m in one.materials), len(one.vertices))
                    for one in bpy.data.meshes}) > 100
        assert all(image.packed_file for image in bpy.data.images)
