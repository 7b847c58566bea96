"""Names, kinds, extras and labels of nodes.

Each node has its extras twice: in its customData, which keeps lists as lists, and as attributes `userProperties:`. Blender
and other programs read users' properties there, and take numbers, texts and up to four numbers together.
"""

from __future__ import annotations

import json
from functools import cache

from pxr import Gf, Kind, Sdf, Tf, Vt

from ..gltf_file import Node

from .specs import Types, apply_schemas, attribute

SIMPLE = {bool, str, int, float}
PROPERTY_TYPES = {bool: Types.Bool, str: Types.String, int: Types.Int, float: Types.Double}
VECTORS = {2: (Types.Double2, Gf.Vec2d), 3: (Types.Double3, Gf.Vec3d), 4: (Types.Double4, Gf.Vec4d)}
# Which of a node's extras name it for who trains on pictures: taxonomy and field, by kind.
LABELS = {
    "level": ("building", "building"),
    "room": ("room", "type"),
    "opening": ("class", "opening"),
    "part": ("class", "part"),
    "furniture": ("class", "class"),
}


def describe(prim: Sdf.PrimSpec, node: Node) -> None:
    """Name, kind, extras and label of a node."""
    prim.SetInfo("displayName", node.name)
    prim.SetInfo("customData", custom_data(node))
    write_properties(prim, node)
    kind = prim_kind(node)
    if kind:
        prim.kind = kind
    label(prim, node)


def custom_data(node: Node) -> dict:
    """The name and the extras."""
    extras = {key: usd_value(value) for key, value in node.extras.items()}
    if "seed" in extras:
        # Seeds use all of 64 bits, which a signed integer does not hold; one type for all of them.
        extras["seed"] = str(node.extras["seed"])
    return {"name": node.name, **extras}


def write_properties(prim: Sdf.PrimSpec, node: Node) -> None:
    """The name and the extras as attributes of users."""
    names: set[str] = set()
    for key, value in {"name": node.name, **node.extras}.items():
        kind, value = property_value(str(value) if key == "seed" else value)
        name = property_name(key)
        # Keys that become equal: the first stays.
        if value is not None and name not in names:
            names.add(name)
            Sdf.AttributeSpec(prim, name, kind, declaresCustom=True).default = value


@cache
def property_name(key: str) -> str:
    return f"userProperties:{Tf.MakeValidIdentifier(key)}"


def property_value(value) -> tuple:
    """Type and value of an attribute; nothing for nothing, and JSON text for what no attribute of one value holds."""
    if value is None:
        return Types.String, None
    if type(value) is int and not -2**31 <= value < 2**31:
        value = str(value)
    if type(value) in PROPERTY_TYPES:
        return PROPERTY_TYPES[type(value)], value
    if isinstance(value, list) and len(value) in VECTORS and all(type(item) in (int, float) for item in value):
        kind, vector = VECTORS[len(value)]
        return kind, vector(*(float(item) for item in value))
    return Types.String, json.dumps(value, sort_keys=True)


def label(prim: Sdf.PrimSpec, node: Node) -> None:
    """UsdSemantics labels of the node: taxonomies `class`, `room` and `building`."""
    taxonomy, field = LABELS.get(node.kind, ("", ""))
    if field in node.extras:
        apply_schemas(prim, f"SemanticsLabelsAPI:{taxonomy}")
        attribute(prim, f"semantics:labels:{taxonomy}", Types.TokenArray, Vt.TokenArray([str(node.extras[field])]))


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
    if type(value) in SIMPLE:
        return value
    if isinstance(value, list) and value and all(isinstance(item, str) for item in value):
        return Vt.StringArray(value)
    if isinstance(value, list) and value and all(type(item) in (int, float) for item in value):
        return Vt.DoubleArray([float(item) for item in value])
    return json.dumps(value, sort_keys=True)
