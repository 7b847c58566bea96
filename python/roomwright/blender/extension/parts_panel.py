"""3D view > Sidebar > Roomwright: shows and hides parts of all levels."""

import bpy

from .parts import PARTS
from .visibility import collections_of, show_part


class ROOMWRIGHT_OT_show_part(bpy.types.Operator):
    """Show or hide this part in all levels, here and in renderings"""

    bl_idname, bl_label, bl_options = "roomwright.show_part", "Show part", {"REGISTER", "UNDO"}
    part: bpy.props.EnumProperty(items=[(part, part.capitalize(), "") for part in PARTS])

    def execute(self, _context):
        show_part(self.part, all(one.hide_viewport for one in collections_of(self.part)))
        return {"FINISHED"}


class ROOMWRIGHT_PT_parts(bpy.types.Panel):
    bl_label, bl_category, bl_space_type, bl_region_type = "Parts", "Roomwright", "VIEW_3D", "UI"

    def draw(self, _context):
        for part in PARTS:
            self.layout.operator(ROOMWRIGHT_OT_show_part.bl_idname, text=part.capitalize(), icon="HIDE_OFF").part = part


def register() -> None:
    bpy.utils.register_class(ROOMWRIGHT_OT_show_part)
    bpy.utils.register_class(ROOMWRIGHT_PT_parts)


def unregister() -> None:
    bpy.utils.unregister_class(ROOMWRIGHT_PT_parts)
    bpy.utils.unregister_class(ROOMWRIGHT_OT_show_part)
