#!/usr/bin/env python3
"""Measures what rooms cost by their type, for cluster.py to cut work by: measure_costs.py PLAN... [--program FILE] [--write]

Bakes every PLAN several times on one thread and takes the processor time of each level from the system when the level is
reported. The costs of the types are those that explain the levels best (least squares, none below zero); the cost of a level
without rooms is one of them. Types with fewer than 5 rooms share the mean cost of a room. Linux only. --write puts the table
into python/roomwright/distributed/costs.json; without it, it is printed.

Exit 0: measured. 2: a plan could not be baked.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import in_project

from roomwright.distributed.failure import Failure
from roomwright.distributed.listing import list_levels
from roomwright.distributed.program import find_program

TABLE = Path(__file__).resolve().parents[1] / "python" / "roomwright" / "distributed" / "costs.json"
RUNS = 3
# Rooms of a type below which its cost is not told from those of the rooms beside it.
LEAST_ROOMS = 5
ROUNDS = 500
# Rooms that come in pairs, such as a bedroom and its bath, are not told apart by levels: without this, one takes the cost of both.
PRIOR = 0.3


def processor_seconds(process: int) -> float:
    """What all threads of a process have run so far; nanoseconds, while `/proc/<id>/stat` counts hundredths."""
    tasks = Path(f"/proc/{process}/task").iterdir()
    return sum(int((task / "schedstat").read_text().split()[0]) for task in tasks) / 1e9


def level_seconds(program: Path, plan: str, options: list[str]) -> dict[tuple[str, str], float]:
    """Processor time of each level of one bake."""
    seconds, before = {}, None
    with tempfile.TemporaryDirectory(prefix="roomwright-costs-") as out:
        command = [str(program), "bake", plan, *options, "--out", f"{out}/out", "--threads", "1", "--progress", "json", "--quiet"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        for line in process.stderr:
            event = json.loads(line) if line.startswith("{") else {}
            if event.get("event") not in ("started", "baked"):
                continue
            now = processor_seconds(process.pid)
            # Textures are painted between the start and the first level, which therefore is not counted.
            if event["event"] == "baked" and before is not None:
                seconds[event["building"], event["level"]] = now - before
            before = now if event["event"] == "baked" else None
        if process.wait() not in (0, 1):
            raise Failure(f"{plan} could not be baked")
    return seconds


def least_squares(rows: list[dict[str, float]], targets: list[float]) -> dict[str, float]:
    """Non-negative costs of the columns, by coordinate descent; each is drawn to the mean as by a few rooms of that cost."""
    columns = sorted({name for row in rows for name in row})
    mean = sum(targets) / max(1e-9, sum(sum(row.values()) for row in rows))
    costs = dict.fromkeys(columns, 0.0)
    residuals = list(targets)
    users = {name: [(index, row[name]) for index, row in enumerate(rows) if name in row] for name in columns}
    for _ in range(ROUNDS):
        for name, used in users.items():
            weight = sum(count * count for _, count in used)
            pull = sum(residuals[index] * count for index, count in used) + PRIOR * (mean - costs[name])
            better = max(0.0, costs[name] + pull / (weight + PRIOR))
            for index, count in used:
                residuals[index] -= (better - costs[name]) * count
            costs[name] = better
    return costs


def table(levels: list[tuple[dict, float]]) -> dict:
    """The costs of levels, each with its rooms by type and its milliseconds."""
    count: dict[str, int] = {}
    for rooms, _ in levels:
        for kind, number in rooms.items():
            count[kind] = count.get(kind, 0) + number
    known = {kind for kind, number in count.items() if number >= LEAST_ROOMS}
    rows = []
    for rooms, _ in levels:
        row = {"": 1.0}
        for kind, number in rooms.items():
            name = kind if kind in known else "other"
            row[name] = row.get(name, 0.0) + number
        rows.append(row)
    # Large levels vary more: weighted so, they count by their number of rooms, not by its square.
    weights = [max(1.0, milliseconds) ** -0.5 for _, milliseconds in levels]
    weighted = [{name: number * weight for name, number in row.items()} for row, weight in zip(rows, weights)]
    costs = least_squares(weighted, [milliseconds * weight for (_, milliseconds), weight in zip(levels, weights)])
    told = {kind: costs[kind] for kind in sorted(known)}
    all_rooms = sum(count[kind] for kind in known)
    mean = sum(told[kind] * count[kind] for kind in known) / max(1, all_rooms)
    residual = sum(abs(milliseconds - sum(costs[name] * number for name, number in row.items()))
                   for row, (_, milliseconds) in zip(rows, levels))
    share = residual / sum(milliseconds for _, milliseconds in levels)
    return {"about": f"Milliseconds of processor time on one thread, measured by measure_costs.py: {sum(count.values())} rooms on "
                     f"{len(levels)} levels; a level differs by {share:.0%} from its sum on average.",
            "level": round(costs[""], 1), "other": round(mean, 1), "rooms": {kind: round(cost, 1) for kind, cost in told.items()}}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plans", nargs="+", metavar="PLAN")
    parser.add_argument("--program", help="the program roomwright (default: ROOMWRIGHT_PROGRAM, then the PATH)")
    parser.add_argument("--write", action="store_true", help="write distributed/costs.json")
    options = parser.parse_args()
    levels = []
    try:
        program = find_program(options.program)
        for plan in options.plans:
            listed = list_levels(program, [plan])
            runs = [level_seconds(program, plan, []) for _ in range(RUNS)]
            for level in listed["levels"]:
                found = [run[level["building"], level["level"]] for run in runs if (level["building"], level["level"]) in run]
                if found:
                    # A line that is read late adds to one level what it takes from the next: the mean evens it out.
                    levels.append((level["rooms"], 1000 * sum(found) / len(found)))
    except Failure as failure:
        print(f"measure_costs: {failure}", file=sys.stderr)
        return 2
    text = json.dumps(table(levels), indent=1) + "\n"
    if options.write:
        TABLE.write_text(text, encoding="utf-8")
    print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
