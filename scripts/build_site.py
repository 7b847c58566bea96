#!/usr/bin/env python3
"""Builds the documentation as one site with mdBook, and checks its links: python scripts/build_site.py [--out FOLDER]

The pages stay where they are: docs/site/SUMMARY.md is the table of contents, docs/site/book.toml the settings. --links checks the pages
alone, without mdBook. mdBook (MPL 2.0) is taken from the path or from target/tools; --install installs it there with cargo.
Exit 0: done. 1: faults, each with its place. 2: nothing could start. 3: there is no mdBook.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

from documentation.built import built_faults
from documentation.links import page_faults
from documentation.source import SiteError, pages_of, write_source

ROOT = Path(__file__).resolve().parents[1]
TOOLS = ROOT / "target" / "tools"
# The version that the site was looked at with.
VERSION = "0.5.4"


def find_mdbook() -> str | None:
    return shutil.which("mdbook") or shutil.which("mdbook", path=str(TOOLS / "bin"))


def install() -> None:
    subprocess.run(["cargo", "install", "--locked", "--version", VERSION, "--root", str(TOOLS), "mdbook"], check=True)


def build(out: Path, mdbook: str, repository: str | None) -> list[str]:
    """Builds the site in a folder below target, puts it into `out`, and returns its faults. Raises SiteError and OSError."""
    folder = ROOT / "target" / "site"
    write_source(ROOT, folder, repository)
    done = subprocess.run([mdbook, "build", str(folder)], capture_output=True, text=True)
    if done.returncode != 0 or re.search(r"\b(WARN|ERROR)\b", done.stderr):
        raise SiteError(f"mdbook says:\n{done.stderr.strip()}")
    if out.resolve() != (folder / "book").resolve():
        replace(out, folder / "book")
    return built_faults(out)


def replace(out: Path, book: Path) -> None:
    """Puts a site in place of an earlier one; nothing else is overwritten."""
    if out.exists() and not (out / "searcher.js").exists() and not list(out.glob("book-*.js")) and any(out.iterdir()):
        raise SiteError(f"{out} holds other files than a site; hint: name a new folder")
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(book, out)


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=ROOT / "target" / "site" / "book",
                        help="folder of the site (default: target/site/book)")
    parser.add_argument("--repository", metavar="ADDRESS",
                        help="address of the repository, where links to files that are no pages lead (default: the files are copied)")
    parser.add_argument("--links", action="store_true", help="check the links of the pages, and build nothing")
    parser.add_argument("--install", action="store_true", help=f"install mdBook {VERSION} into target/tools first")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    faults = [fault for page in pages_of(ROOT) if page.is_file() for fault in page_faults(ROOT, page)]
    if faults or options.links:
        print("\n".join(faults) or f"{len(pages_of(ROOT))} pages: every link leads somewhere", file=sys.stderr if faults else sys.stdout)
        return 1 if faults else 0
    try:
        if options.install:
            install()
        mdbook = find_mdbook()
        if mdbook is None:
            print("build_site: there is no mdbook; hint: --install installs it into target/tools", file=sys.stderr)
            return 3
        faults = build(options.out, mdbook, options.repository.rstrip("/") if options.repository else None)
    except (SiteError, OSError, subprocess.CalledProcessError) as error:
        print(f"build_site: {error}", file=sys.stderr)
        return 2
    print("\n".join(faults) if faults else f"{options.out}: {len(pages_of(ROOT))} pages", file=sys.stderr if faults else sys.stdout)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
