#!/usr/bin/env python3
"""Measures the tables of speed and size of docs/figures.md on this machine, and prints them as Markdown.

    python3 scripts/benchmark.py [--rooms 100000] [--skip-layout] [--folder DIR]

Builds the release program, measures the layout of the paper's two rooms with the criterion bench, bakes a city
with one and two threads, bakes it again with nothing changed, bakes a tenth of it, and writes the same bytes
plainly. Needs about 6 GB of disk for 100,000 rooms and nothing but Python's standard library. Measure on an idle
machine; the first line of the table says how busy it was.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from measuring import measured

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "target" / "release" / "roomwright"
ROOMS_PER_TOWER = 1000
STAGES = ["layout", "audit", "scene", "encoding", "writing"]


def fail(message):
    sys.exit(f"benchmark: {message}")


def build():
    if subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=ROOT).returncode:
        fail("the program does not build")


def measure(*arguments):
    """What a run cost, and its last event."""
    run = measured([PROGRAM, *arguments])
    if run.code:
        fail(f"{arguments} ended with {run.code}:\n{run.stderr[-2000:]}")
    events = [json.loads(line) for line in run.stderr.splitlines() if line.startswith("{")]
    return run, next((event for event in events if event["event"] == "finished"), None)


def write_city(folder, rooms):
    """A project of hotel towers, each with seeds of its own."""
    towers = max(1, rooms // ROOMS_PER_TOWER)
    tower = ROOT / "configs" / "plans" / "hotel-tower.yaml"
    path = folder / f"city-{rooms}.yaml"
    path.write_text(
        "version: 1\nproject:\n  name: City\n  plans:\n"
        f'    - {{plan: "{tower}", id: "tower-{{n:03}}", count: {towers}, columns: 10, step: [100, 40]}}\n'
    )
    return path


def bake(project, out, threads):
    return measure("bake", project, "--out", out, "--threads", threads, "--progress", "json", "--quiet")


def write_plainly(source, target):
    """Seconds to write the files of `source` anew, one write each, from memory already read."""
    seconds = 0.0
    for path in sorted(path for path in source.rglob("*") if path.is_file()):
        content = path.read_bytes()
        copy = target / path.relative_to(source)
        start = time.monotonic()
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(content)
        seconds += time.monotonic() - start
    return seconds


def layout_figures():
    """Median milliseconds and objects that rest, by plan, from the criterion bench."""
    run = subprocess.run(["cargo", "bench", "--bench", "layout", "--", "layout/"], cwd=ROOT,
                         capture_output=True, text=True)
    if run.returncode:
        fail(f"the layout bench fails:\n{run.stderr[-2000:]}")
    scale = {"ns": 1e-6, "µs": 1e-3, "us": 1e-3, "ms": 1.0, "s": 1e3}
    medians = {}
    pattern = r"layout/(\w+)\.yaml\s+time:\s+\[\S+ \S+ (\S+) (\S+) \S+ \S+\]"
    for name, value, unit in re.findall(pattern, run.stdout):
        medians[name] = float(value) * scale[unit]
    rest = {name: float(count) for name, count in re.findall(r"(\w+)\.yaml: ([\d.]+) objects rest", run.stderr)}
    return {name: (medians[name], rest.get(name)) for name in medians}


def megabytes(count):
    return f"{count / 1e6:.0f} MB"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rooms", type=int, default=100_000, help="rooms of the large city (default 100000)")
    parser.add_argument("--skip-layout", action="store_true", help="do not run the layout bench")
    parser.add_argument("--folder", type=Path, help="where to write (default: the system's temporary folder)")
    options = parser.parse_args()
    load = os.getloadavg()[0]
    build()
    rows = [("processors, load before", f"{os.cpu_count()}, {load:.1f}", "")]
    if not options.skip_layout:
        targets = {"office": "≤ 0.25 ms, ≥ 24.9 rest", "restaurant": "≤ 5 ms, ≥ 280 rest"}
        for name, (milliseconds, rest) in layout_figures().items():
            shown = f"{milliseconds:.3f} ms" + (f", {rest:.1f} rest" if rest else "")
            rows.append((f"layout of {name}, one thread", shown, targets.get(name, "")))

    work = Path(tempfile.mkdtemp(prefix="roomwright-benchmark-", dir=options.folder))
    try:
        rows += city_figures(work, options.rooms)
    finally:
        shutil.rmtree(work, ignore_errors=True)
    print("| figure | measured | wanted |\n|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


def city_figures(work, rooms):
    small_rooms = max(ROOMS_PER_TOWER, rooms // 10)
    large, small = write_city(work, rooms), write_city(work, small_rooms)

    one, _ = bake(large, work / "one", 1)
    shutil.rmtree(work / "one")
    two, finished = bake(large, work / "two", 2)
    again, kept = bake(large, work / "two", 2)
    if kept["levels"]:
        fail("the second run baked something")
    plainly = write_plainly(work / "two", work / "copy")
    size = sum(path.stat().st_size for path in (work / "two").rglob("*") if path.is_file())
    shutil.rmtree(work / "copy")
    shutil.rmtree(work / "two")
    little, small_finished = bake(small, work / "small", 2)

    baked = finished["rooms"]
    stages = finished["stage_seconds"]
    work_seconds = sum(stages[stage] for stage in STAGES)
    split = ", ".join(f"{stage} {100 * stages[stage] / work_seconds:.0f} %" for stage in STAGES)
    return [
        (f"city of {baked:,} rooms, 2 threads", f"{baked / two.seconds:,.0f} rooms/s ({two.seconds:.1f} s)",
         "≥ 3,000 rooms/s"),
        ("the same, 1 thread", f"{baked / one.seconds:,.0f} rooms/s ({one.seconds:.1f} s)", ""),
        ("2 threads against 1", f"{one.seconds / two.seconds:.2f} ×", "≥ 1.8 ×"),
        ("second run, nothing changed", f"{again.seconds:.2f} s, {two.seconds / again.seconds:.0f} × faster",
         "≥ 50 ×"),
        ("peak memory", f"{megabytes(two.peak_bytes)}", "≤ 300 MB"),
        (f"peak memory, {small_finished['rooms']:,} rooms", megabytes(little.peak_bytes), "the same"),
        ("processor time of the bake", f"{two.processor_seconds:.1f} s", ""),
        ("where the time goes", split, ""),
        (f"the same {size / 1e9:.2f} GB written plainly", f"{plainly:.1f} s, {two.seconds / plainly:.1f} × less", ""),
    ]


if __name__ == "__main__":
    main()
