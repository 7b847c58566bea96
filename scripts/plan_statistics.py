#!/usr/bin/env python3
"""Measures planned buildings beside real ones: plan_statistics.py --planned FOLDER... --real FOLDER...

--planned names folders that `roomwright plan` wrote, --real folders of plans that `roomwright import` made of real ones.
Prints a row for each measure: how many values there are of both, their 5 %, 50 % and 95 % quantiles, and the distance of the
two distributions (Kolmogorov and Smirnov's two-sample statistic: 0 alike, 1 apart). --json and --out write the same as JSON.

Needs scripts/requirements.txt. Exit 0: measured. 1: some plans could not be read. 2: nothing could start.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path

import in_project

from roomwright import environment

environment.require(environment.PLANS, __name__)

from planned.plan import plans_in
from planned.statistics import Samples, compare, samples_of_file, together
from roomwright.workers import outcomes

# Distances up to here count as alike: with hundreds of values a side, samples of one kind of building differ by half of it.
ALIKE = 0.25


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--planned", nargs="+", type=Path, required=True, metavar="FOLDER")
    parser.add_argument("--real", nargs="+", type=Path, required=True, metavar="FOLDER")
    parser.add_argument("--report", type=Path, metavar="FILE", help="the report that `roomwright plan --report` wrote, for --kind")
    parser.add_argument("--kind", action="append", metavar="NAME", help="measure planned buildings of this kind only; may be repeated")
    parser.add_argument("--out", type=Path, metavar="FILE", help="also write the rows as JSON into a file")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(arguments)
    if options.kind and not options.report:
        parser.error("--kind needs --report")
    return options


def files_in(folders: list[Path], wanted: set[str] | None = None) -> list[Path]:
    """The plans of folders; `wanted` are names of files without their extension."""
    files = []
    for folder in folders:
        if not folder.is_dir():
            raise FileNotFoundError(f"{folder} is no folder")
        files += [placed.file for placed in plans_in(folder) if wanted is None or placed.file.stem in wanted]
    if not files:
        raise FileNotFoundError(f"there is no plan in {', '.join(map(str, folders))}")
    return files


def wanted_ids(options: argparse.Namespace) -> set[str] | None:
    if not options.kind:
        return None
    buildings = json.loads(options.report.read_text(encoding="utf-8"))["buildings"]
    return {building["id"] for building in buildings if building["typology"] in options.kind}


def measure(files: list[Path], jobs: int) -> tuple[Samples, list[str]]:
    """All values of all plans, and a line for each plan that could not be read."""
    samples, failures = [], []
    for file, outcome in zip(files, outcomes(samples_of_file, files, jobs)):
        if isinstance(outcome, Exception):
            failures.append(f"{file}: {type(outcome).__name__}: {outcome}")
        else:
            samples.append(outcome)
    return together(samples), failures


def table(rows: list[dict]) -> str:
    lines = [f"{'measure':<18} {'planned n':>9} {'5/50/95 %':>20} {'real n':>7} {'5/50/95 %':>20} {'distance':>8}"]
    for row in rows:
        distance = "-" if row["distance"] is None else f"{row['distance']:.2f}"
        lines.append(f"{row['measure']:<18} {row['planned']['count']:>9} {quantiles(row['planned']):>20} "
                     f"{row['real']['count']:>7} {quantiles(row['real']):>20} {distance:>8}")
        if row.get("planned_rectangles") is not None and row["real_rectangles"] is not None:
            lines.append(f"{'  rectangles':<18} {row['planned_rectangles']:>30.0%} {row['real_rectangles']:>28.0%}")
    known = [row["distance"] for row in rows if row["distance"] is not None]
    lines.append(f"{sum(distance <= ALIKE for distance in known)} of {len(known)} measures within {ALIKE}")
    return "\n".join(lines)


def quantiles(spread: dict) -> str:
    return "-" if spread["quantiles"] is None else " / ".join(f"{value:.3g}" for value in spread["quantiles"])


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        planned_files, real_files = files_in(options.planned, wanted_ids(options)), files_in(options.real)
    except (OSError, ValueError, KeyError, TypeError) as error:
        print(f"plan_statistics: {error}", file=sys.stderr)
        return 2
    planned, failures = measure(planned_files, options.jobs)
    real, others = measure(real_files, options.jobs)
    for failure in failures + others:
        print(f"plan_statistics: {failure}", file=sys.stderr)
    rows = compare(planned, real)
    text = json.dumps({"planned": len(planned_files), "real": len(real_files), "measures": rows}, indent=1)
    if options.out is not None:
        options.out.write_text(text + "\n", encoding="utf-8")
    print(text if options.json else table(rows))
    return 1 if failures or others else 0


if __name__ == "__main__":
    sys.exit(main())
