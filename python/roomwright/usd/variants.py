"""Variants: other materials (KHR_materials_variants) and coarser meshes (MSFT_lod).

Materials: each model has a set `material` with the variant `default` and those variants of the file that change it. The
level has a set `material` too, whose variants select one in all its models: one selection recolours a level. A piece may
have a selection of its own.

Levels of detail: a node with coarser meshes has a set `lod`: `lod0` is its own mesh, `lod1` the next coarser one. USD does
not select by distance; a renderer or a user does.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from pxr import Sdf, Vt

from ..gltf_file import GltfFile, Node, local_matrix

from .materials import Materials
from .meshes import bind, part_of
from .naming import Names
from .placing import UNMOVED
from .specs import add_variants, new_prim

MATERIAL_SET = "material"
DEFAULT = "default"
LOD_SET = "lod"
MATERIALS_EXTENSION = "KHR_materials_variants"
LOD_EXTENSION = "MSFT_lod"


class MaterialVariants:
    """The material variants of a glTF file."""

    def __init__(self, gltf: GltfFile):
        self.gltf = gltf
        listed = gltf.document.get("extensions", {}).get(MATERIALS_EXTENSION, {}).get("variants", [])
        names = Names({DEFAULT})
        self.names = [names.take(variant.get("name", "")) for variant in listed]
        self.changing: dict[int, list[int]] = {}

    def of_primitive(self, mesh: int, number: int) -> dict[int, int]:
        """The other materials of a primitive, by variant."""
        raw = self.gltf.entry("meshes", mesh)["primitives"][number]
        mappings = raw.get("extensions", {}).get(MATERIALS_EXTENSION, {}).get("mappings", [])
        return {variant: mapping["material"] for mapping in mappings for variant in mapping["variants"]}

    def of_mesh(self, mesh: int) -> list[int]:
        """The variants that change a mesh."""
        if mesh not in self.changing:
            count = len(self.gltf.entry("meshes", mesh)["primitives"])
            variants = {variant for number in range(count) for variant in self.of_primitive(mesh, number)}
            self.changing[mesh] = sorted(variants)
        return self.changing[mesh]

    def bind(self, model: Sdf.PrimSpec, geometry: Sdf.PrimSpec, mesh: int, materials: Materials) -> None:
        """Binds the parts of a mesh, the model's prim or one below; those that change, in variants of the model."""
        changing = self.of_mesh(mesh)
        own = [primitive["material"] for primitive in self.gltf.primitives(mesh)]
        fixed = [number for number in range(len(own)) if not self.of_primitive(mesh, number)]
        for number in fixed:
            if own[number] is not None:
                bind(part_of(geometry, number, len(own)), materials.path(own[number]))
        if not changing:
            return
        # An opinion outside of the set would be stronger than those in it.
        names = [DEFAULT, *(self.names[variant] for variant in changing)]
        variants = add_variants(model, MATERIAL_SET, names, None)
        for variant, name in zip([None, *changing], names):
            inside = over(variants[name], geometry.path.MakeRelativePath(model.path))
            for number in sorted(set(range(len(own))) - set(fixed)):
                material = self.of_primitive(mesh, number).get(variant, own[number])
                if material is not None:
                    bind(part_of(inside, number, len(own)), materials.path(material))

    def choose_for_floor(self, root: Sdf.PrimSpec, models: dict[int, Sdf.PrimSpec]) -> None:
        """The floor's own set, which chooses for all models, given by their meshes."""
        if not self.names:
            return
        variants = add_variants(root, MATERIAL_SET, [DEFAULT, *self.names], DEFAULT)
        for variant, name in [(None, DEFAULT), *enumerate(self.names)]:
            for mesh, model in models.items():
                changing = self.of_mesh(mesh)
                if changing:
                    chosen = over(variants[name], model.path.MakeRelativePath(root.path))
                    chosen.variantSelections[MATERIAL_SET] = name if variant in changing else DEFAULT


def over(owner: Sdf.PrimSpec, path: Sdf.Path) -> Sdf.PrimSpec:
    """Opinions about a prim or one below, inside a variant."""
    for element in path.GetPrefixes() if path != Sdf.Path.reflexiveRelativePath else ():
        children = owner.nameChildren
        owner = children[element.name] if element.name in children else new_prim(
            owner, element.name, "", Sdf.SpecifierOver)
    return owner


def coarser_nodes(gltf: GltfFile, node: Node) -> list[dict]:
    """The nodes that stand for a node at lower levels of detail, finest first."""
    extensions = gltf.entry("nodes", node.index).get("extensions", {})
    return [gltf.entry("nodes", index) for index in extensions.get(LOD_EXTENSION, {}).get("ids", [])]


def mesh_names(finest: str, coarser: int) -> list[str]:
    """The names of the prims of a node's mesh and of so many coarser ones."""
    return [finest, *(f"{finest}_{LOD_SET}{level}" for level in range(1, coarser + 1))]


def write_details(prim: Sdf.PrimSpec, finest: str, gltf: GltfFile, node: Node, write: Callable) -> None:
    """The set `lod` of a node, whose mesh is called `finest`; `write` puts a mesh below a prim at a place in its frame.

    The meshes stand beside each other and the variants make one of them active: were they inside the variants, what a
    model says by itself would be stronger than what the floor's variants of materials say about it.
    """
    coarser = coarser_nodes(gltf, node)
    geometries = mesh_names(finest, len(coarser))
    to_node = np.linalg.inv(node.local)
    places = [(node.mesh, UNMOVED), *((other.get("mesh"), to_node @ local_matrix(other)) for other in coarser)]
    for name, (mesh, local) in zip(geometries, places):
        if mesh is not None:
            write(prim, mesh, local, name)
    names = [f"{LOD_SET}{level}" for level in range(len(geometries))]
    variants = add_variants(prim, LOD_SET, names, names[0])
    for level, name in enumerate(names):
        for other, (geometry, (mesh, _)) in enumerate(zip(geometries, places)):
            if mesh is not None and other != level:
                new_prim(variants[name], geometry, "", Sdf.SpecifierOver).active = False
    coverage = node.extras.get("MSFT_screencoverage")
    if coverage:
        shares = Vt.DoubleArray([float(share) for share in coverage])
        prim.SetInfo("customData", {**dict(prim.customData), "MSFT_screencoverage": shares})
