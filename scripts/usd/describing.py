"""Names, kinds, extras and labels of nodes."""

from __future__ import annotations

import json

from pxr import Kind, Sdf, Vt

from gltf_file import Node

from .specs import Types, apply_schemas, attribute

SIMPLE = {bool, str, int, float}
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


def label(prim: Sdf.PrimSpec, node: Node) -> None:
    """What the node is, as UsdSemantics says it: taxonomies `class`, `room` and `building`."""
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
