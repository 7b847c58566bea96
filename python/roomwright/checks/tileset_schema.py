"""The shapes of what 3D Tiles 1.1 adds to JSON, as JSON Schemas of our own words.

The specification (OGC 22-025r4) publishes schemas, but no package carries them. These are written from its tables, and hold for
tilesets, for `EXT_structural_metadata` and for the feature ids of `EXT_mesh_features` and `EXT_instance_features`. Keys that no table
names are faults: readers ignore them, so that a misspelt one would go unnoticed.
"""

from __future__ import annotations

from functools import cache

from .schemas import Schema

TEXT = {"type": "string", "minLength": 1}
INDEX = {"type": "integer", "minimum": 0}
# Every object may have these.
OPEN = {"extensions": {"type": "object"}, "extras": {}}
# Ids of schemas, classes and properties are identifiers of programming languages.
IDS = {"pattern": "^[A-Za-z_][A-Za-z0-9_]*$"}
TYPES = ["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4", "STRING", "BOOLEAN", "ENUM"]
NUMBERS = ["INT8", "UINT8", "INT16", "UINT16", "INT32", "UINT32", "INT64", "UINT64", "FLOAT32", "FLOAT64"]
OFFSETS = {"enum": ["UINT8", "UINT16", "UINT32", "UINT64"]}


def record(required: tuple[str, ...] = (), /, **properties) -> dict:
    """An object with named keys."""
    return {"type": "object", "properties": properties | OPEN, "required": list(required), "additionalProperties": False}


def listed(items: dict, count: int | None = None) -> dict:
    """A list that is not empty, of a certain length if one is given."""
    return {"type": "array", "items": items, "minItems": count or 1} | ({"maxItems": count} if count else {})


def by_id(values: dict) -> dict:
    """An object whose keys are ids."""
    return {"type": "object", "minProperties": 1, "propertyNames": IDS, "additionalProperties": values}


# --- metadata, the same in tilesets and in glTF ---

PROPERTY = record(
    ("type",), name=TEXT, description=TEXT, type={"enum": TYPES}, componentType={"enum": NUMBERS}, enumType=TEXT,
    array={"type": "boolean"}, count={"type": "integer", "minimum": 2}, normalized={"type": "boolean"}, offset={}, scale={},
    max={}, min={}, required={"type": "boolean"}, noData={}, default={}, semantic=TEXT)
CLASS = record(name=TEXT, description=TEXT, properties=by_id(PROPERTY))
ENUM_VALUE = record(("name", "value"), name=TEXT, description=TEXT, value={"type": "integer"})
ENUM = record(("values",), name=TEXT, description=TEXT, valueType={"enum": NUMBERS[:8]}, values=listed(ENUM_VALUE))
METADATA_SCHEMA = record(
    ("id",), id={"type": "string"} | IDS, name=TEXT, description=TEXT, version=TEXT, classes=by_id(CLASS), enums=by_id(ENUM))
METADATA = {"type": "object", "properties": OPEN | {"class": TEXT, "properties": {"type": "object"}}, "required": ["class"],
            "additionalProperties": False}

# --- tilesets (section 7 and annex A) ---

NUMBER = {"type": "number"}
ERROR = {"type": "number", "minimum": 0}
VOLUME = record(box=listed(NUMBER, 12), region=listed(NUMBER, 6), sphere=listed(NUMBER, 4)) | {"minProperties": 1}
CONTENT = record(("uri",), uri=TEXT, boundingVolume=VOLUME, metadata=METADATA, group=INDEX)
TILE = record(
    ("boundingVolume", "geometricError"), boundingVolume=VOLUME, viewerRequestVolume=VOLUME, geometricError=ERROR,
    refine={"enum": ["ADD", "REPLACE"]}, transform=listed(NUMBER, 16), content=CONTENT, contents=listed(CONTENT),
    metadata=METADATA, implicitTiling={"type": "object"}, children=listed({"$ref": "#/$defs/tile"}))
NAMES = listed(TEXT) | {"uniqueItems": True}
TILESET = record(
    ("asset", "geometricError", "root"), asset=record(("version",), version={"const": "1.1"}, tilesetVersion=TEXT),
    schema=METADATA_SCHEMA, schemaUri=TEXT, statistics={"type": "object"}, groups=listed(METADATA), metadata=METADATA,
    geometricError=ERROR, root={"$ref": "#/$defs/tile"}, properties={"type": "object"}, extensionsUsed=NAMES,
    extensionsRequired=NAMES) | {"$defs": {"tile": TILE}}

# --- glTF ---

COLUMN = record(
    ("values",), values=INDEX, arrayOffsets=INDEX, stringOffsets=INDEX, arrayOffsetType=OFFSETS, stringOffsetType=OFFSETS,
    offset={}, scale={}, max={}, min={})
TABLE = record(
    ("class", "count"), count={"type": "integer", "minimum": 1}, name=TEXT, properties=by_id(COLUMN), **{"class": TEXT})
STRUCTURAL_METADATA = record(
    schema=METADATA_SCHEMA, schemaUri=TEXT, propertyTables=listed(TABLE), propertyTextures=listed({"type": "object"}),
    propertyAttributes=listed({"type": "object"}))
FEATURE_ID = record(
    ("featureCount",), featureCount={"type": "integer", "minimum": 1}, nullFeatureId=INDEX, label=TEXT, attribute=INDEX,
    texture={"type": "object"}, propertyTable=INDEX)
FEATURES = record(("featureIds",), featureIds=listed(FEATURE_ID))


@cache
def tileset_schema() -> Schema:
    return Schema(TILESET)


@cache
def structural_metadata_schema() -> Schema:
    return Schema(STRUCTURAL_METADATA)


@cache
def features_schema() -> Schema:
    return Schema(FEATURES)
