#!/usr/bin/env python3
"""Makes the files of a release from built programs.

    python packaging/release.py archive TARGET PROGRAM --to FOLDER             one archive, for one Rust target
    python packaging/release.py manifests FOLDER --repository URL --to OTHER   checksums.txt, Homebrew's formula, winget's manifests

`manifests` wants the archives of all targets in FOLDER. The same program makes the same archive, byte for byte. Needs nothing
but Python 3.11 or newer.
"""

from __future__ import annotations

import argparse
import gzip
import hashlib
import io
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path
from string import Template

ROOT = Path(__file__).resolve().parents[1]
PACKAGING = ROOT / "packaging"
# As `[package.metadata.binstall]` in Cargo.toml expects them.
TARGETS = ("x86_64-unknown-linux-musl", "aarch64-unknown-linux-musl", "x86_64-apple-darwin", "aarch64-apple-darwin",
           "x86_64-pc-windows-msvc")
BESIDE_THE_PROGRAM = ("README.md", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT")
# The first day that ZIP can say.
LONG_AGO = (1980, 1, 1, 0, 0, 0)
CHECKSUMS = "checksums.txt"


class ReleaseError(Exception):
    """A release that cannot be made; the text says why."""


def version() -> str:
    return tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["package"]["version"]


def is_for_windows(target: str) -> bool:
    return "windows" in target


def archive_name(target: str) -> str:
    return f"roomwright-{version()}-{target}.{'zip' if is_for_windows(target) else 'tar.gz'}"


def archive(target: str, program: Path, folder: Path) -> Path:
    """An archive with one folder, which holds the program and what a user should have with it."""
    if target not in TARGETS:
        raise ReleaseError(f"{target} is no target of a release; hint: one of {', '.join(TARGETS)}")
    inside = f"roomwright-{version()}-{target}"
    name = "roomwright.exe" if is_for_windows(target) else "roomwright"
    # The program comes first, so that readers of a stream have it soon.
    files = {f"{inside}/{name}": program.read_bytes()}
    files |= {f"{inside}/{page}": (ROOT / page).read_bytes() for page in BESIDE_THE_PROGRAM}
    path = folder / archive_name(target)
    folder.mkdir(parents=True, exist_ok=True)
    path.write_bytes(zipped(files) if is_for_windows(target) else tarred(files))
    return path


def tarred(files: dict[str, bytes]) -> bytes:
    whole = io.BytesIO()
    # Neither the names nor the times of this machine.
    with gzip.GzipFile("", "wb", 9, whole, mtime=0) as packed, tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for name, content in files.items():
            member = tarfile.TarInfo(name)
            member.size, member.mode = len(content), 0o755 if name.endswith("/roomwright") else 0o644
            tar.addfile(member, io.BytesIO(content))
    return whole.getvalue()


def zipped(files: dict[str, bytes]) -> bytes:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for name, content in files.items():
            packed.writestr(zipfile.ZipInfo(name, LONG_AGO), content, zipfile.ZIP_DEFLATED, 9)
    return whole.getvalue()


def manifests(folder: Path, repository: str, out: Path) -> list[Path]:
    """The checksums of all archives, and the templates with their blanks filled in."""
    digests = {target: digest_of(folder / archive_name(target)) for target in TARGETS}
    out.mkdir(parents=True, exist_ok=True)
    listed = "".join(f"{digest}  {archive_name(target)}\n" for target, digest in digests.items())
    blanks = {"version": version(), "repository": repository.rstrip("/")}
    blanks |= {f"sha256_{target.replace('-', '_')}": digest for target, digest in digests.items()}
    # With the line ends of Linux everywhere: `sha256sum --check` takes no others.
    written = {CHECKSUMS: listed}
    for template in sorted(PACKAGING.glob("*/*.template")):
        filled = Template(template.read_text(encoding="utf-8")).substitute(blanks)
        written[template.name.removesuffix(".template")] = filled
    for name, text in written.items():
        (out / name).write_bytes(text.encode())
    return [out / name for name in written]


def digest_of(path: Path) -> str:
    if not path.is_file():
        raise ReleaseError(f"{path} is missing; hint: make the archives of all targets first")
    return hashlib.sha256(path.read_bytes()).hexdigest()


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("archive", help="packs one program")
    one.add_argument("target", metavar="TARGET", help="the Rust target that it was built for")
    one.add_argument("program", metavar="PROGRAM", type=Path, help="the file of the program")
    all_of_them = commands.add_parser("manifests", help="writes checksums, Homebrew's formula and winget's manifests")
    all_of_them.add_argument("folder", metavar="FOLDER", type=Path, help="the folder of the archives")
    all_of_them.add_argument("--repository", metavar="URL", required=True, help="the address of the repository that has the release")
    for command in (one, all_of_them):
        command.add_argument("--to", metavar="FOLDER", type=Path, required=True, help="where to write")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        if options.command == "archive":
            written = [archive(options.target, options.program, options.to)]
        else:
            written = manifests(options.folder, options.repository, options.to)
    except (ReleaseError, OSError) as error:
        print(f"release: {error}", file=sys.stderr)
        return 2
    print("\n".join(map(str, written)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
