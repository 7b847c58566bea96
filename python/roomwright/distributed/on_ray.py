"""Units as tasks of Ray, on all machines of a cluster."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from .failure import Failure
from .unit import Outcome, run_unit

# Tasks for each processor: one runs, one waits, so that no processor waits for the driver.
TASKS_OF_PROCESSOR = 2


def connect(address: str | None):
    """Ray, connected to a cluster, or started on this machine."""
    try:
        import ray
    except ImportError as error:
        raise Failure("Ray is not there: python -m pip install -r scripts/requirements-cluster.txt, "
                      "or 'roomwright[cluster]'") from error
    # The code of the tasks goes along: the machines need no copy of the project.
    package = str(Path(__file__).resolve().parents[1])
    if not ray.is_initialized():
        ray.init(address=address, runtime_env={"py_modules": [package]}, log_to_driver=False)
    return ray


def processors(ray) -> int:
    return max(1, int(ray.cluster_resources().get("CPU", 1)))


def outcomes(ray, url: str, threads: int, units: Sequence[int]) -> Iterator[tuple[int, Outcome | Exception]]:
    """What becomes of units, as they end.

    Ray repeats a task without limit if its machine or its process is lost, for on machines that are lent for a while this is
    no fault of the task. A bake that ends with an error returns normally, and the driver counts its attempts.
    """
    task = ray.remote(num_cpus=threads, max_retries=-1)(run_unit)
    waiting, running = iter(units), {}
    while True:
        # The cluster may grow: its size is asked for each time.
        most = max(1, TASKS_OF_PROCESSOR * processors(ray) // threads)
        while len(running) < most and (unit := next(waiting, None)) is not None:
            running[task.remote(url, unit, threads)] = unit
        if not running:
            return
        ended, _ = ray.wait(list(running), num_returns=1)
        for reference in ended:
            unit = running.pop(reference)
            try:
                yield unit, Outcome(*ray.get(reference))
            except Exception as error:  # what the task raised, in a type of Ray's
                yield unit, error
