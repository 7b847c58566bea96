"""Measures what cluster.py costs beside one bake of the same plans: processor time and seconds, by turns.

    python tests/scripts/cluster_overhead.py PLANS... [--runs 3] [-- OPTIONS OF BAKE]

Each run begins without caches and ends with the same manifest. The processor time is that of all processes: of cluster.py with its
units, and of `bake --threads 2`. The program is that of ROOMWRIGHT_PROGRAM. Linux and macOS.
"""

from __future__ import annotations

import os
import shutil
import statistics
import sys
import tempfile
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
from measuring import Measured, measured  # noqa: E402

WORKERS = "2"


def run(command: list[str], folder: Path) -> Measured:
    """A command that begins without caches."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    # What an earlier run wrote is on the disk before the next begins.
    os.sync()
    found = measured(command, {**os.environ, "ROOMWRIGHT_CLUSTER_FOLDER": str(folder / "node")})
    if found.code:
        raise SystemExit(f"{command[0]} ended with {found.code}: {found.stderr[-1000:]}")
    return found


def main(arguments: list[str]) -> int:
    options = arguments[arguments.index("--") + 1:] if "--" in arguments else []
    plans = arguments[: arguments.index("--")] if "--" in arguments else arguments
    runs = 3
    if "--runs" in plans:
        at = plans.index("--runs")
        runs, plans = int(plans[at + 1]), plans[:at] + plans[at + 2:]
    found: dict[str, list[Measured]] = {"one bake": [], "cluster.py": []}
    with tempfile.TemporaryDirectory(prefix="roomwright-overhead-", dir=os.environ.get("TMPDIR")) as scratch:
        one, many = Path(scratch) / "one", Path(scratch) / "many"
        for number in range(runs):
            found["one bake"].append(run(
                [os.environ["ROOMWRIGHT_PROGRAM"], "bake", *plans, "--out", str(one / "out"), "--threads", WORKERS,
                 "--cache", str(one / "cache"), "--quiet", *options], one))
            manifest = (one / "out" / "manifest.json").read_bytes()
            shutil.rmtree(one)
            found["cluster.py"].append(run(
                [sys.executable, str(SCRIPTS / "cluster.py"), "bake", *plans, "--to", str(many / "out"), "--workers", WORKERS, "--", *options], many))
            if (many / "out" / "manifest.json").read_bytes() != manifest:
                raise SystemExit("the manifests differ")
            print(found["cluster.py"][-1].stderr, file=sys.stderr)
            for name, figures in found.items():
                print(f"run {number + 1}, {name}: {figures[-1].processor_seconds:.1f} s of processor time, {figures[-1].seconds:.1f} s", flush=True)
    one_work, work = (statistics.median(run.processor_seconds for run in figures) for figures in found.values())
    one_seconds, seconds = (statistics.median(run.seconds for run in figures) for figures in found.values())
    print(f"medians: processor time {work / one_work - 1:+.1%} ({one_work:.1f} to {work:.1f} s), "
          f"seconds {seconds / one_seconds - 1:+.1%} ({one_seconds:.1f} to {seconds:.1f} s)")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
