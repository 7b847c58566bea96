#!/usr/bin/env python3
"""Converts baked floors to USD: convert.py [options] FOLDER|FILE...

Each .glb or .gltf becomes one .usdc (or .usda) beside it, or at the same relative place under --out:
  - the same tree of nodes under the default prim, with the same places; names made valid, the original name
    in displayName and in customData;
  - the node's extras as customData (numbers, texts and lists of one kind as such, seeds and the rest as text);
  - a mesh that several nodes share is one prototype, referenced by instanceable prims;
  - materials as UsdPreviewSurface, with textures beside the file; metres, Y up (or Z with --up-axis Z);
  - kinds: level assembly, room group, everything in it component, and what stands on it subcomponent.
Equal inputs give equal bytes.

Needs scripts/requirements.txt. Progress goes to standard error, one line per written file to standard output.
Exit 0: all written. 1: some failed. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from pathlib import Path

import numpy as np
from pxr import Gf, Kind, Sdf, Tf, UsdGeom, Vt

from gltf_file import GltfError, GltfFile, Node

SCENE_ENDINGS = {".glb", ".gltf"}
MATERIALS = "Materials"
PROTOTYPES = "Prototypes"
# The child of a node's prim that holds its mesh: a prim with children of its own cannot be an instance.
GEOMETRY = "geometry"
# What is left of a clear material's opacity, so that glass is seen at all.
LEAST_OPACITY = 0.1
TEXTURE_INPUTS = {
    "diffuseColor": ("pbrMetallicRoughness", "baseColorTexture", "rgb", "sRGB"),
    "metallic": ("pbrMetallicRoughness", "metallicRoughnessTexture", "b", "raw"),
    "roughness": ("pbrMetallicRoughness", "metallicRoughnessTexture", "g", "raw"),
    "normal": (None, "normalTexture", "rgb", "raw"),
    "occlusion": (None, "occlusionTexture", "r", "raw"),
    "emissiveColor": (None, "emissiveTexture", "rgb", "sRGB"),
}
INPUT_TYPES = {"diffuseColor": Sdf.ValueTypeNames.Color3f, "emissiveColor": Sdf.ValueTypeNames.Color3f,
               "normal": Sdf.ValueTypeNames.Normal3f}
Types = Sdf.ValueTypeNames


class Converter:
    """Writes one file's prims into a layer."""

    def __init__(self, gltf: GltfFile, layer: Sdf.Layer, textures: Path):
        self.gltf = gltf
        self.layer = layer
        self.textures = textures
        self.written_images: dict[int, str] = {}
        self.materials: dict[int, str] = {}
        self.prototypes: dict[int, str] = {}
        self.uses = Counter(node.mesh for node in gltf.nodes if node.mesh is not None)

    def convert(self, up_axis: str) -> None:
        roots = [node for node in self.gltf.nodes if node.parent is None]
        if len(roots) != 1:
            raise GltfError(f"the scene has {len(roots)} roots, a floor has one")
        # One change block: without it USD recomposes after each of some ten thousand edits.
        with Sdf.ChangeBlock():
            root = self.prim(self.layer.pseudoRoot, valid_name(roots[0].name), "Xform")
            self.layer.defaultPrim = root.name
            self.layer.pseudoRoot.SetInfo("metersPerUnit", 1.0)
            self.layer.pseudoRoot.SetInfo("upAxis", up_axis)
            names = Names({MATERIALS, PROTOTYPES})
            self.write_materials(root)
            self.write_prototypes(root)
            self.write_nodes(roots[0], root, names, up_axis)

    # --- tree ---

    def prim(self, parent: Sdf.PrimSpec, name: str, type_name: str, specifier=Sdf.SpecifierDef) -> Sdf.PrimSpec:
        return Sdf.PrimSpec(parent, name, specifier, type_name)

    def write_nodes(self, root: Node, root_prim: Sdf.PrimSpec, root_names: Names, up_axis: str) -> None:
        """Every node as an Xform, in the file's order."""
        prims = {root.index: (root_prim, root_names)}
        for node in self.gltf.nodes:
            if node is not root:
                parent, names = prims[node.parent.index]
                prims[node.index] = (self.prim(parent, names.take(node.name), "Xform"), Names({GEOMETRY}))
            prim = prims[node.index][0]
            describe(prim, node)
            place(prim, node.local, turned_up=node is root and up_axis == "Z")
            if node.mesh is not None:
                self.write_geometry(prim, node.mesh)

    def write_geometry(self, parent: Sdf.PrimSpec, mesh: int) -> None:
        """The node's mesh: a reference to its prototype if others share it."""
        geometry = self.prim(parent, GEOMETRY, "Xform")
        if mesh in self.prototypes:
            geometry.referenceList.prependedItems = [Sdf.Reference("", self.prototypes[mesh])]
            geometry.instanceable = True
        else:
            self.write_meshes(geometry, mesh, self.materials)

    # --- meshes ---

    def write_prototypes(self, root: Sdf.PrimSpec) -> None:
        """Every mesh that at least two nodes use, out of sight."""
        shared = sorted(mesh for mesh, count in self.uses.items() if count > 1)
        if not shared:
            return
        scope = self.prim(root, PROTOTYPES, "Scope", Sdf.SpecifierClass)
        names = Names()
        for mesh in shared:
            original = self.gltf.document["meshes"][mesh].get("name") or f"mesh{mesh}"
            prototype = self.prim(scope, names.take(original), "Xform")
            self.prototypes[mesh] = str(prototype.path)
            self.write_meshes(prototype, mesh, self.looks(prototype, mesh))

    def looks(self, prototype: Sdf.PrimSpec, mesh: int) -> dict[int, str]:
        """The mesh's materials inside its prototype: a binding may not point out of what is referenced."""
        used = {primitive["material"] for primitive in self.gltf.primitives(mesh)} - {None}
        if not used:
            return {}
        scope, looks = self.prim(prototype, MATERIALS, "Scope"), {}
        for material in sorted(used):
            original = Sdf.Path(self.materials[material])
            look = self.prim(scope, original.name, "Material")
            look.referenceList.prependedItems = [Sdf.Reference("", original)]
            looks[material] = str(look.path)
        return looks

    def write_meshes(self, parent: Sdf.PrimSpec, mesh: int, materials: dict[int, str]) -> None:
        """One Mesh per primitive."""
        for number, primitive in enumerate(self.gltf.primitives(mesh)):
            prim = self.prim(parent, f"part{number}", "Mesh")
            positions = primitive["positions"].astype(np.float32)
            triangles = primitive["triangles"]
            attribute(prim, "points", Types.Point3fArray, Vt.Vec3fArray.FromNumpy(positions))
            attribute(prim, "extent", Types.Float3Array,
                      Vt.Vec3fArray.FromNumpy(np.stack([positions.min(axis=0), positions.max(axis=0)])))
            counts = np.full(len(triangles), 3, np.int32)
            attribute(prim, "faceVertexCounts", Types.IntArray, Vt.IntArray.FromNumpy(counts))
            indices = np.ascontiguousarray(triangles.reshape(-1), np.int32)
            attribute(prim, "faceVertexIndices", Types.IntArray, Vt.IntArray.FromNumpy(indices))
            attribute(prim, "subdivisionScheme", Types.Token, "none", is_uniform=True)
            self.write_surface(prim, primitive, materials)

    def write_surface(self, prim: Sdf.PrimSpec, primitive: dict, materials: dict[int, str]) -> None:
        """Normals, texture coordinates and material of a Mesh."""
        if primitive["normals"] is not None:
            normals = np.ascontiguousarray(primitive["normals"], np.float32)
            spec = attribute(prim, "normals", Types.Normal3fArray, Vt.Vec3fArray.FromNumpy(normals))
            spec.SetInfo("interpolation", UsdGeom.Tokens.vertex)
        if primitive["coordinates"] is not None:
            # USD's texture coordinates begin at the lower left, glTF's at the upper left.
            flipped = np.ascontiguousarray(primitive["coordinates"] * [1, -1] + [0, 1], np.float32)
            spec = attribute(prim, "primvars:st", Types.TexCoord2fArray, Vt.Vec2fArray.FromNumpy(flipped))
            spec.SetInfo("interpolation", UsdGeom.Tokens.vertex)
        if primitive["material"] is not None:
            material = primitive["material"]
            prim.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=["MaterialBindingAPI"]))
            binding = Sdf.RelationshipSpec(prim, "material:binding", custom=False)
            binding.targetPathList.explicitItems = [Sdf.Path(materials[material])]
            if self.gltf.document["materials"][material].get("doubleSided"):
                attribute(prim, "doubleSided", Types.Bool, True, is_uniform=True)

    # --- materials ---

    def write_materials(self, root: Sdf.PrimSpec) -> None:
        listed = self.gltf.document.get("materials", [])
        if not listed:
            return
        scope, names = self.prim(root, MATERIALS, "Scope"), Names()
        for number, material in enumerate(listed):
            name = names.take(material.get("name") or f"material{number}")
            prim = self.prim(scope, name, "Material")
            prim.SetInfo("displayName", material.get("name", name))
            self.materials[number] = str(prim.path)
            self.write_shader(prim, material)

    def write_shader(self, prim: Sdf.PrimSpec, material: dict) -> None:
        """A UsdPreviewSurface with the material's factors, and readers for its textures."""
        shader = self.prim(prim, "surface", "Shader")
        attribute(shader, "info:id", Types.Token, "UsdPreviewSurface", is_uniform=True)
        for name, (kind, value) in surface_inputs(material).items():
            attribute(shader, f"inputs:{name}", kind, value)
        if "alphaCutoff" in material or material.get("alphaMode") == "MASK":
            attribute(shader, "inputs:opacityThreshold", Types.Float, material.get("alphaCutoff", 0.5))
        attribute(shader, "outputs:surface", Types.Token, None)
        output = attribute(prim, "outputs:surface", Types.Token, None)
        output.connectionPathList.explicitItems = [shader.path.AppendProperty("outputs:surface")]
        for name, (group, key, channel, space) in TEXTURE_INPUTS.items():
            holder = material.get(group, {}) if group else material
            if key in holder:
                self.write_texture(prim, shader, name, self.texture_file(holder[key]["index"]), channel, space)

    def write_texture(self, prim, shader, name: str, file: str, channel: str, space: str) -> None:
        """Reads a texture with the mesh's coordinates into an input of the shader."""
        coordinates = f"{prim.path}/coordinates"
        if not self.layer.GetPrimAtPath(coordinates):
            reader = self.prim(prim, "coordinates", "Shader")
            attribute(reader, "info:id", Types.Token, "UsdPrimvarReader_float2", is_uniform=True)
            attribute(reader, "inputs:varname", Types.String, "st")
            attribute(reader, "outputs:result", Types.Float2, None)
        texture = self.prim(prim, f"{name}Texture", "Shader")
        attribute(texture, "info:id", Types.Token, "UsdUVTexture", is_uniform=True)
        attribute(texture, "inputs:file", Types.Asset, Sdf.AssetPath(file))
        attribute(texture, "inputs:sourceColorSpace", Types.Token, space)
        for wrap in ("inputs:wrapS", "inputs:wrapT"):
            attribute(texture, wrap, Types.Token, "repeat")
        if name == "normal":
            attribute(texture, "inputs:scale", Types.Float4, Gf.Vec4f(2, 2, 2, 1))
            attribute(texture, "inputs:bias", Types.Float4, Gf.Vec4f(-1, -1, -1, 0))
        st = attribute(texture, "inputs:st", Types.Float2, None)
        st.connectionPathList.explicitItems = [Sdf.Path(f"{coordinates}.outputs:result")]
        attribute(texture, f"outputs:{channel}", Types.Float3 if channel == "rgb" else Types.Float, None)
        spec = shader.properties.get(f"inputs:{name}") or attribute(
            shader, f"inputs:{name}", INPUT_TYPES.get(name, Types.Float), None)
        spec.connectionPathList.explicitItems = [texture.path.AppendProperty(f"outputs:{channel}")]

    def texture_file(self, texture: int) -> str:
        """Writes the image of a texture beside the layer; its path relative to the layer."""
        image = self.gltf.document["textures"][texture]["source"]
        if image not in self.written_images:
            data, ending = self.gltf.image(image)
            self.textures.mkdir(parents=True, exist_ok=True)
            (self.textures / f"image{image}{ending}").write_bytes(data)
            self.written_images[image] = f"./{self.textures.name}/image{image}{ending}"
        return self.written_images[image]


class Names:
    """Valid names, unique among the children of one prim."""

    def __init__(self, taken: set[str] | None = None):
        self.taken = set(taken or ())

    def take(self, original: str) -> str:
        base = valid_name(original)
        name, number = base, 2
        while name in self.taken:
            name, number = f"{base}_{number}", number + 1
        self.taken.add(name)
        return name


def valid_name(original: str) -> str:
    return Tf.MakeValidIdentifier(original) if original else "unnamed"


def attribute(prim: Sdf.PrimSpec, name: str, kind, value, is_uniform: bool = False) -> Sdf.AttributeSpec:
    variability = Sdf.VariabilityUniform if is_uniform else Sdf.VariabilityVarying
    spec = Sdf.AttributeSpec(prim, name, kind, variability)
    if value is not None:
        spec.default = value
    return spec


def describe(prim: Sdf.PrimSpec, node: Node) -> None:
    """Name, kind and extras of a node."""
    prim.SetInfo("displayName", node.name)
    extras = {key: usd_value(value) for key, value in node.extras.items()}
    if "seed" in extras:
        # Seeds use all of 64 bits, which a signed integer does not hold; one type for all of them.
        extras["seed"] = str(node.extras["seed"])
    prim.SetInfo("customData", {"name": node.name, **extras})
    kind = prim_kind(node)
    if kind:
        prim.kind = kind


def prim_kind(node: Node) -> str | None:
    if node.kind == "level":
        return Kind.Tokens.assembly
    if node.kind == "room":
        return Kind.Tokens.group
    if node.kind in ("opening", "part", "furniture"):
        # A component holds no other models, so what stands on one or belongs to it is a part of it.
        nested = node.parent is not None and node.parent.kind not in ("level", "room")
        return Kind.Tokens.subcomponent if nested else Kind.Tokens.component
    return None


def usd_value(value):
    """A value that a USD dictionary can hold; what it cannot hold becomes JSON text."""
    if isinstance(value, (bool, str, int, float)):
        return value
    if isinstance(value, list) and value and all(isinstance(item, str) for item in value):
        return Vt.StringArray(value)
    if isinstance(value, list) and value and all(type(item) in (int, float) for item in value):
        return Vt.DoubleArray([float(item) for item in value])
    return json.dumps(value, sort_keys=True)


def place(prim: Sdf.PrimSpec, local: np.ndarray, turned_up: bool) -> None:
    """The transform of a prim; `turned_up` lays the Y-up tree into a Z-up stage."""
    matrix = Gf.Matrix4d(*local.T.reshape(-1).tolist())
    order = []
    if turned_up:
        attribute(prim, "xformOp:rotateX:up", Types.Float, 90.0)
        order.append("xformOp:rotateX:up")
    if matrix != Gf.Matrix4d(1.0):
        attribute(prim, "xformOp:transform", Types.Matrix4d, matrix)
        order.append("xformOp:transform")
    if order:
        attribute(prim, "xformOpOrder", Types.TokenArray, Vt.TokenArray(order), is_uniform=True)


def surface_inputs(material: dict) -> dict[str, tuple]:
    """The inputs of a UsdPreviewSurface: type and value by name."""
    factors = material.get("pbrMetallicRoughness", {})
    red, green, blue, alpha = factors.get("baseColorFactor", (1.0, 1.0, 1.0, 1.0))
    transmission = material.get("extensions", {}).get("KHR_materials_transmission", {}).get("transmissionFactor", 0.0)
    is_opaque = material.get("alphaMode", "OPAQUE") == "OPAQUE"
    opacity = (1.0 if is_opaque else alpha) * max(LEAST_OPACITY, 1.0 - transmission)
    inputs = {
        "diffuseColor": (Types.Color3f, Gf.Vec3f(red, green, blue)),
        "metallic": (Types.Float, factors.get("metallicFactor", 1.0)),
        "roughness": (Types.Float, factors.get("roughnessFactor", 1.0)),
        "opacity": (Types.Float, opacity),
    }
    emissive = material.get("emissiveFactor", (0.0, 0.0, 0.0))
    if any(emissive):
        strength = material.get("extensions", {}).get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)
        inputs["emissiveColor"] = (Types.Color3f, Gf.Vec3f(*(part * strength for part in emissive)))
    return inputs


# --- running ---


def convert_file(source: Path, target: Path, up_axis: str) -> str:
    """Converts one file; the answer is empty, or says what went wrong."""
    # The name is new and the rename last, so that a file is there whole or not at all.
    unfinished = target.with_name(f".{target.stem}.{os.getpid()}{target.suffix}")
    try:
        layer = Sdf.Layer.CreateAnonymous(target.suffix)
        Converter(GltfFile(source), layer, target.with_suffix(".textures")).convert(up_axis)
        target.parent.mkdir(parents=True, exist_ok=True)
        if not layer.Export(str(unfinished)):
            return f"{source}: cannot write {target}"
        os.replace(unfinished, target)
        return ""
    except (GltfError, OSError, KeyError, IndexError, TypeError, ValueError, Tf.ErrorException) as error:
        return f"{source}: {type(error).__name__}: {error}"
    finally:
        unfinished.unlink(missing_ok=True)


def jobs_of(paths: list[Path], out: Path | None, ending: str) -> list[tuple[Path, Path]]:
    """Every source with its target."""
    pairs = []
    for path in paths:
        if path.is_dir():
            sources = sorted(file for file in path.rglob("*") if file.suffix.lower() in SCENE_ENDINGS)
            base = path
        elif path.is_file() and path.suffix.lower() in SCENE_ENDINGS:
            sources, base = [path], path.parent
        else:
            raise FileNotFoundError(f"{path} is no folder, .glb or .gltf")
        for source in sources:
            target = source if out is None else out / source.relative_to(base)
            pairs.append((source, target.with_suffix(ending)))
    return pairs


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--out", type=Path, help="folder for the results (default: beside each source)")
    parser.add_argument("--format", choices=("usdc", "usda"), default="usdc", help="binary or text")
    parser.add_argument("--up-axis", choices=("Y", "Z"), default="Y")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        pairs = jobs_of(options.paths, options.out, f".{options.format}")
    except OSError as error:
        print(f"convert: {error}", file=sys.stderr)
        return 2
    if not pairs:
        print("convert: no .glb or .gltf there", file=sys.stderr)
        return 2
    failed = 0
    with ProcessPoolExecutor(max_workers=max(1, options.jobs)) as pool:
        sources, targets = zip(*pairs)
        answers = pool.map(convert_file, sources, targets, repeat(options.up_axis))
        for number, (target, answer) in enumerate(zip(targets, answers), start=1):
            failed += bool(answer)
            print(answer or target, file=sys.stderr if answer else sys.stdout)
            if number % max(1, len(pairs) // 20) == 0:
                print(f"convert: {number} of {len(pairs)} files, {failed} failed", file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
