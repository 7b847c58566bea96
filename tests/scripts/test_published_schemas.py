"""What the program writes, judged by the JSON Schemas that the specifications publish.

No package carries these, and the tests take them from copies of the repositories of the specifications:

    ROOMWRIGHT_TILES_SCHEMAS   specification/schema of CesiumGS/3d-tiles
    ROOMWRIGHT_GLTF_SCHEMAS    the branch 3d-tiles-next of CesiumGS/glTF, which has all extensions that are written here
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from conftest import ROOT
from jsonschema import Draft202012Validator
from jsonschema.protocols import Validator
from referencing import Registry, Resource

TILES_SCHEMAS, GLTF_SCHEMAS = (os.environ.get(f"ROOMWRIGHT_{name}_SCHEMAS") for name in ("TILES", "GLTF"))


def written(folder: Path, command: str, plan: str, *options: str) -> Path:
    program = ROOT / os.environ.get("ROOMWRIGHT_PROGRAM", "target/release/roomwright")
    subprocess.run([program, command, ROOT / "configs" / plan, "--out", folder, "--quiet", *options], check=True)
    return folder


def validator(schema: Path, folders: list[Path]) -> Validator:
    """Judges by a schema. Schemas name each other by the names of their files alone: the first folder that has one counts."""
    paths = {path.name: path for folder in reversed(folders) for path in folder.rglob("*.json")}

    def read(uri: str) -> Resource:
        return Resource.from_contents(json.loads(paths[uri.rsplit("/", 1)[-1]].read_text()))

    return Draft202012Validator(json.loads(schema.read_text()), registry=Registry(retrieve=read))


@pytest.mark.skipif(not TILES_SCHEMAS, reason="ROOMWRIGHT_TILES_SCHEMAS names no folder")
@pytest.mark.parametrize("plan", ["plans/hotel-tower.yaml", "quarter/delft.city.json"])
def test_tilesets_are_as_their_schemas_say(tmp_path, plan):
    written(tmp_path, "tiles", plan, "--textures", "none")
    judge = validator(Path(TILES_SCHEMAS, "tileset.schema.json"), [Path(TILES_SCHEMAS)])
    documents = [json.loads(path.read_text()) for path in [tmp_path / "tileset.json", *(tmp_path / "tileset").glob("*.json")]]
    assert [error.message for document in documents for error in judge.iter_errors(document)] == []
    documents[0]["root"]["geometricError"] = -1
    assert not judge.is_valid(documents[0])


# --- glTF ---

# Published without a schema: it allows further types of numbers, and has no object.
WITHOUT_SCHEMA = {"KHR_mesh_quantization"}


@cache
def core() -> tuple[Path, Validator]:
    folder = Path(GLTF_SCHEMAS, "specification/2.0/schema")
    return folder, validator(folder / "glTF.schema.json", [folder])


@cache
def of_extension(owner: str, name: str) -> Validator:
    """Judges the object of an extension; `owner` says what has it, as the names of the schemas do."""
    (folder,) = Path(GLTF_SCHEMAS, "extensions/2.0").glob(f"[KV]*/{name}/schema")
    named = list(folder.glob(f"*.{name}.schema.json"))
    # That of instances is named after the whole file, though nodes have it.
    schema = folder / f"{owner}.{name}.schema.json" if len(named) > 1 else named[0]
    return validator(schema, [folder, core()[0]])


def owner_of(place: list[str]) -> str:
    """What has an extension, by the keys that lead to it."""
    if place and place[-1].endswith("Texture"):
        return "textureInfo"
    return {"nodes": "node", "materials": "material", "primitives": "mesh.primitive", "": "glTF"}[place[-1] if place else ""]


def extensions_of(value: object, place: list[str]) -> Iterator[tuple[str, str, object]]:
    """Each extension in a document: what has it, its name and its object."""
    if isinstance(value, list):
        for entry in value:
            yield from extensions_of(entry, place)
    elif isinstance(value, dict):
        for name, extension in value.get("extensions", {}).items():
            yield owner_of(place), name, extension
            yield from extensions_of(extension, place)
        for key, entry in value.items():
            if key not in ("extensions", "extras"):
                yield from extensions_of(entry, [*place, key])


def document_of(path: Path) -> dict:
    content = path.read_bytes()
    return json.loads(content[20:20 + int.from_bytes(content[12:16], "little")])


@pytest.mark.skipif(not GLTF_SCHEMAS, reason="ROOMWRIGHT_GLTF_SCHEMAS names no folder")
@pytest.mark.parametrize(("command", "options", "expected"), [
    ("tiles", [], {"EXT_mesh_features", "EXT_instance_features", "EXT_mesh_gpu_instancing", "EXT_structural_metadata"}),
    ("bake", ["--profile", "web"], {"EXT_mesh_features", "EXT_instance_features", "EXT_mesh_gpu_instancing", "EXT_structural_metadata"}),
    ("bake", ["--lights", "physical"], {"KHR_lights_punctual", "KHR_materials_emissive_strength"})])
def test_models_and_their_extensions_are_as_their_schemas_say(tmp_path, command, options, expected):
    documents = [document_of(path) for path in written(tmp_path, command, "plans/house.yaml", *options).rglob("*.glb")]
    faults, found = [], set()
    for document in documents:
        faults += [error.message for error in core()[1].iter_errors(document)]
        for owner, name, extension in extensions_of(document, []):
            found.add(name)
            faults += [f"{name}: {error.message}" for error in of_extension(owner, name).iter_errors(extension)]
        assert set(document["extensionsUsed"]) <= found | WITHOUT_SCHEMA
    assert faults == []
    assert expected <= found


@pytest.mark.skipif(not GLTF_SCHEMAS, reason="ROOMWRIGHT_GLTF_SCHEMAS names no folder")
@pytest.mark.parametrize(("owner", "name", "damaged"), [
    ("glTF", "EXT_structural_metadata", {"schema": {"id": "a b"}}),
    ("glTF", "EXT_structural_metadata", {"propertyTables": [{"class": "piece", "count": 0}]}),
    ("mesh.primitive", "EXT_mesh_features", {"featureIds": [{"attribute": 0}]}),
    ("node", "EXT_instance_features", {"featureIds": []}),
    ("node", "EXT_mesh_gpu_instancing", {"attributes": {"TRANSLATION": -1}}),
])
def test_the_schemas_find_faults(owner, name, damaged):
    assert not of_extension(owner, name).is_valid(damaged)
