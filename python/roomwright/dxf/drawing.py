"""Opens a DXF file and sorts its entities by the roles of their layers."""

from __future__ import annotations

import os
import stat
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import chain, takewhile
from pathlib import Path
from typing import TypeVar

from ezdxf.document import Drawing
from ezdxf.entities.dxfentity import DXFEntity
from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.insert import Insert
from ezdxf.filemanagement import readfile
from ezdxf.lldxf.const import DXFError

from .faults import Place, Report, UnreadableError
from .layer_map import UNITS

DXFCopy = TypeVar("DXFCopy", bound=DXFGraphic)

# Bytes of a drawing; floors of offices have some ten million.
MOST_BYTES = 2**28
# Entities and control points of curves that are looked at, those in blocks as often as the blocks are inserted. An entity that a block
# is copied for costs more than one that is there.
MOST_WORK, COPY_WORK = 1_000_000, 10
# Blocks within blocks; those of people are two or three deep.
MOST_DEPTH = 12
# What stands for a whole, however many entities its block has.
WHOLE_ROLES = ("room_names", "doors", "windows", "columns")
# The codes of $INSUNITS whose unit plans are drawn in (Autodesk, AutoCAD help, "INSUNITS (System Variable)").
INSUNITS = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m", 14: "dm"}
BINARY_SENTINEL = b"AutoCAD Binary DXF"
# The layer that takes the layer of its block's insertion, and that on which nothing is a part of a drawing.
LAYER_OF_INSERT, LAYER_OF_POINTS = "0", "defpoints"


@dataclass
class Budget:
    """The work that a drawing may ask for: a small file may insert blocks of blocks a million times."""

    left: int = MOST_WORK

    def spend(self, work: int = COPY_WORK) -> bool:
        """Whether there was so much left."""
        self.left -= work
        return self.left >= 0


@dataclass(frozen=True)
class Drawn:
    """An entity with a role; the layer of one in a block may be that of the block's insertion."""

    entity: DXFGraphic
    layer: str
    handle: str
    budget: Budget = field(default_factory=Budget, compare=False)

    def place(self, at: tuple[float, float] | None = None) -> Place:
        return Place(self.layer, self.handle, self.entity.dxftype(), at)


def open_drawing(path: Path) -> Drawing:
    """Reads a whole DXF file. Raises UnreadableError, whatever is in it."""
    refuse_what_is_no_drawing(path)
    try:
        document = readfile(path)
        # Repairs what can be repaired, such as blocks that contain themselves.
        document.audit()
    except (OSError, MemoryError) as error:
        raise UnreadableError(f"{path}: {error}") from None
    except DXFError as error:
        raise UnreadableError(damaged(path, str(error))) from None
    except Exception as error:  # a damaged file can raise anything
        raise UnreadableError(damaged(path, f"{type(error).__name__}: {error}")) from None
    return document


def damaged(path: Path, reason: str) -> str:
    lines = reason.splitlines() or ["no reason given"]
    return f"{path}: the drawing is damaged: {lines[0][:200]}\n  hint: open it in its program, audit it, and export it again"


def refuse_what_is_no_drawing(path: Path) -> None:
    """Raises UnreadableError for what is no regular file, too large, of another format, or cut off."""
    try:
        found = path.stat()
        if not stat.S_ISREG(found.st_mode):
            raise UnreadableError(f"{path}: is no file")
        if found.st_size > MOST_BYTES:
            raise UnreadableError(f"{path}: has {found.st_size} bytes, of which {MOST_BYTES} are read\n"
                                  "  hint: export the layers of the plan alone")
        with path.open("rb") as file:
            head = file.read(len(BINARY_SENTINEL))
            file.seek(max(0, found.st_size - 64))
            tail = file.read()
    except OSError as error:
        raise UnreadableError(f"{path}: {error.strerror or error}") from None
    if head[:4] == b"AC10":
        raise UnreadableError(f"{path}: is a DWG file\n  hint: save it as DXF in its program")
    is_binary = head == BINARY_SENTINEL
    if not is_binary and (b"\0" in head or not head.strip()):
        raise UnreadableError(f"{path}: is no DXF file")
    if not (b"EOF" in tail if is_binary else tail.split()[-1:] == [b"EOF"]):
        raise UnreadableError(damaged(path, "it ends before its end mark EOF: a part is missing, or it is no DXF"))


def unit_of(document: Drawing, path: Path, asked: str | None) -> float:
    """Metres of a unit of the drawing: as asked, else as `$INSUNITS` says. Raises UnreadableError."""
    if asked is not None:
        return UNITS[asked]
    code = document.header.get("$INSUNITS", 0)
    if code in INSUNITS:
        return UNITS[INSUNITS[code]]
    fact = "names no unit ($INSUNITS is 0)" if code == 0 else f"has a unit that is not read ($INSUNITS is {code!r})"
    raise UnreadableError(f"{path}: {fact}\n  hint: --unit with one of {', '.join(UNITS)}, or `unit:` in the layer map")


def layers_of(document: Drawing) -> dict[str, Counter[str]]:
    """The layers that hold something in the model space or in blocks, with the number of entities of each kind."""
    found: dict[str, Counter[str]] = {}
    for container in document.blocks:
        if container.name.lower().startswith("*paper_space"):
            continue
        for entity in graphics(container):
            found.setdefault(entity.dxf.layer, Counter())[entity.dxftype()] += 1
    return found


def graphics(entities: Iterable[DXFEntity]) -> Iterator[DXFGraphic]:
    """Entities of kinds that are known; those of other programs have no layer that can be asked for."""
    return (entity for entity in entities if isinstance(entity, DXFGraphic))


@dataclass
class Sorting:
    """Sorts the entities of one drawing by role."""

    document: Drawing
    roles: dict[str, str]  # role by layer
    report: Report
    found: dict[str, list[Drawn]] = field(default_factory=dict)
    budget: Budget = field(default_factory=Budget)
    with_roles: dict[str, bool] = field(default_factory=dict)  # blocks in which any layer may have a role

    def sort(self) -> dict[str, list[Drawn]]:
        """The entities of each role. Raises UnreadableError if the drawing asks for too much."""
        self._walk(self.document.modelspace(), None, 0)
        self.refuse_overspent()
        return self.found

    def refuse_overspent(self) -> None:
        if self.budget.left < 0:
            raise UnreadableError(f"{self.report.file}: has too many entities on the layers of the map, those of blocks counted\n"
                                  "  hint: export the layers of the plan alone")

    def _walk(self, entities: Iterable[DXFEntity], insert: Drawn | None, depth: int) -> None:
        for entity in graphics(entities):
            if not self.budget.spend(COPY_WORK if depth else 1):
                return
            if entity.dxf.get("invisible", 0):
                continue
            own = entity.dxf.layer
            layer = insert.layer if insert is not None and own == LAYER_OF_INSERT else own
            handle = entity.dxf.handle or (insert.handle if insert is not None else "?")
            self._take(Drawn(entity, layer, handle, self.budget), depth)

    def _take(self, drawn: Drawn, depth: int) -> None:
        role = self.roles.get(drawn.layer)
        entity = drawn.entity
        if not isinstance(entity, Insert) or role in WHOLE_ROLES:
            if role is not None:
                self.found.setdefault(role, []).append(drawn)
            return
        if role is None and not self._may_hold_roles(entity.dxf.name, drawn.layer):
            return
        if depth >= MOST_DEPTH:
            self.report.error(drawn.place(), f"blocks lie more than {MOST_DEPTH} deep in each other")
            return
        for single in bounded(singles(entity), self.budget):
            self._walk(single.virtual_entities(), drawn, depth + 1)

    def _may_hold_roles(self, name: str, layer: str) -> bool:
        """Whether a block, or one in it, has entities on layers with a role: furniture need not be taken apart."""
        if name not in self.with_roles:
            self.with_roles[name] = False  # a block in itself adds nothing
            block = self.document.blocks.get(name)
            self.with_roles[name] = block is not None and any(
                entity.dxf.layer in self.roles
                or isinstance(entity, Insert) and self._may_hold_roles(entity.dxf.name, entity.dxf.layer)
                for entity in graphics(block))
        return self.with_roles[name]


def singles(insert: Insert) -> Iterator[Insert]:
    """The insertions that a grid of insertions stands for, one by one."""
    if insert.mcount > 1:
        yield from insert.multi_insert()
    else:
        yield insert


def bounded(copies: Iterable[DXFCopy], budget: Budget) -> Iterator[DXFCopy]:
    """Copies as long as the budget lasts."""
    return takewhile(lambda _: budget.spend(), copies)


def parts_of(drawn: Drawn) -> list[Drawn]:
    """The entities that a whole is drawn of: itself, or those of its block."""
    parts: list[Drawn] = []
    waiting: list[tuple[DXFGraphic, int]] = [(drawn.entity, 0)]
    while waiting and drawn.budget.spend():
        entity, depth = waiting.pop()
        if entity.dxf.get("invisible", 0) or entity.dxf.layer.casefold() == LAYER_OF_POINTS:
            continue
        if not isinstance(entity, Insert):
            parts.append(replace(drawn, entity=entity))
        elif depth < MOST_DEPTH:
            inside = chain.from_iterable(single.virtual_entities() for single in bounded(singles(entity), drawn.budget))
            waiting.extend((part, depth + 1) for part in bounded(graphics(inside), drawn.budget))
    return parts


def file_name(path: Path) -> str:
    """The name of a drawing's file, without its ending."""
    return os.path.splitext(path.name)[0]
