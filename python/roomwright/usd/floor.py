"""One level: a glTF file's tree of nodes as prims of a layer."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from pxr import Sdf

from ..gltf_document import GltfError
from ..gltf_file import GltfFile, Node

from . import physics
from .describing import describe
from .geometry import PROTOTYPES, Geometry
from .instancer import INSTANCER, room_of, small_nodes, write_instancer
from .level import Level, level_of
from .lights import light_name, light_of, write_light
from .materials import MATERIALS
from .naming import Names, valid_name
from .placing import UNMOVED, place, place_leaf, swing_of, turn_up
from .settings import Settings
from .specs import new_prim
from .variants import coarser_nodes, mesh_names, write_details
from .writing import write_layer, write_package


@dataclass(frozen=True)
class Written:
    """The facts of a level's file that its building needs."""

    file: Path
    level: Level | None
    bounds: tuple[tuple[float, ...], tuple[float, ...]] | None  # lowest and highest corner in metres, Y up
    shared: tuple[Path, ...] = ()  # models and images that the file refers to, written by this run


def convert_floor(gltf: GltfFile, target: Path, settings: Settings) -> Written:
    """Converts one file; raises what readers and writers raise."""
    level = level_of(gltf.nodes[0]) if gltf.nodes else None
    if target.suffix == ".usdz":
        with TemporaryDirectory() as folder:
            unpacked = Path(folder) / f"{target.stem}.usdc"
            write_floor(gltf, unpacked, settings.packed(Path(folder)))
            write_package(unpacked, target, settings.root)
        return Written(target, level, bounds_of(gltf))
    return Written(target, level, bounds_of(gltf), write_floor(gltf, target, settings))


def write_floor(gltf: GltfFile, target: Path, settings: Settings) -> tuple[Path, ...]:
    """Writes the layer of a floor; the files of the run that it refers to."""
    layer = Sdf.Layer.CreateAnonymous(target.suffix)
    # One change block: without it USD recomposes after each of some ten thousand edits.
    with Sdf.ChangeBlock():
        floor = Floor(gltf, layer, target, settings)
        floor.write()
    write_layer(layer, target, settings.root)
    return floor.geometry.files


class Floor:
    """Writes one file's prims into a layer."""

    def __init__(self, gltf: GltfFile, layer: Sdf.Layer, target: Path, settings: Settings):
        roots = [node for node in gltf.nodes if node.parent is None]
        if len(roots) != 1:
            raise GltfError(f"the scene has {len(roots)} roots, a floor has one")
        self.gltf = gltf
        self.layer = layer
        self.settings = settings
        self.root = roots[0]
        self.prim = new_prim(layer.pseudoRoot, valid_name(self.root.name), "Xform")
        self.geometry = Geometry(gltf, self.prim, settings, target)
        below = settings.instanced_below
        self.small = {} if below is None else small_nodes(gltf, below)
        self.instanced = {node.index for nodes in self.small.values() for node in nodes}
        self.carriers = self.find_carriers()
        self.prims: dict[int, Sdf.PrimSpec] = {}
        self.names: dict[int, Names] = {}

    def write(self) -> None:
        self.layer.defaultPrim = self.prim.name
        self.layer.pseudoRoot.SetInfo("metersPerUnit", 1.0)
        self.layer.pseudoRoot.SetInfo("upAxis", self.settings.up_axis)
        for node in self.gltf.nodes:
            if node.index not in self.instanced:
                self.write_node(node)
            if node.index in self.small:
                write_instancer(self.prims[node.index], node, self.small[node.index], self.geometry)
        self.geometry.variants.choose_for_floor(self.prim, self.geometry.classes)
        if self.settings.has_physics:
            physics.write_scene(self.layer, self.settings.up_axis)
            self.write_hinges()

    def find_carriers(self) -> set[int]:
        """The nodes with other nodes, or a light of their own, below their prims."""
        written = [node for node in self.gltf.nodes if node.index not in self.instanced and node is not self.root]
        lit = {node.index for node in self.gltf.nodes if self.light_of(node) is not None}
        return lit | {self.parent_of(node).index for node in written}

    def light_of(self, node: Node) -> dict | None:
        return light_of(self.gltf, node, self.settings.lights_lamps)

    def mesh_name(self, prim: Sdf.PrimSpec, node: Node) -> str:
        """The name of a node's mesh: the node's where it is the only child, which importers join with the node."""
        return f"{prim.name}_mesh" if node.index in self.carriers else prim.name

    def write_node(self, node: Node) -> None:
        parent = self.parent_of(node)
        prim = self.prim if node is self.root else new_prim(
            self.prims[parent.index], self.names[parent.index].take(node.name), "Xform")
        self.prims[node.index] = prim
        self.names[node.index] = Names(self.reserved(prim, node))
        describe(prim, node)
        self.place(prim, node, parent)
        self.write_content(prim, node)
        if self.settings.has_physics:
            self.write_body(prim, node)

    def reserved(self, prim: Sdf.PrimSpec, node: Node) -> set[str]:
        """The names of children that are no nodes."""
        meshes = mesh_names(self.mesh_name(prim, node), len(coarser_nodes(self.gltf, node)))
        return {MATERIALS, PROTOTYPES, INSTANCER, light_name(prim.name, node), *meshes}

    def parent_of(self, node: Node) -> Node | None:
        """The node below whose prim a node's prim stands: with physics, furniture stands in its room."""
        if self.settings.has_physics and node.kind == "furniture":
            return room_of(node) or node.parent
        return node.parent

    def place(self, prim: Sdf.PrimSpec, node: Node, parent: Node | None) -> None:
        swing = swing_of(node)
        if swing is not None:
            place_leaf(prim, node.local, swing)
            return
        local = node.local if parent is node.parent else np.linalg.inv(parent.world) @ node.world
        before = (turn_up(prim),) if node is self.root and self.settings.up_axis == "Z" else ()
        place(prim, local, before)

    def write_content(self, prim: Sdf.PrimSpec, node: Node) -> None:
        if coarser_nodes(self.gltf, node):
            write_details(prim, self.mesh_name(prim, node), self.gltf, node, self.geometry.write)
        elif node.mesh is not None:
            self.geometry.write(prim, node.mesh, UNMOVED, self.mesh_name(prim, node))
        light = self.light_of(node)
        if light is not None:
            write_light(prim, light_name(prim.name, node), light, node.extras)

    # --- physics ---

    def write_body(self, prim: Sdf.PrimSpec, node: Node) -> None:
        if node.kind == "furniture" and not physics.is_fixed(node):
            physics.write_body(prim, physics.furniture_mass(node))
        elif node.mesh is not None and swing_of(node) is not None:
            physics.write_body(prim, physics.leaf_mass(self.gltf, node.mesh))

    def write_hinges(self) -> None:
        """A joint for every leaf, beside it in its opening."""
        frames = {node.parent.index: node for node in self.gltf.nodes if node.extras.get("part") == "frame"}
        for node in self.gltf.nodes:
            swing = swing_of(node)
            if swing is None or node.mesh is None:
                continue
            opening, frame = self.prims[node.parent.index], frames.get(node.parent.index)
            held_by = (opening, UNMOVED) if frame is None else (self.prims[frame.index], frame.local)
            name = self.names[node.parent.index].take(f"{physics.JOINT}_{self.prims[node.index].name}")
            physics.write_hinge(opening, name, held_by, (self.prims[node.index], node.local), swing)


def bounds_of(gltf: GltfFile) -> tuple[tuple[float, ...], tuple[float, ...]] | None:
    """The box around the boxes of all meshes."""
    places: dict[int, list[np.ndarray]] = {}
    for node in gltf.nodes:
        if node.mesh is not None:
            places.setdefault(node.mesh, []).append(node.world)
    if not places:
        return None
    boxes = []
    for mesh, worlds in places.items():
        matrices = np.stack(worlds)
        corners = corners_of(gltf, mesh) @ matrices[:, :3, :3].transpose(0, 2, 1) + matrices[:, None, :3, 3]
        boxes.append(corners.reshape(-1, 3))
    everything = np.concatenate(boxes)
    return tuple(everything.min(axis=0).tolist()), tuple(everything.max(axis=0).tolist())


def corners_of(gltf: GltfFile, mesh: int) -> np.ndarray:
    """The eight corners of a mesh's box."""
    positions = np.concatenate([primitive["positions"] for primitive in gltf.primitives(mesh)]).astype(float)
    box = np.stack([positions.min(axis=0), positions.max(axis=0)])
    return np.stack(np.meshgrid(box[:, 0], box[:, 1], box[:, 2]), axis=-1).reshape(-1, 3)
