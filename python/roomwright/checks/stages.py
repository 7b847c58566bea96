"""USD files: layers, stages of buildings and cities, packages.

The names in a file, and in the files that it names, are judged before anything is composed. If all of them may be read, the
file is opened without its payloads, which are files of the same folder and judged by themselves. Then all validators of USD
judge it, and the compliance checker if this USD has one. Their errors and warnings are faults, and so are missing files and
the errors of USD while it composes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from pxr import Sdf, Tf, Usd, UsdGeom, UsdShade, UsdUtils, UsdValidation

from ..resources import ForbiddenError, ResourceError, locate_path, reach_of, regular_file

from .contract import PATH
from .manifest import STAGE_ENDINGS
from .report import Fault, Note


def check_stage(file: Path, folder: Path | None = None) -> tuple[list[Fault], Counter]:
    """Every check of one file, with counts for the report; `folder` is where it was found."""
    counts = Counter({"stages": 1})
    notes: list[Note] = []
    try:
        notes += check_named_files(file, folder)
        if not any(note.code == PATH for note in notes):
            stage = Usd.Stage.Open(str(file), Usd.Stage.LoadNone)
            counts.update(prims=sum(1 for _ in stage.Traverse()))
            for check in (check_stage_metadata, check_composition, check_validators, check_textures):
                notes += check(stage)
            notes += check_compliance(file)
    except Exception as error:  # what a broken file can raise in USD has no end
        notes.append(Note("file", "", f"cannot be opened: {one_line(error)}"))
    return [Fault(str(file), *note) for note in dict.fromkeys(notes)], counts


# --- what it names ---


def check_named_files(file: Path, folder: Path | None) -> Iterator[Note]:
    """The files that a file names, and those that they name: there, and where it may name them."""
    reach = reach_of(file, folder)
    try:
        first = regular_file(file, None if folder is None else reach, "the file")
    except ResourceError as error:
        yield Note(PATH, "", str(error))
        return
    pending, seen = [first], {first}
    while pending:
        owner = pending.pop()
        for name in named_files(owner, owner.stat().st_mtime_ns):
            try:
                named = locate_path(name, replace(reach, folder=owner.resolve().parent))
                if named.suffix.lower() in STAGE_ENDINGS and named not in seen:
                    seen.add(named)
                    pending.append(named)
            except ForbiddenError as error:
                yield Note(PATH, "", f"{'it' if owner == first else owner.name} names a file that it may not: {error}")
            except ResourceError as error:
                # Images that are missing are faults of the materials that read them.
                if owner == first and Path(name).suffix.lower() in STAGE_ENDINGS:
                    yield Note("file", "", f"it names {name!r}, which does not exist")


@lru_cache(maxsize=4096)
def named_files(file: Path, _changed: int) -> tuple[str, ...]:
    """The files that a layer names, without what they name; nothing of what USD cannot open.

    `_changed` is when the file was changed last. Packages have theirs inside.
    """
    if file.suffix.lower() == ".usdz":
        return ()
    try:
        return tuple(dict.fromkeys(name for names in UsdUtils.ExtractExternalReferences(str(file)) for name in names))
    except Tf.ErrorException:
        return ()


# --- what it is ---


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
        if not value.resolvedPath:
            yield Note("texture", shown, f"it reads {value.path!r}, which does not exist")


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
