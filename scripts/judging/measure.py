"""What a measure is: a question to one room, and its answer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from .floors import Room


class Fault(NamedTuple):
    """One thing that is wrong with a room."""

    note: str
    pieces: tuple[str, ...] = ()
    measured: float | None = None  # in the unit of its measure


class Answer(NamedTuple):
    """A room by one measure: it fails if it has faults. `value` is for the distribution over all rooms."""

    faults: tuple[Fault, ...] = ()
    value: float | None = None


@dataclass(frozen=True)
class Measure:
    """A question to rooms; `judge` answers None for a room that the question is not for."""

    code: str
    asks: str
    unit: str  # of `value` and `measured`; empty where there is none
    limit: str
    source: str
    judge: Callable[[Room], Answer | None]
    wanted: float = 1.0  # the share of the judged rooms that should pass
    audit: str = ""  # the code of the audit's finding that says the same, if there is one


def answer(faults: list[Fault], value: float | None = None) -> Answer:
    return Answer(tuple(faults), value)
