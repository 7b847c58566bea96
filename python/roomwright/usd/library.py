"""Assets that all levels of a run share: each model once, named by its content.

The name of an asset's file ends in a hash of its content. Equal models of different levels are one file, and models that
differ by a tint are two. Processes that write the same model at the same time write the same bytes.

    /<model>                 component with its materials: the model by itself
        Materials
        <model>              the geometry with the materials bound to it
    /Geometry                the geometry: levels refer to it and bind their own materials
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from pxr import Kind, Sdf

from ..gltf_file import GltfFile

from .materials import READERS, Materials
from .meshes import write_mesh
from .naming import LONGEST_NAME, valid_name
from .physics import add_collider
from .settings import MODEL_FOLDER, Settings
from .specs import new_prim, refer
from .textures import HASH_LENGTH, Textures
from .variants import MaterialVariants
from .writing import is_of_this_run, write_layer

GEOMETRY_PATH = "/Geometry"


class Library:
    """The models of one glTF file in the folder of the run."""

    def __init__(self, gltf: GltfFile, settings: Settings, textures: Textures, variants: MaterialVariants):
        self.gltf = gltf
        self.settings = settings
        self.textures = textures
        self.variants = variants
        self.folder = settings.root / MODEL_FOLDER
        self.files: set[Path] = set()
        # The materials of all models, in a layer that is never written to a file.
        self.pattern = Sdf.Layer.CreateAnonymous(".usda")
        owner = new_prim(self.pattern.pseudoRoot, "Models", "Scope")
        self.materials = Materials(owner, gltf, textures, self.folder)

    def asset(self, mesh: int, collider: str) -> Path:
        """The file of a mesh; `collider` is the shape that a simulator sees, if any."""
        name = valid_name(self.gltf.name_of("meshes", mesh) or "model")[:LONGEST_NAME]
        file = self.folder / f"{name}.{self.content_hash(mesh, name, collider)}.usdc"
        self.files.add(file)
        if not is_of_this_run(file, self.settings.started):
            layer = Sdf.Layer.CreateAnonymous(file.suffix)
            with Sdf.ChangeBlock():
                self.write_model(layer, name, mesh, collider)
            write_layer(layer, file, self.settings.root)
        return file

    def write_model(self, layer: Sdf.Layer, name: str, mesh: int, collider: str) -> None:
        model = new_prim(layer.pseudoRoot, name, "Xform")
        layer.defaultPrim = name
        # Models lie on their side of the crossing of axes: Y up, whatever the stage that refers to them says.
        layer.pseudoRoot.SetInfo("metersPerUnit", 1.0)
        layer.pseudoRoot.SetInfo("upAxis", "Y")
        model.kind = Kind.Tokens.component
        model.assetInfo["name"] = self.gltf.name_of("meshes", mesh) or name
        materials = Materials(model, self.gltf, self.textures, self.folder, self.materials)
        geometry = new_prim(layer.pseudoRoot, GEOMETRY_PATH[1:], "Mesh", Sdf.SpecifierClass)
        write_mesh(geometry, self.gltf, mesh, materials)
        add_collider(geometry, collider)
        shown = new_prim(model, name, "Mesh")
        refer(shown, "", GEOMETRY_PATH)
        self.variants.bind(model, shown, mesh, materials)

    def content_hash(self, mesh: int, name: str, collider: str) -> str:
        summary = hashlib.sha256()
        own = []
        for number, primitive in enumerate(self.gltf.primitives(mesh)):
            arrays = [primitive["positions"], primitive["normals"], primitive["triangles"], *primitive["coordinates"]]
            for array in arrays:
                summary.update(b"none" if array is None else array.tobytes())
                summary.update(b"/")
            others = sorted(self.variants.of_primitive(mesh, number).items())
            variants = [[self.variants.names[variant], self.described(material)] for variant, material in others]
            own.append([self.described(primitive["material"]), variants])
        summary.update(json.dumps([name, collider, own], sort_keys=True).encode())
        return summary.hexdigest()[:HASH_LENGTH]

    def described(self, number: int | None) -> dict | None:
        """A material with the files of its textures instead of their numbers in this glTF file."""
        if number is None:
            return None
        material = self.gltf.entry("materials", number)
        files = {}
        for reader in READERS.values():
            used = (material.get(reader.group, {}) if reader.group else material).get(reader.key)
            if used is not None:
                files[reader.key] = self.textures.path(used["index"], self.folder)
        return {**without_numbers(material), "files": files}


def without_numbers(value):
    """A material's values without the numbers of textures, which differ from file to file."""
    if isinstance(value, dict):
        return {key: without_numbers(part) for key, part in value.items() if key != "index"}
    return value
