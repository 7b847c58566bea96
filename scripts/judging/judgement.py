"""The judgement of files: every measure's answer for every room, as plain values that processes can send."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import shapely

from .drawn import Drawn, read_drawn
from .floors import Floor, Room, read_floor
from .ifc import read_ifc
from .measure import Answer
from .pieces import MeshShelf
from .table import MEASURES
from .variety import Arrangement, arrangement_of


class Place(NamedTuple):
    """A room of a bake."""

    building: str
    level: str
    room: str
    kind: str
    seed: int


class Verdict(NamedTuple):
    """The answers about a room, and the codes that the audit recorded in its extras: those that count, and given ones."""

    place: Place
    area: float
    answers: dict[str, Answer]
    audit: dict[str, tuple[str, ...]]
    given: dict[str, tuple[str, ...]]
    # Required classes that are missing without a finding: the audit says that the plan has no place for them.
    not_required: tuple[str, ...]
    arrangement: Arrangement


class Task(NamedTuple):
    file: Path
    drawn: Path | None = None  # the folder of architects' drawings


def judge_file(task: Task) -> list[Verdict]:
    """Every furnished room of a file."""
    floor = read_floor(task.file, shelf())
    if task.drawn is not None:
        attach(floor, task.drawn)
    return [judge_room(room) for room in floor.rooms if room.pieces]


def attach(floor: Floor, folder: Path) -> None:
    """Gives each room the fixtures that its plan draws in it."""
    fixtures = drawings(folder).get((floor.building, floor.level), [])
    for room in floor.rooms:
        room.drawn = [fixture for fixture in fixtures if room.region.covers(shapely.Point(fixture.center))]


@lru_cache(maxsize=1)
def shelf() -> MeshShelf:
    """The meshes that this process has measured."""
    return MeshShelf()


@lru_cache(maxsize=1)
def drawings(folder: Path) -> dict[tuple[str, str], list[Drawn]]:
    """What architects drew, by building and level: archilyse's drawings and IFC files below a folder."""
    found = read_drawn(folder)
    for path in sorted(folder.rglob("*.ifc")):
        found |= read_ifc(path)
    return found


def judge_room(room: Room) -> Verdict:
    place = Place(room.floor.building, room.floor.level, room.id, room.kind, room.floor.seed)
    answers = {code: found for code, measure in MEASURES.items() if (found := measure.judge(room)) is not None}
    findings = room.extras.get("findings", [])
    given = [finding for finding in findings if finding["severity"] == "given"]
    counted = [finding for finding in findings if finding["severity"] != "given"]
    return Verdict(place, room.area, answers, by_code(counted), by_code(given), given_classes(room, counted),
                   arrangement_of(room))


def given_classes(room: Room, counted: list[dict]) -> tuple[str, ...]:
    """Required pieces that are missing, in a room to which the audit does not count it."""
    missing = tuple(sorted(piece["class"] for piece in room.extras.get("removed", []) if piece.get("required")))
    return () if any(finding["code"] == "missing_required" for finding in counted) else missing


def by_code(findings: list[dict]) -> dict[str, tuple[str, ...]]:
    """The objects of findings by their code."""
    found: dict[str, tuple[str, ...]] = {}
    for finding in findings:
        found[finding["code"]] = found.get(finding["code"], ()) + tuple(finding.get("objects", ()))
    return found


def rooms_failing(verdicts: list[Verdict], code: str) -> Iterator[Verdict]:
    return (verdict for verdict in verdicts if code in verdict.answers and verdict.answers[code].faults)
