"""Units in processes of this machine."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait

from .unit import Outcome

Work = Callable[[int], Outcome]


def outcomes(work: Work, units: Sequence[int], workers: int) -> Iterator[tuple[int, Outcome | Exception]]:
    """What becomes of units, as they end. Each thread waits for a process `roomwright`."""
    waiting = iter(units)
    with ThreadPoolExecutor(workers) as pool:
        running = {}
        while True:
            # No more than there are workers: whoever interrupts the run waits for these only.
            while len(running) < workers and (unit := next(waiting, None)) is not None:
                running[pool.submit(work, unit)] = unit
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                unit = running.pop(future)
                error = future.exception()
                yield unit, error if isinstance(error, Exception) else future.result()
