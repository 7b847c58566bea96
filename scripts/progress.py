"""How far a run is, on standard error: a bar on a terminal, a line now and then elsewhere."""

from __future__ import annotations

import sys
import time

BAR_WIDTH = 30
# Seconds between two lines where nobody watches a bar.
LINE_EVERY = 5.0


class Progress:
    """Counts what is done of a known number of things."""

    def __init__(self, title: str, of: int, stream=None):
        self.title = title
        self.of = of
        self.done = 0
        self.faults = 0
        self.stream = sys.stderr if stream is None else stream
        self.is_terminal = self.stream.isatty()
        self.started = self.told = time.monotonic()

    def step(self, faults: int = 0) -> None:
        self.done += 1
        self.faults += faults
        is_last = self.done == self.of
        if self.is_terminal:
            self.stream.write("\r" + self.bar() + ("\n" if is_last else ""))
            self.stream.flush()
        elif is_last or time.monotonic() - self.told >= LINE_EVERY:
            self.told = time.monotonic()
            print(self.line(), file=self.stream, flush=True)

    def clear(self) -> None:
        """Makes room for a line on the same terminal."""
        if self.is_terminal:
            self.stream.write("\r\x1b[K")
            self.stream.flush()

    def line(self) -> str:
        seconds = time.monotonic() - self.started
        return f"{self.title}: {self.done} of {self.of} files, {self.faults} faults, {seconds:.0f} s"

    def bar(self) -> str:
        filled = BAR_WIDTH * self.done // max(1, self.of)
        return f"[{'#' * filled}{'.' * (BAR_WIDTH - filled)}] {self.line()}"
