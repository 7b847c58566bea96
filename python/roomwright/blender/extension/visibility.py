"""Shows and hides parts of all levels, in the viewport and in renderings."""

import bpy

# Custom property of collections: building, level, room or one of PARTS.
ROLE = "roomwright"


def collections_of(part: str) -> list:
    """The collections of one of PARTS, as the active view layer has them."""
    found, waiting = [], [bpy.context.view_layer.layer_collection]
    while waiting:
        one = waiting.pop()
        waiting += one.children
        if one.collection.get(ROLE) == part:
            found.append(one)
    return found


def show_part(part: str, is_shown: bool) -> int:
    """Shows or hides one of PARTS in all levels; the count of collections that it has."""
    found = collections_of(part)
    show(found, is_shown)
    return len(found)


def show(layer_collections: list, is_shown: bool) -> None:
    # By the eye: Blender does not place what is disabled or excluded, and would export it from a wrong place.
    for one in layer_collections:
        one.hide_viewport = one.collection.hide_render = not is_shown
