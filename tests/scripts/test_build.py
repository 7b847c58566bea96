"""The library is compiled once for users, tests, benches and examples alike."""

from __future__ import annotations

import subprocess
import tomllib
from pathlib import Path

PROJECT = Path(__file__).parents[2]


def features(edges: str) -> set[str]:
    """Each dependency with the features that it is compiled with."""
    command = ["cargo", "tree", "--offline", "--locked", "--prefix", "none", "--format", "{p} {f}", "--edges", edges]
    lines = subprocess.run(command, cwd=PROJECT, capture_output=True, text=True, check=True).stdout.splitlines()
    return {line.removesuffix(" (*)").strip() for line in lines}


def test_development_dependencies_switch_on_no_feature_of_another():
    assert features("normal") - features("normal,dev") == set()


def test_benches_are_compiled_with_the_settings_of_releases():
    assert "bench" not in tomllib.loads((PROJECT / "Cargo.toml").read_text())["profile"]
