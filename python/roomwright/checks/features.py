"""Features of a tile: the numbers of its corners and instances, and the table that names them.

    EXT_mesh_features         a number a corner
    EXT_instance_features     a number an instance of EXT_mesh_gpu_instancing
    EXT_structural_metadata   the table, each column as texts one after the other and where each begins
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..gltf_document import GltfError
from ..gltf_file import GltfFile
from ..resources import shown

from .report import Note
from .tile_metadata import class_of, key_faults
from .tile_volumes import INSTANCING
from .tileset_schema import features_schema, structural_metadata_schema

CODE = "features"
MESH_FEATURES, INSTANCE_FEATURES, TABLES = "EXT_mesh_features", "EXT_instance_features", "EXT_structural_metadata"
QUANTIZATION, LIGHTS = "KHR_mesh_quantization", "KHR_lights_punctual"
FLOAT = 5126
OFFSET_TYPES = {"UINT8": "<u1", "UINT16": "<u2", "UINT32": "<u4", "UINT64": "<u8"}
# Bytes to which the views of a table are aligned (EXT_structural_metadata, "Binary Table Format").
ALIGNMENT = 8


def is_tile(gltf: GltfFile) -> bool:
    """Whether a file names its pieces by features, and not by nodes with extras."""
    nodes = gltf.document.get("nodes", [])
    return TABLES in gltf.document.get("extensionsUsed", ()) and not any("extras" in node for node in nodes)


def check_features(gltf: GltfFile) -> Iterator[Note]:
    yield from check_extensions(gltf)
    counts = []
    for message, count in check_tables(gltf):
        if count is not None:
            counts.append(count)
        if message:
            yield Note(CODE, "", message)
    for owner, features, attributes, entry in owners(gltf):
        for message in check_ids(gltf, features, attributes, counts, entry):
            yield Note(CODE, owner, message)


# --- extensions ---


def check_extensions(gltf: GltfFile) -> Iterator[Note]:
    """A file that cannot be drawn right without an extension must require it, so that clients without it refuse it."""
    document = gltf.document
    used, required = (set(document.get(key, ())) for key in ("extensionsUsed", "extensionsRequired"))
    if LIGHTS in used:
        yield Note(CODE, "", f"it has lights ({LIGHTS}): a level has more than a shader of three.js can hold")
    found = {INSTANCING} if any(INSTANCING in node.get("extensions", {}) for node in document.get("nodes", [])) else set()
    positions = (primitive["attributes"]["POSITION"] for mesh in document.get("meshes", []) for primitive in mesh["primitives"])
    if any(gltf.entry("accessors", index)["componentType"] != FLOAT for index in positions):
        found.add(QUANTIZATION)
    for name in sorted(found - required):
        yield Note(CODE, "", f"it needs {name}, but does not require it")
    for name in sorted(required - used):
        yield Note(CODE, "", f"it requires {name}, but does not use it")


# --- the table ---


def check_tables(gltf: GltfFile) -> Iterator[tuple[str, int | None]]:
    """Faults of the tables, and of each table that has no fault of shape the count of its rows."""
    metadata = gltf.document.get("extensions", {}).get(TABLES)
    violations = structural_metadata_schema().violations(metadata)
    yield from ((f"{TABLES}: {violation}", None) for violation in violations)
    if any(not violation.is_surplus for violation in violations):
        return
    if "schema" not in metadata:
        yield f"{TABLES} holds no schema", None
        return
    for number, table in enumerate(metadata.get("propertyTables", [])):
        yield "", table["count"]
        for message in check_table(gltf, metadata["schema"], table):
            yield f"propertyTables[{number}]: {message}", None


def check_table(gltf: GltfFile, schema: dict, table: dict) -> Iterator[str]:
    described = class_of(schema, table["class"])
    if described is None:
        yield f"the schema has no class {shown(table['class'])}"
        return
    columns = table.get("properties", {})
    yield from key_faults(described, columns)
    for key in sorted(described.keys() - columns.keys()):
        # What all rows share is said once, in the schema.
        if not described[key].get("required") and not isinstance(described[key].get("default"), str):
            yield f"the property {shown(key)} has neither a column nor a text as `default`"
    for key, column in columns.items():
        try:
            yield from (f"{key}: {message}" for message in check_column(gltf, column, table["count"]))
        except GltfError as error:
            yield f"{key}: {error}"


def check_column(gltf: GltfFile, column: dict, count: int) -> Iterator[str]:
    """Texts, one after the other, and where each begins and the last ends."""
    if "stringOffsets" not in column:
        yield "a column of texts has no `stringOffsets`"
        return
    kind = np.dtype(OFFSET_TYPES[column.get("stringOffsetType", "UINT32")])
    values, offsets = view_of(gltf, column["values"]), view_of(gltf, column["stringOffsets"])
    for name in ("values", "stringOffsets"):
        if gltf.entry("bufferViews", column[name]).get("byteOffset", 0) % ALIGNMENT:
            yield f"`{name}` does not begin at a multiple of {ALIGNMENT} bytes"
    if len(offsets) != (count + 1) * kind.itemsize:
        yield f"`stringOffsets` has {len(offsets)} bytes, not those of {count + 1} numbers"
        return
    bounds = np.frombuffer(offsets, kind).astype(np.int64)
    if bounds[0] != 0 or (np.diff(bounds) < 0).any():
        yield "`stringOffsets` does not rise from 0"
    elif bounds[-1] > len(values):
        yield f"`stringOffsets` ends at {bounds[-1]}, after the {len(values)} bytes of `values`"
    else:
        yield from check_texts(values, bounds)


def check_texts(values: bytes, bounds: np.ndarray) -> Iterator[str]:
    for row, (begin, end) in enumerate(zip(bounds, bounds[1:])):
        try:
            values[begin:end].decode("utf-8")
        except UnicodeDecodeError:
            yield f"row {row} is no text in UTF-8"


def view_of(gltf: GltfFile, index: int) -> bytes:
    """The bytes of a buffer view."""
    view = gltf.entry("bufferViews", index)
    data = gltf.buffer(view["buffer"])
    start = view.get("byteOffset", 0)
    if start + view["byteLength"] > len(data):
        raise GltfError(f"bufferViews[{index}] reaches past the end of its buffer")
    return bytes(data[start:start + view["byteLength"]])


# --- numbers ---


def owners(gltf: GltfFile) -> Iterator[tuple[str, object, dict, dict | None]]:
    """Whatever is drawn: its name, its features, the attributes that hold them, and the primitive if there is a number a corner."""
    instanced: set[int] = set()
    for index, node in enumerate(gltf.document.get("nodes", [])):
        extensions = node.get("extensions", {})
        if INSTANCING in extensions:
            instanced.add(node.get("mesh"))
            name = node.get("name", f"nodes[{index}]")
            yield name, extensions.get(INSTANCE_FEATURES), extensions[INSTANCING].get("attributes", {}), None
    for index, mesh in enumerate(gltf.document.get("meshes", [])):
        if index not in instanced:
            for number, primitive in enumerate(mesh["primitives"]):
                features = primitive.get("extensions", {}).get(MESH_FEATURES)
                yield f"meshes[{index}].primitives[{number}]", features, primitive["attributes"], primitive


def check_ids(gltf: GltfFile, features: object, attributes: dict, counts: list[int], primitive: dict | None) -> Iterator[str]:
    """The numbers of corners or instances, each within its table."""
    if features is None:
        yield "nothing says which pieces it shows"
        return
    violations = features_schema().violations(features)
    yield from map(str, violations)
    if any(not violation.is_surplus for violation in violations):
        return
    lengths = {gltf.entry("accessors", index)["count"] for index in attributes.values()}
    if len(lengths) > 1:
        yield f"its attributes have {', '.join(map(str, sorted(lengths)))} rows, not all the same number"
        return
    for number, feature in enumerate(features["featureIds"]):
        place = f"featureIds[{number}]"
        table = feature.get("propertyTable")
        if table is None or table >= len(counts):
            yield f"{place}: there is no table {table}"
            continue
        name = f"_FEATURE_ID_{feature.get('attribute')}"
        if name not in attributes:
            yield f"{place}: there is no attribute {name}"
            continue
        yield from (f"{place}: {message}" for message in check_rows(gltf, feature, attributes[name], counts[table], primitive))


def check_rows(gltf: GltfFile, feature: dict, index: int, count: int, primitive: dict | None) -> Iterator[str]:
    entry = gltf.entry("accessors", index)
    if entry["type"] != "SCALAR" or entry.get("normalized"):
        yield "the attribute holds no plain numbers"
        return
    rows = gltf.accessor(index)
    if not np.array_equal(rows, np.round(rows)) or rows.min() < 0 or rows.max() >= count:
        yield f"numbers from {rows.min():g} to {rows.max():g} are not those of the {count} rows of the table"
        return
    if len(np.unique(rows)) > feature["featureCount"]:
        yield f"there are {len(np.unique(rows))} features, and `featureCount` is {feature['featureCount']}"
    if primitive is not None and "indices" in primitive:
        corners = rows[gltf.accessor(primitive["indices"]).reshape(-1, 3)]
        mixed = int((corners.min(axis=1) != corners.max(axis=1)).sum())
        if mixed:
            yield f"{mixed} triangles join corners of different pieces"
