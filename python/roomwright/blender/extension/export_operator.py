"""File > Export > Roomwright floor."""

import bpy
from bpy_extras.io_utils import ExportHelper

from .errors import ExportError
from .exporting import export_level, levels


class EXPORT_SCENE_OT_roomwright(bpy.types.Operator, ExportHelper):
    """Export a level that was edited, so that roomwright can judge it"""

    bl_idname, bl_label = "export_scene.roomwright", "Export Roomwright floor"
    filename_ext = ".glb"
    filter_glob: bpy.props.StringProperty(default="*.glb", options={"HIDDEN"})
    level: bpy.props.StringProperty(name="Level", description="building/level; empty where there is only one")

    def invoke(self, context, event):
        thing = context.active_object
        while thing is not None and thing.get("kind") != "level":
            thing = thing.parent
        self.level = next((name for name, one in levels().items() if one == thing), "")
        return super().invoke(context, event)

    def execute(self, _context):
        try:
            notes = export_level(self.filepath, self.level or None)
        except (ExportError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for note in notes:
            self.report({"WARNING"}, note)
        return {"FINISHED"}


def _add_to_menu(menu, _context) -> None:
    menu.layout.operator(EXPORT_SCENE_OT_roomwright.bl_idname, text="Roomwright floor (.glb)")


def register() -> None:
    bpy.utils.register_class(EXPORT_SCENE_OT_roomwright)
    bpy.types.TOPBAR_MT_file_export.append(_add_to_menu)


def unregister() -> None:
    bpy.types.TOPBAR_MT_file_export.remove(_add_to_menu)
    bpy.utils.unregister_class(EXPORT_SCENE_OT_roomwright)
