#!/usr/bin/env python3
"""Judges the rooms of finished files by their meshes: judge.py [options] FOLDER|FILE...

An independent second opinion to `roomwright audit`: it shares no code and no table with it, reads no catalogue, and knows
what a thing is from its class's name alone. docs/judge.md lists the measures with their limits and sources.

Prints one row a measure: rooms judged, rooms failing, their share, and the spread of the measured values. --worst lists the
rooms that fail, --compare adds how far the judge agrees with the findings that the files carry, --drawn compares kitchens
and baths with the architects' drawings of the same plans. FOLDERs of several seeds are judged together.

Needs scripts/requirements.txt. Exit 0: judged, whatever it found. 1: some files could not be read. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.TOOLS, __name__)

from tqdm import tqdm

from roomwright.checks.manifest import scenes_in
from judging.judgement import Task, Verdict, judge_file
from judging.report import (agreement_of, disagreements, given_lines, markdown, measures_table, rows_of, variety_of,
                            worst_rooms)
from judging.table import MEASURES, SUBJECTS
from roomwright.workers import outcomes


# Arrangements that a room should have.
LEAST_VARIETY = 3
# The line of a page below which its figures are.
FIGURES = "<!-- figures -->"


def judge_files(tasks: list[Task], jobs: int, is_quiet: bool) -> tuple[list[Verdict], list[str]]:
    """The verdicts, and a line for each file that could not be judged."""
    verdicts: list[Verdict] = []
    failures: list[str] = []
    with tqdm(total=len(tasks), desc="judge", unit=" files", disable=is_quiet or None) as progress:
        for task, outcome in zip(tasks, outcomes(judge_file, tasks, jobs)):
            if isinstance(outcome, Exception):
                failures.append(f"{task.file}: {type(outcome).__name__}: {outcome}")
            else:
                verdicts += outcome
            progress.update()
    return verdicts, failures


def files_in(paths: list[Path]) -> list[Path]:
    files: list[Path] = []
    for path in paths:
        if not path.exists():
            raise FileNotFoundError(f"{path} is not there")
        files += scenes_in(path) if path.is_dir() else [path]
    return files


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="*", type=Path, metavar="FOLDER|FILE")
    parser.add_argument("--list", action="store_true", help="print the table of measures, and judge nothing")
    parser.add_argument("--drawn", type=Path, metavar="FOLDER", help="folder with archilyse's drawings of the same plans")
    parser.add_argument("--compare", action="store_true", help="also the agreement with the audit's findings")
    parser.add_argument("--variety", action="store_true", help="also how many arrangements the seeds of a room have")
    parser.add_argument("--worst", type=int, default=0, metavar="N", help="also N rooms that fail, for each measure")
    parser.add_argument("--measure", action="append", metavar="CODE", choices=sorted(MEASURES),
                        help="list the worst rooms of this measure only; may be repeated")
    parser.add_argument("--page", type=Path, metavar="FILE", help=f"also put the tables into a page, below its line {FIGURES}")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--json", action="store_true", help="write one JSON document instead of tables")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    if options.list:
        print(measures_table())
        return 0
    try:
        files = files_in(options.paths)
    except OSError as error:
        print(f"judge: {error}", file=sys.stderr)
        return 2
    if not files:
        print("judge: there is no .glb or .gltf file", file=sys.stderr)
        return 2
    started = time.monotonic()
    verdicts, failures = judge_files([Task(file, options.drawn) for file in files], options.jobs, options.quiet)
    for failure in failures:
        print(f"judge: {failure}", file=sys.stderr)
    text = as_json(verdicts) if options.json else as_text(verdicts, options)
    print(text)
    if options.page is not None:
        write_figures(options.page, text)
    if not options.quiet:
        print(f"judge: {len(files)} files in {time.monotonic() - started:.0f} s", file=sys.stderr)
    return 1 if failures else 0


def write_figures(page: Path, text: str) -> None:
    head, mark, _ = page.read_text(encoding="utf-8").partition(FIGURES)
    page.write_text(f"{head}{mark or FIGURES}\n\n{text}\n", encoding="utf-8")


def as_text(verdicts: list[Verdict], options: argparse.Namespace) -> str:
    rooms, seeds = len(verdicts), len({verdict.place.seed for verdict in verdicts})
    blocks = [f"{rooms:,} furnished rooms, {seeds} seed{'' if seeds == 1 else 's'}. {flawless_rooms(verdicts)}", markdown(verdicts)]
    if options.compare:
        blocks.append(comparison(verdicts, options.worst))
        blocks.append(given(verdicts, options.worst))
    if options.variety:
        blocks.append(variety(verdicts))
    codes = options.measure or (MEASURES if options.worst else [])
    for code in codes:
        lines = worst_rooms(verdicts, code, options.worst or 10)
        if lines:
            blocks.append("\n".join([f"{code}:", *(f"- {line}" for line in lines)]))
    return "\n\n".join(blocks)


def flawless_rooms(verdicts: list[Verdict]) -> str:
    """How many rooms pass all measures but those of drawings, and how many the audit finds nothing in."""
    drawn = {measure.code for measure in SUBJECTS["Drawn fixtures"].MEASURES}
    judge = sum(not any(found.faults for code, found in verdict.answers.items() if code not in drawn) for verdict in verdicts)
    audit = sum(not verdict.audit for verdict in verdicts)
    rooms = max(len(verdicts), 1)
    return (f"No finding, drawings apart: {judge / rooms:.1%} of them by the judge, {audit / rooms:.1%} by the audit"
            ).replace("%", " %")


def comparison(verdicts: list[Verdict], most: int) -> str:
    lines = ["| measure | audit's code | both | only judge | only audit | of these given |", "|---|---|---|---|---|---|"]
    for measure in MEASURES.values():
        if measure.audit:
            found = agreement_of(verdicts, measure)
            lines.append(f"| `{found.code}` | `{measure.audit}` | {found.both} | {found.only_judge} | {found.only_audit} "
                         f"| {found.given} |")
    for measure in MEASURES.values():
        found = disagreements(verdicts, measure, most) if measure.audit else []
        lines += ["", f"{measure.code}, where the two differ:", *(f"- {line}" for line in found)] if found else []
    return "\n".join(lines)


def given(verdicts: list[Verdict], most: int) -> str:
    lines = given_lines(verdicts)
    rooms = len({verdict.place[:3] for verdict in verdicts})
    head = (f"Given by the plan, as the audit has it: a required piece is missing without a finding in {len(lines)} of {rooms} "
            f"rooms ({len(lines) / max(rooms, 1):.1%})").replace("%", " %")
    return "\n".join([head, *(f"- {line}" for line in lines[:most])])


def variety(verdicts: list[Verdict]) -> str:
    kinds = variety_of(verdicts)
    counts = [count for of_kind in kinds.values() for count in of_kind]
    seeds = len({verdict.place.seed for verdict in verdicts})
    rooms = max(len(counts), 1)
    head = (f"Variety: {varied(counts)} of {len(counts)} rooms ({varied(counts) / rooms:.0%}) have {LEAST_VARIETY} or more "
            f"arrangements in {seeds} seeds, mirrored ones counted once; a room has {sum(counts) / rooms:.1f} on average")
    # The types of which most rooms lack it first.
    lacking = sorted(kinds, key=lambda kind: (varied(kinds[kind]) - len(kinds[kind]), kind))
    lines = [f"| {kind} | {len(kinds[kind])} | {varied(kinds[kind])} | {varied(kinds[kind]) / len(kinds[kind]):.0%} |"
             for kind in lacking]
    table = ["| type | rooms | varied | share |", "|---|---|---|---|", *lines]
    return "\n".join([head, "", *table]).replace("%", " %")


def varied(counts: list[int]) -> int:
    return sum(count >= LEAST_VARIETY for count in counts)


def as_json(verdicts: list[Verdict]) -> str:
    rows = [row._asdict() for rows in rows_of(verdicts).values() for row in rows]
    agreements = [agreement_of(verdicts, measure)._asdict() for measure in MEASURES.values() if measure.audit]
    rooms = [{"place": verdict.place._asdict(), "code": code, "value": found.value,
              "faults": [fault._asdict() for fault in found.faults]}
             for verdict in verdicts for code, found in verdict.answers.items() if found.faults]
    return json.dumps({"rooms": len(verdicts), "measures": rows, "agreement": agreements, "failing": rooms}, indent=1)


if __name__ == "__main__":
    # Names of files and rooms may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(main())
