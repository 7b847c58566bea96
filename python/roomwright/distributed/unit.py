"""One share of the work: baked into a scratch folder, its files put into the store, its record last.

A unit is done if its record is there, and not before. A process that dies in between leaves files that no record names; the next
one writes the same bytes to the same names. So nothing is locked, and to do a unit twice does no harm.
"""

from __future__ import annotations

import json
import os
import socket
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from . import job as jobs
from .failure import Failure
from .job import Job
from .node import Node, prepare
from .program import ALL_DONE, SOME_FAILED, Ran, run
from .store import Store, digest, open_store

KEPT, BAKED, FLAWED, FAILED = "kept", "baked", "flawed", "failed"
# Files that are on their way to the store at the same time.
UPLOADS = 8
# Failures of a machine, not of a plan: on another machine the level can be made.
OF_MACHINE = {"disk_full", "no_rights", "write_failed", "no_threads", "wrong_kind"}


class Outcome(NamedTuple):
    """How a unit ended."""

    unit: int
    kind: str
    rooms: int = 0
    bake_seconds: float = 0.0
    seconds: float = 0.0
    bytes: int = 0
    message: str = ""


def run_unit(url: str, unit: int, threads: int) -> Outcome:
    """Does a unit, unless it is done."""
    store = open_store(url)
    job = jobs.read_job(store)
    if job is None:
        raise Failure(f"{url} holds no job; `cluster.py prepare` and `cluster.py bake` make one")
    if not 1 <= unit <= job.units:
        raise Failure(f"units are counted from 1 to {job.units}")
    if store.has(job.record(unit)):
        return Outcome(unit, KEPT)
    started = time.monotonic()
    node = prepare(store, job)
    with tempfile.TemporaryDirectory(prefix=f"{os.getpid()}-", dir=node.scratch) as scratch:
        outcome = bake(store, job, node, unit, threads, Path(scratch) / "out")
    return outcome._replace(seconds=time.monotonic() - started)


def bake(store: Store, job: Job, node: Node, unit: int, threads: int, out: Path) -> Outcome:
    content = store.read(job.list_of(unit))
    if content is None:
        raise Failure("the store lacks the list of levels of the unit")
    levels = out.with_name("levels.json")
    levels.write_bytes(content)
    started = time.monotonic()
    ran = run(node.program, "bake", *job.arguments, "--out", str(out), "--shard", f"{unit}/{job.units}", "--only-levels", str(levels),
              "--threads", str(threads), "--cache", str(node.cache), "--progress", "none", folder=node.inputs)
    seconds = time.monotonic() - started
    if reason := refusal(ran):
        note_error(store, unit, ran, reason)
        return Outcome(unit, FAILED, message=reason)
    part = out / Path(job.record(unit)).name
    files = recorded(part)
    if damaged := first_damaged(out, files):
        note_error(store, unit, ran, reason := f"{damaged} is not what the bake recorded: the disk of this machine is damaged or full")
        return Outcome(unit, FAILED, message=reason)
    upload(store, out, files)
    if ran.code == SOME_FAILED:
        note = {"failures": ran.answer["failures"], "misfits": ran.answer["misfits"], "stderr": ran.errors}
        store.write(f"{jobs.FLAWED}/{unit}.json", json.dumps(note, indent=1).encode())
    # The last of all: whoever sees it may rely on everything else.
    store.put(part, job.record(unit))
    kind = FLAWED if ran.code == SOME_FAILED else BAKED
    return Outcome(unit, kind, ran.answer["totals"]["rooms"], seconds, bytes=sum(file["bytes"] for file in files))


def refusal(ran: Ran) -> str:
    """Why a run counts as none; empty if it counts. Rooms that fail would fail again, machines that fail are replaced."""
    if ran.code not in (ALL_DONE, SOME_FAILED) or "totals" not in ran.answer:
        how = f"was ended by signal {-ran.code}" if ran.code < 0 else f"ended with exit code {ran.code}"
        return f"bake {how}: {ran.errors.strip()[-300:]}"
    of_machine = [failure for failure in ran.answer["failures"] if failure["code"] in OF_MACHINE]
    if of_machine or ran.answer["skipped_levels"] or ran.answer["manifest"] is None:
        return f"bake could not write: {(of_machine or [{'message': ran.errors}])[0]['message']}"
    return ""


def recorded(part: Path) -> list[dict]:
    """The files of levels and those that they share, as the part of the manifest lists them."""
    manifest = json.loads(part.read_text(encoding="utf-8"))
    return [file for level in manifest["levels"] for file in level["files"]] + manifest["library"]


def first_damaged(out: Path, files: list[dict]) -> str | None:
    """A file whose content is not the recorded one: `bake` hashes what it writes, not what the disk made of it."""
    return next((file["path"] for file in files if not is_intact(out / file["path"], file)), None)


def is_intact(path: Path, file: dict) -> bool:
    return path.is_file() and digest(path, "sha256") == file["sha256"]


def upload(store: Store, out: Path, files: list[dict]) -> None:
    """Puts files into the store."""
    def put(file: dict) -> None:
        path, name = out / file["path"], file["path"]
        # The names of shared files say their content: most are there already.
        if not path.parent.name.startswith("shared-") or not store.holds(path, name):
            store.take(path, name)

    with ThreadPoolExecutor(UPLOADS) as pool:
        list(pool.map(put, files))


def note_error(store: Store, unit: int, ran: Ran, reason: str) -> None:
    """Leaves a note about a failed attempt."""
    note = {"unit": unit, "machine": socket.gethostname(), "code": ran.code, "reason": reason, "stderr": ran.errors}
    store.write(f"{jobs.ERRORS}/{unit}.{time.time_ns()}.json", json.dumps(note, indent=1).encode())
