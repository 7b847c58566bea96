"""A tileset: its JSON files, one leading to the next, and the glTF files that they lead to.

    shape     each file is as 3D Tiles 1.1 says (tileset_schema)
    volumes   boxes lie in the box of the tile above, and hold all that their content draws
    errors    geometric errors fall from a tile to those below it
    files     every URI leads to a file of the folder, no two tiles to the same, and every file of the folder is used
    metadata  the metadata of tiles is as the schema of the file says
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ..resources import ForbiddenError, ResourceError, locate, read_file, shown
from ..workers import outcomes

from .contract import PATH
from .report import Fault
from .tile_metadata import entity_faults
from .tile_volumes import TOLERANCE, Box, Content, content_of, placed, reach_in, transform_fault
from .tileset_schema import tileset_schema

NAME = "tileset.json"
CODE = "tiles"
# Written beside a tileset, and read by no viewer.
BESIDE = {"manifest.json"}
MOST_NESTING = 60


def tilesets_in(folder: Path) -> list[Path]:
    return sorted(folder.rglob(NAME))


def check_tileset(path: Path, jobs: int = 1) -> list[Fault]:
    """Everything that is wrong with a tileset and its files as parts of it."""
    walk = Walk(path)
    walk.read(path, None)
    walk.check_contents(jobs)
    walk.check_unused()
    return walk.faults


class Walk:
    """A walk over the files of a tileset."""

    def __init__(self, path: Path):
        self.first = path.resolve()
        self.folder = self.first.parent
        self.shown_folder = path.parent
        self.faults: list[Fault] = []
        # Of each file that a tile leads to, who leads to it.
        self.used: dict[Path, str] = {self.first: "the address of the tileset"}
        self.contents: list[tuple[Path, Path, str, Box]] = []

    def fault(self, file: Path, place: str, message: str, code: str = CODE) -> None:
        self.faults.append(Fault(str(self.shown_folder / file.resolve().relative_to(self.folder)), code, place, message))

    def read(self, file: Path, above: dict | None) -> None:
        """A file; `above` is the tile whose content it is."""
        try:
            document = json.loads(read_file(file))
        except (ResourceError, ValueError, RecursionError) as error:
            self.fault(file, "", f"cannot be read: {error}", "file")
            return
        violations = tileset_schema().violations(document)
        for violation in violations:
            self.fault(file, "", str(violation))
        if any(not violation.is_surplus for violation in violations):
            return
        root = document["root"]
        if "refine" not in root:
            self.fault(file, "root", "`refine` is missing; the root has no tile to inherit it from")
        if not set(document.get("extensionsRequired", ())) <= set(document.get("extensionsUsed", ())):
            self.fault(file, "", "it requires an extension that it does not use")
        self.check_errors(file, "root", root, document["geometricError"], "the file")
        if above is not None and document["geometricError"] > above["geometricError"]:
            self.fault(file, "", f"its error, {document['geometricError']}, is larger than that of the tile that leads to it, "
                                 f"{above['geometricError']}")
        self.tile(file, "root", root, above, document.get("schema"))

    def tile(self, file: Path, place: str, tile: dict, above: dict | None, schema: object) -> None:
        """A tile and all below it; `above` is the tile above, in this file or in the one that leads here."""
        if place.count(".") > MOST_NESTING:
            self.fault(file, place, f"more than {MOST_NESTING} tiles are below each other")
            return
        box = self.box_of(file, place, tile)
        if box is not None and above is not None:
            self.check_volume(file, place, box, tile, above)
        if above is not None:
            self.check_errors(file, place, tile, above["geometricError"], "the tile above")
        for message in entity_faults(schema, tile["metadata"]) if "metadata" in tile else ():
            self.fault(file, place, message)
        if "contents" in tile or "implicitTiling" in tile:
            self.fault(file, place, "it has several contents or implicit tiles; each client reads tiles of one content")
        if "content" in tile:
            self.content(file, place, tile, box)
        for number, child in enumerate(tile.get("children", [])):
            self.tile(file, f"{place}.children[{number}]", child, tile, schema)

    def check_errors(self, file: Path, place: str, tile: dict, above: float, name: str) -> None:
        if not tile["geometricError"] < above:
            self.fault(file, place, f"its error, {tile['geometricError']}, is not smaller than that of {name}, {above}")

    def box_of(self, file: Path, place: str, tile: dict) -> Box | None:
        """The box of a tile; `None`, and a fault, if it has none."""
        numbers = tile["boundingVolume"].get("box")
        if numbers is None:
            self.fault(file, place, "its volume is no box, which is all that roomwright writes")
            return None
        fault = transform_fault(tile["transform"]) if "transform" in tile else None
        if fault is not None:
            self.fault(file, place, f"`transform` is none: {fault}")
        box = Box.of(numbers)
        if not box.is_square():
            self.fault(file, place, "the axes of its box are not at right angles")
        return box

    def check_volume(self, file: Path, place: str, box: Box, tile: dict, above: dict) -> None:
        around = above["boundingVolume"].get("box")
        if around is None:
            return
        excess = Box.of(around).excess(placed(tile.get("transform"), box.corners()))
        if not excess <= TOLERANCE:
            self.fault(file, place, f"its box reaches {excess:.4f} m out of that of the tile above")

    def content(self, file: Path, place: str, tile: dict, box: Box | None) -> None:
        """The file that a tile leads to."""
        uri = tile["content"]["uri"]
        try:
            named = locate(uri, reach_in(file, self.folder))
        except ResourceError as error:
            self.fault(file, place, f"content.uri: {error}", PATH if isinstance(error, ForbiddenError) else CODE)
            return
        if named in self.used:
            self.fault(file, place, f"content.uri: {shown(uri)} is already the content of {self.used[named]}")
            return
        self.used[named] = place
        if named.suffix == ".json":
            if tile.get("children"):
                self.fault(file, place, "a tile that leads to another tileset has no children of its own")
            self.read(named, tile)
        elif box is not None:
            self.contents.append((named, file, place, box))

    def check_contents(self, jobs: int) -> None:
        """The glTF files: where they draw, and what they name."""
        asked = [(named, self.folder) for named, *_ in self.contents]
        found = outcomes(content_of, asked, jobs) if asked else ()
        for (named, file, place, box), content in zip(self.contents, found):
            if isinstance(content, Content):
                self.used |= {path.resolve(): str(named.name) for path in content.files}
                self.check_drawn(file, place, box, content)
            else:
                self.fault(named, "", f"cannot be read: {content}", "file")

    def check_drawn(self, file: Path, place: str, box: Box, content: Content) -> None:
        drawn = Box((content.low + content.high) / 2, np.diag((content.high - content.low) / 2))
        excess = box.excess(drawn.corners())
        if not excess <= TOLERANCE:
            self.fault(file, place, f"its content draws up to {excess:.4f} m outside of its box")

    def check_unused(self) -> None:
        for path in self.files_beside():
            if path not in self.used:
                self.fault(path, "", "no tile leads to it")

    def files_beside(self) -> Iterator[Path]:
        """The files of the folder that a host would serve."""
        for path in sorted(self.folder.rglob("*")):
            inner = path.relative_to(self.folder)
            is_hidden = any(part.startswith(".") for part in inner.parts)
            if path.is_file() and not is_hidden and inner.as_posix() not in BESIDE:
                yield path
