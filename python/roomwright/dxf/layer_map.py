"""The layer map: a YAML file that says which layers of a drawing hold what."""

from __future__ import annotations

import difflib
import fnmatch
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

import yaml

from .faults import Report, UnreadableError
from .room_types import key_of

# What layers can hold, in the order in which the documentation lists it.
ROLES = ("rooms", "room_names", "doors", "windows", "walls", "columns", "railings")
# Metres of a unit, by its word.
UNITS = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}
OUTLINES = ("inner", "center")
VERSION = 1
# Bytes of a layer map; those of people have some hundred.
MOST_BYTES = 2**20
# Metres from floor to floor that the program takes.
LEVEL_HEIGHT = (1.0, 100.0)


@dataclass
class LayerMap:
    """Globs of layer names by role, and what a drawing does not say."""

    layers: dict[str, list[str]] = field(default_factory=dict)
    room_types: dict[str, str] = field(default_factory=dict)  # key of a name (`key_of`) → room type
    outlines: str = "inner"
    unit: str | None = None
    level_height: float | None = None  # metres

    def roles_of(self, layer: str) -> list[str]:
        """The roles whose globs match a layer. DXF does not tell upper from lower case in names of layers."""
        return [role for role, globs in self.layers.items() if any(matches(layer, glob) for glob in globs)]

    def check_against(self, layers: Iterable[str], report: Report) -> dict[str, str]:
        """The role of each layer that has one. Reports layers with two roles, and globs that match no layer."""
        names = sorted(set(layers))
        roles = {}
        for layer in names:
            found = self.roles_of(layer)
            if len(found) > 1:
                report.error(None, f'layer "{layer}" has two roles, {found[0]} and {found[1]}', "make their globs narrower")
            elif found:
                roles[layer] = found[0]
        for role, globs in self.layers.items():
            for glob in globs:
                if not any(matches(layer, glob) for layer in names):
                    report.warning(None, f'no layer is called "{glob}" ({role})', nearest(glob, names))
        return roles


def matches(layer: str, glob: str) -> bool:
    return fnmatch.fnmatchcase(layer.casefold(), glob.casefold())


def nearest(word: str, names: list[str]) -> str:
    found = difflib.get_close_matches(word.casefold(), [name.casefold() for name in names], n=1)
    if found:
        return "did you mean \"{}\"?".format(next(name for name in names if name.casefold() == found[0]))
    return "--list-layers lists the layers of a drawing"


def read_layer_map(path: Path) -> tuple[LayerMap, Report]:
    """Reads a layer map with all of its faults. Raises UnreadableError if it is no YAML map."""
    try:
        with path.open("rb") as file:
            data = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise UnreadableError(f"{path}: {error.strerror or error}") from None
    if len(data) > MOST_BYTES:
        raise UnreadableError(f"{path}: a layer map has at most {MOST_BYTES} bytes")
    try:
        node = yaml.compose(data.decode("utf-8-sig"), Loader=yaml.SafeLoader)
    except (yaml.YAMLError, UnicodeDecodeError, RecursionError, ValueError) as error:
        raise UnreadableError(f"{path}: is no YAML: {str(error).splitlines()[0]}{mark_of(error)}") from None
    report = Report(str(path))
    if not isinstance(node, yaml.MappingNode):
        raise UnreadableError(f"{path}: is no layer map; hint: it begins with `version: 1` and `layers:`")
    return Reader(report).layer_map(node), report


def mark_of(error: Exception) -> str:
    mark = getattr(error, "problem_mark", None)
    return "" if mark is None else f" at line {mark.line + 1}, column {mark.column + 1}"


def place_of(node: yaml.Node) -> str:
    return f":{node.start_mark.line + 1}:{node.start_mark.column + 1}"


class Reader:
    """Turns the nodes of a layer map into values; every fault has line and column."""

    def __init__(self, report: Report):
        self.report = report

    def layer_map(self, node: yaml.MappingNode) -> LayerMap:
        result = LayerMap()
        readers: dict[str, Callable[[yaml.Node], None]] = {
            "version": self.version,
            "layers": lambda value: result.layers.update(self.layers(value)),
            "room_types": lambda value: result.room_types.update(self.room_types(value)),
            "outlines": lambda value: setattr(result, "outlines", self.word(value, OUTLINES) or "inner"),
            "unit": lambda value: setattr(result, "unit", self.word(value, UNITS)),
            "level_height": lambda value: setattr(result, "level_height", self.height(value)),
        }
        entries = self.entries(node, readers)
        for key, value in entries.items():
            readers[key](value)
        if "version" not in entries:
            self.report.error(place_of(node), "has no version", f"`version: {VERSION}`")
        if "rooms" not in result.layers and not self.report.errors:
            self.report.error(place_of(node), "no layer has the role rooms",
                              "rooms are read from closed outlines on layers of their own; walls are not turned into rooms")
        return result

    def entries(self, node: yaml.Node, known: Iterable[str] | None = None) -> dict[str, yaml.Node]:
        """The entries of a map with keys of text, each once and, where `known` is given, one of these."""
        if not isinstance(node, yaml.MappingNode):
            self.report.error(place_of(node), "is no map of keys and values")
            return {}
        found: dict[str, yaml.Node] = {}
        for key, value in node.value:
            text = key.value if isinstance(key, yaml.ScalarNode) else None
            if text is None:
                self.report.error(place_of(key), "a key is no text")
            elif text in found:
                self.report.error(place_of(key), f'key "{text}" stands twice')
            elif known is not None and text not in known:
                close = difflib.get_close_matches(text, list(known), n=1)
                hint = f'did you mean "{close[0]}"?' if close else f"the keys are {', '.join(known)}"
                self.report.error(place_of(key), f'unknown key "{text}"', hint)
            else:
                found[text] = value
        return found

    def layers(self, node: yaml.Node) -> dict[str, list[str]]:
        entries = self.entries(node, ROLES)
        return {role: self.texts(value) for role, value in entries.items()}

    def texts(self, node: yaml.Node) -> list[str]:
        """A text, or a list of them."""
        nodes = node.value if isinstance(node, yaml.SequenceNode) else [node]
        texts = [self.text(each) for each in nodes]
        return [text for text in texts if text]

    def text(self, node: yaml.Node) -> str | None:
        if isinstance(node, yaml.ScalarNode) and node.value:
            return str(node.value)
        self.report.error(place_of(node), "is no text", "a name of a layer, such as A-AREA or *rooms*")
        return None

    def room_types(self, node: yaml.Node) -> dict[str, str]:
        found = {}
        for name, value in self.entries(node).items():
            room_type, key = self.text(value), key_of(name)
            if not key:
                self.report.error(place_of(value), f'"{name}" has no letters', "names are compared without numbers and signs")
            elif room_type:
                found[key] = room_type
        return found

    def word(self, node: yaml.Node, words: Iterable[str]) -> str | None:
        if isinstance(node, yaml.ScalarNode) and node.value in words:
            return str(node.value)
        self.report.error(place_of(node), f"{shown(node)} is none of {', '.join(words)}")
        return None

    def version(self, node: yaml.Node) -> None:
        if not (isinstance(node, yaml.ScalarNode) and node.value == str(VERSION)):
            self.report.error(place_of(node), f"{shown(node)} is no version that is read", f"`version: {VERSION}`")

    def height(self, node: yaml.Node) -> float | None:
        try:
            value = float(node.value) if isinstance(node, yaml.ScalarNode) else math.nan
        except ValueError:
            value = math.nan
        if LEVEL_HEIGHT[0] <= value <= LEVEL_HEIGHT[1]:
            return value
        self.report.error(place_of(node), f"{shown(node)} is no height", "metres from floor to floor, 1 to 100")
        return None


def shown(node: yaml.Node) -> str:
    return f'"{node.value[:40]}"' if isinstance(node, yaml.ScalarNode) else "this"
