"""Collision shapes of furniture, leaves and stairs: a box or a convex part for each loose part of a mesh.

Simulators take the convex hull of each part that is no box. Boxes are cheaper, and rest on each other more quietly, so a part
that nearly fills the box around it becomes that box.
"""

from __future__ import annotations

import numpy as np

from ..checks.bodies import Part, is_closed, parts_of, solids_of
from ..checks.shell_parts import FITTING_HEIGHT
from ..gltf_file import GltfFile

from .axes import points_up
from .bodies import Box, Collider, Surface
from .prisms import colliders_of_shell

# Share of its box that a part fills from which on it is a box: a cushion with round edges is, a cylinder (0.785) is not.
NEARLY_FULL = 0.9
# Metres: half of the least thickness of a shape. A sheet has no volume, and simulators reject meshes without one.
LEAST_HALF = 0.001
# Cosine under which two normals are perpendicular.
PERPENDICULAR = 1e-3
# Metres by which the shapes of free pieces are narrower on each side: pieces that touch must not press.
MARGIN = 0.001
# Cosine of the steepest axis of a box that counts as lying.
UPRIGHT = 0.5


def shell_colliders(gltf: GltfFile, mesh: int, has_fittings: bool) -> list[Collider]:
    """Of a part of the building. Skirting boards and sockets (`has_fittings`) are no obstacles: furniture stands on them."""
    found = []
    for part in closed_parts(gltf.primitives(mesh)):
        if not has_fittings or not is_fitting(part):
            found += colliders_of_shell(part)
    return found


def is_fitting(part: Part) -> bool:
    """Whether a part of a wall is a skirting board, which is low, or a socket or switch, which is small; a rail is neither."""
    size = part.high - part.low
    return bool(size[1] < FITTING_HEIGHT and (part.low[1] < FITTING_HEIGHT or size.max() < FITTING_HEIGHT))


def closed_parts(primitives: list[dict]) -> list[Part]:
    """The parts of a mesh. A surface whose sides have different materials, such as a wall with tiles, is one part."""
    parts = parts_of(primitives)
    opened = [part for part in parts if not is_closed(part)]
    if not opened:
        return parts
    starts = np.cumsum([0, *(len(part.corners) for part in opened)])
    together = {"positions": np.concatenate([part.corners for part in opened]),
                "triangles": np.concatenate([part.triangles + start for part, start in zip(opened, starts)])}
    return [part for part in parts if is_closed(part)] + parts_of([together])


def furniture_colliders(gltf: GltfFile, mesh: int) -> list[Collider]:
    """Of a piece or a leaf, in its own axes, Z up."""
    return [collider_of(part) for part in closed_parts(gltf.primitives(mesh))]


def stairs_colliders(gltf: GltfFile, mesh: int) -> list[Collider]:
    """Of stairs: each step, landing, post and piece of a handrail. Steps share edges, and the hull of a flight is a ramp."""
    return [collider_of(part) for primitive in gltf.primitives(mesh) for part in solids_of(primitive)]


def collider_of(part: Part) -> Collider:
    turn = box_axes(part)
    corners = points_up(part.corners)
    if turn is not None:
        return box_around(corners, turn)
    around, surface = box_around(corners, np.identity(3)), Surface(corners, part.triangles)
    is_sheet = around.half.min() <= LEAST_HALF or surface.volume < 1e-9
    return around if is_sheet or surface.volume > NEARLY_FULL * around.volume else surface


def box_axes(part: Part) -> np.ndarray | None:
    """The axes of a part that is a box, whichever way it is turned."""
    if not part.is_convex or len(part.normals) != 3:
        return None
    normals = points_up(part.normals)
    if np.abs(normals @ normals.T - np.identity(3)).max() > PERPENDICULAR:
        return None
    # The axis that is most upright is z, and the axes are right-handed.
    order = np.argsort(np.abs(normals[:, 2]), kind="stable")
    axes = normals[order]
    axes *= np.where(axes[:, 2] < -PERPENDICULAR, -1.0, 1.0)[:, None]
    axes[1] = np.cross(axes[2], axes[0])
    return axes.T


def box_around(corners: np.ndarray, turn: np.ndarray) -> Box:
    """The box along given axes around some corners."""
    own = corners @ turn
    low, high = own.min(axis=0), own.max(axis=0)
    return Box(turn @ ((low + high) / 2), turn, np.maximum((high - low) / 2, LEAST_HALF))


def scaled(collider: Collider, stretch: np.ndarray) -> Collider:
    """A shape in a frame that was scaled by hand."""
    if np.array_equal(stretch, np.identity(3)):
        return collider
    if isinstance(collider, Box):
        return box_around(collider.corners @ stretch.T, collider.turn)
    return Surface(collider.corners @ stretch.T, collider.triangles)


def shrunk(collider: Collider) -> Collider:
    """A shape of a free piece: narrower by the margin on all sides.

    Its height stays: pieces stand exactly on what carries them, and would fall as far as they were cut.
    """
    if isinstance(collider, Box):
        is_upright = np.abs(collider.turn[2]) > UPRIGHT
        # A thin part keeps half of its thickness.
        return Box(collider.centre, collider.turn, collider.half - np.where(is_upright, 0.0, inset(collider.half)))
    low, high = collider.corners.min(axis=0), collider.corners.max(axis=0)
    half = (high - low) / 2
    factor = np.array([*(1.0 - inset(half)[:2] / np.maximum(half[:2], 1e-9)), 1.0])
    centre = (low + high) / 2
    return Surface(centre + (collider.corners - centre) * factor, collider.triangles)


def inset(half: np.ndarray) -> np.ndarray:
    return np.minimum(MARGIN, half / 2)
