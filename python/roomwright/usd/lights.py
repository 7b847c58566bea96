"""Lamps: KHR_lights_punctual to UsdLux, and on request lights for lamps that have only lumens in their extras.

A point light of I candela in every direction becomes a sphere of radius r with the same luminous flux 4 pi I. UsdLux
gives the luminance of a light in nits (openusd.org, UsdLux, "Quantities and Units"): L = intensity * 2^exposure *
color, divided by the light's area where `normalize` is set. A sphere of luminance L has the luminous intensity
L pi r^2 from every side, and the area 4 pi r^2, so that with `normalize`

    I = intensity / (4 pi r^2) * pi r^2 = intensity / 4        intensity = 4 I = lumens / pi

whatever the radius. `colorTemperature` keeps the luminance (UsdLux normalises its colours to luminance 1), which a
glTF colour does not: lamps with lumens and kelvins in their extras get these, all others the glTF's
intensity and colour. A spot light is such a sphere in a cone: the glTF intensity is that of the cone's axis, as
here. A directional light of E lux is a DistantLight with `normalize`, whose intensity is in lux.

Intensities are photometric, pictures are not: renderers show a radiance of 1 as white, and a lamp's light on a wall is
some 30 nits. `exposure` converts between them, as a camera's does: at EXPOSURE a furnished room is neither dark nor
white in renderers at their defaults. For a camera with an exposure of its own, set it to 0.
"""

from __future__ import annotations

import math

from pxr import Gf, Sdf

from ..gltf_file import GltfFile, Node

from .specs import Types, apply_schemas, attribute, new_prim

EXTENSION = "KHR_lights_punctual"
# The keys of a lamp's extras that describe its light.
PHOTOMETRIC = {"lumens", "kelvin"}
# Metres: less than the 2 cm that lights keep from their lamps' boxes, so that no lamp shades its own light.
RADIUS = 0.015
# Stops, of every light: 1/32. Blender's Cycles draws the living room of the demo's house 0.52 bright on average then (0
# is black, 1 white; 48 samples, all else as Blender has it); 0.92 at 0, 0.73 at -3, 0.31 at -7.
EXPOSURE = -5.0
# Degrees of the sun's disc. A point has sharp shadows in glTF, and so has this nearly.
SUN_ANGLE = 0.53
TYPE_NAMES = {"point": "SphereLight", "spot": "SphereLight", "directional": "DistantLight"}


def light_of(gltf: GltfFile, node: Node, lights_lamps: bool = False) -> dict | None:
    """The light of a node: that of the file, or on request one with the lumens of the lamp's extras."""
    used = gltf.entry("nodes", node.index).get("extensions", {}).get(EXTENSION)
    if used is not None:
        return gltf.document["extensions"][EXTENSION]["lights"][used["light"]]
    return {"type": "point"} if lights_lamps and node.kind == "light" and PHOTOMETRIC <= node.extras.keys() else None


def light_name(node_name: str, node: Node) -> str:
    """The name of a light's prim below its node's: the node's own, unless the node's mesh has that."""
    return node_name if node.mesh is None else f"{node_name}_light"


def write_light(parent: Sdf.PrimSpec, name: str, light: dict, extras: dict) -> None:
    """A light below its node's prim."""
    prim = new_prim(parent, name, TYPE_NAMES[light["type"]])
    is_sun = light["type"] == "directional"
    intensity = light.get("intensity", 1.0) * (1.0 if is_sun else 4.0)
    if PHOTOMETRIC <= extras.keys() and light["type"] == "point":
        intensity = extras["lumens"] / math.pi
        attribute(prim, "inputs:enableColorTemperature", Types.Bool, True)
        attribute(prim, "inputs:colorTemperature", Types.Float, float(extras["kelvin"]))
    else:
        attribute(prim, "inputs:color", Types.Color3f, Gf.Vec3f(*light.get("color", (1.0, 1.0, 1.0))))
    attribute(prim, "inputs:intensity", Types.Float, float(intensity))
    attribute(prim, "inputs:exposure", Types.Float, EXPOSURE)
    attribute(prim, "inputs:normalize", Types.Bool, True)
    if is_sun:
        attribute(prim, "inputs:angle", Types.Float, SUN_ANGLE)
    else:
        attribute(prim, "inputs:radius", Types.Float, RADIUS)
        attribute(prim, "extent", Types.Float3Array, [Gf.Vec3f(-RADIUS), Gf.Vec3f(RADIUS)])
    if light["type"] == "spot":
        write_cone(prim, light.get("spot", {}))


def write_cone(prim: Sdf.PrimSpec, spot: dict) -> None:
    """Both formats shine along -Z. The edge is soft from the inner angle on."""
    outer, inner = spot.get("outerConeAngle", math.pi / 4), spot.get("innerConeAngle", 0.0)
    apply_schemas(prim, "ShapingAPI")
    attribute(prim, "inputs:shaping:cone:angle", Types.Float, math.degrees(outer))
    attribute(prim, "inputs:shaping:cone:softness", Types.Float, 1.0 - inner / outer)
