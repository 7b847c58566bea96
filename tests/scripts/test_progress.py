"""Progress goes to standard error, and only where somebody watches it."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
import termios

import pytest
from conftest import LACKS, ROOT

pytestmark = pytest.mark.skipif(bool(LACKS), reason=f"{', '.join(LACKS)} is not installed (scripts/requirements.txt)")


@pytest.fixture(params=["validate.py", "convert.py"])
def command(request, floor, tmp_path):
    (tmp_path / "out").mkdir()
    for name in ("ground", "upper"):
        floor.write(tmp_path / "out" / f"{name}.glb")
    arguments = ["--no-khronos"] if request.param == "validate.py" else ["--out", str(tmp_path / "usd")]
    return [sys.executable, str(ROOT / "scripts" / request.param), str(tmp_path / "out"), *arguments]


def run_on_terminal(command) -> tuple[str, str]:
    """Standard output, and standard error as a terminal gets it."""
    terminal, side = pty.openpty()
    termios.tcsetwinsize(side, (24, 80))
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=side, text=True, timeout=120)
    finally:
        os.close(side)
    shown = b""
    try:
        while data := os.read(terminal, 4096):
            shown += data
    except OSError:  # the end, on Linux
        pass
    os.close(terminal)
    assert done.returncode == 0, shown
    return done.stdout, shown.decode()


def test_a_terminal_shows_how_many_files_are_done(command):
    results, shown = run_on_terminal(command)
    assert "2/2" in shown and "100%" in shown
    assert "%" not in results and results.strip()


def test_quiet_shows_no_progress(command):
    results, shown = run_on_terminal([*command, "--quiet"])
    assert shown == "" and results.strip()


def test_a_log_gets_no_progress(command):
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.strip()
