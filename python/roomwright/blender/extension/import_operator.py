"""File > Import > Roomwright bake."""

from pathlib import Path

import bpy
from bpy_extras.io_utils import ImportHelper

from .assets import write_catalog
from .errors import BakeError
from .importing import import_bake
from .options import Options


class IMPORT_SCENE_OT_roomwright(bpy.types.Operator, ImportHelper):
    """Import floors that roomwright baked: files, a building's folder, or a bake"""

    bl_idname, bl_label, bl_options = "import_scene.roomwright", "Import Roomwright bake", {"REGISTER", "UNDO"}

    filter_glob: bpy.props.StringProperty(default="*.glb;*.gltf;manifest.json", options={"HIDDEN"})
    directory: bpy.props.StringProperty(subtype="DIR_PATH", options={"HIDDEN", "SKIP_SAVE"})
    files: bpy.props.CollectionProperty(type=bpy.types.OperatorFileListElement, options={"HIDDEN", "SKIP_SAVE"})
    levels: bpy.props.StringProperty(
        name="Levels", description="Patterns of levels, separated by spaces: ground tower-001/1*; none is all")
    ceilings: bpy.props.BoolProperty(name="Ceilings", description="Show ceilings", default=True)
    place: bpy.props.BoolProperty(
        name="In place", description="Levels at their elevation, buildings at their site", default=True)
    assets: bpy.props.BoolProperty(
        name="Assets", description="Mark furniture as assets, with a catalogue for each class", default=False)

    def execute(self, context):
        names = [one.name for one in self.files if one.name]
        paths = [Path(self.directory) / name for name in names] or [Path(self.directory or self.filepath)]
        options = Options(tuple(self.levels.split()), self.ceilings, self.place, self.assets)
        manager = context.window_manager
        manager.progress_begin(0, 100)
        try:
            done = import_bake(paths, options, lambda step, steps, _: manager.progress_update(100 * step // steps))
            self._write_catalog()
        except (BakeError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            manager.progress_end()
        self.report({"INFO"}, f"{done.object_count} objects with {len(done.datablocks.meshes)} meshes")
        return {"FINISHED"}

    def _write_catalog(self) -> None:
        if self.assets and bpy.data.filepath:
            write_catalog(Path(bpy.data.filepath).parent)
        elif self.assets:
            self.report({"WARNING"}, "save the file, then import again for the catalogue of the assets' classes")


def _add_to_menu(menu, _context) -> None:
    menu.layout.operator(IMPORT_SCENE_OT_roomwright.bl_idname, text="Roomwright bake (.glb / folder)")


def register() -> None:
    bpy.utils.register_class(IMPORT_SCENE_OT_roomwright)
    bpy.types.TOPBAR_MT_file_import.append(_add_to_menu)


def unregister() -> None:
    bpy.types.TOPBAR_MT_file_import.remove(_add_to_menu)
    bpy.utils.unregister_class(IMPORT_SCENE_OT_roomwright)
