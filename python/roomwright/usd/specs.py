"""Prims, attributes and relationships of a layer.

Specs are written without a stage: a stage composes the scene again after every edit.
"""

from __future__ import annotations

from pxr import Sdf, Vt

Types = Sdf.ValueTypeNames


def new_prim(parent: Sdf.PrimSpec, name: str, type_name: str, specifier=Sdf.SpecifierDef) -> Sdf.PrimSpec:
    return Sdf.PrimSpec(parent, name, specifier, type_name)


def attribute(prim: Sdf.PrimSpec, name: str, kind, value, is_uniform: bool = False) -> Sdf.AttributeSpec:
    """Declares an attribute; `value` may be none."""
    variability = Sdf.VariabilityUniform if is_uniform else Sdf.VariabilityVarying
    spec = Sdf.AttributeSpec(prim, name, kind, variability)
    if value is not None:
        spec.default = value
    return spec


def relationship(prim: Sdf.PrimSpec, name: str, targets: list[str]) -> Sdf.RelationshipSpec:
    spec = Sdf.RelationshipSpec(prim, name, custom=False)
    spec.targetPathList.explicitItems = [Sdf.Path(target) for target in targets]
    return spec


def apply_schemas(prim: Sdf.PrimSpec, *names: str) -> None:
    """Adds API schemas after those that the prim has."""
    known = prim.GetInfo("apiSchemas").prependedItems if prim.HasInfo("apiSchemas") else []
    prim.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=[*known, *names]))


def transform_order(prim: Sdf.PrimSpec, operations: list[str]) -> None:
    if operations:
        attribute(prim, "xformOpOrder", Types.TokenArray, Vt.TokenArray(operations), is_uniform=True)


def refer(prim: Sdf.PrimSpec, asset: str, path: str) -> None:
    """References a prim of a file, or of this layer if `asset` is empty."""
    prim.referenceList.prependedItems = [Sdf.Reference(asset, path)]


def inherit(prim: Sdf.PrimSpec, path: Sdf.Path) -> None:
    """Gives a prim everything that a class has; what the class targets outside of itself stays where it is."""
    prim.inheritPathList.prependedItems = [path]


def add_variants(prim: Sdf.PrimSpec, name: str, variants: list[str], selected: str | None) -> dict[str, Sdf.PrimSpec]:
    """A set of variants; the prims that hold their opinions, by name. Something else may select one."""
    prim.variantSetNameList.prependedItems = [*prim.variantSetNameList.prependedItems, name]
    if selected is not None:
        prim.variantSelections[name] = selected
    variant_set = Sdf.VariantSetSpec(prim, name)
    return {variant: Sdf.VariantSpec(variant_set, variant).primSpec for variant in variants}
