"""The library is compiled once for users, tests, benches and examples alike, and its crate has what it is compiled from."""

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


def test_continuous_integration_runs_every_test_program():
    checks = (PROJECT / "scripts" / "test.sh").read_text()
    targets = {path.stem for path in (PROJECT / "tests").glob("*.rs")} | {path.parent.name for path in (PROJECT / "tests").glob("*/main.rs")}
    assert {target for target in targets if f"--test {target}" not in checks} == set()


def test_the_crate_holds_what_the_program_is_built_from_and_no_more():
    """Besides the four files that cargo adds. What a checkout holds beside its files (environments, modules of Node) stays out."""
    command = ["cargo", "package", "--list", "--offline", "--allow-dirty"]
    listed = subprocess.run(command, cwd=PROJECT, capture_output=True, text=True, check=True).stdout.splitlines()
    assert {line.split("/")[0] for line in listed} - {".cargo_vcs_info.json", "Cargo.lock", "Cargo.toml", "Cargo.toml.orig"} == {
        "ARCHITECTURE.md", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT", "README.md", "build.rs", "configs", "src", "viewer"}
