"""Meshes: triangles, normals, texture coordinates, and the parts of a mesh that have materials of their own.

All primitives of a glTF mesh are one Mesh here, as a glTF importer makes of them, and each is a subset of its faces. A
mesh of one primitive has no subsets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from pxr import Sdf, UsdGeom, Vt

from ..gltf_file import GltfFile

from .materials import Materials
from .naming import coordinate_name
from .specs import Types, apply_schemas, attribute, new_prim, relationship

BINDING = "material:binding"
# Square metres twice: a face with less has no normal.
NO_AREA = 1e-12


@dataclass(frozen=True)
class Joined:
    """The primitives of a mesh as one."""

    positions: np.ndarray  # n x 3, metres
    triangles: np.ndarray  # m x 3, corners
    normals: np.ndarray
    interpolation: str  # of the normals: one for each corner, for each face, or for each corner of each face
    coordinates: list[np.ndarray]  # n x 2 for each set
    sizes: list[int]  # triangles of each primitive


def write_mesh(prim: Sdf.PrimSpec, gltf: GltfFile, mesh: int, materials: Materials) -> None:
    """Everything of a mesh but its materials into a Mesh prim."""
    primitives = gltf.primitives(mesh)
    joined = join(primitives)
    write_triangles(prim, joined)
    write_surface(prim, joined)
    used = {primitive["material"] for primitive in primitives} - {None}
    if any(materials.is_double_sided(material) for material in used):
        attribute(prim, "doubleSided", Types.Bool, True, is_uniform=True)
    if len(primitives) > 1:
        write_subsets(prim, joined.sizes)


def part_of(mesh: Sdf.PrimSpec, number: int, count: int) -> Sdf.PrimSpec:
    """The prim of one of so many primitives: a subset of the mesh, said more about where it is not defined here."""
    name = f"part{number}"
    if count == 1:
        return mesh
    return mesh.nameChildren[name] if name in mesh.nameChildren else new_prim(mesh, name, "", Sdf.SpecifierOver)


def bind(part: Sdf.PrimSpec, material: str) -> None:
    apply_schemas(part, "MaterialBindingAPI")
    relationship(part, BINDING, [material])


# --- one of many ---


def join(primitives: list[dict]) -> Joined:
    """The primitives' corners and triangles after each other."""
    starts = np.cumsum([0] + [len(primitive["positions"]) for primitive in primitives])
    positions = np.concatenate([primitive["positions"] for primitive in primitives]).astype(np.float32)
    triangles = np.concatenate([primitive["triangles"] + start for primitive, start in zip(primitives, starts)])
    normals, interpolation = join_normals(primitives, positions, triangles)
    sets = max(len(primitive["coordinates"]) for primitive in primitives)
    coordinates = [np.concatenate([coordinates_of(primitive, number) for primitive in primitives])
                   for number in range(sets)]
    return Joined(positions, triangles, normals, interpolation, coordinates,
                  [len(primitive["triangles"]) for primitive in primitives])


def join_normals(primitives: list[dict], positions: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, str]:
    """Primitives without normals are flat (glTF 2.0, 3.7.2.1); USD leaves that to readers, so theirs are written."""
    own = [primitive["normals"] for primitive in primitives]
    if all(normals is not None for normals in own):
        return np.concatenate(own), UsdGeom.Tokens.vertex
    flat = face_normals(positions, triangles)
    if all(normals is None for normals in own):
        return flat, UsdGeom.Tokens.uniform
    of_corners, first = np.repeat(flat, 3, axis=0).reshape(-1, 3, 3), 0
    for primitive, normals in zip(primitives, own):
        last = first + len(primitive["triangles"])
        if normals is not None:
            of_corners[first:last] = normals[primitive["triangles"]]
        first = last
    return of_corners.reshape(-1, 3), UsdGeom.Tokens.faceVarying


def face_normals(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    ring = positions.astype(float)[triangles]
    normals = np.cross(ring[:, 1] - ring[:, 0], ring[:, 2] - ring[:, 0])
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), NO_AREA)


def coordinates_of(primitive: dict, number: int) -> np.ndarray:
    """A set of a primitive's texture coordinates; the origin for a primitive that has fewer sets than others."""
    sets = primitive["coordinates"]
    return sets[number] if number < len(sets) else np.zeros((len(primitive["positions"]), 2), np.float32)


# --- attributes ---


def write_triangles(prim: Sdf.PrimSpec, joined: Joined) -> None:
    attribute(prim, "points", Types.Point3fArray, Vt.Vec3fArray.FromNumpy(joined.positions))
    bounds = np.stack([joined.positions.min(axis=0), joined.positions.max(axis=0)])
    attribute(prim, "extent", Types.Float3Array, Vt.Vec3fArray.FromNumpy(bounds))
    counts = np.full(len(joined.triangles), 3, np.int32)
    attribute(prim, "faceVertexCounts", Types.IntArray, Vt.IntArray.FromNumpy(counts))
    indices = np.ascontiguousarray(joined.triangles.reshape(-1), np.int32)
    attribute(prim, "faceVertexIndices", Types.IntArray, Vt.IntArray.FromNumpy(indices))
    attribute(prim, "subdivisionScheme", Types.Token, "none", is_uniform=True)


def write_surface(prim: Sdf.PrimSpec, joined: Joined) -> None:
    """Normals and texture coordinates."""
    normals = np.ascontiguousarray(joined.normals, np.float32)
    spec = attribute(prim, "normals", Types.Normal3fArray, Vt.Vec3fArray.FromNumpy(normals))
    spec.SetInfo("interpolation", joined.interpolation)
    for number, coordinates in enumerate(joined.coordinates):
        # USD's texture coordinates begin at the lower left, glTF's at the upper left.
        flipped = np.ascontiguousarray(coordinates * [1, -1] + [0, 1], np.float32)
        name = f"primvars:{coordinate_name(number)}"
        spec = attribute(prim, name, Types.TexCoord2fArray, Vt.Vec2fArray.FromNumpy(flipped))
        spec.SetInfo("interpolation", UsdGeom.Tokens.vertex)


def write_subsets(prim: Sdf.PrimSpec, sizes: list[int]) -> None:
    """Every face belongs to the subset of its primitive."""
    attribute(prim, "subsetFamily:materialBind:familyType", Types.Token, UsdGeom.Tokens.partition, is_uniform=True)
    first = 0
    for number, size in enumerate(sizes):
        subset = new_prim(prim, f"part{number}", "GeomSubset")
        attribute(subset, "elementType", Types.Token, UsdGeom.Tokens.face, is_uniform=True)
        attribute(subset, "familyName", Types.Token, "materialBind", is_uniform=True)
        indices = np.arange(first, first + size, dtype=np.int32)
        attribute(subset, "indices", Types.IntArray, Vt.IntArray.FromNumpy(indices))
        first += size
