"""Verdicts as tables: one row a measure."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

import numpy as np

from .judgement import Verdict, rooms_failing
from .measure import Measure
from .table import SUBJECTS
from .variety import distinct

PERCENTILES = (5, 50, 95)


class Row(NamedTuple):
    """A measure over all rooms."""

    code: str
    judged: int
    failing: int
    mean: float | None  # of the values, for measures with values
    values: tuple[float, ...]  # at PERCENTILES
    wanted: float

    @property
    def passing(self) -> float:
        return 1.0 - self.failing / self.judged if self.judged else 1.0

    @property
    def is_met(self) -> bool:
        return self.passing >= self.wanted - 1e-9


class Agreement(NamedTuple):
    """Rooms in which the judge and the audit say the same or not, for one code of the audit."""

    code: str
    both: int
    only_judge: int
    only_audit: int
    given: int  # of `both` and `only_audit`: findings that the plan makes unavoidable


def row_of(verdicts: list[Verdict], measure: Measure) -> Row:
    answers = [verdict.answers[measure.code] for verdict in verdicts if measure.code in verdict.answers]
    values = [found.value for found in answers if found.value is not None and np.isfinite(found.value)]
    spread = tuple(float(value) for value in np.percentile(values, PERCENTILES)) if values else ()
    failing = sum(1 for found in answers if found.faults)
    return Row(measure.code, len(answers), failing, float(np.mean(values)) if values else None, spread, measure.wanted)


def rows_of(verdicts: list[Verdict]) -> dict[str, list[Row]]:
    """The rows of each subject."""
    return {subject: [row_of(verdicts, measure) for measure in module.MEASURES] for subject, module in SUBJECTS.items()}


def agreement_of(verdicts: list[Verdict], measure: Measure) -> Agreement:
    both = only_judge = only_audit = given = 0
    for verdict in verdicts:
        if measure.code not in verdict.answers:
            continue
        judge = bool(verdict.answers[measure.code].faults)
        audit = measure.audit in verdict.audit or measure.audit in verdict.given
        both += judge and audit
        only_judge += judge and not audit
        only_audit += audit and not judge
        given += audit and measure.audit not in verdict.audit
    return Agreement(measure.code, both, only_judge, only_audit, given)


def disagreements(verdicts: list[Verdict], measure: Measure, most: int) -> list[str]:
    """Rooms that only one of judge and audit complains about, those of the audit first."""
    only_judge, only_audit = [], []
    for verdict in verdicts:
        found = verdict.answers.get(measure.code)
        audit = verdict.audit | verdict.given
        if found is not None and bool(found.faults) != (measure.audit in audit):
            what = found.faults[0].note if found.faults else ", ".join(audit[measure.audit])
            pieces = f" ({', '.join(found.faults[0].pieces)})" if found.faults and found.faults[0].pieces else ""
            line = f"{named(verdict)}, seed {verdict.place.seed}: {what}{pieces}"
            (only_judge if found.faults else only_audit).append(line)
    return [*(f"only the audit: {line}" for line in only_audit[:most]),
            *(f"only the judge: {line}" for line in only_judge[:most])]


def markdown(verdicts: list[Verdict]) -> str:
    lines = ["| measure | limit | rooms | failing | share | wanted | mean (5 %, median, 95 %) |",
             "|---|---|---|---|---|---|---|"]
    for subject, rows in rows_of(verdicts).items():
        for row, measure in zip(rows, SUBJECTS[subject].MEASURES):
            lines.append(f"| `{row.code}` | {measure.limit} | {row.judged:,} | {row.failing:,} | {share(row)} "
                         f"| {wanted(row)} | {spread(row)} {measure.unit if row.values else ''} |")
    return "\n".join(lines)


def spread(row: Row) -> str:
    return f"{row.mean:.2f} ({', '.join(f'{value:.2f}' for value in row.values)})" if row.values else ""


def wanted(row: Row) -> str:
    """The share that may fail, and whether it does not; nothing for rooms that there are none of."""
    if not row.judged:
        return ""
    return f"{'met' if row.is_met else '**not met**'}: ≤ {1 - row.wanted:.0%}".replace("%", " %")


def measures_table() -> str:
    """All measures with their limits, for docs/judge.md."""
    lines = ["| measure | a room passes if | limit | unit | may fail | source | audit's code |",
             "|---|---|---|---|---|---|---|"]
    for module in SUBJECTS.values():
        for measure in module.MEASURES:
            audit = f"`{measure.audit}`" if measure.audit else ""
            lines.append(f"| `{measure.code}` | {measure.asks} | {measure.limit} | {measure.unit} | {1 - measure.wanted:.0%} "
                         f"| {measure.source} | {audit} |".replace("%", " %"))
    return "\n".join(lines)


def share(row: Row) -> str:
    return f"{row.failing / row.judged:.1%}".replace("%", " %") if row.judged else ""


def given_lines(verdicts: list[Verdict]) -> list[str]:
    """Rooms whose plan, the audit says, has no place for a required piece, one line each over all seeds."""
    rooms: dict[tuple[str, str, str], list[Verdict]] = {}
    for verdict in verdicts:
        if verdict.not_required:
            rooms.setdefault(verdict.place[:3], []).append(verdict)
    lines = []
    for _, group in sorted(rooms.items(), key=lambda entry: (-len(entry[1]), entry[0])):
        first = group[0]
        lines.append(f"{named(first)}, {seeds_of(group)}: no {', '.join(first.not_required)}")
    return lines


def variety_of(verdicts: list[Verdict]) -> dict[str, list[int]]:
    """The number of arrangements of each room over its seeds, by the type that the room has with most of them."""
    rooms: dict[tuple[str, str, str], list[Verdict]] = {}
    for verdict in verdicts:
        if verdict.arrangement.stands:
            rooms.setdefault(verdict.place[:3], []).append(verdict)
    found: dict[str, list[int]] = {}
    for group in rooms.values():
        kinds = Counter(verdict.place.kind for verdict in group)
        kind = min(kinds, key=lambda kind: (-kinds[kind], kind))
        found.setdefault(kind, []).append(distinct(verdict.arrangement for verdict in group))
    return found


def worst_rooms(verdicts: list[Verdict], code: str, most: int) -> list[str]:
    """The rooms that fail a measure with most seeds, and then with most faults, one line each."""
    rooms: dict[tuple[str, str, str], list[Verdict]] = {}
    for verdict in rooms_failing(verdicts, code):
        rooms.setdefault(verdict.place[:3], []).append(verdict)
    worst = sorted(rooms.values(), key=lambda group: (-len(group), -faults_in(group, code), group[0].place))
    return [line_of(group, code) for group in worst[:most]]


def faults_in(group: list[Verdict], code: str) -> int:
    return sum(len(verdict.answers[code].faults) for verdict in group)


def line_of(group: list[Verdict], code: str) -> str:
    """One room over its seeds, with the first fault of the first."""
    first = group[0]
    place, fault = first.place, first.answers[code].faults[0]
    pieces = f" ({', '.join(fault.pieces[:5])})" if fault.pieces else ""
    seeds = f"seed {place.seed}" if len(group) == 1 else f"{seeds_of(group)}, {place.seed} first"
    more = len(first.answers[code].faults) - 1
    return f"{named(first)}, {seeds}: {fault.note}{pieces}" + (f", and {more} more" if more else "")


def named(verdict: Verdict) -> str:
    place = verdict.place
    return f"{place.building}/{place.level}/{place.room} {place.kind} {verdict.area:.1f} m²"


def seeds_of(group: list[Verdict]) -> str:
    return "1 seed" if len(group) == 1 else f"{len(group)} seeds"
