"""Faults of drawings and layer maps, collected so that one run reports all of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

# Faults that are printed; the rest is counted.
MOST_SHOWN = 200


class UnreadableError(Exception):
    """Nothing can be read; the text has the place, the reason and a hint."""


@dataclass(frozen=True)
class Place:
    """An entity of a drawing; `at` is in units of the drawing."""

    layer: str
    handle: str
    kind: str
    at: tuple[float, float] | None = None

    def __str__(self) -> str:
        at = "" if self.at is None else f" at ({self.at[0]:.6g}, {self.at[1]:.6g})"
        return f'layer "{self.layer}", {self.kind} {self.handle}{at}'


@dataclass
class Report:
    """The faults of one file. Errors leave out what they name; warnings leave out nothing, or what is no part of a plan."""

    file: str
    errors: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    def error(self, place: Place | str | None, fact: str, hint: str = "") -> None:
        self.errors.append(self._line(place, "error", fact, hint))

    def warning(self, place: Place | str | None, fact: str, hint: str = "") -> None:
        self.warnings.append(self._line(place, "warning", fact, hint))

    def _line(self, place: Place | str | None, severity: str, fact: str, hint: str) -> str:
        where = self.file if place is None else f"{self.file}{place}" if isinstance(place, str) else f"{self.file}: {place}"
        return f"{where}: {severity}: {fact}" + (f"\n  hint: {hint}" if hint else "")


def lines_of(reports: Iterable[Report]) -> list[str]:
    """All errors, then all warnings, up to a bound."""
    reports = list(reports)
    lines = [line for report in reports for line in report.errors] + [line for report in reports for line in report.warnings]
    rest = len(lines) - MOST_SHOWN
    return lines[:MOST_SHOWN] + ([f"... and {rest} more"] if rest > 0 else [])
