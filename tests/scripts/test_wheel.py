"""The wheel in a clean environment: the commands of docs/python.md, as they are written there.

ROOMWRIGHT_WHEEL names the wheel. The environment gets what the extras ask for from the registry that pip knows.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

WHEEL = os.environ.get("ROOMWRIGHT_WHEEL")
pytestmark = pytest.mark.skipif(WHEEL is None, reason="ROOMWRIGHT_WHEEL names no wheel (maturin build --release)")


class Clean:
    """A folder with a home, and an environment with nothing but pip in front of the path."""

    def __init__(self, folder: Path):
        self.folder = folder
        shutil.copy(ROOT / "tests/cases/sweet_home/flat.sh3d", folder / "home.sh3d")
        subprocess.run([sys.executable, "-m", "venv", str(folder / "environment")], check=True)
        self.bin = folder / "environment" / "bin"
        kept = {name: value for name, value in os.environ.items() if name not in ("ROOMWRIGHT_PROGRAM", "PYTHONPATH", "VIRTUAL_ENV")}
        self.variables = kept | {"PATH": f"{self.bin}:/usr/bin:/bin"}

    def run(self, line: str) -> subprocess.CompletedProcess:
        return subprocess.run(shlex.split(line), cwd=self.folder, env=self.variables, capture_output=True, text=True,
                              executable=shutil.which(shlex.split(line)[0], path=str(self.bin)))


def three_commands() -> list[str]:
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    block = re.search(r"Three commands lead[^\n]*\n\n((?:    [^\n]*\n)+)", text)
    return [line.strip() for line in block[1].splitlines()]


@pytest.fixture(scope="module")
def clean(tmp_path_factory) -> Clean:
    clean = Clean(tmp_path_factory.mktemp("clean"))
    for line in three_commands():
        done = clean.run(re.sub(r"roomwright-[\w.-]+\.whl", lambda _: str(Path(WHEEL).resolve()), line))
        assert done.returncode == 0, (line, done.stdout, done.stderr)
    return clean


def test_three_commands_lead_from_a_home_to_usd(clean):
    assert len(three_commands()) == 3
    (level,) = (clean.folder / "out").rglob("*.glb")
    assert level.read_bytes()[:4] == b"glTF"
    stages = {path.name for path in (clean.folder / "usd").rglob("*.usd*")}
    assert "building.usda" in stages and any(name.endswith(".usdc") for name in stages)


def test_the_program_beside_the_package_is_the_one_that_runs(clean):
    code = ("import roomwright; bake = roomwright.Bake.open('out'); "
            "print(roomwright.find_program()); print(len(list(bake.placements)) == bake.manifest['totals']['placed'] > 0)")
    done = clean.run(f"python -c {shlex.quote(code)}")
    assert done.stdout.split("\n")[:2] == [str((clean.bin / "roomwright").resolve()), "True"], done.stderr


def test_a_command_without_its_modules_names_its_extra(clean):
    done = clean.run("roomwright-validate out")
    assert done.returncode == 2 and done.stderr.endswith('-m pip install "roomwright[validate]"\n'), done.stderr


def test_a_reader_of_drawings_names_its_extra_and_has_its_words(clean):
    done = clean.run("roomwright-dxf-to-plan plan.dxf --layers layers.yaml")
    assert done.returncode == 2 and done.stderr.endswith('-m pip install "roomwright[dxf]"\n'), done.stderr
    code = "import pathlib, roomwright; print((pathlib.Path(roomwright.__file__).parent / 'dxf' / 'room_words.yaml').read_text('utf-8'))"
    assert clean.run(f"python -c {shlex.quote(code)}").stdout.strip() == (ROOT / "configs" / "room_words.yaml").read_text("utf-8").strip()


def test_an_installed_validator_finds_its_schemas(clean):
    wheel = Path(WHEEL).resolve()
    installed = clean.run(f'python -m pip install -q "{wheel}[validate]"')
    assert installed.returncode == 0, installed.stderr
    done = clean.run("roomwright-validate out usd --no-khronos")
    assert done.returncode == 0 and "1 manifests" in done.stdout and done.stdout.endswith(": 0 faults\n"), done.stdout + done.stderr
    # The Khronos validator is not there, and the line that sets it up names the folder of the package.
    done = clean.run("roomwright-validate out")
    assert done.returncode == 2 and f"npm ci --prefix '{clean.folder}" in done.stderr


def test_modules_are_commands_too(clean):
    done = clean.run("python -m roomwright.convert --help")
    assert done.returncode == 0 and "roomwright-convert [options]" in done.stdout, done.stderr
