"""Measures what cluster.py costs beside one bake of the same plans: processor time and seconds, by turns.

    python tests/scripts/cluster_overhead.py PLANS... [--runs 3] [-- OPTIONS OF BAKE]

Each run begins without caches and ends with the same manifest. The processor time is that of all processes: of cluster.py with its
units, and of `bake --threads 2`. The program is that of ROOMWRIGHT_PROGRAM. Linux and macOS.
"""

from __future__ import annotations

import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "cluster.py"
WORKERS = "2"


def measured(command: list[str], folder: Path) -> tuple[float, float]:
    """Processor time of a command and all that it waited for, and its seconds."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    # What an earlier run wrote is on the disk before the next begins.
    os.sync()
    before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    with (folder / "log").open("w") as log:
        subprocess.run(command, check=True, stdout=log, stderr=log,
                       env={**os.environ, "ROOMWRIGHT_CLUSTER_FOLDER": str(folder / "node")})
    seconds, after = time.monotonic() - started, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, seconds


def main(arguments: list[str]) -> int:
    options = arguments[arguments.index("--") + 1:] if "--" in arguments else []
    plans = arguments[: arguments.index("--")] if "--" in arguments else arguments
    runs = 3
    if "--runs" in plans:
        at = plans.index("--runs")
        runs, plans = int(plans[at + 1]), plans[:at] + plans[at + 2:]
    found: dict[str, list[tuple[float, float]]] = {"one bake": [], "cluster.py": []}
    with tempfile.TemporaryDirectory(prefix="roomwright-overhead-", dir=os.environ.get("TMPDIR")) as scratch:
        one, many = Path(scratch) / "one", Path(scratch) / "many"
        for run in range(runs):
            found["one bake"].append(measured(
                [os.environ["ROOMWRIGHT_PROGRAM"], "bake", *plans, "--out", str(one / "out"), "--threads", WORKERS,
                 "--cache", str(one / "cache"), "--quiet", *options], one))
            manifest = (one / "out" / "manifest.json").read_bytes()
            shutil.rmtree(one)
            found["cluster.py"].append(measured(
                [sys.executable, str(SCRIPT), "bake", *plans, "--to", str(many / "out"), "--workers", WORKERS, "--", *options], many))
            if (many / "out" / "manifest.json").read_bytes() != manifest:
                raise SystemExit("the manifests differ")
            print((many / "log").read_text(), file=sys.stderr)
            for name, figures in found.items():
                print(f"run {run + 1}, {name}: {figures[-1][0]:.1f} s of processor time, {figures[-1][1]:.1f} s", flush=True)
    medians = {name: [statistics.median(values) for values in zip(*figures)] for name, figures in found.items()}
    (one_work, one_seconds), (work, seconds) = medians.values()
    print(f"medians: processor time {work / one_work - 1:+.1%} ({one_work:.1f} to {work:.1f} s), "
          f"seconds {seconds / one_seconds - 1:+.1%} ({one_seconds:.1f} to {seconds:.1f} s)")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
