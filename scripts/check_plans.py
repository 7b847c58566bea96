#!/usr/bin/env python3
"""Checks plans that `roomwright plan` wrote: check_plans.py [options] FOLDER...

A FOLDER holds project.yaml and the plans that it places; without project.yaml, every plan in it is checked by itself. The
checks share no code and no table with Roomwright: they measure the rooms with shapely, and know what a room is for from its
type's name alone. What a storey encloses is found from its rooms; neighbours are the other buildings of the project.

Prints a row for each kind of fault, with faults, buildings that have them and the worst ones. --report adds the area of the
outlines, and the kinds and ways of planning of the buildings with faults.

Needs scripts/requirements.txt. Exit 0: no fault. 1: faults, or plans that could not be read. 2: nothing could start.
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

environment.require(environment.PLANS, __name__)

from tqdm import tqdm

from planned.check import Checked, Task, check_plan
from planned.neighbours import neighbour_faults
from planned.plan import plans_in
from planned.report import as_json, as_text
from planned.table import FAULTS
from roomwright.workers import outcomes


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path, metavar="FOLDER")
    parser.add_argument("--report", type=Path, metavar="FILE", help="the report that `roomwright plan --report` wrote")
    parser.add_argument("--worst", type=int, default=3, metavar="N", help="list N faults of each kind, of N buildings (default: 3)")
    parser.add_argument("--code", action="append", metavar="CODE", choices=sorted(FAULTS), help="only these; may be repeated")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (default: one a core)")
    parser.add_argument("--json", action="store_true", help="write one JSON document instead of text")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    return parser.parse_args(arguments)


def tasks_in(folders: list[Path], reported: dict[str, dict]) -> list[Task]:
    """The plans to check, each with the area of its outline; the name of a file may differ from its building's id."""
    tasks = []
    for folder in folders:
        if not folder.is_dir():
            raise FileNotFoundError(f"{folder} is no folder")
        tasks += [Task(placed, reported.get(placed.file.stem, {}).get("area")) for placed in plans_in(folder)]
    return tasks


def read_report(path: Path | None) -> dict[str, dict]:
    if path is None:
        return {}
    return {building["id"]: building for building in json.loads(path.read_text(encoding="utf-8"))["buildings"]}


def check_plans(tasks: list[Task], jobs: int, is_quiet: bool) -> tuple[list[Checked], list[str]]:
    """The checked buildings, and a line for each plan that could not be read."""
    checked, failures = [], []
    with tqdm(total=len(tasks), desc="check", unit=" plans", disable=is_quiet or None) as progress:
        for task, outcome in zip(tasks, outcomes(check_plan, tasks, jobs)):
            if isinstance(outcome, Exception):
                failures.append(f"{task.placed.file}: {type(outcome).__name__}: {outcome}")
            else:
                checked.append(outcome)
            progress.update()
    return checked, failures


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        reported = read_report(options.report)
        tasks = tasks_in(options.folders, reported)
    except (OSError, ValueError, KeyError, TypeError) as error:
        print(f"check_plans: {error}", file=sys.stderr)
        return 2
    if not tasks:
        print("check_plans: there is no plan", file=sys.stderr)
        return 2
    started = time.monotonic()
    checked, failures = check_plans(tasks, options.jobs, options.quiet)
    for failure in failures:
        print(f"check_plans: {failure}", file=sys.stderr)
    faults = [fault for building in checked for fault in building.faults] + neighbour_faults(checked)
    faults = [fault for fault in faults if not options.code or fault.code in options.code]
    print(as_json(checked, faults, reported) if options.json else as_text(checked, faults, reported, options.worst))
    if not options.quiet:
        print(f"check_plans: {len(tasks)} plans in {time.monotonic() - started:.0f} s", file=sys.stderr)
    return 1 if failures or faults else 0


if __name__ == "__main__":
    # Names of files and rooms may have what the terminal's encoding has not.
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(main())
