"""The parts of a mesh: triangles, normals, texture coordinates, bindings."""

from __future__ import annotations

import numpy as np
from pxr import Sdf, UsdGeom, Vt

from gltf_file import GltfFile

from .materials import Materials
from .naming import coordinate_name
from .specs import Types, apply_schemas, attribute, new_prim, relationship

BINDING = "material:binding"


def write_parts(parent: Sdf.PrimSpec, gltf: GltfFile, mesh: int, materials: Materials) -> list[Sdf.PrimSpec]:
    """One Mesh per primitive, without materials."""
    parts = []
    for number, primitive in enumerate(gltf.primitives(mesh)):
        part = new_prim(parent, f"part{number}", "Mesh")
        write_triangles(part, primitive)
        write_surface(part, primitive)
        material = primitive["material"]
        if material is not None and materials.is_double_sided(material):
            attribute(part, "doubleSided", Types.Bool, True, is_uniform=True)
        parts.append(part)
    return parts


def write_triangles(part: Sdf.PrimSpec, primitive: dict) -> None:
    positions = primitive["positions"].astype(np.float32)
    triangles = primitive["triangles"]
    attribute(part, "points", Types.Point3fArray, Vt.Vec3fArray.FromNumpy(positions))
    bounds = np.stack([positions.min(axis=0), positions.max(axis=0)])
    attribute(part, "extent", Types.Float3Array, Vt.Vec3fArray.FromNumpy(bounds))
    counts = np.full(len(triangles), 3, np.int32)
    attribute(part, "faceVertexCounts", Types.IntArray, Vt.IntArray.FromNumpy(counts))
    indices = np.ascontiguousarray(triangles.reshape(-1), np.int32)
    attribute(part, "faceVertexIndices", Types.IntArray, Vt.IntArray.FromNumpy(indices))
    attribute(part, "subdivisionScheme", Types.Token, "none", is_uniform=True)


def write_surface(part: Sdf.PrimSpec, primitive: dict) -> None:
    """Normals and texture coordinates."""
    if primitive["normals"] is not None:
        normals = np.ascontiguousarray(primitive["normals"], np.float32)
        spec = attribute(part, "normals", Types.Normal3fArray, Vt.Vec3fArray.FromNumpy(normals))
        spec.SetInfo("interpolation", UsdGeom.Tokens.vertex)
    for number, coordinates in enumerate(primitive["coordinates"]):
        # USD's texture coordinates begin at the lower left, glTF's at the upper left.
        flipped = np.ascontiguousarray(coordinates * [1, -1] + [0, 1], np.float32)
        name = f"primvars:{coordinate_name(number)}"
        spec = attribute(part, name, Types.TexCoord2fArray, Vt.Vec2fArray.FromNumpy(flipped))
        spec.SetInfo("interpolation", UsdGeom.Tokens.vertex)


def bind(part: Sdf.PrimSpec, material: str) -> None:
    apply_schemas(part, "MaterialBindingAPI")
    relationship(part, BINDING, [material])
