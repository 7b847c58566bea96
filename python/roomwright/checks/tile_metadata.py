"""Values of metadata against the class that describes them: of tiles, and of property tables in glTF files.

roomwright writes texts and nothing else: other types are told, not judged.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..resources import shown

PLAIN_TEXT = {"type": "STRING"}


def class_of(schema: object, name: str) -> dict | None:
    """The properties of a class, by id; `None` if the schema has no such class."""
    classes = schema.get("classes", {}) if isinstance(schema, dict) else {}
    return classes[name].get("properties", {}) if name in classes else None


def key_faults(described: dict, given: dict) -> Iterator[str]:
    """Keys that a class does not have, required ones that are missing, and types that are not judged here."""
    for key in sorted(given.keys() - described.keys()):
        yield f"its class has no property {shown(key)}"
    for key, about in described.items():
        if about.get("required") and key not in given:
            yield f"the property {shown(key)} is missing"
        if key in given and (about["type"] != "STRING" or about.get("array")):
            yield f"the property {shown(key)} is no text, which is all that roomwright writes"


def entity_faults(schema: object, metadata: dict) -> Iterator[str]:
    """Faults of the metadata of one tile."""
    described = class_of(schema, metadata["class"])
    if described is None:
        yield f"the file's schema has no class {shown(metadata['class'])}"
        return
    given = metadata.get("properties", {})
    yield from key_faults(described, given)
    for key, value in given.items():
        if key in described and not isinstance(value, str):
            yield f"the property {shown(key)} is {shown(value)}, which is no text"
