"""Clear materials of a baked level in Blender: thin panes that stop no light."""

from __future__ import annotations

import bpy

# Panes of windows, seen from outside and above: what lies behind them is the paper.
PANE_COLOR = (0.62, 0.72, 0.78, 1.0)


def let_light_through(objects: list) -> None:
    """Panes stop neither the sun nor the sky: few samples would not find the way through them."""
    for thing in objects:
        if thing.get("part") == "glass":
            thing.visible_shadow = thing.visible_diffuse = False


def panes(objects: list) -> list[tuple]:
    """Glass of the shell: object, slot, material. The slots become the objects' own, for meshes are shared."""
    found = []
    for thing in objects:
        for index, slot in enumerate(thing.material_slots if thing.get("kind") == "part" else []):
            if slot.material is not None and any(_is_clear(one) for one in _shaders(slot.material)):
                glass, slot.link = slot.material, "OBJECT"
                slot.material = glass
                found.append((thing, index, glass))
    return found


def _shaders(material) -> list:
    tree = material.node_tree
    return [one for one in (tree.nodes if tree else []) if one.type == "BSDF_PRINCIPLED"]


def _is_clear(shader) -> bool:
    inputs = shader.inputs
    is_seen_through = inputs["Transmission Weight"].default_value > 0.5 or inputs["Alpha"].default_value < 0.5
    return is_seen_through and not inputs["Alpha"].is_linked


def thin_glass() -> None:
    """Clear materials become thin panes: refraction needs many more samples than a small picture has."""
    for material in bpy.data.materials:
        for shader in _shaders(material):
            inputs = shader.inputs
            if _is_clear(shader):
                inputs["Transmission Weight"].default_value = 0.0
                inputs["Alpha"].default_value = min(inputs["Alpha"].default_value, 0.2)
                inputs["Roughness"].default_value = 0.1


def plain_material(name: str, color: tuple) -> object:
    material = bpy.data.materials.new(name)
    if material.node_tree is None:
        material.use_nodes = True
    shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = color
    shader.inputs["Roughness"].default_value = 1.0
    material.diffuse_color = color
    return material
