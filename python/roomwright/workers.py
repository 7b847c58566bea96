"""Work on many files by several processes, none of which can end the others' work."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool

DIED = "the process that read it died"
# No copies of this process: USD has threads of its own, and a copy waits for ever for a lock that one of them held.
FRESH = multiprocessing.get_context("forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn")


def outcomes(work: Callable, items: Sequence, processes: int) -> Iterator:
    """The results of `work` for items, in their order; an exception that it raised is the result for its item."""
    with ProcessPoolExecutor(max(1, min(processes, len(items))), mp_context=FRESH) as pool:
        futures = [pool.submit(work, item) for item in items]
        for future, item in zip(futures, items):
            outcome = outcome_of(future)
            # One death ends a whole pool, and does not say whose work it was: what is left is done again, one by one.
            yield alone(work, item) if isinstance(outcome, BrokenProcessPool) else outcome


def alone(work: Callable, item) -> object:
    """The outcome of work in a process of its own."""
    with ProcessPoolExecutor(1, mp_context=FRESH) as pool:
        outcome = outcome_of(pool.submit(work, item))
    return RuntimeError(DIED) if isinstance(outcome, BrokenProcessPool) else outcome


def outcome_of(future: Future) -> object:
    try:
        return future.result()
    except Exception as error:  # any exception of the work, and results that cannot be sent between processes
        return error
