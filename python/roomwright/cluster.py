"""Bakes a city on many processors or machines, into a folder or a store of objects.

    python scripts/cluster.py bake plans/ --to out                       all processors of this machine
    python scripts/cluster.py bake plans/ --to s3://bucket/city --ray    a Ray cluster; --address names one elsewhere
    python scripts/cluster.py prepare plans/ --to s3://bucket/city       the job alone, for schedulers of other kinds
    python scripts/cluster.py unit s3://bucket/city 17                   one unit, as Slurm, Kubernetes and AWS Batch call it
    python scripts/cluster.py status s3://bucket/city                    how far it is, asked on any machine
    python scripts/cluster.py merge s3://bucket/city                     joins the records of all units into manifest.json

Options of `roomwright bake` follow after `--`: ... --to out -- --seed 7 --textures none

The work is cut into units, each a `bake --shard I/N`. A second run does what is missing. The manifest has the bytes that a
single bake would have written. Ends with 0 if all is done, 1 if levels or units failed, 2 if nothing could start.
docs/cluster.md has the rest.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

from .distributed import local, on_ray
from .distributed import job as jobs
from .distributed.failure import Failure
from .distributed.inputs import Inputs, pack, unpack
from .distributed.job import Job
from .distributed.listing import Division, check_packed, list_levels, room_count
from .distributed.node import cache_of
from .distributed.program import find_program
from .distributed.progress import Progress, done_units, status
from .distributed.report import merge, summary
from .distributed.sizing import cut, cut_into, measure, read_costs
from .distributed.store import digest, open_store
from .distributed.unit import FAILED, FLAWED, KEPT, Outcome, run_unit

DONE, SOME_FAILED, NOT_STARTED = 0, 1, 2


def prepare(options: argparse.Namespace, workers: int) -> Job:
    """The job in the store: the one that is there, or a new one."""
    bake_options = options.bake_options
    jobs.check_options(bake_options)
    program = find_program(options.program)
    typed = [*options.plans, *flagged("--catalog", options.catalog), *flagged("--edits", options.edits)]
    listed = list_levels(program, [*typed, *bake_options])
    without = None if "://" in options.to else Path(options.to).resolve()
    inputs = pack(options.plans, options.catalog, options.edits, [*listed["sources"], *options.including], without)
    store = open_store(options.to)
    found = jobs.read_job(store)
    division = Division(listed, []) if found is not None else divide(program, inputs, listed, options, workers)
    job = jobs.agree(store, jobs.new_job(program, inputs, bake_options, division), program, inputs, division)
    if options.units not in (None, job.units):
        raise Failure(f"the job in the store has {job.units} units; its number cannot be changed")
    return job


def flagged(flag: str, values: list[str]) -> list[str]:
    return [word for value in values for word in (flag, value)]


def divide(program: Path, inputs: Inputs, listed: dict, options: argparse.Namespace, workers: int) -> Division:
    """The levels cut into units by their cost, from the plans as the machines will unpack them."""
    levels, costs = listed["levels"], read_costs()
    with tempfile.TemporaryDirectory(prefix="roomwright-job-") as folder:
        unpack(inputs.archive, Path(folder))
        check_packed(program, listed, inputs, options.bake_options, Path(folder))
        if options.units is not None:
            return Division(listed, cut_into([costs.of(level) for level in levels], options.units))
        arguments = [*inputs.arguments, *options.bake_options]
        # The units of this machine find the textures and models of the sample.
        sample = measure(program, Path(folder), arguments, listed, cache_of(digest(program, "sha256")))
    units = cut([costs.of(level) * sample.scale for level in levels], workers, sample.start_seconds)
    total = sum(map(costs.of, levels)) * sample.scale
    print(f"{room_count(levels)} rooms on {len(levels)} levels at {1000 * total / max(1, room_count(levels)):.1f} ms (measured with "
          f"{sample.rooms} rooms), {sample.start_seconds:.2f} s for a unit to start: {len(units)} units", file=sys.stderr)
    return Division(listed, units)


def bake(options: argparse.Namespace) -> int:
    """All units that are missing, then the manifest."""
    started = time.monotonic()
    is_ray = options.ray or options.address is not None
    ray = on_ray.connect(options.address) if is_ray else None
    workers = options.workers or (on_ray.processors(ray) if is_ray else os.cpu_count() or 1)
    job, store = prepare(options, workers), open_store(options.to)
    url = options.to if "://" in options.to else str(Path(options.to).resolve())
    done = done_units(store, job)
    missing = [unit for unit in range(1, job.units + 1) if unit not in done]
    progress = Progress(job.units, len(done))
    outcomes = [Outcome(unit, KEPT) for unit in sorted(done)]
    attempts: dict[int, int] = {}
    while missing:
        results = (on_ray.outcomes(ray, url, options.threads, missing) if is_ray else
                   local.outcomes(lambda unit: run_unit(url, unit, options.threads), missing, workers))
        missing = []
        for unit, result in results:
            outcome = result if isinstance(result, Outcome) else Outcome(unit, FAILED, message=str(result))
            attempts[unit] = attempts.get(unit, 0) + 1
            if outcome.kind == FAILED and attempts[unit] < options.attempts:
                # At the end of all others: a machine in trouble has time to recover.
                missing.append(unit)
                continue
            outcomes.append(outcome)
            progress.failed += outcome.kind == FAILED
            progress.done += outcome.kind != FAILED
            progress.show()
    progress.show(is_last=True)
    print(summary(outcomes, sum(attempts.values()) - len(attempts), time.monotonic() - started))
    return finish(options, job, outcomes)


def finish(options: argparse.Namespace, job: Job, outcomes: list[Outcome]) -> int:
    """The manifest, if all units are there."""
    if any(outcome.kind == FAILED for outcome in outcomes):
        print("the manifest is not written: run the same command again for the units that are missing", file=sys.stderr)
        return SOME_FAILED
    store = open_store(options.to)
    are_all_kept = all(outcome.kind == KEPT for outcome in outcomes)
    if not (are_all_kept and store.has("manifest.json")):
        totals = merge(store, job, find_program(options.program))
        print(f"{options.to}/manifest.json: {totals['rooms']} rooms, {totals['placed']} objects")
    return SOME_FAILED if store.list(jobs.FLAWED) else DONE


def known_job(url: str) -> Job:
    job = jobs.read_job(open_store(url))
    if job is None:
        raise Failure(f"{url} holds no job")
    return job


def do_prepare(options: argparse.Namespace) -> int:
    job = prepare(options, options.workers or os.cpu_count() or 1)
    # The number of units alone on standard output: scripts pass it to their schedulers.
    print(job.units)
    return DONE


def do_unit(options: argparse.Namespace) -> int:
    for _ in range(options.attempts):
        outcome = run_unit(options.store, options.unit, options.threads)
        if outcome.kind != FAILED:
            break
    print(f"unit {outcome.unit} {outcome.kind} {outcome.message}".rstrip())
    # A flawed unit is done: schedulers would repeat it in vain.
    return NOT_STARTED if outcome.kind == FAILED else DONE


def do_status(options: argparse.Namespace) -> int:
    print(status(open_store(options.store), known_job(options.store)))
    return DONE


def do_merge(options: argparse.Namespace) -> int:
    store, job = open_store(options.store), known_job(options.store)
    totals = merge(store, job, find_program(options.program))
    print(f"{options.store}/manifest.json: {totals['rooms']} rooms, {totals['placed']} objects")
    return SOME_FAILED if store.list(jobs.FLAWED) else DONE


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = top.add_subparsers(required=True)

    def add(name: str, action, about: str) -> argparse.ArgumentParser:
        command = commands.add_parser(name, help=about, description=about)
        command.set_defaults(action=action)
        if name != "unit" and name != "status":
            command.add_argument("--program", help="the program roomwright (default: ROOMWRIGHT_PROGRAM, then the PATH)")
        if name in ("bake", "unit"):
            command.add_argument("--threads", type=int, default=1, help="threads of each unit (default 1)")
            command.add_argument("--attempts", type=int, default=3, help="attempts for a unit whose bake fails (default 3)")
        if name in ("unit", "status", "merge"):
            command.add_argument("store", help="folder or URL that --to named")
        return command

    for name, action, about in (("bake", bake, "bakes everything that is missing, and joins the records"),
                                ("prepare", do_prepare, "puts the job into the store; prints the number of units")):
        command = add(name, action, about)
        command.add_argument("plans", nargs="+", help="plans, folders, projects")
        command.add_argument("--to", required=True, metavar="FOLDER|URL", help="where levels, records and manifest go")
        command.add_argument("--catalog", action="append", default=[], metavar="DIR", help="folder of configuration")
        command.add_argument("--edits", action="append", default=[], metavar="FILE", help="further edits")
        command.add_argument("--including", action="append", default=[], metavar="PATH",
                             help="further files that the plans need, packed at their places (default: all that the program says it reads)")
        command.add_argument("--units", type=int, help="number of units (default: by measured cost)")
        command.add_argument("--workers", type=int, help="units at the same time (default: one for each processor)")
    command = commands.choices["bake"]
    command.add_argument("--ray", action="store_true", help="run the units as tasks of Ray")
    command.add_argument("--address", help="address of a Ray cluster, such as auto; implies --ray")
    add("unit", do_unit, "does one unit").add_argument("unit", type=int, help="which, from 1")
    add("status", do_status, "says how far the job is")
    add("merge", do_merge, "joins the records of all units")
    return top


def main(arguments: list[str] | None = None) -> int:
    arguments = sys.argv[1:] if arguments is None else arguments
    own, options = arguments, []
    if "--" in arguments:
        at = arguments.index("--")
        own, options = arguments[:at], arguments[at + 1:]
    parsed = parser().parse_args(own)
    parsed.bake_options = options
    for name in ("units", "workers", "threads", "attempts"):
        if (number := getattr(parsed, name, None)) is not None and number < 1:
            print(f"cluster: --{name} is at least 1", file=sys.stderr)
            return NOT_STARTED
    try:
        return parsed.action(parsed)
    except (Failure, OSError) as failure:
        print(f"cluster: {failure}", file=sys.stderr)
        return NOT_STARTED


if __name__ == "__main__":
    sys.exit(main())
