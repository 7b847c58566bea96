"""The files of a release: archives of programs, checksums, the manifests of package managers, workflows."""

from __future__ import annotations

import hashlib
import importlib.util
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest
import yaml
from conftest import ROOT

ADDRESS = "https://example.org/owner/roomwright"
PROGRAM = b"a program"


def load():
    spec = importlib.util.spec_from_file_location("release", ROOT / "packaging" / "release.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


release = load()
PACKAGE = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["package"]


@pytest.fixture
def archives(tmp_path) -> Path:
    """The archives of all targets, each with a program that is a text."""
    (tmp_path / "program").write_bytes(PROGRAM)
    for target in release.TARGETS:
        release.archive(target, tmp_path / "program", tmp_path / "archives")
    return tmp_path / "archives"


def test_an_archive_holds_a_program_that_may_run(archives):
    inside = f"roomwright-{PACKAGE['version']}-x86_64-unknown-linux-musl"
    with tarfile.open(archives / f"{inside}.tar.gz") as packed:
        assert {Path(name).parent.name for name in packed.getnames()} == {inside}
        assert {Path(name).name for name in packed.getnames()} == {"roomwright", *release.BESIDE_THE_PROGRAM}
        program = packed.getmember(f"{inside}/roomwright")
        assert program.mode == 0o755 and packed.extractfile(program).read() == PROGRAM


def test_an_archive_for_windows_is_a_zip(archives):
    inside = f"roomwright-{PACKAGE['version']}-x86_64-pc-windows-msvc"
    with zipfile.ZipFile(archives / f"{inside}.zip") as packed:
        assert packed.read(f"{inside}/roomwright.exe") == PROGRAM and f"{inside}/LICENSE-MIT" in packed.namelist()


def test_the_same_program_makes_the_same_archives(archives, tmp_path):
    for target in release.TARGETS:
        again = release.archive(target, tmp_path / "program", tmp_path / "again")
        assert again.read_bytes() == (archives / again.name).read_bytes()


def test_cargo_binstall_finds_the_archives(archives):
    said = PACKAGE["metadata"]["binstall"]
    for target in release.TARGETS:
        kind = said.get("overrides", {}).get(target, {}).get("pkg-fmt", said["pkg-fmt"])
        blanks = {"repo": ADDRESS, "name": PACKAGE["name"], "version": PACKAGE["version"], "target": target, "bin": "roomwright",
                  "archive-suffix": {"tgz": ".tar.gz", "zip": ".zip"}[kind], "binary-ext": ".exe" if kind == "zip" else ""}
        address = filled(said["pkg-url"], blanks)
        file = archives / address.removeprefix(f"{ADDRESS}/releases/download/v{PACKAGE['version']}/")
        names = zipfile.ZipFile(file).namelist() if kind == "zip" else tarfile.open(file).getnames()
        assert filled(said["bin-dir"], blanks) in names


def filled(text: str, blanks: dict[str, str]) -> str:
    return re.sub(r"\{ ([\w-]+) \}", lambda found: blanks[found[1]], text)


def test_manifests_have_the_digests_of_the_archives(archives, tmp_path):
    assert release.main(["manifests", str(archives), "--repository", f"{ADDRESS}/", "--to", str(tmp_path / "out")]) == 0
    written = {path.name: path.read_text() for path in (tmp_path / "out").iterdir()}
    assert len(written) == 5 and not [name for name, text in written.items() if "${" in text]
    subprocess.run(["sha256sum", "--check", "--quiet", tmp_path / "out" / "checksums.txt"], cwd=archives, check=True)
    # Each address is that of a file, and the line after it has this file's digest.
    pairs = re.findall(r'(?:url "|InstallerUrl: )(\S+?)"?\n\s*(?:sha256 "|InstallerSha256: )(\w{64})', "".join(written.values()))
    assert len(pairs) == len(release.TARGETS)
    for address, digest in pairs:
        name = address.removeprefix(f"{ADDRESS}/releases/download/v{PACKAGE['version']}/")
        assert hashlib.sha256((archives / name).read_bytes()).hexdigest() == digest


def test_winget_s_manifests_name_the_program_in_the_archive(archives, tmp_path):
    release.manifests(archives, ADDRESS, tmp_path / "out")
    found = [yaml.safe_load(path.read_text()) for path in (tmp_path / "out").glob("*.yaml")]
    assert {manifest["ManifestType"] for manifest in found} == {"version", "installer", "defaultLocale"}
    assert {str(manifest["PackageVersion"]) for manifest in found} == {PACKAGE["version"]}
    (installer,) = (manifest for manifest in found if manifest["ManifestType"] == "installer")
    (nested,) = installer["NestedInstallerFiles"]
    names = zipfile.ZipFile(archives / installer["Installers"][0]["InstallerUrl"].rsplit("/", 1)[1]).namelist()
    assert nested["RelativeFilePath"].replace("\\", "/") in names


@pytest.mark.parametrize("arguments, message", [
    (["archive", "sparc", "program", "--to", "out"], "sparc is no target of a release; hint: one of x86_64-unknown-linux-musl"),
    (["archive", "x86_64-pc-windows-msvc", "absent", "--to", "out"], "No such file"),
    (["manifests", "absent", "--repository", ADDRESS, "--to", "out"], "hint: make the archives of all targets first"),
])
def test_what_cannot_be_made_is_said(tmp_path, arguments, message):
    done = subprocess.run([sys.executable, ROOT / "packaging" / "release.py", *arguments], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.startswith("release: ") and message in done.stderr and "Traceback" not in done.stderr


class TestWorkflows:
    @pytest.mark.parametrize("name", ["release.yml", "test.yml", "pages.yml"])
    def test_steps_run_files_that_are_there(self, name):
        text = (ROOT / ".github" / "workflows" / name).read_text(encoding="utf-8")
        steps = [step for job in yaml.safe_load(text)["jobs"].values() for step in job["steps"]]
        assert all(("run" in step) != ("uses" in step) for step in steps)
        named = re.findall(r"\b(?:packaging|tests|scripts|\.ci)/[\w./-]+", "\n".join(step.get("run", "") for step in steps))
        assert named and all((ROOT / path).exists() for path in named)

    def test_a_release_builds_the_targets_that_are_packed(self):
        jobs = yaml.safe_load((ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8"))["jobs"]
        assert {entry["target"] for entry in jobs["program"]["strategy"]["matrix"]["include"]} == set(release.TARGETS)

    def test_the_container_is_built_from_files_that_its_list_lets_in(self):
        listed = (ROOT / "packaging" / "Dockerfile.dockerignore").read_text().splitlines()
        allowed = {line.removeprefix("!") for line in listed if line.startswith("!")}
        assert all((ROOT / name).exists() for name in allowed)
        # Cargo reads the files of targets that its manifest names.
        assert {"src", "benches", "configs", "viewer", "build.rs", "Cargo.toml", "Cargo.lock"} <= allowed
