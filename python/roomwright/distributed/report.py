"""The manifest of all units, and what a run has to say at its end."""

from __future__ import annotations

import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .failure import Failure
from .job import Job
from .program import ALL_DONE, SOME_FAILED, run
from .progress import duration
from .store import Store
from .unit import BAKED, FAILED, FLAWED, KEPT, Outcome

# Records that are on their way from the store at the same time.
DOWNLOADS = 16


def merge(store: Store, job: Job, program: Path) -> dict:
    """Joins the records of all units, and puts the manifest into the store; its sums."""
    with tempfile.TemporaryDirectory(prefix="roomwright-merge-") as folder:
        def fetch(unit: int) -> None:
            content = store.read(job.record(unit))
            # A record that is missing is reported by the merge, with all others.
            if content is not None:
                (Path(folder) / Path(job.record(unit)).name).write_bytes(content)

        with ThreadPoolExecutor(DOWNLOADS) as pool:
            list(pool.map(fetch, range(1, job.units + 1)))
        manifest = Path(folder) / "manifest.json"
        levels = Path(folder) / "levels.json"
        levels.write_bytes(store.read(job.levels_name) or b"")
        merged = run(program, "merge", "--records", folder, "--levels", str(levels), "--out", str(manifest))
        # Levels that failed are left out, as one bake leaves them out.
        if merged.code not in (ALL_DONE, SOME_FAILED):
            raise Failure(f"the records cannot be joined:\n{merged.errors}")
        store.put(manifest, "manifest.json")
        return merged.answer["totals"]


def summary(outcomes: list[Outcome], retried: int, seconds: float) -> str:
    """What a run did, in a few lines."""
    count = {kind: sum(outcome.kind == kind for outcome in outcomes) for kind in (KEPT, BAKED, FLAWED, FAILED)}
    done = [outcome for outcome in outcomes if outcome.kind in (BAKED, FLAWED)]
    rooms, size = sum(outcome.rooms for outcome in done), sum(outcome.bytes for outcome in done)
    baking, all_seconds = sum(outcome.bake_seconds for outcome in done), sum(outcome.seconds for outcome in done)
    text = (f"{count[BAKED] + count[FLAWED]} units baked, {count[KEPT]} kept, {count[FAILED]} failed, "
            f"{retried} attempts repeated; {rooms} rooms, {size / 1e6:.1f} MB in {duration(seconds)}")
    if done:
        text += (f"\nOf {all_seconds:.1f} s of all units, {baking:.1f} s were the bake and {all_seconds - baking:.1f} s "
                 "the store.")
    for outcome in outcomes:
        if outcome.kind == FAILED:
            text += f"\nunit {outcome.unit} failed: {outcome.message}"
    if count[FLAWED]:
        text += f"\nlevels or rooms of {count[FLAWED]} units could not be made: see .cluster/flawed/ in the store"
    return text
