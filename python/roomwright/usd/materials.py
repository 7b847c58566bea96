"""Materials as UsdPreviewSurface."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from pxr import Gf, Sdf

from ..gltf_file import GltfFile

from .naming import Names, coordinate_name
from .specs import Types, attribute, new_prim
from .textures import Textures

MATERIALS = "Materials"
# The least opacity of a clear material, so that glass is visible at all.
LEAST_OPACITY = 0.1
INPUT_TYPES = {"diffuseColor": Types.Color3f, "emissiveColor": Types.Color3f, "normal": Types.Normal3f}


class Reader(NamedTuple):
    """How an input of the surface reads a texture of a glTF material."""

    group: str | None  # of the material that holds the texture
    key: str
    channel: str
    space: str


READERS = {
    "diffuseColor": Reader("pbrMetallicRoughness", "baseColorTexture", "rgb", "sRGB"),
    "metallic": Reader("pbrMetallicRoughness", "metallicRoughnessTexture", "b", "raw"),
    "roughness": Reader("pbrMetallicRoughness", "metallicRoughnessTexture", "g", "raw"),
    "normal": Reader(None, "normalTexture", "rgb", "raw"),
    "occlusion": Reader(None, "occlusionTexture", "r", "raw"),
    "emissiveColor": Reader(None, "emissiveTexture", "rgb", "sRGB"),
}


class Materials:
    """The materials of a glTF file below one prim, each written when it is first asked for.

    With `originals` of another layer of the same folder they are copies: many models have the same wood, and a copy
    takes a tenth of the time.
    """

    def __init__(self, owner: Sdf.PrimSpec, gltf: GltfFile, textures: Textures, folder: Path,
                 originals: Materials | None = None):
        """`folder` is the layer's."""
        self.owner = owner
        self.gltf = gltf
        self.textures = textures
        self.folder = folder
        self.originals = originals
        self.names = Names()
        self.scope: Sdf.PrimSpec | None = None
        self.paths: dict[int, str] = {}

    def path(self, number: int) -> str:
        if number not in self.paths:
            if self.scope is None:
                # Without a type: importers make an object of a Scope.
                self.scope = new_prim(self.owner, MATERIALS, "")
            material = self.gltf.entry("materials", number)
            original = self.gltf.name_of("materials", number) or f"material{number}"
            prim = new_prim(self.scope, self.names.take(original), "Material")
            self.paths[number] = str(prim.path)
            if self.originals is not None:
                Sdf.CopySpec(self.originals.owner.layer, self.originals.path(number), prim.layer, prim.path)
                return self.paths[number]
            prim.SetInfo("displayName", original)
            self.write_surface(prim, material)
        return self.paths[number]

    def is_double_sided(self, number: int) -> bool:
        return bool(self.gltf.entry("materials", number).get("doubleSided"))

    def write_surface(self, prim: Sdf.PrimSpec, material: dict) -> None:
        """A UsdPreviewSurface with the material's factors, and readers for its textures."""
        shader = new_prim(prim, "surface", "Shader")
        attribute(shader, "info:id", Types.Token, "UsdPreviewSurface", is_uniform=True)
        for name, (kind, value) in surface_inputs(material).items():
            attribute(shader, f"inputs:{name}", kind, value)
        attribute(shader, "outputs:surface", Types.Token, None)
        output = attribute(prim, "outputs:surface", Types.Token, None)
        output.connectionPathList.explicitItems = [shader.path.AppendProperty("outputs:surface")]
        for name, reader in READERS.items():
            holder = material.get(reader.group, {}) if reader.group else material
            if reader.key in holder:
                self.write_texture(prim, shader, name, holder[reader.key])
                self.scale_texture(prim.nameChildren[f"{name}Texture"], name, material)
        if not is_opaque(material) and "diffuseColorTexture" in prim.nameChildren:
            self.connect_opacity(prim.nameChildren["diffuseColorTexture"], shader)

    def connect_opacity(self, texture: Sdf.PrimSpec, shader: Sdf.PrimSpec) -> None:
        """Holes and clear places are in the alpha of the base colour."""
        attribute(texture, "outputs:a", Types.Float, None)
        opacity = shader.properties["inputs:opacity"]
        opacity.connectionPathList.explicitItems = [texture.path.AppendProperty("outputs:a")]

    def write_texture(self, prim: Sdf.PrimSpec, shader: Sdf.PrimSpec, name: str, used: dict) -> None:
        """Reads a texture with the mesh's coordinates into an input of the shader."""
        reader = READERS[name]
        texture = new_prim(prim, f"{name}Texture", "Shader")
        attribute(texture, "info:id", Types.Token, "UsdUVTexture", is_uniform=True)
        file = self.textures.path(used["index"], self.folder)
        attribute(texture, "inputs:file", Types.Asset, Sdf.AssetPath(file))
        attribute(texture, "inputs:sourceColorSpace", Types.Token, reader.space)
        for wrap in ("inputs:wrapS", "inputs:wrapT"):
            attribute(texture, wrap, Types.Token, "repeat")
        coordinates = attribute(texture, "inputs:st", Types.Float2, None)
        coordinates.connectionPathList.explicitItems = [self.coordinates(prim, used.get("texCoord", 0))]
        attribute(texture, f"outputs:{reader.channel}", Types.Float3 if reader.channel == "rgb" else Types.Float, None)
        spec = shader.properties.get(f"inputs:{name}") or attribute(
            shader, f"inputs:{name}", INPUT_TYPES.get(name, Types.Float), None)
        spec.connectionPathList.explicitItems = [texture.path.AppendProperty(f"outputs:{reader.channel}")]

    def coordinates(self, prim: Sdf.PrimSpec, number: int) -> Sdf.Path:
        """The output that reads a set of the mesh's texture coordinates; one for all textures that share the set."""
        name = f"coordinates{number or ''}"
        if name not in prim.nameChildren:
            reader = new_prim(prim, name, "Shader")
            attribute(reader, "info:id", Types.Token, "UsdPrimvarReader_float2", is_uniform=True)
            attribute(reader, "inputs:varname", Types.String, coordinate_name(number))
            attribute(reader, "outputs:result", Types.Float2, None)
        return prim.path.AppendChild(name).AppendProperty("outputs:result")

    def scale_texture(self, texture: Sdf.PrimSpec, name: str, material: dict) -> None:
        """glTF multiplies a texture with its factor; a connected input of a UsdPreviewSurface has the texture alone."""
        scale, bias = texture_scale(name, material), None
        if name == "normal":
            # From colours to directions: 0 to 1 becomes -1 to 1. UsdPreviewSurface prescribes these figures: normals that glTF
            # flattens by `scale` are as deep as in the image.
            scale, bias = [2.0, 2.0, 2.0, 1.0], Gf.Vec4f(-1.0, -1.0, -1.0, 0.0)
        if bias is not None or any(part != 1.0 for part in scale):
            attribute(texture, "inputs:scale", Types.Float4, Gf.Vec4f(*scale))
        if bias is not None:
            attribute(texture, "inputs:bias", Types.Float4, bias)


def texture_scale(name: str, material: dict) -> list[float]:
    """The factors of a texture's four channels."""
    factors = material.get("pbrMetallicRoughness", {})
    if name == "diffuseColor":
        opacity = 1.0 if is_opaque(material) else opacity_of(material)
        return [*list(factors.get("baseColorFactor", (1.0, 1.0, 1.0)))[:3], opacity]
    if name == "emissiveColor":
        return [*emission(material), 1.0]
    if name == "occlusion":
        return [1.0] * 4
    return [1.0, factors.get("roughnessFactor", 1.0), factors.get("metallicFactor", 1.0), 1.0]


def surface_inputs(material: dict) -> dict[str, tuple]:
    """The inputs of a UsdPreviewSurface: type and value by name."""
    factors = material.get("pbrMetallicRoughness", {})
    red, green, blue, _ = factors.get("baseColorFactor", (1.0, 1.0, 1.0, 1.0))
    inputs = {
        "diffuseColor": (Types.Color3f, Gf.Vec3f(red, green, blue)),
        "metallic": (Types.Float, factors.get("metallicFactor", 1.0)),
        "roughness": (Types.Float, factors.get("roughnessFactor", 1.0)),
        "opacity": (Types.Float, opacity_of(material)),
    }
    if any(emission(material)):
        inputs["emissiveColor"] = (Types.Color3f, Gf.Vec3f(*emission(material)))
    if "alphaCutoff" in material or material.get("alphaMode") == "MASK":
        inputs["opacityThreshold"] = (Types.Float, material.get("alphaCutoff", 0.5))
    return inputs


def is_opaque(material: dict) -> bool:
    return material.get("alphaMode", "OPAQUE") == "OPAQUE"


def opacity_of(material: dict) -> float:
    """Alpha, and what transmission leaves: a UsdPreviewSurface knows nothing between clear and opaque."""
    alpha = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", (1.0, 1.0, 1.0, 1.0))[3]
    transmission = material.get("extensions", {}).get("KHR_materials_transmission", {}).get("transmissionFactor", 0.0)
    return (1.0 if is_opaque(material) else alpha) * max(LEAST_OPACITY, 1.0 - transmission)


def emission(material: dict) -> list[float]:
    extension = material.get("extensions", {}).get("KHR_materials_emissive_strength", {})
    return [part * extension.get("emissiveStrength", 1.0) for part in material.get("emissiveFactor", (0.0, 0.0, 0.0))]
