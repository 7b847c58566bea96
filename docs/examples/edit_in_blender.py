"""Changes the furniture of a level in Blender: the steps of docs/walkthrough.sh that you would do with the mouse.

    blender --background --python docs/examples/edit_in_blender.py -- house.blend
    python docs/examples/edit_in_blender.py house.blend        # where Python has Blender's module, bpy

Each edit names its keys in Blender's window. edit_without_blender.py makes the same edits in the glTF file.
"""

import math
import sys

import bpy
from mathutils import Quaternion, Vector


def piece(name: str):
    """A piece of furniture by the name that the outliner shows: `<id>@<room>`."""
    found = bpy.data.objects.get(name)
    if found is None:
        room = name.partition("@")[2]
        others = sorted(item.name for item in bpy.data.objects
                        if item.get("kind") == "furniture" and item.name.endswith(f"@{room}"))
        sys.exit(f"there is no {name} in the file\n  hint: in {room} there are {', '.join(others) or 'no pieces'}")
    return found


def select_hierarchy(item) -> None:
    """Right click on a piece in the outliner, Select Hierarchy: the piece and all that stands on it."""
    bpy.ops.object.select_all(action="DESELECT")
    for one in (item, *item.children_recursive):
        one.select_set(True)
    bpy.context.view_layer.objects.active = item


def edit() -> None:
    # Move: G Y 0.25. Locations count from the room, X to the east and Y to the north. The side table goes along,
    # for it hangs below the armchair.
    piece("armchair.1@study").location += Vector((0.0, 0.25, 0.0))

    # Turn: R Z -10, clockwise seen from above. The chairs and what lies on the table turn with it.
    table = piece("dining_table.1@living")
    table.rotation_quaternion = Quaternion((0.0, 0.0, 1.0), math.radians(-10.0)) @ table.rotation_quaternion

    # Delete: X, with what stands on it, which would hang in the air.
    select_hierarchy(piece("cabinet.1@study"))
    bpy.ops.object.delete()

    # Duplicate: Alt+D, and the copy goes to the other side of the window, X 1.1.
    select_hierarchy(piece("plant.1@study"))
    bpy.ops.object.duplicate(linked=True)
    bpy.context.view_layer.objects.active.location += Vector((1.1, 0.0, 0.0))


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else sys.argv[1:]
    if len(arguments) != 1:
        sys.exit(__doc__)
    bpy.ops.wm.open_mainfile(filepath=arguments[0])
    edit()
    bpy.ops.wm.save_mainfile(compress=True)
