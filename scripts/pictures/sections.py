"""Walls cut open: at which height a part of a level ends, and the cut through its mesh. Needs bpy."""

from __future__ import annotations

import bpy  # before bmesh and mathutils, which it brings
import bmesh
from mathutils import Matrix, Vector

from .camera import Camera

# The faces of cuts, by view.
CUT_COLORS = {"top": (0.02, 0.021, 0.024, 1.0), "dollhouse": (0.12, 0.123, 0.13, 1.0)}


def height_of_cut(thing, chain: list, camera: Camera, cuts: dict[str, float]) -> float | None:
    """Metres at which a part ends, or None; `chain` is the part and its ancestors, `cuts` is by openings' names."""
    if thing.type != "MESH" or thing.get("kind") != "part":
        return None
    part, parent = thing["part"], chain[1] if len(chain) > 1 else None
    if part == "floor" or parent is None:
        return None
    if parent.get("kind") == "opening":
        return cuts.get(parent.name)
    number = str(thing.get("id", "")).partition(".")[2].partition(".")[0]
    if part in ("wall", "socket", "switch") and number.isdigit():
        return camera.cuts.get((parent["room"], int(number)))
    # Columns and the like end where the walls do, where all walls end; so do flights, as in drawn plans.
    return max(camera.cuts.values(), default=None) if camera.view == "top" else None


def cut_open(thing, height: float, cap) -> None:
    """Takes away what is above a height and closes the cut."""
    levels = [(thing.matrix_world @ Vector(corner)).z for corner in thing.bound_box]
    if min(levels) >= height - 1e-4:
        thing.hide_render = True
        return
    if max(levels) <= height + 1e-4:
        return
    thing.data = thing.data.copy()
    thing.data.materials.append(cap)
    _bisect(thing.data, thing.matrix_world, height, len(thing.data.materials) - 1)


def _bisect(mesh, world: Matrix, height: float, cap: int) -> None:
    point = world.inverted_safe() @ Vector((0, 0, height))
    normal = (world.to_3x3().transposed() @ Vector((0, 0, 1))).normalized()
    shape = bmesh.new()
    shape.from_mesh(mesh)
    # The file has corners once per face; the cut closes where edges meet.
    bmesh.ops.remove_doubles(shape, verts=shape.verts, dist=1e-5)
    everything = shape.verts[:] + shape.edges[:] + shape.faces[:]
    cut = bmesh.ops.bisect_plane(shape, geom=everything, plane_co=point, plane_no=normal, clear_outer=True)
    edges = [one for one in cut["geom_cut"] if isinstance(one, bmesh.types.BMEdge)]
    if edges:
        filled = bmesh.ops.triangle_fill(shape, edges=edges, use_beauty=True)
        for face in (one for one in filled["geom"] if isinstance(one, bmesh.types.BMFace)):
            face.material_index, face.smooth = cap, False
    shape.to_mesh(mesh)
    shape.free()
