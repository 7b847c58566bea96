"""Meshes of nodes: in place, as a prototype of the floor, or as an asset of the run.

Furniture and whatever several nodes share is referenced by instances; walls and floors, which nothing shares, stand
where they are.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
from pxr import Kind, Sdf

from gltf_file import GltfFile

from .library import Library
from .materials import MATERIALS, Materials
from .meshes import write_parts
from .naming import Names
from .physics import add_colliders, collider_of
from .placing import place
from .settings import Settings
from .specs import new_prim, refer
from .textures import Textures
from .variants import GEOMETRY, MaterialVariants, coarser_nodes
from .writing import relative_path

PROTOTYPES = "Prototypes"


class Geometry:
    """The meshes of one floor."""

    def __init__(self, gltf: GltfFile, root: Sdf.PrimSpec, settings: Settings, target: Path):
        self.gltf = gltf
        self.settings = settings
        self.folder = target.parent
        self.variants = MaterialVariants(gltf)
        self.textures = Textures(gltf, settings, target)
        self.materials = Materials(root, gltf, self.textures, self.folder)
        self.library = Library(gltf, settings, self.textures, self.variants)
        self.colliders: dict[int, str] = {}
        self.shared = self.find_shared()
        self.sources: dict[int, tuple[str, str]] = {}
        self.uses: list[tuple[Sdf.Path, int]] = []
        if settings.is_self_contained:
            self.write_prototypes(root)

    @property
    def files(self) -> tuple[Path, ...]:
        """The models and images beside the floor, of those that this run writes."""
        return tuple(sorted(self.library.files | self.textures.copies))

    def find_shared(self) -> set[int]:
        """The meshes that are models of their own; notes what a simulator sees of each mesh."""
        uses: Counter = Counter()
        models = set()
        for node in self.gltf.nodes:
            coarser = [other["mesh"] for other in coarser_nodes(self.gltf, node) if "mesh" in other]
            meshes = coarser if node.mesh is None else [node.mesh, *coarser]
            uses.update(meshes)
            for mesh in meshes:
                if self.settings.has_physics:
                    self.colliders.setdefault(mesh, collider_of(node))
                if self.variants.of_mesh(mesh) or (node.kind == "furniture" and self.shares_furniture()):
                    models.add(mesh)
        return models | {mesh for mesh, count in uses.items() if count > 1}

    def shares_furniture(self) -> bool:
        """Whether a piece is a model even if it is the only one: others of the run may have it, or an instancer."""
        return not self.settings.is_self_contained or self.settings.instanced_below is not None

    def write_prototypes(self, root: Sdf.PrimSpec) -> None:
        """Every model of the floor, out of sight."""
        if not self.shared:
            return
        scope = new_prim(root, PROTOTYPES, "Scope", Sdf.SpecifierClass)
        names = Names()
        for mesh in sorted(self.shared):
            original = self.gltf.name_of("meshes", mesh) or f"mesh{mesh}"
            prototype = new_prim(scope, names.take(original), "Xform")
            # A binding may not point out of what is referenced: materials are inside, and refer to the floor's.
            inside = Materials(prototype, self.gltf, self.textures, self.folder, self.materials)
            self.write_model(prototype, mesh, inside)
            self.sources[mesh] = ("", str(prototype.path))

    def write_model(self, model: Sdf.PrimSpec, mesh: int, materials: Materials) -> None:
        parts = write_parts(model, self.gltf, mesh, materials)
        self.variants.bind(model, parts, mesh, materials)
        add_colliders(parts, self.colliders.get(mesh, ""))

    def source(self, mesh: int) -> tuple[str, str]:
        """Asset and path that a shared mesh is referenced by."""
        if mesh not in self.sources:
            file = self.library.asset(mesh, self.colliders.get(mesh, ""))
            self.sources[mesh] = (relative_path(file, self.folder), "")
        return self.sources[mesh]

    def write(self, parent: Sdf.PrimSpec, mesh: int, local: np.ndarray, name: str = GEOMETRY) -> None:
        """A mesh below a node's prim."""
        geometry = new_prim(parent, name, "Xform")
        place(geometry, local)
        if mesh not in self.shared:
            self.write_model(geometry, mesh, self.materials)
            return
        self.refer(geometry, mesh)
        geometry.instanceable = True

    def refer(self, prim: Sdf.PrimSpec, mesh: int) -> None:
        asset, path = self.source(mesh)
        refer(prim, asset, path or Sdf.Path.emptyPath)
        # A component holds no other: the asset is one by itself, and a part of what it is used in.
        prim.kind = Kind.Tokens.subcomponent
        self.uses.append((prim.path, mesh))
