"""Counts, rate and time left, from what the store lists: any machine can ask, also after the driver died."""

from __future__ import annotations

import sys
import time

from . import job as jobs
from .job import Job
from .store import Store

# Seconds between two lines.
PAUSE = 5.0


class Progress:
    """The lines of a running driver."""

    def __init__(self, total: int, kept: int):
        self.total, self.kept, self.done, self.failed, self.retried = total, kept, 0, 0, 0
        self.started = time.monotonic()
        self.told = self.started

    def show(self, is_last: bool = False) -> None:
        now = time.monotonic()
        if not is_last and now - self.told < PAUSE:
            return
        self.told = now
        left = self.total - self.kept - self.done - self.failed
        print(line(self.total, self.kept + self.done, self.failed, self.done / max(now - self.started, 1e-9), left),
              file=sys.stderr, flush=True)


def line(total: int, done: int, failed: int, rate: float, left: int) -> str:
    """One line of progress; the rate is in units a second."""
    parts = [f"{done} of {total} units done"]
    if failed:
        parts.append(f"{failed} failed")
    if rate > 0:
        parts.append(f"{60 * rate:.1f} a minute")
        if left:
            parts.append(f"{duration(left / rate)} left")
    return ", ".join(parts)


def duration(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def done_units(store: Store, job: Job) -> dict[int, float]:
    """The units whose records are in the store, with the times of these."""
    found = {}
    for entry in store.list(jobs.RECORDS):
        name = entry.name.rsplit("/", 1)[-1].removeprefix("manifest.").removesuffix(f"-of-{job.units}.json")
        if name.isdigit():
            found[int(name)] = entry.written
    return found


def status(store: Store, job: Job) -> str:
    """The state of a job, as any machine sees it."""
    done = done_units(store, job)
    span = max(done.values()) - min(done.values()) if len(done) > 1 else 0.0
    rate = (len(done) - 1) / span if span > 0 else 0.0
    text = line(job.units, len(done), 0, rate, job.units - len(done))
    for folder, words in ((jobs.ERRORS, "failed attempts"), (jobs.FLAWED, "units with levels or rooms that failed")):
        if count := len(store.list(folder)):
            text += f"\n{count} {words}: see {folder}/ in the store"
    return text
