"""Measures commands: what a process costs, with all that it waited for."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from typing import NamedTuple


class Measured(NamedTuple):
    """A command that ended."""

    code: int
    seconds: float
    # Of all threads, in and out of the kernel.
    processor_seconds: float
    # The most memory of one process.
    peak_bytes: int
    stderr: str


def measured(command: list, environment: dict[str, str] | None = None) -> Measured:
    """Runs a command without its standard output. Linux and macOS, which count for each process."""
    started = time.monotonic()
    process = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environment)
    said = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    unit = 1 if sys.platform == "darwin" else 1024
    return Measured(process.returncode, time.monotonic() - started, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * unit, said)
