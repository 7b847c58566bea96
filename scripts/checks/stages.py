"""USD files: layers, stages of buildings and cities, packages.

Each is opened without its payloads, which are files of the same folder and judged as such, asked by all validators
that come with USD, and by the compliance checker where this USD has one. What a validator calls an error or a warning
is a fault here, as is a file that is named and not there, a path that is absolute, and what USD says while it composes.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from pxr import Ar, Sdf, Usd, UsdGeom, UsdShade, UsdUtils, UsdValidation

from .report import Fault, Note

ENDINGS = {".usd", ".usda", ".usdc", ".usdz"}
# The schemes that USD itself takes; a letter and a colon are a drive.
ABSOLUTE = re.compile(r"/|\\|[A-Za-z][A-Za-z0-9+.-]*:")


def check_stage(file: Path) -> tuple[list[Fault], Counter]:
    """Every check of one file, with counts for the report."""
    counts = Counter({"stages": 1})
    try:
        stage = Usd.Stage.Open(str(file), Usd.Stage.LoadNone)
        notes = list(check_layer(stage.GetRootLayer()))
        counts.update(prims=sum(1 for _ in stage.Traverse()))
        for check in (check_stage_metadata, check_composition, check_validators, check_textures):
            notes += check(stage)
        notes += check_compliance(file)
    except Exception as error:  # what a broken file can raise in USD has no end
        notes = [Note("file", "", f"cannot be opened: {one_line(error)}")]
    return [Fault(str(file), *note) for note in dict.fromkeys(notes)], counts


def check_layer(layer: Sdf.Layer) -> Iterator[Note]:
    """The files that a layer names itself: there, and by relative paths."""
    for path in sorted(layer.GetCompositionAssetDependencies()):
        # A reference inside of the layer names no file.
        if path:
            yield from check_path(layer, path)


def check_path(layer: Sdf.Layer, path: str) -> Iterator[Note]:
    if ABSOLUTE.match(path):
        yield Note("file", "", f"it names the absolute path {path!r}")
    elif not Ar.GetResolver().Resolve(layer.ComputeAbsolutePath(path)):
        yield Note("file", "", f"it names {path!r}, which is not there")


def check_stage_metadata(stage: Usd.Stage) -> Iterator[Note]:
    if not stage.GetDefaultPrim():
        yield Note("usd", "", "it has no default prim, so that nothing can reference it")
    if UsdGeom.GetStageMetersPerUnit(stage) != 1.0:
        yield Note("usd", "", f"a unit is {UsdGeom.GetStageMetersPerUnit(stage)} m, not 1")


def check_composition(stage: Usd.Stage) -> Iterator[Note]:
    for error in stage.GetCompositionErrors():
        yield Note("usd", "", one_line(error))


def check_validators(stage: Usd.Stage) -> Iterator[Note]:
    """All that the registry knows."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    for issue in UsdValidation.ValidationContext(validators).Validate(stage):
        if issue.GetType() in (UsdValidation.ValidationErrorType.Error, UsdValidation.ValidationErrorType.Warn):
            sites = [str(site.GetProperty().GetPath() if site.IsProperty() else site.GetPrim().GetPath())
                     for site in issue.GetSites() if site.IsPrim() or site.IsProperty()]
            yield Note("usd", sites[0] if sites else "", f"{issue.GetIdentifier()}: {issue.GetMessage()}")


def check_textures(stage: Usd.Stage) -> Iterator[Note]:
    """Images that materials read; instances are asked once, by the name of their first."""
    owners = [(stage.GetPseudoRoot(), Sdf.Path.absoluteRootPath)]
    owners += [(prototype, prototype.GetInstances()[0].GetPath()) for prototype in stage.GetPrototypes()]
    for owner, shown in owners:
        for prim in Usd.PrimRange(owner):
            if prim.GetTypeName() == "Shader":
                yield from check_shader(prim, str(prim.GetPath().ReplacePrefix(owner.GetPath(), shown)))


def check_shader(prim: Usd.Prim, shown: str) -> Iterator[Note]:
    for shader_input in UsdShade.Shader(prim).GetInputs():
        value = shader_input.Get()
        if not isinstance(value, Sdf.AssetPath) or not value.path:
            continue
        if ABSOLUTE.match(value.path):
            yield Note("texture", shown, f"it reads the absolute path {value.path!r}")
        elif not value.resolvedPath:
            yield Note("texture", shown, f"it reads {value.path!r}, which is not there")


def check_compliance(file: Path) -> Iterator[Note]:
    """The older checker, which newer releases leave to the registry."""
    if not hasattr(UsdUtils, "ComplianceChecker"):
        return
    checker = UsdUtils.ComplianceChecker()
    checker.CheckCompliance(str(file))
    for message in [*checker.GetErrors(), *checker.GetFailedChecks(), *checker.GetWarnings()]:
        yield Note("usd", "", one_line(message))


def one_line(message) -> str:
    return " ".join(str(message).split())[:300]
