"""Values against the JSON Schemas that roomwright publishes in configs/schema/.

The schemas allow what a reader of roomwright accepts; a bake is held to more:
- no object has a key that its schema does not name
- extras have every key with a default, for defaults are for the files of older versions and of editors
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import cache
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from jsonschema import Draft202012Validator, ValidationError

from ..environment import IS_PROJECT, ROOT
from ..resources import shown

# The package's own folder holds links for the wheel to follow, which are no files where git makes no links.
FOLDER = ROOT / "configs" / "schema" if IS_PROJECT else Path(__file__).resolve().parents[1] / "schema"
KINDS = {"array": "a list", "string": "text", "integer": "a whole number", "number": "a number", "object": "an object",
         "boolean": "true or false", "null": "null"}
NAME = re.compile(r"\w{1,60}")


class Violation(NamedTuple):
    """A value that its schema does not allow."""

    place: str  # such as sides[0].wall; empty for the whole value
    fact: str
    is_surplus: bool = False  # an unknown key: the other keys can be used all the same

    def __str__(self) -> str:
        return f"{self.place}: {self.fact}" if self.place else self.fact


class Schema:
    """One schema, ready to judge values."""

    def __init__(self, schema: dict):
        self._validator = Draft202012Validator(schema)

    def is_usable(self, value: object) -> bool:
        """Whether a value has every key with a value of the right kind; unknown keys do no harm."""
        return all(violation.is_surplus for violation in self.violations(value))

    def violations(self, value: object) -> list[Violation]:
        """Everything in a value that the schema does not allow, each once."""
        return list(dict.fromkeys(chain.from_iterable(map(_violations_of, self._validator.iter_errors(value)))))


def _violations_of(error: ValidationError) -> Iterator[Violation]:
    path, value = list(error.absolute_path), error.instance
    if error.validator == "required":
        # One error a key, none of which says in a field of its own which key it is.
        yield from (Violation(place_of([*path, key]), "it is missing") for key in error.validator_value if key not in value)
    elif error.validator == "additionalProperties":
        for key in sorted(value.keys() - error.schema["properties"].keys()):
            yield Violation(place_of(path), f"the key {shown(key)} is unknown", is_surplus=True)
    elif error.validator == "anyOf":
        # A value that may also be null: the faults of the value are of use, and that it is not null is not.
        yield from chain.from_iterable(_violations_of(inner) for inner in error.context if inner.validator_value != "null")
    else:
        yield Violation(place_of(path), f"{shown(value)} is not {_wanted(error)}")


def _wanted(error: ValidationError) -> str:
    """The values that a keyword of a schema allows, in words."""
    limit = error.validator_value
    match error.validator:
        case "type":
            return " or ".join(KINDS[kind] for kind in ([limit] if isinstance(limit, str) else limit))
        case "oneOf" if all("const" in choice for choice in limit):
            return "one of " + ", ".join(choice["const"] for choice in limit)
        case "minItems" | "maxItems":
            return f"a list of {limit}"
        case "minimum":
            return f"{limit} or more"
        case _:
            return f"as its schema says: {error.validator} {shown(limit)}"


def place_of(path: list) -> str:
    """A path such as sides[0].wall; keys that are no names are quoted."""
    steps = (f".{key}" if isinstance(key, str) and NAME.fullmatch(key) else f"[{shown(key)}]" for key in path)
    return "".join(steps).removeprefix(".")


@cache
def extras_schemas() -> dict[str, Schema]:
    """The schema of the extras of each kind of node."""
    document = _read("extras")
    found = {}
    for choice in document["oneOf"]:
        kind = choice["properties"]["kind"]
        own = document["$defs"][choice["$ref"].rpartition("/")[2]]
        whole = own | {"properties": own["properties"] | {"kind": kind}, "$defs": document["$defs"]}
        found[kind["const"]] = Schema(_closed(_with_defaults(whole)))
    return found


@cache
def manifest_schema() -> Schema:
    return Schema(_closed(_read("manifest")))


@cache
def file_record_schema() -> Schema:
    """The schema of one entry of a manifest: path, size and hash of a file."""
    document = _read("manifest")
    return Schema(document["$defs"]["FileRecord"])


def _read(name: str) -> dict:
    return json.loads((FOLDER / f"{name}.schema.json").read_text(encoding="utf-8"))


def _closed(schema):
    """A schema in which objects with named keys have no others."""
    return _changed(schema, lambda part: {"additionalProperties": False} | part)


def _with_defaults(schema):
    """A schema in which keys with a default are required."""
    def change(part: dict) -> dict:
        defaulted = [key for key, value in part["properties"].items() if "default" in value]
        return part | {"required": [*part.get("required", []), *defaulted]}

    return _changed(schema, change)


def _changed(schema, change):
    """A copy of a schema with each part that names keys changed."""
    if isinstance(schema, list):
        return [_changed(part, change) for part in schema]
    if not isinstance(schema, dict):
        return schema
    copy = {key: _changed(part, change) for key, part in schema.items()}
    return change(copy) if isinstance(copy.get("properties"), dict) else copy
