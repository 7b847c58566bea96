"""Meshes of nodes: in place, or as models, which are classes of a level and assets of a run.

Furniture, and every mesh that several nodes share, is a model: a class below `Prototypes` that binds the level's materials
to the geometry of an asset, or holds the geometry itself if the level is self-contained. Each node's mesh inherits its
class, so that all of them have the same materials, which Blender then imports once. The meshes of walls and floors are not
shared, and stay below their nodes.

Some importers, as Blender's, join a node with its only child and call the result by the child. Therefore a node's mesh has
the node's name. If a node also has other children, its mesh is called `<node>_mesh`.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
from pxr import Sdf

from ..gltf_file import GltfFile

from .library import GEOMETRY_PATH, Library
from .materials import Materials
from .meshes import write_mesh
from .naming import Names
from .physics import add_collider, collider_of
from .placing import place
from .settings import Settings
from .specs import inherit, new_prim, refer
from .textures import Textures
from .variants import MaterialVariants, coarser_nodes
from .writing import relative_path

PROTOTYPES = "Prototypes"
# The mesh below an instance.
INSTANCED = "mesh"


class Geometry:
    """The meshes of one floor."""

    def __init__(self, gltf: GltfFile, root: Sdf.PrimSpec, settings: Settings, target: Path):
        self.gltf = gltf
        self.root = root
        self.settings = settings
        self.folder = target.parent
        self.variants = MaterialVariants(gltf)
        self.textures = Textures(gltf, settings, target)
        self.materials = Materials(root, gltf, self.textures, self.folder)
        self.library = Library(gltf, settings, self.textures, self.variants)
        self.colliders: dict[int, str] = {}
        self.shared = self.find_shared()
        self.classes: dict[int, Sdf.PrimSpec] = {}
        self.names = Names()

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

    # --- models ---

    def class_of(self, mesh: int) -> Sdf.PrimSpec:
        """The class of a model; written when it is first asked for."""
        if mesh not in self.classes:
            if PROTOTYPES not in self.root.nameChildren:
                # Without a type, for importers make an object of a Scope.
                new_prim(self.root, PROTOTYPES, "", Sdf.SpecifierClass)
            scope = self.root.nameChildren[PROTOTYPES]
            name = self.names.take(self.gltf.name_of("meshes", mesh) or f"mesh{mesh}")
            self.classes[mesh] = self.write_class(scope, name, mesh)
        return self.classes[mesh]

    def write_class(self, scope: Sdf.PrimSpec, name: str, mesh: int) -> Sdf.PrimSpec:
        is_instanced = self.settings.has_instances
        model = new_prim(scope, name, "Xform" if is_instanced else "Mesh", Sdf.SpecifierClass)
        geometry = new_prim(model, INSTANCED, "Mesh") if is_instanced else model
        if self.settings.is_self_contained:
            self.write_geometry(geometry, mesh)
        else:
            file = self.library.asset(mesh, self.colliders.get(mesh, ""))
            refer(geometry, relative_path(file, self.folder), GEOMETRY_PATH)
        self.variants.bind(model, geometry, mesh, self.materials)
        return model

    def write_geometry(self, prim: Sdf.PrimSpec, mesh: int) -> None:
        write_mesh(prim, self.gltf, mesh, self.materials)
        add_collider(prim, self.colliders.get(mesh, ""))

    # --- uses ---

    def write(self, parent: Sdf.PrimSpec, mesh: int, local: np.ndarray, name: str) -> None:
        """A mesh below a node's prim."""
        if mesh in self.shared:
            prim = self.write_use(parent, name, mesh)
            # Only what is below an instance is shared, so that an instance has its mesh below it.
            if self.settings.has_instances:
                prim.instanceable = True
        else:
            prim = new_prim(parent, name, "Mesh")
            self.write_geometry(prim, mesh)
            self.variants.bind(prim, prim, mesh, self.materials)
        place(prim, local)

    def write_use(self, parent: Sdf.PrimSpec, name: str, mesh: int) -> Sdf.PrimSpec:
        """A prim that is a model."""
        model = self.class_of(mesh)
        prim = new_prim(parent, name, model.typeName)
        inherit(prim, model.path)
        return prim
