"""A level's glTF file as bodies: parts of the building, leaves with joints, furniture."""

from __future__ import annotations

import numpy as np

from ..gltf_document import GltfError
from ..gltf_file import GltfFile, Node
from ..usd.physics import properties_of

from .axes import about_up, points_up, pose_up, split_scale
from .bodies import Body, Collider, LevelModel, Surface, Visual
from .colliders import furniture_colliders, scaled, shell_colliders, shrunk, stairs_colliders
from .colours import Colours, Rgba
from .doors import is_leaf, joint_of, leaf_inertia, without_fittings
from .movable import movable_pieces, piece_inertia
from .pressing import fix_pressed

# Parts of a room that one stands on or under; its other parts may be or carry skirting boards, sockets and switches.
SLABS = {"floor", "ceiling"}
# Corners that MuJoCo demands of a mesh.
LEAST_CORNERS = 4


def read_level(gltf: GltfFile, heaviest: float | None) -> LevelModel:
    """The bodies of a level; `heaviest` is the mass up to which pieces are free, if any are."""
    root = gltf.nodes[0] if gltf.nodes else None
    if root is None or root.kind != "level":
        raise GltfError(f"its first node {root.name if root else ''!r} is no level; hint: `roomwright bake` writes levels")
    if not any(node.mesh is not None for node in gltf.nodes if node.kind in ("furniture", "part")):
        raise GltfError("no node of a part or a piece has a mesh of its own; hint: bake without `--profile web`")
    reader = LevelReader(gltf, heaviest)
    return LevelModel(root.name, reader.bodies())


class LevelReader:
    """One file; what its nodes share is read once."""

    def __init__(self, gltf: GltfFile, heaviest: float | None):
        self.gltf = gltf
        self.colours = Colours(gltf)
        self.free = movable_pieces(gltf, heaviest) if heaviest is not None else set()
        self.names: dict[int, str] = {}
        self.shapes: dict[tuple[int, str], list[Collider]] = {}
        self.seen: dict[int, list[Visual]] = {}

    def bodies(self) -> list[Body]:
        taken: set[str] = set()
        for node in self.gltf.nodes:
            self.names[node.index] = unique(path_of(node), taken)
        nodes = [node for node in self.gltf.nodes if node.mesh is not None and node.kind in ("part", "furniture")]
        bodies = [self.body(node) for node in nodes]
        if self.free:
            fix_pressed(bodies)
        return bodies

    def body(self, node: Node) -> Body:
        pose, stretch = split_scale(pose_up(node.world))
        colliders = [scaled(collider, stretch) for collider in self.colliders(node)]
        body = Body(self.names[node.index], pose, colliders, [stretched(visual, stretch) for visual in self.visuals(node.mesh)])
        if is_leaf(node):
            self.hang(body, colliders, node)
        elif node.index in self.free and colliders:
            body.is_free = True
            body.inertia = piece_inertia(node, colliders)
            body.colliders = [shrunk(collider) for collider in colliders]
        return body

    def hang(self, body: Body, colliders: list[Collider], node: Node) -> None:
        """Gives a leaf its joint, if it has one."""
        body.joint = joint_of(self.gltf, node)
        if body.joint is not None:
            # A shut sliding leaf touches the frame at its end.
            body.colliders = (without_fittings(colliders) if body.joint.kind == "hinge" else
                              [shrunk(collider) for collider in colliders])
            corners = np.concatenate([collider.corners for collider in body.colliders])
            body.inertia = leaf_inertia(self.gltf, node, corners.min(axis=0), corners.max(axis=0))
            # Shut leaves touch their frames and each other.
            body.apart = [self.names[other.index] for other in self.gltf.nodes if other.parent is node.parent
                          and other is not node and other.mesh is not None and other.kind == "part"]

    def colliders(self, node: Node) -> list[Collider]:
        key = node.mesh, shape_kind(node)
        if key not in self.shapes:
            self.shapes[key] = self.shape(*key)
        return self.shapes[key]

    def shape(self, mesh: int, kind: str) -> list[Collider]:
        if kind == "shell" or kind == "walls":
            return shell_colliders(self.gltf, mesh, kind == "walls")
        if kind == "stairs":
            return stairs_colliders(self.gltf, mesh)
        return furniture_colliders(self.gltf, mesh) if kind == "loose" else []

    def visuals(self, mesh: int) -> list[Visual]:
        if mesh not in self.seen:
            name = self.gltf.name_of("meshes", mesh) or "mesh"
            groups = [(surface_of(primitive["positions"], triangles), rgba) for primitive in self.gltf.primitives(mesh)
                      for triangles, rgba in self.colours.groups(primitive)]
            self.seen[mesh] = [Visual(name, surface, rgba) for surface, rgba in large_enough(groups)]
        return self.seen[mesh]


def shape_kind(node: Node) -> str:
    """How the collision shapes of a node are made."""
    if node.kind == "furniture":
        return "loose" if properties_of(node.extras["class"])["shape"] else "none"
    if node.extras.get("part") == "leaf":
        return "loose"
    if node.extras.get("part") == "stairs":
        return "stairs"
    is_of_room = node.parent is not None and node.parent.kind == "room"
    return "walls" if is_of_room and node.extras.get("part") not in SLABS else "shell"


def surface_of(positions: np.ndarray, triangles: np.ndarray) -> Surface:
    """Some triangles of a primitive, with the corners that they use."""
    used, renumbered = np.unique(triangles, return_inverse=True)
    return Surface(points_up(positions[used].astype(float)), renumbered.reshape(-1, 3))


def large_enough(groups: list[tuple[Surface, Rgba]]) -> list[tuple[Surface, Rgba]]:
    """Surfaces by colour; those of fewer corners than simulators accept are added to the largest one."""
    by_colour: dict[Rgba, Surface] = {}
    for surface, rgba in sorted(groups, key=lambda group: -len(group[0].corners)):
        key = rgba if rgba in by_colour or len(surface.corners) >= LEAST_CORNERS else next(iter(by_colour), rgba)
        by_colour[key] = joined(by_colour[key], surface) if key in by_colour else surface
    return [(surface, rgba) for rgba, surface in by_colour.items() if len(surface.corners) >= LEAST_CORNERS]


def joined(one: Surface, other: Surface) -> Surface:
    return Surface(np.concatenate([one.corners, other.corners]),
                   np.concatenate([one.triangles, other.triangles + len(one.corners)]))


def stretched(visual: Visual, stretch: np.ndarray) -> Visual:
    if np.array_equal(stretch, np.identity(3)):
        return visual
    return Visual(visual.name, Surface(visual.surface.corners @ stretch.T, visual.surface.triangles), visual.rgba)


def shut_pose(body: Body) -> np.ndarray:
    """Where a leaf stands when its joint is at 0."""
    pose = body.pose.copy()
    if body.joint.kind == "hinge":
        pose[:3, :3] = pose[:3, :3] @ about_up(-body.joint.now)
    return pose


def path_of(node: Node) -> str:
    """building/level/room/id, or building/level/door:id/part."""
    around = node.parent
    while around is not None and around.kind not in ("room", "opening", "level"):
        around = around.parent
    if around is None:
        return node.name
    level = around
    while level.parent is not None:
        level = level.parent
    own = str(node.extras.get("id") or node.name)
    if around.kind == "level":
        return f"{level.name}/{node.name}"
    group = around.name if around.kind == "opening" else str(around.extras.get("room") or around.name)
    return f"{level.name}/{group}/{own}"


def unique(name: str, taken: set[str]) -> str:
    found, number = name, 2
    while found in taken:
        found, number = f"{name}_{number}", number + 1
    taken.add(found)
    return found
